"""How likely something feels: probability weighting.

A weighting function w maps [0, 1] onto [0, 1], and its slope is infinite at both ends when its
curvature is below 1. With curvature 0.5, a probability that misses 1 by one rounding error, 1e-16,
has a weight that misses 1 by 1e-8. Therefore a probability p is handed around together with its
complement 1 − p, each exact where it is small, and logarithms are taken of the smaller of the two.
"""

from __future__ import annotations

from collections.abc import Callable
from types import ModuleType
from typing import TYPE_CHECKING, Literal, overload

import numpy as np

from learners.arrays import (
    Array,
    FloatArray,
    Numbers,
    NumbersOrTensor,
    finite_array,
    namespace,
    positive_array,
)
from learners.errors import InputError

if TYPE_CHECKING:
    from torch import Tensor

Weighting = Literal["prelec", "tversky-kahneman"]

TVERSKY_KAHNEMAN_LOWEST = 0.27921
"""Least curvature at which the weighting of Tversky and Kahneman is monotone.

The slope touches 0 at 0.279204, rounded up here (Ingersoll, "Non-monotonicity of the
Tversky–Kahneman probability-weighting function", European Financial Management 14, 2008).
"""


@overload
def weight(probability: Numbers, gamma: Numbers, *, weighting: Weighting = ...) -> FloatArray: ...  # type: ignore[overload-overlap]
@overload
def weight(
    probability: NumbersOrTensor, gamma: NumbersOrTensor, *, weighting: Weighting = ...
) -> Tensor: ...
def weight(
    probability: NumbersOrTensor, gamma: NumbersOrTensor, *, weighting: Weighting = "prelec"
) -> Array:
    """Weight w(p) of a probability.

    `prelec` is w(p) = exp(−(−ln p)^γ) (Prelec, "The Probability Weighting Function",
    Econometrica 66, 1998, proposition 1 with β = 1). `tversky-kahneman` is
    w(p) = p^γ / (p^γ + (1 − p)^γ)^(1/γ) (Tversky and Kahneman, "Advances in Prospect Theory",
    J. Risk and Uncertainty 5, 1992, equation 6). Both are p itself when γ = 1.

    w(0) = 0 and w(1) = 1 for every γ. The gradient there, infinite for γ < 1, is given as 1, so
    that all gradients are finite.

    Args:
        probability: p, any shape, 0 to 1.
        gamma: curvature, γ for gains and δ for losses, above 0; it must broadcast against
            `probability`.
        weighting: which function.

    Returns:
        The weights, float64, 0 to 1: a tensor if a tensor is given, else an array.

    Raises:
        InputError: if a probability or the curvature is out of range, or the weighting unknown.

    Example:
        >>> weight([0.0, 0.01, 1.0], 0.5).round(decimals=3).tolist()
        [0.0, 0.117, 1.0]
    """
    xp = namespace(probability, gamma)
    p = finite_array("probability", probability, xp)
    outside = p[(p < 0.0) | (p > 1.0)]
    if len(outside):
        raise InputError(f"probability {outside[0].item()} is not allowed: 0 to 1")
    return weigh(p, 1.0 - p, curvature("gamma", gamma, weighting, xp), weighting)


def curvature(
    field: str, given: NumbersOrTensor, weighting: Weighting, xp: ModuleType = np
) -> Array:
    """The curvature as a float64 array of a namespace, checked for this weighting.

    Raises:
        InputError: if the weighting is unknown, or not monotone with this curvature.
    """
    if weighting not in _FUNCTIONS:
        raise InputError(f"weighting {weighting!r} is not allowed: {' or '.join(_FUNCTIONS)}")
    checked = positive_array(field, given, xp)
    lowest = checked.min().item()
    if weighting == "tversky-kahneman" and lowest < TVERSKY_KAHNEMAN_LOWEST:
        raise InputError(
            f"{field} {lowest} is not allowed with the tversky-kahneman weighting: "
            f"{TVERSKY_KAHNEMAN_LOWEST} or more, below which it is not monotone"
        )
    return checked


def weigh(p: Array, complement: Array, gamma: Array, weighting: Weighting) -> Array:
    """Weight w(p) of a probability whose complement 1 − p is known as exactly as p itself.

    The arguments are not checked: `weight` is the function for callers.
    """
    xp = namespace(p)
    inside = (p > 0.0) & (complement > 0.0)
    is_smaller = p <= complement
    # not `minimum`, which at p = 1/2 would split a tensor's gradient between p and 1 − p; and 1/2
    # at the ends, because gradients through `where` need finite numbers on both of its branches
    smaller = xp.where(inside, xp.where(is_smaller, p, complement), 0.5)
    log_smaller, log_larger = xp.log(smaller), xp.log1p(-smaller)
    log_p = xp.where(is_smaller, log_smaller, log_larger)
    log_complement = xp.where(is_smaller, log_larger, log_smaller)
    # an overflow here leads to exp(−∞), a weight of 0, as it should
    with np.errstate(over="ignore"):
        weights = _FUNCTIONS[weighting](log_p, log_complement, gamma, xp)
    return xp.clip(xp.where(inside, weights, p), 0.0, 1.0)


def _prelec(log_p: Array, log_complement: Array, gamma: Array, xp: ModuleType) -> Array:  # noqa: ARG001
    return xp.exp(-((-log_p) ** gamma))


def _tversky_kahneman(log_p: Array, log_complement: Array, gamma: Array, xp: ModuleType) -> Array:
    both = xp.logaddexp(gamma * log_p, gamma * log_complement)
    return xp.exp(gamma * log_p - both / gamma)


_FUNCTIONS: dict[str, Callable[[Array, Array, Array, ModuleType], Array]] = {
    "prelec": _prelec,
    "tversky-kahneman": _tversky_kahneman,
}
