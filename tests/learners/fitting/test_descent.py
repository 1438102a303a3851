import numpy as np
import pytest

from learners.fitting.descent import ENOUGH, minimise
from learners.fitting.likelihood import Choices

ONE = np.ones(1)


def linear(slopes):
    return lambda z: ((slopes * z).sum(axis=1), slopes)


def test_smooth_minimum():
    # one choice for, two against, and a prior too vague to matter: the log-odds are ln 1/2
    choices = Choices(np.array([0, 1, 1]), np.array([1, 0, 0]), beta=2.0)
    found = minimise(linear(np.array([[1.0], [0.0]])), choices, 1e6 * ONE, ONE, ONE)
    assert found.converged
    assert found.z[0] == pytest.approx(-np.log(2.0) / 2.0, abs=1e-4)
    assert found.nll == pytest.approx(np.log(3.0) + 2.0 * np.log(1.5), abs=1e-6)


def test_minimum_on_a_kink():
    kink = np.array([0.3, -0.2])

    def model(z):
        # the dearer the further from the kink, in either direction
        away = z - kink
        value = -np.abs(away).sum() - 2.0 * np.abs(away.sum())
        return np.array([value, 0.0]), np.array(
            [-np.sign(away) - 2.0 * np.sign(away.sum()), np.zeros(2)]
        )

    choices = Choices(np.array([0]), np.array([1]), beta=1.0)
    prior = np.full(2, 10.0)
    found = minimise(model, choices, prior, np.array([-1.0, 1.0]), np.ones(2))
    assert found.converged
    assert found.expected_decrease <= ENOUGH
    np.testing.assert_allclose(found.z, kink, atol=1e-5)


def test_says_when_it_did_not_arrive():
    def model(z):  # whose slopes are wrong
        return np.array([z[0], 0.0]), np.array([[-1.0], [0.0]])

    choices = Choices(np.array([0]), np.array([1]), beta=1.0)
    found = minimise(model, choices, ONE, ONE, ONE)
    assert not found.converged
    assert found.expected_decrease > ENOUGH
