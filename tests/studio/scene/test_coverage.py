"""Whether intervals hold what they say, over many scenes; docs/certainty.md has the numbers."""

import numpy as np
import pytest

from learners import PROFILES, prospect_value, resampled_values
from scenes import sample_scene, simulate
from studio.arrays import FloatArray
from studio.scene.certainty import interval, resampled_counts
from studio.scene.judgements import utilities
from studio.scene.reference import REFERENCE_ROLLOUTS

SCENES, FEW, OTHERS = 20, 50, 2000
TEACHERS = list(PROFILES)


@pytest.fixture(scope="module")
def worths() -> list[FloatArray]:
    """Utilities of every scene: those of the reference first, then those of other rollouts."""
    scenes = [sample_scene(5, number) for number in range(SCENES)]
    return [utilities(simulate(each, rollouts=REFERENCE_ROLLOUTS + OTHERS)) for each in scenes]


def coverage(worths: list[FloatArray], teacher: str, pool: int) -> float:
    """In what share of cases intervals hold the value that fifty other rollouts have."""
    counts, held = resampled_counts(FEW, pool), []
    for each in worths:
        [drawn] = resampled_values(each[:, :pool], (PROFILES[teacher],), counts)
        low, high = interval(drawn)
        others = each[:, REFERENCE_ROLLOUTS:].reshape(len(each), -1, FEW)
        values = prospect_value(others, PROFILES[teacher]).T
        held.append(((low <= values) & (values <= high)).mean())
    return float(np.mean(held))


@pytest.mark.slow
@pytest.mark.parametrize("teacher", TEACHERS)
def test_draws_of_a_thousand_rollouts_hold_what_fifty_others_say(worths, teacher) -> None:
    assert 0.92 < coverage(worths, teacher, REFERENCE_ROLLOUTS) < 0.97


@pytest.mark.slow
@pytest.mark.parametrize("teacher", ["tk", "strong"])
def test_draws_of_the_fifty_rollouts_themselves_would_not(worths, teacher) -> None:
    assert coverage(worths, teacher, FEW) < 0.8
