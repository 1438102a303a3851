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
from learners.fitting.likelihood import Choices, Model, Survey, survey
from learners.fitting.simplex import lowest_mixture

ENOUGH = 1e-4
"""A fit has converged when the model promises to lower the objective by no more than this, nats."""

MOST_STEPS = 300  # steps that are tried before a fit ends without having converged
MOST_KEPT = 40  # gradients in the bundle; a minimum needs at most one more than parameters
FAR = 1.0  # ½ ‖z − z_j‖² in the metric of H, nats, beyond which a gradient is forgotten
LEAST_DAMPING, FIRST_DAMPING, MOST_DAMPING = 1e-6, 1e-3, 1e9  # values of μ
WORTHWHILE = 0.05  # share of the promised decrease that a step must deliver to be taken
PATIENCE = 3  # steps that may fail before μ grows; each adds a gradient to the bundle


@dataclass(frozen=True)
class Optimum(Survey):
    """The objective around the place where the search ended."""

    expected_decrease: float  # by how much the model still promises to lower f, nats
    steps: int  # how many steps were tried
    converged: bool  # whether the promised decrease is as small as was asked for


def minimise(
    model: Model,
    choices: Choices,
    deviation: FloatArray,
    start: FloatArray,
    longest_step: FloatArray,
    enough: float = ENOUGH,
) -> Optimum:
    """Find the parameters that best explain the choices.

    Args:
        model: values and slopes of the prospects.
        choices: the choices among them.
        deviation: [M], standard deviations of the prior of the parameters, around 0.
        start: [M], the parameters at which to begin.
        longest_step: [M], how far each parameter may move in one step.
        enough: the search ends when the model promises no larger decrease than this, nats.
    """
    here = survey(model, choices, deviation, start)
    bundle = [here]
    damping, failed, steps = FIRST_DAMPING, 0, 0
    while True:
        bundle, gradients, errors = _carry_over(bundle[-MOST_KEPT:], here)
        damped = here.hessian + damping * np.diag(np.diagonal(here.hessian))
        way, decrease = _model_step(damped, gradients, errors)
        exhausted = steps == MOST_STEPS or damping > MOST_DAMPING
        # a damped model promises less: while it promises enough, the undamped one need not be asked
        if exhausted or decrease <= enough:
            _, left = _model_step(here.hessian, gradients, errors)
            if exhausted or left <= enough:
                return Optimum(
                    **vars(here), expected_decrease=left, steps=steps, converged=left <= enough
                )

        steps += 1
        d = way / max(1.0, float(np.max(np.abs(way) / longest_step)))
        promised = -float(np.max(gradients @ d - errors) + 0.5 * d @ here.hessian @ d)
        there = survey(model, choices, deviation, here.z + d)
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


def _model_step(
    hessian: FloatArray, gradients: FloatArray, errors: FloatArray
) -> tuple[FloatArray, float]:
    """The d that minimises max_j (g_j·d − e_j) + ½ d·H d, and the decrease that it promises."""
    # the dual problem is one of mixtures of the gradients
    mixture = lowest_mixture(gradients @ np.linalg.solve(hessian, gradients.T), errors)
    gradient = mixture @ gradients
    d = np.asarray(-np.linalg.solve(hessian, gradient), dtype=np.float64)
    return d, float(mixture @ errors - 0.5 * gradient @ d)
