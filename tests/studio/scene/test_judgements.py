import numpy as np
import pytest

from learners import PROFILES, value
from studio.scene.judgements import Judgement, Reference


def judgement(*values: float, teacher: str = "eu") -> Judgement:
    given = np.array(values)
    return Judgement(teacher, PROFILES[teacher], given, given[None])


@pytest.mark.parametrize("teacher", list(PROFILES))
def test_a_sure_utility_is_worth_what_the_prospect_is_worth(teacher: str) -> None:
    values = np.array([-1.3, -0.02, 0.0, 0.004, 0.6])
    sure = judgement(*values, teacher=teacher).certainty_equivalents
    np.testing.assert_allclose(value(sure, PROFILES[teacher]), values, atol=1e-10)


def test_the_largest_value_ranks_first_and_of_equal_ones_the_earlier() -> None:
    assert judgement(0.1, 0.3, 0.1, -2.0).ranks.tolist() == [1, 0, 2, 3]


def test_discordant_pairs_are_those_that_are_preferred_the_other_way_round() -> None:
    one, other = judgement(3.0, 2.0, 1.0), judgement(1.0, 2.0, 1.5)
    assert one.discordant_pairs(other) == [(0, 1), (0, 2)]
    assert other.discordant_pairs(one) == [(1, 0), (2, 0)]
    assert one.discordant_pairs(one) == []


def test_a_tie_contradicts_nobody() -> None:
    assert judgement(1.0, 1.0).discordant_pairs(judgement(0.0, 1.0)) == []


def test_the_best_of_some_actions_is_the_best_among_these() -> None:
    every = judgement(0.5, 0.1, 0.2)
    some = every.of([2, 1])
    assert some.values.tolist() == [0.2, 0.1]
    assert (every.best, some.best) == (0, 0)


def drawn(*picks: int, best: int | None = None) -> Judgement:
    """A judgement of three actions of which each draw of rollouts makes one the best."""
    resampled = np.eye(3)[list(picks)]
    reference = None
    if best is not None:
        values = np.eye(3)[best]
        reference = Reference(np.zeros((3, 7)), values, np.zeros(3))
    return Judgement("eu", PROFILES["eu"], resampled.mean(axis=0), resampled, reference)


def test_a_pick_is_what_nearly_all_draws_lead_to() -> None:
    sure = drawn(*[1] * 95, *[0] * 5)
    assert sure.shares.tolist() == [0.05, 0.95, 0.0]
    assert (sure.candidates, sure.is_sure) == ((1,), True)


def test_what_may_be_the_pick_is_told_with_the_likeliest_first() -> None:
    open_pick = drawn(*[1] * 60, *[2] * 34, *[0] * 6)
    assert (open_pick.candidates, open_pick.is_sure) == ((1, 2, 0), False)
    assert drawn(*[1] * 60, *[2] * 36, *[0] * 4).candidates == (1, 2)


def test_a_pick_that_more_rollouts_deny_is_open() -> None:
    assert drawn(*[1] * 100, best=1).candidates == (1,)
    assert drawn(*[1] * 100, best=2).candidates == (1, 2)


def test_the_interval_of_a_difference_is_that_of_the_two_in_the_same_draws() -> None:
    shared = np.random.default_rng(0).normal(size=(500, 1))
    resampled = shared + np.array([0.3, 0.1])  # both are lucky together
    both = Judgement("eu", PROFILES["eu"], np.array([0.3, 0.1]), resampled)
    difference = both.difference(0, 1)
    assert difference.value == pytest.approx(0.2)
    assert (difference.low, difference.high) == pytest.approx((0.2, 0.2))
    assert both.difference(1, 0).value == pytest.approx(-0.2)


def test_some_actions_are_as_sure_as_if_there_were_no_others() -> None:
    three = drawn(*[1] * 60, *[2] * 36, *[0] * 4, best=2)
    two = three.of([2, 0])
    assert two.shares.tolist() == [0.96, 0.04]  # of equally good ones the first
    assert two.reference is not None
    assert two.reference.values.tolist() == [1.0, 0.0]
