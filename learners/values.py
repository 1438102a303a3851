"""What a prospect is worth: expected utility and cumulative prospect theory.

Everything here is batched over leading axes, takes tensors, arrays or lists, gives float64 tensors
and has finite gradients everywhere. The formulas are those of Tversky and Kahneman, "Advances in
Prospect Theory: Cumulative Representation of Uncertainty", J. Risk and Uncertainty 5 (1992).
"""

import numpy as np
import torch
from numpy.typing import ArrayLike
from torch import Tensor

from learners.arrays import finite_tensor, outcome_tensor, positive_tensor, probability_tensor
from learners.parameters import CptLike
from learners.weighting import Weighting, curvature, weigh

SMOOTHING = 1e-12
"""Outcomes smaller than this are valued in proportion to their size, in units of utility.

It keeps the slope finite at 0, where that of x^α is not: 27 with the `tk` profile, 251 with
`strong`. The error is largest at |x| near 1e-12, where it stays below 1e-10 for exponents of 0.8
and more, and vanishes as (1e-12/x)² relative to the value: below rounding from |x| = 1e-4 on.
"""


def expected_utility(
    utilities: Tensor | ArrayLike, probabilities: Tensor | ArrayLike | None = None
) -> Tensor:
    """Mean utility of prospects, V = Σ p_k u_k.

    Args:
        utilities: [..., K], one utility per outcome.
        probabilities: [..., K], that broadcast against the utilities; left out, every outcome
            has probability 1/K.

    Returns:
        [...], float64.

    Raises:
        InputError: if utilities are missing or not finite, or the probabilities are not such.
    """
    u = outcome_tensor(utilities)
    if probabilities is None:
        return u.mean(-1)
    return (probability_tensor(probabilities, u) * u).sum(-1)


def prospect_value(
    utilities: Tensor | ArrayLike,
    parameters: CptLike,
    probabilities: Tensor | ArrayLike | None = None,
    *,
    weighting: Weighting = "prelec",
    reference: Tensor | float = 0.0,
) -> Tensor:
    """Value of prospects in cumulative prospect theory, V = Σ π_k v(u_k − r).

    With all five parameters 1 and r = 0 this is the mean.

    Args:
        utilities: [..., K], one utility per outcome, in any order.
        parameters: anything with the five attributes of `CptParameters`, as floats or tensors.
        probabilities: [..., K], that broadcast against the utilities; left out, every outcome
            has probability 1/K.
        weighting: how probabilities are weighted, see `weight`.
        reference: r, what counts as neither gain nor loss; broadcasts against the utilities.

    Returns:
        [...], float64.

    Raises:
        InputError: if utilities are missing or not finite, the probabilities are not such, or a
            parameter is out of range.

    Example:
        >>> from learners import PROFILES
        >>> float(prospect_value([1.0, -1.0], PROFILES["eu"]))
        0.0
        >>> round(float(prospect_value([1.0, -1.0], PROFILES["tk"])), 3)
        -0.585
    """
    x = outcome_tensor(utilities, reference)
    weights = _decision_weights(x, parameters, probabilities, weighting)
    return (weights * value(x, parameters)).sum(-1)


def value(x: Tensor | ArrayLike, parameters: CptLike) -> Tensor:
    """Value v of gains and losses: x^α for x ≥ 0, −λ(−x)^η for x < 0 (equation 5).

    Computed as x·√(x² + ε²)^(α−1), which has a slope at 0 and is exact for α = 1; `SMOOTHING`
    is ε. At 0 the gradient is the one towards gains.

    Args:
        x: any shape, utility above (gain) or below (loss) the reference.
        parameters: as for `prospect_value`; α, η and λ are used.

    Returns:
        The values, float64.

    Raises:
        InputError: if an outcome is not finite or a parameter is out of range.
    """
    x = finite_tensor("x", x)
    is_gain = x >= 0.0
    exponent = torch.where(
        is_gain, positive_tensor("alpha", parameters.alpha), positive_tensor("eta", parameters.eta)
    )
    aversion = torch.where(is_gain, 1.0, positive_tensor("loss_aversion", parameters.loss_aversion))
    size = torch.hypot(x, x.new_tensor(SMOOTHING))
    return aversion * x * size ** (exponent - 1.0)


def decision_weights(
    utilities: Tensor | ArrayLike,
    parameters: CptLike,
    probabilities: Tensor | ArrayLike | None = None,
    *,
    weighting: Weighting = "prelec",
    reference: Tensor | float = 0.0,
) -> Tensor:
    """Decision weights π of outcomes: how much each counts (section 1.1).

    A loss counts w⁻(P of it or worse) − w⁻(P of worse), a gain w⁺(P of it or better) −
    w⁺(P of better). An outcome at the reference counts as a gain, which changes no value. Of
    outcomes that tie, the earlier counts as the worse; together they count what they must.
    In mixed prospects the weights need not sum to 1.

    Args:
        utilities: [..., K], one utility per outcome, in any order.
        parameters: as for `prospect_value`; γ and δ are used.
        probabilities: [..., K], that broadcast against the utilities; left out, every outcome
            has probability 1/K.
        weighting: how probabilities are weighted, see `weight`.
        reference: r, what counts as neither gain nor loss; broadcasts against the utilities.

    Returns:
        [..., K], float64, in the order of the utilities.

    Raises:
        InputError: if utilities are missing or not finite, the probabilities are not such, or a
            parameter is out of range.
    """
    x = outcome_tensor(utilities, reference)
    return _decision_weights(x, parameters, probabilities, weighting)


def _decision_weights(
    x: Tensor,
    parameters: CptLike,
    probabilities: Tensor | ArrayLike | None,
    weighting: Weighting,
) -> Tensor:
    gamma = curvature("gamma", parameters.gamma, weighting)
    delta = curvature("delta", parameters.delta, weighting)
    if probabilities is None:
        ranked, order = x.sort(stable=True)
        p = x.new_full((x.shape[-1],), 1.0 / x.shape[-1])
    else:
        p = probability_tensor(probabilities, x)
        shape = np.broadcast_shapes(x.shape, p.shape)
        ranked, order = x.expand(shape).sort(stable=True)
        p = p.expand(shape).gather(-1, order)
    # the K + 1 places at which the ranked outcomes can be cut into worse and better
    nothing = torch.zeros_like(p[..., :1])
    worse = torch.cat([nothing, p.cumsum(-1)], -1)
    better = torch.cat([p.flip(-1).cumsum(-1).flip(-1), nothing], -1)
    of_loss = weigh(worse, better, delta, weighting).diff(dim=-1)
    of_gain = -weigh(better, worse, gamma, weighting).diff(dim=-1)
    weights = torch.where(ranked >= 0.0, of_gain, of_loss).clamp(min=0.0)
    return torch.zeros_like(weights).scatter(-1, order.expand(weights.shape), weights)
