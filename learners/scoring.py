"""Damped Fisher scoring: how a learner finds the values that best explain the choices.

The objective is the Bradley–Terry negative log-likelihood of the choices (Bradley and Terry, "Rank
Analysis of Incomplete Block Designs", Biometrika 39, 1952) plus a weak normal prior,

    f(z) = Σ ln(1 + exp(−β (V_preferred − V_other))) + ½ Σ ((z − mean) / deviation)²,

in nats. Each step solves (H + μ diag H) d = −∇f, where H is the expected Hessian
β² Σ p (1 − p) J Jᵀ + 1/deviation² with J the slope of a pair's difference of values, and μ is the
damping of Levenberg and Marquardt in the schedule of Nielsen ("Damping Parameter in Marquardt's
Method", IMM, Technical University of Denmark, 1999). H is positive definite, so every step leads
downhill, and the prior keeps the minimum finite also where the choices do not.

Values of cumulative prospect theory have a kink wherever two outcomes change places or one crosses
the reference. There are so many that the objective looks smooth from afar, and so that close to
the minimum a step may promise a decrease that no step delivers.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]

Model = Callable[[FloatArray], tuple[FloatArray, FloatArray]]
"""From parameters z [M] to the values [P] of prospects and their slopes [P, M]."""

ENOUGH = 1e-6
"""A fit has converged when the next step promises to lower the objective by less, in nats."""

MOST_STEPS = 200

MOST_DAMPING = 1e12


@dataclass(frozen=True)
class Choices:
    """Choices between prospects, and how consistent they are.

    Attributes:
        preferred: [N], place of the preferred prospect among the P of the model.
        other: [N], place of the other one.
        beta: β, the inverse temperature.
    """

    preferred: NDArray[np.int64]
    other: NDArray[np.int64]
    beta: float


@dataclass(frozen=True)
class Prior:
    """Independent normal distributions that the parameters are thought to come from.

    Attributes:
        mean: [M].
        deviation: [M], standard deviations.
    """

    mean: FloatArray
    deviation: FloatArray


@dataclass(frozen=True)
class Optimum:
    """Where the search ended.

    Attributes:
        z: [M], the parameters.
        objective: f(z), nats.
        nll: the part of it that is due to the choices, nats.
        expected_decrease: by how much an undamped step promises to lower f, nats.
        steps: how many steps were tried.
        converged: whether the search ended because there was nothing left to gain.
    """

    z: FloatArray
    objective: float
    nll: float
    expected_decrease: float
    steps: int
    converged: bool


@dataclass(frozen=True)
class _Local:
    """The objective around one place: its value, gradient and expected Hessian."""

    objective: float
    nll: float
    gradient: FloatArray
    hessian: FloatArray

    def expected_decrease(self) -> float:
        return 0.5 * float(self.gradient @ np.linalg.solve(self.hessian, self.gradient))


def minimise(
    model: Model,
    choices: Choices,
    prior: Prior,
    start: FloatArray,
    longest_step: FloatArray,
) -> Optimum:
    """Find the parameters that best explain the choices.

    Args:
        model: values and slopes of the prospects.
        choices: what was preferred to what.
        prior: what is thought of the parameters beforehand.
        start: [M], where to begin.
        longest_step: [M], how far each parameter may move in one step.
    """
    z, here = start, _survey(model, choices, prior, start)
    damping, growth, steps = 1e-3, 2.0, 0
    while steps < MOST_STEPS and damping < MOST_DAMPING and here.expected_decrease() > ENOUGH:
        steps += 1
        diagonal = np.diagonal(here.hessian)
        step = -np.linalg.solve(here.hessian + damping * np.diag(diagonal), here.gradient)
        step /= max(1.0, float(np.max(np.abs(step) / longest_step)))
        promised = -float(here.gradient @ step + 0.5 * step @ here.hessian @ step)
        there = _survey(model, choices, prior, z + step)
        kept = (here.objective - there.objective) / promised
        if kept > 1e-3:
            z, here = z + step, there
            damping *= max(1.0 / 3.0, 1.0 - (2.0 * kept - 1.0) ** 3)
            growth = 2.0
        else:
            damping *= growth
            growth *= 2.0
    left = here.expected_decrease()
    return Optimum(z, here.objective, here.nll, left, steps, left <= ENOUGH)


def _survey(model: Model, choices: Choices, prior: Prior, z: FloatArray) -> _Local:
    values, slopes = model(z)
    margin = choices.beta * (values[choices.preferred] - values[choices.other])
    nll = float(np.logaddexp(0.0, -margin).sum())
    surprise = 1.0 / (1.0 + np.exp(np.clip(margin, -700.0, 700.0)))  # probability of the other
    slope = choices.beta * (slopes[choices.preferred] - slopes[choices.other])
    away = (z - prior.mean) / prior.deviation
    # sums rather than matrix products, whose rounding may depend on the number of processors
    gradient = -(slope * surprise[:, None]).sum(axis=0) + away / prior.deviation
    spread = np.sqrt(surprise * (1.0 - surprise))[:, None] * slope
    hessian = np.einsum("ni,nj->ij", spread, spread) + np.diag(prior.deviation**-2.0)
    return _Local(nll + 0.5 * float(away @ away), nll, gradient, hessian)
