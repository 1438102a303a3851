"""Which scenes are learned from and which are kept back for the test."""

from dataclasses import dataclass

import numpy as np

from learners.arrays import IntArray
from learners.asking.prospects import Prospects
from learners.errors import InputError
from learners.seeds import Stream, generator

HELD_OUT = 1.0 / 3.0
"""Share of the scenes that is kept back."""


@dataclass(frozen=True)
class Split:
    """Two sets of scenes that have none in common."""

    training: IntArray  # places of the scenes to learn from, ascending
    held_out: IntArray  # places of the scenes that are kept back, ascending


def split_scenes(prospects: Prospects, seed: int, held_out: float = HELD_OUT) -> Split:
    """Split the scenes in two, every family in the same proportion, by chance.

    The share of each family that is held out is rounded to whole scenes, with at least one on
    either side.

    Raises:
        InputError: if the share is out of range, or a family has a single scene.
    """
    if not 0.0 < held_out < 1.0:
        raise InputError(f"held_out {held_out} is not allowed: between 0 and 1")
    random = generator(seed, Stream.SPLIT)
    families = np.array(prospects.families)
    kept_back = np.zeros(len(families), dtype=bool)
    for family in sorted(set(prospects.families)):
        places = np.flatnonzero(families == family)
        if len(places) < 2:
            raise InputError(
                f"scenes: family {family} has 1: two or more of each family are needed, "
                "to learn from and to keep back"
            )
        count = min(max(round(held_out * len(places)), 1), len(places) - 1)
        kept_back[random.permutation(places)[:count]] = True
    return Split(np.flatnonzero(~kept_back), np.flatnonzero(kept_back))
