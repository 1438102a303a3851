"""The random streams of scenes and rollouts.

Each comes from Philox, a counter-based generator (Salmon et al., "Parallel random numbers: as easy
as 1, 2, 3", SC 2011), and is found again by its numbers alone. The streams of scenes start from
other counters than those of rollouts, so no scene shares random numbers with a rollout.
"""

import numpy as np


def scene_stream(seed: int, number: int) -> np.random.Generator:
    """The random stream by which a scene of a series is drawn."""
    return _philox(seed, number, counter=[0, 0, 0, 1])


def rollout_stream(seed: int, scene_number: int, rollout: int) -> np.random.Generator:
    """The random stream of one rollout of one scene."""
    return _philox(seed, scene_number << 32 | rollout, counter=[0, 0, 0, 0])


def _philox(seed: int, number: int, counter: list[int]) -> np.random.Generator:
    key = np.array([seed, number], dtype=np.uint64)
    return np.random.Generator(np.random.Philox(key=key, counter=counter))
