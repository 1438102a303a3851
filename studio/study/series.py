"""Curves of a study laid along all its numbers of pairs, whether they have a point there or not."""

import numpy as np

from learners import Curve
from studio.arrays import FloatArray
from studio.study.results import StudyResults


def along(curve: Curve, sizes: tuple[int, ...], numbers: FloatArray) -> FloatArray:
    """Numbers of a curve after each of these sizes, not a number where the curve has no point."""
    found = np.full(len(sizes), np.nan)
    found[np.searchsorted(sizes, curve.pairs)] = numbers
    return found


def seeds_along(results: StudyResults, curve: Curve) -> tuple[list[int], FloatArray]:
    """The seeds of a curve, and their numbers after each size of the study, [sizes, seeds]."""
    numbers: dict[tuple[int, int], float] = {}
    (teacher,) = (each for each in results.teachers if each.name == curve.teacher)
    for size, samples in zip(curve.pairs.tolist(), curve.samples, strict=True):
        seeds = [fit["seed"] for fit in results.fits_of(teacher, curve.learner, size)]
        if len(seeds) != len(samples):  # some seed has nothing in the column
            seeds = list(range(len(samples)))
        numbers |= {(size, seed): number for seed, number in zip(seeds, samples, strict=True)}
    found = sorted({seed for _, seed in numbers})
    rows = [[numbers.get((size, seed), np.nan) for seed in found] for size in results.sizes]
    return found, np.array(rows, dtype=np.float64)
