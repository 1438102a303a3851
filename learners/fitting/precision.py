"""How precisely a teacher can be known from a number of choices, at best."""

from dataclasses import dataclass

import numpy as np

from learners.arrays import FloatArray
from learners.asking.preferences import all_pairs
from learners.asking.prospects import Prospects
from learners.errors import InputError
from learners.fitting.cpt import TIED, UNTIED, prior_deviation
from learners.fitting.fits import REWARD_DEVIATION
from learners.fitting.likelihood import Choices, survey
from learners.fitting.slopes import feature_planes, value_slopes
from learners.judging.teachers import Teacher


@dataclass(frozen=True)
class Precision:
    """Standard deviations that no learner can expect to stay below."""

    theta: FloatArray  # [D], of θ
    log_parameters: FloatArray  # [5], of ln α, ln η, ln λ, ln γ, ln δ; about relative errors
    theta_cosine: float  # the cosine between θ and the truth that is to be expected


def attainable_precision(
    teacher: Teacher, prospects: Prospects, count: int, *, tied: bool = False
) -> Precision:
    """Precision that choices about random pairs of these prospects allow.

    It is the inverse of the Fisher information of `count` choices together with the prior of
    `CptLearner` (the bound of Cramér and Rao, "Mathematical Methods of Statistics", 1946, section
    32.6), with the kinks of values left aside. With too few choices to tell the parameters apart,
    the result owes more to the prior than to the teacher.

    Args:
        teacher: who chooses, with Prelec weights.
        prospects: what the choices are about.
        count: how many choices.
        tied: whether the learner knows that α = η and γ = δ.

    Raises:
        InputError: if the count or the teacher's weighting is not allowed.
    """
    if count < 1:
        raise InputError(f"pairs {count} is not allowed: 1 or more")
    if teacher.weighting != "prelec":
        raise InputError(f"weighting {teacher.weighting!r} is not allowed: prelec")
    scenes, actions, outcomes, features = prospects.features.shape
    planes = feature_planes(prospects.features.reshape(scenes * actions, outcomes, features))
    ties = TIED if tied else UNTIED
    reward = np.array(teacher.reward)
    worth = value_slopes(planes, reward, teacher.reference, teacher.parameters)
    slopes = np.concatenate([worth.by_theta, worth.by_log_parameters @ ties.T], axis=1)

    pairs = all_pairs(scenes, actions)
    choices = Choices(
        pairs.scenes * actions + pairs.first, pairs.scenes * actions + pairs.second, teacher.beta
    )
    vague = np.full(slopes.shape[1], 1e9)  # a prior that says nothing
    each = survey(lambda _: (worth.values, slopes), choices, vague, 0.0 * vague).hessian
    deviation = prior_deviation(features, ties, REWARD_DEVIATION)
    covariance = np.linalg.inv(count / len(pairs.scenes) * each + np.diag(deviation**-2.0))
    of_theta = covariance[:features, :features]
    length = np.sqrt((reward**2).sum())
    across = np.eye(features) - np.outer(reward, reward) / length**2
    # the tangent of the angle to the truth has this mean square, to first order
    tangent_square = np.trace(across @ of_theta @ across) / length**2
    return Precision(
        theta=np.sqrt(np.diagonal(of_theta)),
        log_parameters=np.sqrt(np.diagonal(covariance)[features:] @ ties),
        theta_cosine=float(1.0 / np.sqrt(1.0 + tangent_square)),
    )
