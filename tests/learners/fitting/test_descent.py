import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from learners.fitting.descent import ENOUGH, minimise
from learners.fitting.likelihood import Choices, Prior, survey
from learners.fitting.simplex import lowest_mixture

ONE = np.ones(1)


def linear(slopes):
    return lambda z: ((slopes * z).sum(axis=1), slopes)


class TestSurvey:
    def test_gradient_is_that_of_finite_differences(self):
        random = np.random.default_rng(0)
        slopes = random.normal(size=(6, 3))
        choices = Choices(random.integers(6, size=20), random.integers(6, size=20), beta=3.0)
        prior = Prior(random.normal(size=3), np.array([0.5, 1.0, 2.0]))
        z = random.normal(size=3)
        for place, slope in enumerate(survey(linear(slopes), choices, prior, z).gradient):
            step = 1e-6 * np.eye(3)[place]
            high, low = (
                survey(linear(slopes), choices, prior, z + h).objective for h in (step, -step)
            )
            assert slope == pytest.approx((high - low) / 2e-6, rel=1e-6)

    def test_hessian_of_a_linear_model_is_that_of_the_gradient(self):
        random = np.random.default_rng(1)
        slopes = random.normal(size=(6, 3))
        choices = Choices(random.integers(6, size=20), random.integers(6, size=20), beta=1.0)
        prior, z = Prior(np.zeros(3), np.ones(3)), random.normal(size=3)
        hessian = survey(linear(slopes), choices, prior, z).hessian
        for place in range(3):
            step = 1e-6 * np.eye(3)[place]
            high, low = (
                survey(linear(slopes), choices, prior, z + h).gradient for h in (step, -step)
            )
            np.testing.assert_allclose(hessian[place], (high - low) / 2e-6, rtol=1e-6, atol=1e-8)

    def test_certain_and_surprising_choices_do_not_overflow(self):
        for preferred in (0, 1):
            there = survey(
                lambda z: (np.array([1e6, 0.0]) * z, np.array([[1e6], [0.0]])),
                Choices(np.array([preferred]), np.array([1 - preferred]), beta=1e3),
                Prior(0.0 * ONE, ONE),
                ONE,
            )
            assert np.isfinite(there.objective)
            assert np.isfinite(there.gradient).all()


class TestMinimise:
    def test_smooth_minimum(self):
        # one choice for, two against, and a prior too vague to matter: the log-odds are ln 1/2
        choices = Choices(np.array([0, 1, 1]), np.array([1, 0, 0]), beta=2.0)
        found = minimise(
            linear(np.array([[1.0], [0.0]])), choices, Prior(0.0 * ONE, 1e6 * ONE), ONE, ONE
        )
        assert found.converged
        assert found.z[0] == pytest.approx(-np.log(2.0) / 2.0, abs=1e-4)
        assert found.nll == pytest.approx(np.log(3.0) + 2.0 * np.log(1.5), abs=1e-6)

    def test_minimum_on_a_kink(self):
        kink = np.array([0.3, -0.2])

        def model(z):
            # the dearer the further from the kink, in either direction
            away = z - kink
            value = -np.abs(away).sum() - 2.0 * np.abs(away.sum())
            return np.array([value, 0.0]), np.array(
                [-np.sign(away) - 2.0 * np.sign(away.sum()), np.zeros(2)]
            )

        choices = Choices(np.array([0]), np.array([1]), beta=1.0)
        prior = Prior(np.zeros(2), np.full(2, 10.0))
        found = minimise(model, choices, prior, np.array([-1.0, 1.0]), np.ones(2))
        assert found.converged
        assert found.expected_decrease <= ENOUGH
        np.testing.assert_allclose(found.z, kink, atol=1e-5)

    def test_says_when_it_did_not_arrive(self):
        def model(z):  # whose slopes are wrong
            return np.array([z[0], 0.0]), np.array([[-1.0], [0.0]])

        choices = Choices(np.array([0]), np.array([1]), beta=1.0)
        found = minimise(model, choices, Prior(0.0 * ONE, ONE), ONE, ONE)
        assert not found.converged
        assert found.expected_decrease > ENOUGH


class TestLowestMixture:
    @settings(deadline=None, derandomize=True)
    @given(st.integers(0, 10_000), st.integers(1, 12), st.integers(1, 4))
    def test_nothing_else_is_lower(self, seed, count, dimensions):
        random = np.random.default_rng(seed)
        vectors, linear = random.normal(size=(count, dimensions)), random.random(count)
        quadratic = vectors @ vectors.T
        mixture = lowest_mixture(quadratic, linear)
        assert mixture.min() >= 0.0
        assert mixture.sum() == pytest.approx(1.0)
        # the conditions of Karush, Kuhn and Tucker
        slopes = quadratic @ mixture + linear
        assert slopes.min() == pytest.approx(float(slopes @ mixture), abs=1e-6)

    def test_the_same_thing_twice(self):
        mixture = lowest_mixture(np.ones((3, 3)), np.zeros(3))
        assert mixture.sum() == pytest.approx(1.0)
