"""Single fits of a study, and what several of them come to."""

from collections.abc import Iterable
from typing import Any

import numpy as np

from learners import PARAMETER_COLUMNS, PROFILES, Calibration, CptParameters

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
