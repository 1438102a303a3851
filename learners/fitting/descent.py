"""Fisher scoring across kinks: how a learner finds what best explains the choices.

Values of cumulative prospect theory have a kink wherever two outcomes change places or one crosses
the reference. These kinks are so dense that the minimum of the objective usually lies on one or
several of them, where the gradient jumps and a Newton step promises a decrease that no step
delivers. Therefore the gradients at all places that were tried are kept in a bundle and looked at
together (Lukšan and Vlček, "A Bundle-Newton Method for Nonsmooth Unconstrained Minimization",
Mathematical Programming 83, 1998). Around z, with H the expected Hessian of `likelihood.Survey`,
the objective is taken to be

    f(z) + max_j (g_j·d − e_j) + ½ d·H d,

where g_j is the gradient at place z_j, carried over to z along H. Its error e_j is how far the
quadratic model around z_j misses f(z), but at least ½ ‖z − z_j‖² in the metric of H, so that
gradients from far away count little. With the gradient at z alone the step is that of Fisher
scoring. The steps are damped as in the method of Levenberg and Marquardt, by adding μ diag H to H.

The decrease that the undamped model promises measures how far away the minimum is: when the promise
is almost nothing, some mixture of the gradients nearby is almost zero.
"""

from dataclasses import dataclass

import numpy as np

from learners.arrays import FloatArray
from learners.fitting.likelihood import Choices, Model, Prior, Survey, survey
from learners.fitting.simplex import lowest_mixture

ENOUGH = 1e-4
"""A fit has converged when the model promises to lower the objective by no more than this, nats."""

MOST_STEPS = 300

MOST_KEPT = 40
"""How many gradients are kept. A minimum needs at most one more of them than parameters."""

FAR = 1.0
"""Gradients from places further away are forgotten; ½ ‖z − z_j‖² in the metric of H, nats."""

LEAST_DAMPING, FIRST_DAMPING, MOST_DAMPING = 1e-6, 1e-3, 1e9

WORTHWHILE = 0.05
"""A step is taken if it delivers this share of what the model promises."""

PATIENCE = 3
"""How many steps may fail before the damping grows; each adds a gradient to the bundle."""


@dataclass(frozen=True)
class Optimum(Survey):
    """The objective around the place where the search ended.

    Attributes:
        expected_decrease: by how much the model still promises to lower f, nats.
        steps: how many steps were tried.
        converged: whether the promised decrease is as small as was asked for.
    """

    expected_decrease: float
    steps: int
    converged: bool


@dataclass(frozen=True)
class _Step:
    """The way d to the minimum of the model of the objective, and the decrease it promises."""

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
        choices: the choices among them.
        prior: what is thought of the parameters beforehand.
        start: [M], the parameters at which to begin.
        longest_step: [M], how far each parameter may move in one step.
        enough: the search ends when the model promises no larger decrease than this, nats.
    """
    here = survey(model, choices, prior, start)
    bundle = [here]
    damping, failed, steps = FIRST_DAMPING, 0, 0
    while True:
        bundle, gradients, errors = _carry_over(bundle[-MOST_KEPT:], here)
        damped = here.hessian + damping * np.diag(np.diagonal(here.hessian))
        step = _model_step(damped, gradients, errors)
        exhausted = steps == MOST_STEPS or damping > MOST_DAMPING
        # a damped model promises less: while it promises enough, the undamped one need not be asked
        if exhausted or step.decrease <= enough:
            left = _model_step(here.hessian, gradients, errors).decrease
            if exhausted or left <= enough:
                return Optimum(
                    **vars(here), expected_decrease=left, steps=steps, converged=left <= enough
                )

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
            # the current place stays last, so that it is never the one to be forgotten
            bundle = [*(seen for seen in bundle if seen is not here), there, here]
            failed += 1
            if failed > PATIENCE:
                damping *= 2.0


def _carry_over(bundle: list[Survey], here: Survey) -> tuple[list[Survey], FloatArray, FloatArray]:
    """The near part of the bundle, its gradients [J, M] carried over to here, their errors [J]."""
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
