"""How well a model explains choices: the objective that learners minimise.

It is the Bradley–Terry negative log-likelihood of the choices (Bradley and Terry, "Rank Analysis of
Incomplete Block Designs", Biometrika 39, 1952) plus a weak normal prior around the origin,

    f(z) = Σ ln(1 + exp(−β (V_preferred − V_other))) + ½ Σ (z / deviation)²,

in nats. The prior keeps the minimum finite where the choices do not, for example where a model can
explain every single choice (separable choices).
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from learners.arrays import FloatArray, IntArray

Model = Callable[[FloatArray], tuple[FloatArray, FloatArray]]
"""From parameters z [M] to the values [P] of prospects and their slopes [P, M]."""

LEAST_CURVATURE = 1e-12
"""Share of its diagonal that is added to the Hessian, so that rounding cannot make it singular."""


@dataclass(frozen=True)
class Choices:
    """N choices between prospects, and how decided they are."""

    preferred: IntArray  # [N], places of the preferred prospects among the P of the model
    other: IntArray  # [N], places of the others
    beta: float  # β, the inverse temperature


@dataclass(frozen=True)
class Survey:
    """The objective around one place; J is the slope of a pair's difference of values there."""

    z: FloatArray  # [M], the place: parameters of the model
    objective: float  # f(z), nats
    nll: float  # f(z) without the prior, nats
    gradient: FloatArray  # [M], ∇f
    hessian: FloatArray  # [M, M], expected: β² Σ p (1 − p) J Jᵀ + 1/deviation², positive definite


def survey(model: Model, choices: Choices, deviation: FloatArray, z: FloatArray) -> Survey:
    """Evaluate the objective at a place; the prior has the standard deviations `deviation` [M]."""
    values, slopes = model(z)
    margin = choices.beta * (values[choices.preferred] - values[choices.other])
    nll = float(np.logaddexp(0.0, -margin).sum())
    surprise = 0.5 - 0.5 * np.tanh(0.5 * margin)  # the probability of the opposite choice
    slope = choices.beta * (slopes[choices.preferred] - slopes[choices.other])
    away = z / deviation
    # sums rather than matrix products, whose rounding may depend on the number of processors
    gradient = -(slope * surprise[:, None]).sum(axis=0) + away / deviation
    spread = np.sqrt(surprise * (1.0 - surprise))[:, None] * slope
    hessian = np.einsum("ni,nj->ij", spread, spread) + np.diag(deviation**-2.0)
    hessian += LEAST_CURVATURE * np.diag(np.diagonal(hessian))
    return Survey(z, nll + 0.5 * float((away**2).sum()), nll, gradient, hessian)
