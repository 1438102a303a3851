from dataclasses import fields
from types import SimpleNamespace

import numpy as np
import pytest
import torch
from hypothesis import given, settings
from hypothesis import strategies as st

from learners import PROFILES, CptParameters, decision_weights, prospect_value, weight
from learners.fitting.slopes import feature_planes, prelec_steps, value_slopes

repeatable = settings(deadline=None, derandomize=True, max_examples=40)
people = st.builds(
    CptParameters,
    alpha=st.floats(0.5, 1.5),
    eta=st.floats(0.5, 1.5),
    loss_aversion=st.floats(0.3, 5.0),
    gamma=st.floats(0.2, 1.5),
    delta=st.floats(0.2, 1.5),
)


def draw(seed, outcomes):
    random = np.random.default_rng(seed)
    return random.random((6, outcomes, 5)), random.normal(0.0, 0.4, 5), random.normal(0.0, 0.1)


def autograd(features, theta, reference, parameters):
    """Values and slopes by way of the definition in `learners.judging.values`."""

    def values(theta, reference, logs):
        names = [field.name for field in fields(CptParameters)]
        mind = SimpleNamespace(**dict(zip(names, logs.exp(), strict=True)))
        return prospect_value(torch.from_numpy(features) @ theta, mind, reference=reference)

    places = tuple(
        torch.tensor(p, dtype=torch.float64) for p in (theta, reference, np.log(parameters.numbers))
    )
    slopes = torch.autograd.functional.jacobian(values, places)
    return values(*places).numpy(), *(slope.numpy() for slope in slopes)


@repeatable
@given(st.integers(0, 10_000), st.integers(1, 50), people)
def test_values_and_slopes_are_those_of_the_definition(seed, outcomes, parameters):
    features, theta, reference = draw(seed, outcomes)
    ours = value_slopes(feature_planes(features), theta, reference, parameters)
    values, by_theta, by_reference, by_logs = autograd(features, theta, reference, parameters)
    np.testing.assert_allclose(ours.values, values, rtol=1e-9, atol=1e-12)
    np.testing.assert_allclose(ours.by_theta, by_theta, rtol=1e-9, atol=1e-12)
    np.testing.assert_allclose(ours.by_reference, by_reference, rtol=1e-9, atol=1e-12)
    np.testing.assert_allclose(ours.by_log_parameters, by_logs, rtol=1e-9, atol=1e-12)


@pytest.mark.parametrize("parameters", PROFILES.values(), ids=PROFILES)
def test_slopes_are_those_of_finite_differences(parameters):
    features, theta, reference = draw(3, 9)
    planes = feature_planes(features)

    def values(z):
        return value_slopes(planes, z[:5], z[5], CptParameters(*np.exp(z[6:]))).values

    z = np.concatenate([theta, [reference], np.log(parameters.numbers)])
    ours = value_slopes(planes, theta, reference, parameters)
    slopes = np.column_stack([ours.by_theta, ours.by_reference, ours.by_log_parameters])
    for place, slope in enumerate(slopes.T):
        step = 1e-6 * np.eye(len(z))[place]
        difference = (values(z + step) - values(z - step)) / 2e-6
        np.testing.assert_allclose(slope, difference, rtol=1e-5, atol=1e-7)


def test_everything_is_finite_at_the_reference_and_at_ties():
    for features in (np.zeros((3, 4, 5)), np.ones((3, 4, 5))):
        ours = value_slopes(feature_planes(features), np.ones(5), 0.0, PROFILES["strong"])
        for numbers in vars(ours).values():
            assert np.isfinite(numbers).all()


def test_expected_utility_is_the_mean():
    features, theta, _ = draw(0, 50)
    ours = value_slopes(feature_planes(features), theta, 0.0, PROFILES["eu"])
    np.testing.assert_allclose(ours.values, (features @ theta).mean(axis=1), rtol=1e-12)
    np.testing.assert_allclose(ours.by_theta, features.mean(axis=1), rtol=1e-12)


def test_a_prospect_is_valued_the_same_bits_in_any_company():
    features, theta, reference = draw(1, 50)
    whole = value_slopes(feature_planes(features), theta, reference, PROFILES["tk"])
    for place in range(len(features)):
        part = value_slopes(
            feature_planes(features[place : place + 1]), theta, reference, PROFILES["tk"]
        )
        for name, numbers in vars(part).items():
            assert np.array_equal(numbers[0], getattr(whole, name)[place])


@pytest.mark.parametrize("curvature", [0.3, 0.61, 1.0, 1.4])
@pytest.mark.parametrize("outcomes", [1, 2, 50])
def test_steps_are_decision_weights(outcomes, curvature):
    steps, slopes = prelec_steps(outcomes, curvature)
    mind = CptParameters(1.0, 1.0, 1.0, 1.0, curvature)
    losses = np.arange(-outcomes, 0.0)
    np.testing.assert_allclose(steps, decision_weights(losses, mind), atol=1e-14)
    places = np.arange(outcomes + 1) / outcomes
    high, low = (np.diff(weight(places, curvature + h)) for h in (1e-6, -1e-6))
    np.testing.assert_allclose(slopes, (high - low) / 2e-6, atol=1e-8)
