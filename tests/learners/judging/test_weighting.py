import doctest
import math
from functools import partial

import numpy as np
import pytest
import torch
from hypothesis import given, settings
from hypothesis import strategies as st

import learners.judging.weighting
from learners import InputError, weight
from learners.judging.weighting import TVERSKY_KAHNEMAN_LOWEST

WEIGHTINGS = ["prelec", "tversky-kahneman"]
either_weighting = pytest.mark.parametrize("weighting", WEIGHTINGS)
repeatable = settings(deadline=None, derandomize=True)
probability = st.floats(0.0, 1.0)
curvature = st.floats(0.28, 3.0)


def closed_form(p, gamma, weighting):
    if p in (0.0, 1.0):
        return p
    if weighting == "prelec":
        return math.exp(-((-math.log(p)) ** gamma))
    return p**gamma / (p**gamma + (1 - p) ** gamma) ** (1 / gamma)


def test_the_examples_in_the_docstrings_hold():
    assert doctest.testmod(learners.judging.weighting) == doctest.TestResults(failed=0, attempted=1)


@either_weighting
@repeatable
@given(probability, curvature)
def test_weight_is_the_closed_form(weighting, p, gamma):
    assert weight(p, gamma, weighting=weighting).item() == pytest.approx(
        closed_form(p, gamma, weighting), rel=1e-9, abs=1e-300
    )


@either_weighting
@repeatable
@given(probability, probability, curvature)
def test_weight_is_monotone_and_stays_within_0_and_1(weighting, one, other, gamma):
    low, high = weight(sorted([one, other]), gamma, weighting=weighting)
    assert 0.0 <= low <= high + 1e-15
    assert high <= 1.0


@either_weighting
@repeatable
@given(curvature)
def test_certainty_and_impossibility_are_not_distorted(weighting, gamma):
    assert weight([0.0, 1.0], gamma, weighting=weighting).tolist() == [0.0, 1.0]


@either_weighting
def test_curvature_1_distorts_nothing(weighting):
    p = torch.linspace(0.0, 1.0, 1001, dtype=torch.float64)
    torch.testing.assert_close(weight(p, 1.0, weighting=weighting), p, rtol=0.0, atol=1e-15)
    np.testing.assert_allclose(weight(p.numpy(), 1.0, weighting=weighting), p, rtol=0.0, atol=1e-15)


@either_weighting
@repeatable
@given(st.lists(probability, min_size=1), curvature)
def test_arrays_and_tensors_agree(weighting, p, gamma):
    array = weight(p, gamma, weighting=weighting)
    assert isinstance(array, np.ndarray)
    assert array.dtype == np.float64
    numbers = torch.tensor(p, dtype=torch.float64)
    for tensor in (
        weight(numbers, gamma, weighting=weighting),
        weight(p, torch.tensor(gamma, dtype=torch.float64), weighting=weighting),
    ):
        assert tensor.dtype == torch.float64
        np.testing.assert_allclose(array, tensor, rtol=0.0, atol=1e-15)


def test_prelec_crosses_the_diagonal_at_one_over_e():
    assert weight(1 / math.e, 0.37).item() == pytest.approx(1 / math.e, abs=1e-15)


@either_weighting
@pytest.mark.parametrize("gamma", [0.3, 0.61, 1.0, 1.7])
def test_gradients_are_those_of_finite_differences(weighting, gamma):
    # 0.5 is where the computation changes sides
    p = torch.tensor([1e-3, 0.2, 0.5, 0.7, 0.999], dtype=torch.float64, requires_grad=True)
    gammas = torch.tensor(gamma, dtype=torch.float64, requires_grad=True)
    assert torch.autograd.gradcheck(partial(weight, weighting=weighting), (p, gammas))


@either_weighting
@pytest.mark.parametrize("gamma", [0.3, 1.0, 2.5])
def test_gradients_are_finite_at_the_ends(weighting, gamma):
    p = torch.tensor([0.0, 1e-300, 1 - 2**-53, 1.0], dtype=torch.float64, requires_grad=True)
    gammas = torch.tensor(gamma, dtype=torch.float64, requires_grad=True)
    weight(p, gammas, weighting=weighting).sum().backward()
    assert torch.isfinite(p.grad).all()
    assert p.grad[[0, -1]].tolist() == [1.0, 1.0]
    assert torch.isfinite(gammas.grad)


@either_weighting
def test_a_batch_of_curvatures_broadcasts(weighting):
    p = torch.linspace(0.0, 1.0, 5)
    gammas = torch.tensor([[0.5], [0.9]])
    batch = weight(p, gammas, weighting=weighting)
    loop = torch.stack([weight(p, gamma, weighting=weighting) for gamma in (0.5, gammas[1])])
    assert batch.dtype == torch.float64
    torch.testing.assert_close(batch, loop, rtol=0.0, atol=1e-15)


def test_the_lowest_curvature_of_tversky_and_kahneman_is_where_monotony_ends():
    p = np.linspace(1e-4, 0.5, 200_001)

    def steepest_descent(gamma):
        return np.diff(p**gamma / (p**gamma + (1 - p) ** gamma) ** (1 / gamma)).min()

    assert steepest_descent(TVERSKY_KAHNEMAN_LOWEST) > 0.0
    assert steepest_descent(TVERSKY_KAHNEMAN_LOWEST - 2e-5) < 0.0
    weight(0.5, TVERSKY_KAHNEMAN_LOWEST, weighting="tversky-kahneman")
    with pytest.raises(InputError, match=r"^gamma 0\.27 is not allowed.*0\.27921 or more"):
        weight(0.5, 0.27, weighting="tversky-kahneman")


def test_prelec_has_no_lowest_and_no_highest_curvature():
    assert weight(0.5, 0.01).item() == pytest.approx(closed_form(0.5, 0.01, "prelec"))
    assert weight([0.01, 0.5, 0.99], 1e3).tolist() == [0.0, 1.0, 1.0]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (([0.5, 1.1], 0.5), r"probability 1\.1 is not allowed: 0 to 1"),
        ((-0.1, 0.5), r"probability -0\.1 is not allowed: 0 to 1"),
        ((math.nan, 0.5), r"probability contains nan: only finite numbers are allowed"),
        (("half", 0.5), r"probability of type str is not allowed: an array of numbers"),
        ((0.5, 0.0), r"gamma 0\.0 is not allowed: a finite number above 0"),
        ((0.5, math.inf), r"gamma contains inf: only finite numbers are allowed"),
    ],
)
def test_wrong_input_is_refused_by_name(arguments, message):
    with pytest.raises(InputError, match=f"^{message}$"):
        weight(*arguments)


def test_an_unknown_weighting_is_refused():
    with pytest.raises(InputError) as refusal:
        weight(0.5, 0.5, weighting="linear")
    assert str(refusal.value) == ("weighting 'linear' is not allowed: prelec or tversky-kahneman")
