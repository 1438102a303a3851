"""The ranges that all teachers' panels in a study's picture share."""

from dataclasses import dataclass

import numpy as np

from learners import unit_vector, value
from studio.study.picture.results import (
    Results,
    calibration,
    numbers_of,
    parameters_of,
)
from studio.style.ticks import round_range


@dataclass(frozen=True)
class Scales:
    """Ranges that the teachers' panels share, so that they can be compared.

    They hold what was found at every number of pairs, so that nothing moves but what is learned.

    Attributes:
        regret: in %, above 0.
        has_zero: whether a mean regret is 0.
        agreement: lowest share shown, in %.
        reach: largest utility of which the value is shown.
        values: of the value functions.
        calibration: largest error of a prediction shown, in %.
        theta: of the numbers of θ/‖θ‖.
        parameters: of α, η, λ, γ and δ.
    """

    regret: tuple[float, float]
    has_zero: bool
    agreement: float
    reach: float
    values: tuple[float, float]
    calibration: float
    theta: tuple[float, float]
    parameters: tuple[float, float]

    @classmethod
    def around(cls, results: Results) -> "Scales":
        """Ranges that hold what the whole study found."""
        means = np.concatenate([curve.mean for curve in results.regret] or [np.array([1.0])])
        above = means[means > 0.0]
        low, high = (float(above.min()), float(above.max())) if len(above) else (0.1, 10.0)
        high = max([high, *(float(curve.high.max()) for curve in results.regret)])
        regret = (low / 1.5, max(high * 1.2, low * 12.0))
        shares = [float(min(curve.low.min(), 1.0)) for curve in results.agreement]
        lowest = min(100.0 * min(shares, default=0.0), 90.0)
        lengths = [float(np.linalg.norm(teacher.reward)) for teacher in results.teachers]
        _, reach = round_range(0.0, max(0.75 * max(lengths, default=0.4), 1e-3))
        ends = np.array([-reach, reach])
        truths = [value(ends, teacher.parameters) for teacher in results.teachers]
        values = (
            min((1.15 * float(truth[0]) for truth in truths), default=-reach),
            max((1.35 * float(truth[1]) for truth in truths), default=reach),
        )
        units = [unit_vector(teacher.reward) for teacher in results.teachers]
        learnt = [unit_vector(row["theta"]) for row in results.fits]
        theta = np.concatenate([*units, *learnt, np.zeros(1)])
        numbers = [0.5, 2.0]
        for teacher in results.teachers:
            numbers += numbers_of(teacher.parameters)
        for parameters in map(parameters_of, results.fits):
            numbers += numbers_of(parameters) if parameters is not None else []
        return cls(
            regret,
            bool((means <= 0.0).any()),
            10.0 * np.floor(lowest / 10.0),
            reach,
            values,
            _largest_error(results),
            (max(float(theta.min()) - 0.05, -1.0), min(float(theta.max()) + 0.05, 1.0)),
            (max(min(numbers) / 1.1, 0.1), min(max(numbers) * 1.1, 10.0)),
        )


def _largest_error(results: Results) -> float:
    """The largest error of predictions at any number of pairs, in %, rounded up."""
    tasks = [(row["teacher"], row["learner"], row["pairs"]) for row in results.fits]
    errors = [
        abs(float(error))
        for task in dict.fromkeys(tasks)
        for _, error in calibration(results.fits_of(*task))
    ]
    return float(max(5.0, 5.0 * np.ceil(max(errors, default=0.0) / 5.0)))
