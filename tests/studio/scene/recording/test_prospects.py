import numpy as np
import pytest

from learners import PROFILES, value
from studio.scene.recording.prospects import certainty_equivalents, stairs


@pytest.mark.parametrize("teacher", list(PROFILES))
def test_a_sure_utility_is_worth_what_the_prospect_is_worth(teacher: str) -> None:
    values = np.array([-1.3, -0.02, 0.0, 0.004, 0.6])
    sure = certainty_equivalents(values, PROFILES[teacher])
    np.testing.assert_allclose(value(sure, PROFILES[teacher]), values, atol=1e-10)


def test_stairs_have_a_level_step_for_every_height() -> None:
    assert stairs(2.0, np.array([0.5, 0.25])).tolist() == [
        [2.0, 0.5],
        [2.5, 0.5],
        [2.5, 0.25],
        [3.0, 0.25],
    ]
