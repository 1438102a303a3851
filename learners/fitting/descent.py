"""Fisher scoring across kinks: how a learner finds what best explains the choices.

Values of cumulative prospect theory have a kink wherever two outcomes change places or one crosses
the reference. There are so many that the minimum of the objective usually lies on some, where the
gradient jumps and a Newton step promises a decrease that no step delivers. Therefore gradients of
the places that were tried are kept in a bundle and looked at together (Lukšan and Vlček, "A
Bundle-Newton Method for Nonsmooth Unconstrained Minimization", Mathematical Programming 83, 1998).
Around z, with H the expected Hessian of `likelihood.Survey`, the objective is taken to be

    f(z) + max_j (g_j·d − e_j) + ½ d·H d,

where g_j is gradient j, carried over to z along H, and e_j, its error, is how far off f(z) its
quadratic model is, though at least ½ ‖z − z_j‖² in the metric of H, so that what was seen far away
counts little. With the gradient at z alone the step is that of Fisher scoring. The steps are damped
as Levenberg's and Marquardt's are, by adding μ diag H to H.

How much the undamped model promises is a measure of how far the minimum is: when it is as good as
nothing, some mixture of gradients nearby is as good as zero.
"""

from dataclasses import dataclass

import numpy as np

from learners.arrays import FloatArray
from learners.fitting.likelihood import Choices, Model, Prior, Survey, survey
from learners.fitting.simplex import lowest_mixture

ENOUGH = 1e-4
"""A fit has converged when the model promises to lower the objective by no more, in nats."""

MOST_STEPS = 300

MOST_KEPT = 40
"""How many gradients are kept. Those needed at a minimum are at most one more than parameters."""

FAR = 1.0
"""Gradients are forgotten from places as far as this, ½ ‖z − z_j‖² in the metric of H, in nats."""

LEAST_DAMPING, FIRST_DAMPING, MOST_DAMPING = 1e-6, 1e-3, 1e9

WORTHWHILE = 0.05
"""A step is taken if it delivers this share of what the model promises."""

PATIENCE = 3
"""So many steps may fail before the damping grows; each teaches the model one more gradient."""


@dataclass(frozen=True)
class Optimum:
    """Where the search ended.

    Attributes:
        z: [M], the parameters.
        objective: f(z), nats.
        nll: the part of it that is due to the choices, nats.
        expected_decrease: by how much the model still promises to lower f, nats.
        steps: how many steps were tried.
        converged: whether that is no more than was asked for.
    """

    z: FloatArray
    objective: float
    nll: float
    expected_decrease: float
    steps: int
    converged: bool


@dataclass(frozen=True)
class _Step:
    """The minimum of the model of the objective: where, and how much lower."""

    d: FloatArray
    decrease: float


def minimise(
    model: Model,
    choices: Choices,
    prior: Prior,
    start: FloatArray,
    longest_step: FloatArray,
    enough: float = ENOUGH,
) -> Optimum:
    """Find the parameters that best explain the choices.

    Args:
        model: values and slopes of the prospects.
        choices: what was preferred to what.
        prior: what is thought of the parameters beforehand.
        start: [M], where to begin.
        longest_step: [M], how far each parameter may move in one step.
        enough: the search ends when no more than this is promised, in nats.
    """
    here = survey(model, choices, prior, start)
    bundle = [here]
    damping, failed, steps = FIRST_DAMPING, 0, 0
    while True:
        bundle, gradients, errors = _carry_over(bundle[-MOST_KEPT:], here)
        damped = here.hessian + damping * np.diag(np.diagonal(here.hessian))
        step = _model_step(damped, gradients, errors)
        exhausted = steps == MOST_STEPS or damping > MOST_DAMPING
        # a damped model promises less, so the undamped one need not be asked before
        if exhausted or step.decrease <= enough:
            left = _model_step(here.hessian, gradients, errors).decrease
            if exhausted or left <= enough:
                return Optimum(here.z, here.objective, here.nll, left, steps, left <= enough)

        steps += 1
        d = step.d / max(1.0, float(np.max(np.abs(step.d) / longest_step)))
        promised = -float(np.max(gradients @ d - errors) + 0.5 * d @ here.hessian @ d)
        there = survey(model, choices, prior, here.z + d)
        delivered = here.objective - there.objective
        if delivered > WORTHWHILE * promised:
            bundle.append(there)
            here, failed = there, 0
            if delivered > 0.5 * promised:
                damping = max(damping / 3.0, LEAST_DAMPING)
        else:
            # before the current place, which is never the one to be forgotten
            bundle = [*(seen for seen in bundle if seen is not here), there, here]
            failed += 1
            if failed > PATIENCE:
                damping *= 2.0


def _carry_over(bundle: list[Survey], here: Survey) -> tuple[list[Survey], FloatArray, FloatArray]:
    """What of the bundle is near, its gradients [J, M] as they would be here, their errors [J]."""
    away = here.z - np.array([seen.z for seen in bundle])
    bend = away @ here.hessian
    distance = 0.5 * (bend * away).sum(axis=1)
    near = np.flatnonzero(distance <= FAR)
    bundle = [bundle[place] for place in near]
    away, bend, distance = away[near], bend[near], distance[near]
    gradients = np.array([seen.gradient for seen in bundle])
    predicted = [seen.objective for seen in bundle] + (gradients * away).sum(axis=1) + distance
    errors = np.maximum(np.abs(here.objective - predicted), distance)
    return bundle, gradients + bend, errors


def _model_step(hessian: FloatArray, gradients: FloatArray, errors: FloatArray) -> _Step:
    """Minimise max_j (g_j·d − e_j) + ½ d·H d, by way of the dual problem."""
    mixture = lowest_mixture(gradients @ np.linalg.solve(hessian, gradients.T), errors)
    gradient = mixture @ gradients
    d = np.asarray(-np.linalg.solve(hessian, gradient), dtype=np.float64)
    return _Step(d, float(mixture @ errors - 0.5 * gradient @ d))
