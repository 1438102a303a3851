"""How well a model explains choices: the objective that learners minimise.

It is the Bradley–Terry negative log-likelihood of the choices (Bradley and Terry, "Rank Analysis of
Incomplete Block Designs", Biometrika 39, 1952) plus a weak normal prior,

    f(z) = Σ ln(1 + exp(−β (V_preferred − V_other))) + ½ Σ ((z − mean) / deviation)²,

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
class Prior:
    """Independent normal distributions that the parameters are thought to come from."""

    mean: FloatArray  # [M]
    deviation: FloatArray  # [M], standard deviations


@dataclass(frozen=True)
class Survey:
    """The objective around one place.

    Attributes:
        z: [M], the place: parameters of the model.
        objective: f(z), nats.
        nll: the negative log-likelihood of the choices, which is f(z) without the prior, nats.
        gradient: [M], ∇f.
        hessian: [M, M], the expected Hessian β² Σ p (1 − p) J Jᵀ + 1/deviation², where J is the
            slope of a pair's difference of values. It is positive definite.
    """

    z: FloatArray
    objective: float
    nll: float
    gradient: FloatArray
    hessian: FloatArray


def survey(model: Model, choices: Choices, prior: Prior, z: FloatArray) -> Survey:
    """Evaluate the objective at a place."""
    values, slopes = model(z)
    margin = choices.beta * (values[choices.preferred] - values[choices.other])
    nll = float(np.logaddexp(0.0, -margin).sum())
    surprise = 0.5 - 0.5 * np.tanh(0.5 * margin)  # the probability of the opposite choice
    slope = choices.beta * (slopes[choices.preferred] - slopes[choices.other])
    away = (z - prior.mean) / prior.deviation
    # sums rather than matrix products, whose rounding may depend on the number of processors
    gradient = -(slope * surprise[:, None]).sum(axis=0) + away / prior.deviation
    spread = np.sqrt(surprise * (1.0 - surprise))[:, None] * slope
    hessian = np.einsum("ni,nj->ij", spread, spread) + np.diag(prior.deviation**-2.0)
    hessian += LEAST_CURVATURE * np.diag(np.diagonal(hessian))
    return Survey(z, nll + 0.5 * float((away**2).sum()), nll, gradient, hessian)
