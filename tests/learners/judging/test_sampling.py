"""What values from few outcomes are worth."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from learners import PROFILES, expected_sample_value, prospect_value, resampled_values
from learners.judging.sampling import binomial_chances

repeatable = settings(deadline=None, derandomize=True, max_examples=40)


def some_utilities(seed: int, outcomes: int) -> np.ndarray:
    drawn = np.random.default_rng(seed).normal(0.1, 0.4, (3, outcomes))
    # ties, nothing, and a rare loss, as outcomes have them
    drawn[1] = np.round(drawn[1], 1)
    drawn[2, 0] = -2.0
    return drawn


@repeatable
@given(
    seed=st.integers(0, 10_000),
    outcomes=st.integers(1, 30),
    size=st.integers(1, 30),
    teacher=st.sampled_from(sorted(PROFILES)),
)
def test_a_draw_is_worth_what_its_outcomes_are_worth(seed, outcomes, size, teacher) -> None:
    worths, parameters = some_utilities(seed, outcomes), PROFILES[teacher]
    drawn = np.random.default_rng(seed + 1).integers(outcomes, size=(4, size))
    counts = np.array([np.bincount(draw, minlength=outcomes) for draw in drawn])
    expected = [prospect_value(worths[:, draw], parameters) for draw in drawn]
    [found] = resampled_values(worths, (parameters,), counts)
    np.testing.assert_allclose(found, expected, atol=1e-12)


@pytest.mark.parametrize("teacher", list(PROFILES))
def test_samples_are_worth_on_average_what_is_foretold(teacher: str) -> None:
    worths, parameters, size = some_utilities(0, 40), PROFILES[teacher], 12
    counts = np.random.default_rng(2).multinomial(size, np.full(40, 1 / 40), size=40_000)
    [values] = resampled_values(worths, (parameters,), counts)
    error = 5.0 * values.std(axis=0) / math.sqrt(len(values))
    foretold = expected_sample_value(worths, parameters, size)
    assert (np.abs(foretold - values.mean(axis=0)) < error).all()


def test_the_mean_of_a_sample_is_right_on_average_and_a_bent_value_is_not() -> None:
    worths = some_utilities(0, 1000)
    eu, strong = PROFILES["eu"], PROFILES["strong"]
    np.testing.assert_allclose(expected_sample_value(worths, eu, 50), worths.mean(axis=1))
    bias = expected_sample_value(worths, strong, 50) - prospect_value(worths, strong)
    assert (bias > 0.003).all()  # the rare loss is missing from most samples


def test_more_outcomes_are_less_off() -> None:
    worths, strong = some_utilities(3, 1000), PROFILES["strong"]
    exact = prospect_value(worths, strong)
    off = [expected_sample_value(worths, strong, size) - exact for size in (50, 500, 5000)]
    assert (np.abs(off[0]) > np.abs(off[1])).all()
    assert (np.abs(off[1]) > np.abs(off[2])).all()


def test_chances_are_binomial() -> None:
    chances = binomial_chances(3, np.array([0.0, 0.25, 1.0]))
    expected = [math.comb(3, n) * 0.25**n * 0.75 ** (3 - n) for n in range(4)]
    np.testing.assert_allclose(chances, [[1, 0, 0, 0], expected, [0, 0, 0, 1]], atol=1e-15)
    assert binomial_chances(5000, np.array([1e-4, 0.5, 0.9999])).sum(axis=1) == pytest.approx(1.0)
