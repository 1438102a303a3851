"""What the study claims, on a bank like that of the paper. Run by name: pytest -m slow."""

import numpy as np
import pytest

from learners import (
    PARAMETER_COLUMNS,
    TEACHERS,
    attainable_precision,
    learning_curves,
    paired_differences,
    read_bank,
    run_study,
)

pytestmark = pytest.mark.slow

SEEDS = 20


@pytest.fixture(scope="module")
def bank(tmp_path_factory):
    # the one place where the learners' tests need a world to learn about
    from scenes.bank import BankPlan, write_bank

    path = tmp_path_factory.mktemp("claims") / "outcomes.parquet"
    write_bank(path, BankPlan(scenes=300))
    return read_bank(path)


@pytest.fixture(scope="module")
def table(bank):
    return run_study(bank, learners=["eu", "cpt", "cpt-tied"], seeds=SEEDS)


def curve(table, teacher, learner, column="regret_percent"):
    curves = learning_curves(table, column)
    return next(c for c in curves if (c.teacher, c.learner) == (teacher, learner))


def at(curve, pairs, field="mean"):
    return getattr(curve.at(pairs), field)


@pytest.mark.parametrize("learner", ["cpt", "cpt-tied"])
@pytest.mark.parametrize(("teacher", "share"), [("tk", 0.5), ("strong", 0.2)])
def test_the_matched_learner_wins_from_1000_pairs(table, teacher, share, learner):
    comparison = next(c for c in paired_differences(table, learner) if c.teacher == teacher)
    assert at(comparison, 1000, "ratio") <= share
    assert at(comparison, 1000, "high") < 0.0


def test_expected_utility_is_learned_sooner_without_more_to_learn(table):
    simple, flexible = (curve(table, "eu", learner) for learner in ("eu", "cpt"))
    for pairs in (25, 50, 100):
        assert at(simple, pairs) <= at(flexible, pairs)
    assert at(simple, 2000) < 0.5
    assert at(flexible, 2000) < 0.5


@pytest.mark.parametrize("teacher", ["tk", "strong"])
def test_the_matched_learner_goes_on_and_the_other_stalls(table, teacher):
    matched, other = (curve(table, teacher, learner) for learner in ("cpt", "eu"))
    assert (np.diff(matched.mean) < 0.0).all()
    assert at(matched, 2000) < 0.5 * at(matched, 500)
    assert at(other, 2000) > 0.6 * at(other, 500)


@pytest.mark.parametrize("learner", ["cpt", "cpt-tied"])
@pytest.mark.parametrize("teacher", TEACHERS)
def test_the_direction_of_the_reward_is_found_as_well_as_it_can_be(table, bank, teacher, learner):
    # two thirds of the bank are learned from, and a pair there tells as much as elsewhere
    best = attainable_precision(TEACHERS[teacher], bank, 2000, tied=learner == "cpt-tied")
    found = at(curve(table, teacher, learner, "theta_cosine"), 2000)
    assert 1.0 - found < 2.0 * (1.0 - best.theta_cosine)
    assert found > (0.99 if teacher == "strong" else 0.98)


@pytest.mark.parametrize(("place", "column"), list(enumerate(PARAMETER_COLUMNS)))
@pytest.mark.parametrize("teacher", TEACHERS)
def test_parameters_are_found_within_what_choices_can_tell(table, bank, teacher, place, column):
    best = attainable_precision(TEACHERS[teacher], bank, 2000)
    deviation = best.log_parameters[place]
    truth = TEACHERS[teacher].parameters.numbers[place]
    found = curve(table, teacher, "cpt", column)
    # the mean of 20 within three of its standard deviations, and a spread as wide as expected
    assert abs(np.log(at(found, 2000) / truth)) < 3.0 * deviation / np.sqrt(SEEDS) + 0.05
    assert 0.5 * deviation < at(found, 2000, "std") / truth < 2.0 * deviation


def test_every_fit_converged(table):
    assert np.mean(table["converged"].to_pylist()) > 0.995
