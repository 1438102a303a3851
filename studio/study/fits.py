"""Single fits of a study, and what several of them come to."""

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from learners import PARAMETER_COLUMNS, PROFILES, Calibration, CptParameters
from studio.arrays import FloatArray

_RESAMPLES = 2000  # draws of seeds, for intervals

Row = dict[str, Any]
"""One fit: the columns of `learners.STUDY_SCHEMA` by name, in plain types."""


def parameters_of(fit: Row) -> CptParameters | None:
    """The parameters that a fit learnt; None if its learner has none."""
    found = [fit[column] for column in PARAMETER_COLUMNS]
    if any(given is None or not np.isfinite(given) or given <= 0.0 for given in found):
        return None
    return CptParameters(*(float(given) for given in found))


def learnt_parameters(fit: Row) -> CptParameters:
    """The parameters of a fit; those of expected utility if its learner has none."""
    return parameters_of(fit) or PROFILES["eu"]


def pooled_calibration(fits: Iterable[Row]) -> Calibration:
    """The calibration of several fits taken together, in the bins that have predictions."""
    told = [fit for fit in fits if fit["calibration_count"]]
    count, predicted, preferred = (
        np.array([fit[f"calibration_{what}"] for fit in told], dtype=np.float64)
        for what in ("count", "predicted", "preferred")
    )  # (fits, bins)
    if not told:
        return Calibration(np.zeros(0, np.int64), np.zeros(0), np.zeros(0))
    total = count.sum(axis=0)
    some = total > 0.0
    means = (np.nansum(count * each, axis=0)[some] / total[some] for each in (predicted, preferred))
    return Calibration(total[some].astype(np.int64), *means)


def calibration_with_intervals(
    fits: Sequence[Row],
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """Predicted and preferred share, and the latter's 95 % bootstrap interval over seeds.

    Returns:
        Four arrays [bins], 0 in bins without predictions. The interval of a single seed is empty.
    """
    count, predicted, preferred = (
        np.nan_to_num(np.array([fit[f"calibration_{what}"] for fit in fits], dtype=np.float64))
        for what in ("count", "predicted", "preferred")
    )  # (seeds, bins)
    draws = np.random.default_rng(0).multinomial(
        len(fits), np.full(len(fits), 1.0 / len(fits)), _RESAMPLES
    )
    total = np.maximum(count.sum(axis=0), 1.0)
    drawn = (draws @ (count * preferred)) / np.maximum(draws @ count, 1.0)
    low, high = np.quantile(drawn, (0.025, 0.975), axis=0)
    means = ((count * each).sum(axis=0) / total for each in (predicted, preferred))
    return (*means, low, high)
