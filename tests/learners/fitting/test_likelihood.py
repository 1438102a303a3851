import numpy as np
import pytest

from learners.fitting.likelihood import Choices, survey


def linear(slopes):
    return lambda z: ((slopes * z).sum(axis=1), slopes)


def test_gradient_is_that_of_finite_differences():
    random = np.random.default_rng(0)
    slopes = random.normal(size=(6, 3))
    choices = Choices(random.integers(6, size=20), random.integers(6, size=20), beta=3.0)
    prior = np.array([0.5, 1.0, 2.0])
    z = random.normal(size=3)
    for place, slope in enumerate(survey(linear(slopes), choices, prior, z).gradient):
        step = 1e-6 * np.eye(3)[place]
        high, low = (survey(linear(slopes), choices, prior, z + h).objective for h in (step, -step))
        assert slope == pytest.approx((high - low) / 2e-6, rel=1e-6)


def test_hessian_of_a_linear_model_is_that_of_the_gradient():
    random = np.random.default_rng(1)
    slopes = random.normal(size=(6, 3))
    choices = Choices(random.integers(6, size=20), random.integers(6, size=20), beta=1.0)
    prior, z = np.ones(3), random.normal(size=3)
    hessian = survey(linear(slopes), choices, prior, z).hessian
    for place in range(3):
        step = 1e-6 * np.eye(3)[place]
        high, low = (survey(linear(slopes), choices, prior, z + h).gradient for h in (step, -step))
        np.testing.assert_allclose(hessian[place], (high - low) / 2e-6, rtol=1e-6, atol=1e-8)


def test_certain_and_surprising_choices_do_not_overflow():
    for preferred in (0, 1):
        there = survey(
            lambda z: (np.array([1e6, 0.0]) * z, np.array([[1e6], [0.0]])),
            Choices(np.array([preferred]), np.array([1 - preferred]), beta=1e3),
            np.ones(1),
            np.ones(1),
        )
        assert np.isfinite(there.objective)
        assert np.isfinite(there.gradient).all()
