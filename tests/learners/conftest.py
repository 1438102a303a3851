import numpy as np
import pytest

from learners import Prospects


def make_prospects(scenes=24, actions=4, outcomes=8, seed=0, features=5):
    """Prospects with gains and losses and an occasional disaster, of three families."""
    random = np.random.default_rng(seed)
    usual = random.uniform(0.0, 1.0, (scenes, actions, 1, features))
    phi = usual + random.normal(0.0, 0.3, (scenes, actions, outcomes, features))
    phi[..., -1] = random.random((scenes, actions, outcomes)) < random.random((scenes, actions, 1))
    return Prospects(
        phi,
        100 + np.arange(scenes),
        tuple(["corridor", "doorway", "open"][i % 3] for i in range(scenes)),
        ("mixed",) * scenes,
        tuple(["forward", "stop", "left", "right"][:actions]),
    )


@pytest.fixture(scope="session")
def prospects():
    return make_prospects()


@pytest.fixture(scope="session")
def make():
    return make_prospects
