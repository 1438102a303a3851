"""How likely something feels: probability weighting.

A weighting function w takes [0, 1] onto [0, 1], and its slope is infinite at both ends when its
curvature is below 1. With curvature 0.5, a probability that misses 1 by one rounding error, 1e-16,
has a weight that misses 1 by 1e-8. Therefore a probability p is handed around together with its
complement 1 − p, each exact where it is small, and logarithms are taken of the smaller one.
"""

from collections.abc import Callable
from typing import Literal

import torch
from numpy.typing import ArrayLike
from torch import Tensor

from learners.arrays import finite_tensor, positive_tensor
from learners.errors import InputError

Weighting = Literal["prelec", "tversky-kahneman"]

TVERSKY_KAHNEMAN_LOWEST = 0.27921
"""Least curvature at which the weighting of Tversky and Kahneman is monotone.

The slope touches 0 at 0.279204, rounded up here (Ingersoll, "Non-monotonicity of the
Tversky–Kahneman probability-weighting function", European Financial Management 14, 2008).
"""


def weight(
    probability: Tensor | ArrayLike, gamma: Tensor | float, *, weighting: Weighting = "prelec"
) -> Tensor:
    """Weight w(p) of a probability.

    `prelec` is w(p) = exp(−(−ln p)^γ) (Prelec, "The Probability Weighting Function",
    Econometrica 66, 1998, proposition 1 with β = 1). `tversky-kahneman` is
    w(p) = p^γ / (p^γ + (1 − p)^γ)^(1/γ) (Tversky and Kahneman, "Advances in Prospect Theory",
    J. Risk and Uncertainty 5, 1992, equation 6). Both are p itself when γ = 1.

    w(0) = 0 and w(1) = 1 whatever γ is. The slope there, which is infinite for γ < 1, is given
    as 1, so that no gradient is ever infinite or not a number.

    Args:
        probability: p, any shape, 0 to 1.
        gamma: curvature, γ for gains and δ for losses, above 0; a tensor must broadcast
            against `probability`.
        weighting: which function.

    Returns:
        The weights, float64, 0 to 1.

    Raises:
        InputError: if a probability or the curvature is out of range, or the weighting unknown.

    Example:
        >>> weight([0.0, 0.01, 1.0], 0.5).round(decimals=3).tolist()
        [0.0, 0.117, 1.0]
    """
    p = finite_tensor("probability", probability)
    outside = p.detach()[(p.detach() < 0.0) | (p.detach() > 1.0)]
    if outside.numel():
        raise InputError(f"probability {outside[0].item()} is not allowed: 0 to 1")
    return weigh(p, 1.0 - p, curvature("gamma", gamma, weighting), weighting)


def curvature(field: str, given: Tensor | float, weighting: Weighting) -> Tensor:
    """The curvature as a float64 tensor, checked for the weighting that it is meant for.

    Raises:
        InputError: if the weighting is unknown, or not monotone with this curvature.
    """
    if weighting not in _FUNCTIONS:
        raise InputError(f"weighting {weighting!r} is not allowed: {' or '.join(_FUNCTIONS)}")
    tensor = positive_tensor(field, given)
    lowest = tensor.detach().min().item()
    if weighting == "tversky-kahneman" and lowest < TVERSKY_KAHNEMAN_LOWEST:
        raise InputError(
            f"{field} {lowest} is not allowed with the tversky-kahneman weighting: "
            f"{TVERSKY_KAHNEMAN_LOWEST} or more, below which it is not monotone"
        )
    return tensor


def weigh(p: Tensor, complement: Tensor, gamma: Tensor, weighting: Weighting) -> Tensor:
    """Weight w(p) of a probability whose complement 1 − p is known as exactly as p itself.

    The arguments are not checked: `weight` is the function for callers.
    """
    inside = (p > 0.0) & (complement > 0.0)
    is_smaller = p <= complement
    # not torch.minimum, which at p = 1/2 would halve the gradient between p and 1 − p, and
    # 1/2 at the ends because `where` spoils gradients unless its input is harmless too
    smaller = torch.where(inside, torch.where(is_smaller, p, complement), 0.5)
    log_smaller, log_larger = smaller.log(), torch.log1p(-smaller)
    log_p = torch.where(is_smaller, log_smaller, log_larger)
    log_complement = torch.where(is_smaller, log_larger, log_smaller)
    weights = _FUNCTIONS[weighting](log_p, log_complement, gamma)
    return torch.where(inside, weights, p).clamp(0.0, 1.0)


def _prelec(log_p: Tensor, log_complement: Tensor, gamma: Tensor) -> Tensor:  # noqa: ARG001
    return torch.exp(-((-log_p) ** gamma))


def _tversky_kahneman(log_p: Tensor, log_complement: Tensor, gamma: Tensor) -> Tensor:
    both = torch.logaddexp(gamma * log_p, gamma * log_complement)
    return torch.exp(gamma * log_p - both / gamma)


_FUNCTIONS: dict[str, Callable[[Tensor, Tensor, Tensor], Tensor]] = {
    "prelec": _prelec,
    "tversky-kahneman": _tversky_kahneman,
}
