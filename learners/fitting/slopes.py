"""Values of prospects together with their slopes, which a learner climbs.

`values.prospect_value` is the definition, for any probabilities; here every outcome of a prospect
has probability 1/K. Then the decision weight of a gain depends only on how many outcomes are
better, and that of a loss only on how many are worse. So the weights of all prospects are two lists
of K numbers, and sorting the utilities once gives all the order that values and slopes need. The
order does not change within a small enough neighbourhood, so the slopes are those of a sum of K
smooth terms.

This is NumPy rather than torch because all of it works number by number or row by row: the result
of a prospect is the same bits whatever stands beside it and however many processors there are.
"""

from dataclasses import dataclass

import numpy as np

from learners.arrays import FloatArray
from learners.judging.parameters import CptParameters
from learners.judging.values import SMOOTHING


@dataclass(frozen=True)
class ValueSlopes:
    """Values of P prospects, and how they change with the parameters."""

    values: FloatArray  # [P], V
    by_theta: FloatArray  # [P, D], ∂V/∂θ
    by_reference: FloatArray  # [P], ∂V/∂r
    by_log_parameters: FloatArray  # [P, 5], ∂V/∂ ln of α, η, λ, γ, δ


def feature_planes(features: FloatArray) -> FloatArray:
    """Features of prospects [P, K, D] as one contiguous plane for each feature, [D, P, K]."""
    return np.ascontiguousarray(np.moveaxis(features, -1, 0))


def value_slopes(
    planes: FloatArray, theta: FloatArray, reference: float, parameters: CptParameters
) -> ValueSlopes:
    """Value of prospects by cumulative prospect theory with Prelec weights, and its slopes.

    The features come as planes [D, P, K], θ as [D]; r is subtracted from the utilities θ·φ.
    """
    a = parameters
    x = np.einsum("d,dpk->pk", theta, planes) - reference
    count, outcomes = x.shape
    # where each sorted outcome stood, as a place in the flattened array
    places = (x.argsort(axis=1) + outcomes * np.arange(count)[:, None]).ravel()
    x = x.ravel()[places].reshape(count, outcomes)

    is_gain = x >= 0.0
    square = x * x
    smooth_square = square + SMOOTHING**2
    log_size = 0.5 * np.log(smooth_square)
    less_one = np.where(is_gain, a.alpha - 1.0, a.eta - 1.0)
    power = np.exp(less_one * log_size)
    worth = x * power  # v(x) without the loss aversion, which is a factor of the weights here
    steepness = power * (1.0 + less_one * (square / smooth_square))

    of_gain, of_gain_slope = (ranks[::-1] for ranks in prelec_steps(outcomes, a.gamma))
    of_loss, of_loss_slope = (a.loss_aversion * r for r in prelec_steps(outcomes, a.delta))
    weights = np.where(is_gain, of_gain, of_loss)
    weighted = weights * worth
    values = weighted.sum(axis=1)
    of_curvature = np.where(is_gain, of_gain_slope, of_loss_slope) * worth

    pull = np.empty(count * outcomes)  # ∂V/∂u of each outcome, in the order of the features
    pull[places] = (weights * steepness).ravel()
    pull = pull.reshape(count, outcomes)

    # the part of V that is due to gains; losses contribute the rest
    gains = np.where(is_gain, weighted, 0.0)
    by_alpha = np.einsum("pk,pk->p", gains, log_size)
    by_eta = np.einsum("pk,pk->p", weighted, log_size) - by_alpha
    by_gamma = np.where(is_gain, of_curvature, 0.0).sum(axis=1)
    by_delta = of_curvature.sum(axis=1) - by_gamma
    by_parameters = (
        a.alpha * by_alpha,
        a.eta * by_eta,
        values - gains.sum(axis=1),
        a.gamma * by_gamma,
        a.delta * by_delta,
    )
    return ValueSlopes(
        values=values,
        by_theta=np.einsum("pk,dpk->pd", pull, planes),
        by_reference=-pull.sum(axis=1),
        by_log_parameters=np.stack(by_parameters, axis=1),
    )


def prelec_steps(outcomes: int, curvature: float) -> tuple[FloatArray, FloatArray]:
    """Decision weights of K equally likely outcomes by rank from the extreme, and their slopes.

    The weight of the most extreme outcome is w(1/K), that of the next w(2/K) − w(1/K), and so on,
    where w is the weighting of Prelec (see `weighting.weight`).

    Returns:
        [K] weights and [K] derivatives with respect to the curvature.
    """
    minus_log = -np.log(np.arange(1, outcomes) / outcomes)  # of the probabilities inside (0, 1)
    raised = minus_log**curvature
    weights = np.concatenate([[0.0], np.exp(-raised), [1.0]])
    slopes = np.concatenate([[0.0], -np.exp(-raised) * raised * np.log(minus_log), [0.0]])
    return np.diff(weights), np.diff(slopes)
