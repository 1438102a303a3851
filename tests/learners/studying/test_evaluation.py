from dataclasses import replace

import numpy as np
import pytest

from learners import TEACHERS, evaluate

TK = TEACHERS["tk"]


def test_the_teacher_regrets_nothing_of_the_own_choices(prospects):
    truth = TK.values(prospects.features)
    test = evaluate(truth, TK.values(prospects.features))
    assert (test.regret, test.regret_percent, test.agreement) == (0.0, 0.0, 1.0)
    assert test.nll == test.nll_teacher < np.log(2.0)
    full = test.calibration.count > 0
    np.testing.assert_allclose(test.calibration.predicted[full], test.calibration.preferred[full])


def test_regret_by_hand(prospects):
    truth = TK.values(prospects.features)
    test = evaluate(-truth, TK.values(prospects.features))
    assert test.regret == pytest.approx((truth.max(axis=1) - truth.min(axis=1)).mean())
    random = (truth.max(axis=1)[:, None] - truth).mean()
    assert test.regret_percent == pytest.approx(100.0 * test.regret / random)
    assert test.agreement == 0.0


def test_regret_of_each_scene_is_that_of_its_pick(prospects):
    truth = TK.values(prospects.features)
    test = evaluate(-truth, truth)
    assert test.scene_picks.tolist() == truth.argmin(axis=1).tolist()
    np.testing.assert_array_equal(test.scene_regret, truth.max(axis=1) - truth.min(axis=1))
    assert test.scene_regret.mean() == test.regret


def test_all_actions_in_turn_cost_what_a_random_one_costs(prospects):
    percents = [
        evaluate(np.tile(np.eye(4)[a], (24, 1)), TK.values(prospects.features)).regret_percent
        for a in range(4)
    ]
    assert np.mean(percents) == pytest.approx(100.0)


def test_knowing_nothing_is_calibrated_but_uninformed(prospects):
    test = evaluate(np.zeros((24, 4)), TK.values(prospects.features))
    assert test.nll == pytest.approx(np.log(2.0))
    assert test.calibration.count.tolist() == [0, 0, 0, 0, 0, 24 * 6 * 2, 0, 0, 0, 0]
    assert test.calibration.preferred[5] == pytest.approx(0.5)
    assert np.isnan(test.calibration.predicted[0])


def test_calibration_counts_every_pair_from_both_sides(prospects):
    test = evaluate(0.5 * TK.values(prospects.features), TK.values(prospects.features))
    calibration = test.calibration
    assert calibration.count.sum() == 24 * 6 * 2
    assert calibration.count.tolist() == calibration.count[::-1].tolist()
    # half the values are half as decided as they should be
    assert calibration.preferred[7] > calibration.predicted[7]


def test_nothing_to_choose_from_costs_nothing(prospects):
    alike = replace(prospects, features=np.ones(prospects.features.shape))
    assert evaluate(np.zeros((24, 4)), TK.values(alike.features)).regret_percent == 0.0
