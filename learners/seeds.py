"""One seed, several independent streams of random numbers."""

from enum import IntEnum

import numpy as np

from learners.errors import InputError


class Stream(IntEnum):
    """What random numbers are for; the streams of one seed are independent of one another."""

    SPLIT = 0
    PAIRS = 1
    SIDES = 2
    LABELS = 3
    BOOTSTRAP = 4


def generator(seed: int, stream: Stream) -> np.random.Generator:
    """The random numbers of one stream; raises `InputError` if the seed is negative."""
    if seed < 0:
        raise InputError(f"seed {seed} is not allowed: 0 or more")
    return np.random.default_rng([seed, stream])
