"""Many more rollouts, to hold few of them against."""

import numpy as np
import pytest

from learners import PROFILES, prospect_value
from scenes import load_scene, simulate
from studio.scene.judgements import judge, utilities
from studio.scene.reference import REFERENCE_ROLLOUTS, reference_utilities


@pytest.fixture(scope="module")
def doorway():
    return simulate(load_scene("doorway"), rollouts=20, horizon=2.0)


def test_the_given_rollouts_are_the_first_of_the_many(doorway) -> None:
    many = reference_utilities(doorway)
    assert many.shape == (7, REFERENCE_ROLLOUTS)
    np.testing.assert_array_equal(many[:, :20], utilities(doorway))


def test_as_many_rollouts_need_no_reference() -> None:
    rollouts = simulate(load_scene("open"), rollouts=REFERENCE_ROLLOUTS, horizon=0.2)
    assert reference_utilities(rollouts) is None


def test_intervals_hold_what_other_rollouts_say(doorway) -> None:
    many = reference_utilities(doorway)
    held, told = 0, 0
    for judgement in judge(doorway, reference=many):
        for seed in range(1, 81):
            other = simulate(doorway.scene, rollouts=20, horizon=2.0, seed=seed)
            values = prospect_value(utilities(other), PROFILES[judgement.teacher])
            held += ((judgement.low <= values) & (values <= judgement.high)).sum()
            told += values.size
    assert 0.91 < held / told < 0.97


def test_what_is_said_of_the_pick_is_how_often_other_rollouts_lead_to_it(doorway) -> None:
    judgement = judge(doorway, reference=reference_utilities(doorway))[2]
    picks = np.zeros(7)
    for seed in range(1, 81):
        other = simulate(doorway.scene, rollouts=20, horizon=2.0, seed=seed)
        picks[judge(other)[2].best] += 1 / 80
    np.testing.assert_allclose(judgement.shares, picks, atol=0.2)  # 80 seeds tell it to ± 0.1
