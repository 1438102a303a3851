"""How well learnt values do in held-out scenes: regret, agreement, likelihood, calibration."""

from dataclasses import dataclass

import numpy as np

from learners.arrays import FloatArray, IntArray
from learners.asking.preferences import all_pairs, first_log_odds, probability
from learners.judging.teachers import BETA

CALIBRATION_BINS = 10  # equal bins that predicted probabilities, 0 to 1, are sorted into


@dataclass(frozen=True)
class Calibration:
    """Whether people prefer as often as predicted, in bins of predicted probability.

    Every pair is counted from both sides, so the lower half mirrors the upper one.
    The means are not a number in bins without predictions.
    """

    count: IntArray  # [bins], how many predictions fall into the bin
    predicted: FloatArray  # [bins], the mean of these predictions
    preferred: FloatArray  # [bins], the mean probability with which the teacher does as predicted


@dataclass(frozen=True)
class Evaluation:
    """How a learner's choices suit the teacher.

    Attributes:
        regret: mean over scenes of V_teacher(best action) − V_teacher(picked action).
        regret_percent: the same in % of what an action picked at random would cost.
        agreement: share of scenes in which the teacher's best action is picked, 0 to 1.
        nll: expected negative log-likelihood of the teacher's answers to all pairs of the scenes,
            nats a pair.
        nll_teacher: the same if the teacher's own values predicted them: the least possible.
        calibration: of the predicted answers to all pairs of the scenes.
        scene_regret: [S], V_teacher(best action) − V_teacher(picked action) in each scene.
        scene_picks: [S], place of the action that the learner picks there.
    """

    regret: float
    regret_percent: float
    agreement: float
    nll: float
    nll_teacher: float
    calibration: Calibration
    scene_regret: FloatArray
    scene_picks: IntArray


def evaluate(
    values: FloatArray, truth: FloatArray, beta: float = BETA, teacher_beta: float | None = None
) -> Evaluation:
    """Measure learnt values of prospects [S, A] against the truth, their values to the teacher.

    The learner picks the action of the highest learnt value, the first of equal ones. If in no
    scene any action is better than another, the regret is 0 %. `beta` is the β that the learner
    takes choices to have, `teacher_beta` that of the teacher; the same if left out.
    """
    best = truth.max(axis=1)
    picks = values.argmax(axis=1)
    got = np.take_along_axis(truth, picks[:, None], axis=1)[:, 0]
    regret = float((best - got).mean())
    random_regret = float((best - truth.mean(axis=1)).mean())

    pairs = all_pairs(*truth.shape)
    log_odds = first_log_odds(values, pairs, beta)
    true_log_odds = first_log_odds(truth, pairs, beta if teacher_beta is None else teacher_beta)
    preferred = probability(true_log_odds)
    return Evaluation(
        regret=regret,
        regret_percent=100.0 * regret / random_regret if random_regret > 0.0 else 0.0,
        agreement=float((got == best).mean()),
        nll=_cross_entropy(preferred, log_odds),
        nll_teacher=_cross_entropy(preferred, true_log_odds),
        calibration=_calibrate(probability(log_odds), preferred),
        scene_regret=best - got,
        scene_picks=picks,
    )


def _cross_entropy(preferred: FloatArray, log_odds: FloatArray) -> float:
    losses = preferred * np.logaddexp(0.0, -log_odds)
    losses += (1.0 - preferred) * np.logaddexp(0.0, log_odds)
    return float(losses.mean())


def _calibrate(predicted: FloatArray, preferred: FloatArray) -> Calibration:
    both_predicted = np.concatenate([predicted, 1.0 - predicted])
    both_preferred = np.concatenate([preferred, 1.0 - preferred])
    bins = np.minimum((both_predicted * CALIBRATION_BINS).astype(np.int64), CALIBRATION_BINS - 1)
    count = np.bincount(bins, minlength=CALIBRATION_BINS)
    with np.errstate(invalid="ignore"):
        mean_predicted, mean_preferred = (
            np.bincount(bins, weights=numbers, minlength=CALIBRATION_BINS) / count
            for numbers in (both_predicted, both_preferred)
        )
    return Calibration(count, mean_predicted, mean_preferred)
