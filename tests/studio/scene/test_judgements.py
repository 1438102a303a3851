import numpy as np
import pytest

from learners import PROFILES, value
from studio.scene.judgements import Judgement


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
