"""What a prospect is worth: expected utility and cumulative prospect theory.

Every function is batched over leading axes and takes tensors, arrays or lists. If one argument or
one parameter is a tensor, the result is a tensor, whose gradients are finite everywhere; otherwise
it is an array, or a number of NumPy where it has no axes. Either is float64. The formulas are those
of Tversky and Kahneman, "Advances in Prospect Theory: Cumulative Representation of Uncertainty",
J. Risk and Uncertainty 5 (1992).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Protocol, overload

from learners.arrays import (
    Array,
    FloatArray,
    Numbers,
    NumbersOrTensor,
    finite_array,
    namespace,
    outcome_array,
    positive_array,
    probability_array,
    take_along,
)
from learners.judging.parameters import CptLike
from learners.judging.weighting import Weighting, curvature, weigh

if TYPE_CHECKING:
    from torch import Tensor

SMOOTHING = 1e-12
"""Outcomes smaller than this are valued in proportion to their size, in units of utility.

It keeps the slope at 0 finite, where the slope of x^α is infinite: 27 with the `tk` profile, 251
with `strong`. The error is largest for |x| near 1e-12, where it stays below 1e-10 for exponents of
0.8 and more. Relative to the value it vanishes as (1e-12/x)², and is below rounding from
|x| = 1e-4 on.
"""


class _OfOutcomes(Protocol):
    """A function of prospects that gives an array, or a tensor if it is given a tensor."""

    @overload
    def __call__(  # type: ignore[overload-overlap]
        self,
        utilities: Numbers,
        parameters: CptLike[Numbers],
        probabilities: Numbers | None = ...,
        *,
        weighting: Weighting = ...,
        reference: Numbers = ...,
    ) -> FloatArray: ...
    @overload
    def __call__(
        self,
        utilities: NumbersOrTensor,
        parameters: CptLike[NumbersOrTensor],
        probabilities: NumbersOrTensor | None = ...,
        *,
        weighting: Weighting = ...,
        reference: NumbersOrTensor = ...,
    ) -> Tensor: ...


def _of_outcomes(function: Callable[..., Array]) -> _OfOutcomes:
    """Tell type checkers what a function of prospects gives; it is handed back as it is."""
    return function


@overload
def expected_utility(utilities: Numbers, probabilities: Numbers | None = ...) -> FloatArray: ...  # type: ignore[overload-overlap]
@overload
def expected_utility(
    utilities: NumbersOrTensor, probabilities: NumbersOrTensor | None = ...
) -> Tensor: ...
def expected_utility(
    utilities: NumbersOrTensor, probabilities: NumbersOrTensor | None = None
) -> Array:
    """Mean utility of prospects, V = Σ p_k u_k.

    Args:
        utilities: [..., K], one utility per outcome.
        probabilities: [..., K], that broadcast against the utilities; left out, every outcome
            has probability 1/K.

    Returns:
        [...], float64.

    Raises:
        InputError: if utilities are missing or not finite, or the probabilities are wrong.
    """
    u = outcome_array(utilities, namespace(utilities, probabilities))
    if probabilities is None:
        return u.mean(-1)
    return (probability_array(probabilities, u) * u).sum(-1)


@_of_outcomes
def prospect_value(
    utilities: NumbersOrTensor,
    parameters: CptLike[NumbersOrTensor],
    probabilities: NumbersOrTensor | None = None,
    *,
    weighting: Weighting = "prelec",
    reference: NumbersOrTensor = 0.0,
) -> Array:
    """Value of prospects in cumulative prospect theory, V = Σ π_k v(u_k − r).

    With all five parameters 1 and r = 0 this is the mean.

    Args:
        utilities: [..., K], one utility per outcome, in any order.
        parameters: anything with the five attributes of `CptParameters`, as floats, arrays or
            tensors.
        probabilities: [..., K], that broadcast against the utilities; left out, every outcome
            has probability 1/K.
        weighting: how probabilities are weighted, see `weight`.
        reference: r, what counts as neither gain nor loss; broadcasts against the utilities.

    Returns:
        [...], float64.

    Raises:
        InputError: if utilities are missing or not finite, the probabilities are wrong, or a
            parameter is out of range.

    Example:
        >>> from learners import PROFILES
        >>> float(prospect_value([1.0, -1.0], PROFILES["eu"]))
        0.0
        >>> round(float(prospect_value([1.0, -1.0], PROFILES["tk"])), 3)
        -0.585
    """
    a = parameters
    xp = namespace(
        utilities, probabilities, reference, a.alpha, a.eta, a.loss_aversion, a.gamma, a.delta
    )
    x = outcome_array(utilities, xp, reference)
    weights = decision_weights(x, parameters, probabilities, weighting=weighting)
    return (weights * value(x, parameters)).sum(-1)


@overload
def value(x: Numbers, parameters: CptLike[Numbers]) -> FloatArray: ...  # type: ignore[overload-overlap]
@overload
def value(x: NumbersOrTensor, parameters: CptLike[NumbersOrTensor]) -> Tensor: ...
def value(x: NumbersOrTensor, parameters: CptLike[NumbersOrTensor]) -> Array:
    """Value v of gains and losses: x^α for x ≥ 0, −λ(−x)^η for x < 0 (equation 5).

    Computed as x·√(x² + ε²)^(α−1), ε being `SMOOTHING`, which has a finite slope at 0 and is
    exact for α = 1. At 0 the gradient is that of gains.

    Args:
        x: any shape, utility above (gain) or below (loss) the reference.
        parameters: as for `prospect_value`; α, η and λ are used.

    Raises:
        InputError: if an outcome is not finite or a parameter is out of range.
    """
    a = parameters
    xp = namespace(x, a.alpha, a.eta, a.loss_aversion)
    outcomes = finite_array("x", x, xp)
    is_gain = outcomes >= 0.0
    exponent = xp.where(
        is_gain, positive_array("alpha", a.alpha, xp), positive_array("eta", a.eta, xp)
    )
    loss_aversion = positive_array("loss_aversion", a.loss_aversion, xp)
    aversion = xp.where(is_gain, 1.0, loss_aversion)
    size = xp.hypot(outcomes, xp.full_like(outcomes, SMOOTHING))
    return aversion * outcomes * size ** (exponent - 1.0)


@_of_outcomes
def decision_weights(
    utilities: NumbersOrTensor,
    parameters: CptLike[NumbersOrTensor],
    probabilities: NumbersOrTensor | None = None,
    *,
    weighting: Weighting = "prelec",
    reference: NumbersOrTensor = 0.0,
) -> Array:
    """Decision weights π of outcomes: how much each counts (section 1.1).

    A loss counts w⁻(P of it or worse) − w⁻(P of worse), a gain w⁺(P of it or better) −
    w⁺(P of better). An outcome at the reference counts as a gain, which changes no value. Of
    outcomes that tie, the earlier counts as the worse, which does not change their total. The
    weights of a prospect that has gains and losses need not sum to 1.

    The arguments are those of `prospect_value`; of the parameters γ and δ are used.

    Returns:
        [..., K], float64, in the order of the utilities.

    Raises:
        InputError: if utilities are missing or not finite, the probabilities are wrong, or a
            parameter is out of range.
    """
    xp = namespace(utilities, probabilities, reference, parameters.gamma, parameters.delta)
    x = outcome_array(utilities, xp, reference)
    gamma = curvature("gamma", parameters.gamma, weighting, xp)
    delta = curvature("delta", parameters.delta, weighting, xp)
    order = xp.argsort(x, axis=-1, stable=True)
    ranked = take_along(x, order)
    if probabilities is None:
        p = xp.full(x.shape[-1:], 1.0 / x.shape[-1], dtype=x.dtype, device=x.device)
    else:
        p = take_along(probability_array(probabilities, x), order)
    # the K + 1 places at which the ranked outcomes can be cut into worse and better
    nothing = xp.zeros_like(p[..., :1])
    worse = xp.concatenate([nothing, xp.cumsum(p, -1)], -1)
    better = xp.concatenate([xp.flip(xp.cumsum(xp.flip(p, (-1,)), -1), (-1,)), nothing], -1)
    of_loss = xp.diff(weigh(worse, better, delta, weighting))
    of_gain = -xp.diff(weigh(better, worse, gamma, weighting))
    weights = xp.clip(xp.where(ranked >= 0.0, of_gain, of_loss), 0.0, None)
    return take_along(weights, xp.argsort(order, axis=-1))  # back into the order of the utilities
