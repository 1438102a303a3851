"""The ranges that all teachers' panels in a study's picture share."""

import itertools
from dataclasses import dataclass

import numpy as np

from learners import unit_vector, value
from studio.study.fits import parameters_of, pooled_calibration
from studio.study.results import StudyResults
from studio.style.ticks import round_range


@dataclass(frozen=True)
class Scales:
    """Ranges that the teachers' panels share, so that they can be compared.

    They hold what was found at every number of pairs, so that nothing moves but what is learned.
    """

    regret: tuple[float, float]  # in %, above 0
    agreement: float  # lowest share shown, in %
    reach: float  # largest utility of which the value is shown
    values: tuple[float, float]  # of the value functions
    calibration: float  # largest error of a prediction shown, in %
    theta: tuple[float, float]  # of the numbers of θ/‖θ‖
    parameters: tuple[float, float]  # of the numbers of `CptParameters`

    @classmethod
    def around(cls, results: StudyResults) -> "Scales":
        """Ranges that hold what the whole study found."""
        teachers = results.teachers
        low = results.regrets.start if results.curves("regret_percent") else 1.0
        regret = (low / 1.5, max(1.2 * (results.regrets.most or 10.0), 12.0 * low))
        shares = [float(min(curve.low.min(), 1.0)) for curve in results.curves("agreement")]
        lowest = min(100.0 * min(shares, default=0.0), 90.0)
        lengths = [float(np.linalg.norm(teacher.reward)) for teacher in teachers]
        _, reach = round_range(0.0, max(0.75 * max(lengths, default=0.4), 1e-3))
        truths = [value(np.array([-reach, reach]), teacher.parameters) for teacher in teachers]
        values = (
            min((1.15 * float(truth[0]) for truth in truths), default=-reach),
            max((1.35 * float(truth[1]) for truth in truths), default=reach),
        )
        rewards = [teacher.reward for teacher in teachers] + [fit["theta"] for fit in results.fits]
        theta = np.concatenate([*map(unit_vector, rewards), np.zeros(1)])
        people = [teacher.parameters for teacher in teachers]
        people += [learnt for learnt in map(parameters_of, results.fits) if learnt is not None]
        numbers = [0.5, 2.0, *itertools.chain(*(each.numbers for each in people))]
        return cls(
            regret,
            10.0 * np.floor(lowest / 10.0),
            reach,
            values,
            _largest_error(results),
            (max(float(theta.min()) - 0.05, -1.0), min(float(theta.max()) + 0.05, 1.0)),
            (max(min(numbers) / 1.1, 0.1), min(max(numbers) * 1.1, 10.0)),
        )


def _largest_error(results: StudyResults) -> float:
    """The largest error of predictions at any number of pairs, in %, rounded up."""
    tasks = itertools.product(results.teachers, results.learners, results.sizes)
    found = [pooled_calibration(results.fits_of(*task)) for task in tasks]
    errors = [100.0 * np.abs(each.preferred - each.predicted).max(initial=0.0) for each in found]
    return float(max(5.0, 5.0 * np.ceil(max(errors, default=0.0) / 5.0)))
