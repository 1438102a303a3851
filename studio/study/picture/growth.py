"""What lies between two numbers of pairs, so that a film can move smoothly from one to the next.

Nobody was fitted there: what is drawn in between is interpolated, and the film says so.
"""

from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np

from learners import PARAMETER_COLUMNS, Curve, Teacher
from studio.study.fits import Row
from studio.study.results import Stage

_LISTS = ("theta", "theta_unit")  # columns of a fit that hold a direction, number by number


def grown(curve: Curve, reached: float) -> Curve:
    """The curve as far as a number of pairs, whose last point is interpolated between two sizes.

    Between two sizes the mean and its interval change evenly with the logarithm of the pairs; where
    all of their ends are above 0, their logarithms do. Nothing is interpolated of single seeds.
    """
    known = curve.where(curve.pairs <= reached)
    later = curve.where(curve.pairs > reached)
    if not len(known.pairs) or not len(later.pairs) or known.pairs[-1] == reached:
        return known
    share = _share(float(known.pairs[-1]), float(later.pairs[0]), reached)
    ends: dict[str, Any] = {
        name: np.append(
            getattr(known, name), _between(getattr(known, name)[-1], getattr(later, name)[0], share)
        )
        for name in ("mean", "low", "high")
    }
    return replace(
        known, pairs=np.append(known.pairs, reached), runs=np.append(known.runs, 0), **ends
    )


def fits_between(stage: Stage, teacher: Teacher, learner: str) -> list[Row]:
    """The fits of a learner from the most pairs so far, moved on towards those from more pairs.

    Of every seed, the reward changes evenly with the logarithm of the pairs, and so do the
    logarithms of the parameters.
    """
    fits = stage.largest(teacher, learner)
    sizes = stage.results.sizes
    for size, more in pairwise(sizes):
        if size < stage.reached < more:
            share = _share(size, more, stage.reached)
            towards = {row["seed"]: row for row in stage.results.fits_of(teacher, learner, more)}
            return [
                _moved(fit, towards[fit["seed"]], share) if fit["seed"] in towards else fit
                for fit in fits
            ]
    return fits


def _moved(fit: Row, towards: Row, share: float) -> Row:
    moved = dict(fit)
    for name in _LISTS:
        before, after = np.array(fit[name]), np.array(towards[name])
        moved[name] = ((1.0 - share) * before + share * after).tolist()
    for name in PARAMETER_COLUMNS:
        if fit[name] and towards[name]:
            moved[name] = _between(fit[name], towards[name], share)
    return moved


def _share(before: float, after: float, reached: float) -> float:
    """How far on the way a number of pairs is, on a logarithmic axis, 0 to 1."""
    return float(np.log(reached / before) / np.log(after / before))


def _between(before: float, after: float, share: float) -> float:
    if before > 0.0 and after > 0.0:
        return float(np.exp((1.0 - share) * np.log(before) + share * np.log(after)))
    return float((1.0 - share) * before + share * after)
