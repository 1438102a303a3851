import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from learners.fitting.simplex import lowest_mixture


@settings(deadline=None, derandomize=True)
@given(st.integers(0, 10_000), st.integers(1, 12), st.integers(1, 4))
def test_nothing_else_is_lower(seed, count, dimensions):
    random = np.random.default_rng(seed)
    vectors, linear = random.normal(size=(count, dimensions)), random.random(count)
    quadratic = vectors @ vectors.T
    mixture = lowest_mixture(quadratic, linear)
    assert mixture.min() >= 0.0
    assert mixture.sum() == pytest.approx(1.0)
    # the conditions of Karush, Kuhn and Tucker
    slopes = quadratic @ mixture + linear
    assert slopes.min() == pytest.approx(float(slopes @ mixture), abs=1e-6)


def test_the_same_thing_twice():
    mixture = lowest_mixture(np.ones((3, 3)), np.zeros(3))
    assert mixture.sum() == pytest.approx(1.0)
