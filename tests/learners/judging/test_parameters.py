from dataclasses import FrozenInstanceError, asdict, replace

import numpy as np
import pytest

from learners import PROFILES, REWARD, CptParameters, InputError


def test_profiles_are_the_three_teachers_in_order():
    assert {name: tuple(asdict(profile).values()) for name, profile in PROFILES.items()} == {
        "eu": (1.0, 1.0, 1.0, 1.0, 1.0),
        "tk": (0.88, 0.88, 2.25, 0.61, 0.69),
        "strong": (0.80, 0.80, 3.00, 0.50, 0.50),
    }
    assert list(PROFILES) == ["eu", "tk", "strong"]


def test_fields_are_in_the_order_of_the_papers():
    assert list(asdict(PROFILES["tk"])) == ["alpha", "eta", "loss_aversion", "gamma", "delta"]


def test_reward_is_the_one_of_the_study():
    assert REWARD == (0.10, -0.20, 0.30, 0.05, -0.25)


def test_parameters_cannot_be_changed():
    with pytest.raises(FrozenInstanceError):
        PROFILES["tk"].alpha = 1.0


@pytest.mark.parametrize("name", asdict(PROFILES["eu"]))
@pytest.mark.parametrize("wrong", [0.0, -1.0, float("nan"), float("inf"), "1", None, 1j, [1.0]])
def test_a_parameter_that_is_not_a_finite_number_above_0_is_refused_by_name(name, wrong):
    with pytest.raises(InputError) as refusal:
        replace(PROFILES["eu"], **{name: wrong})
    assert str(refusal.value) == f"{name} {wrong!r} is not allowed: a finite number above 0"


def test_integers_and_numpy_numbers_are_allowed():
    assert CptParameters(1, 1, np.float32(2.0), np.int64(1), np.float64(1.0)).loss_aversion == 2.0
