"""What of a study is plotted over the number of pairs: which curves, where, and on which scale.

Plots of regret are logarithmic.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import chain
from operator import itemgetter

import numpy as np
from numpy.typing import ArrayLike

from learners import FEATURES, PARAMETER_COLUMNS, CptParameters, Curve, Teacher, unit_vector
from studio.arrays import FloatArray
from studio.study.regret import RegretRange
from studio.study.results import StudyResults
from studio.study.words import short_teacher_name
from studio.style.words import short

REGRET, AGREEMENT, LIKELIHOOD = "regret", "agreement", "likelihood"
THETA = [f"theta/{feature}" for feature in FEATURES]
PARAMETERS = [f"parameters/{column}" for column in PARAMETER_COLUMNS]

Place = Callable[[ArrayLike], FloatArray]
"""Gives where numbers stand in a plot."""


@dataclass(frozen=True)
class PairPlot:
    """A plot of one column: how it changes for all who learn from one teacher."""

    title: str
    curves: tuple[Curve, ...]  # one a learner
    truth: FloatArray | None = None  # what the teacher has or attains after each size of the study
    place: Place = np.asarray

    @property
    def ends(self) -> tuple[float, float]:
        """The lowest and the highest place in the plot."""
        shown = [(curve.low, curve.high, *curve.samples) for curve in self.curves]
        truths = [] if self.truth is None else [self.truth]
        places = self.place(np.concatenate([*chain(*shown), *truths]))
        return float(places.min()), float(places.max())


Plots = Mapping[tuple[str, str], PairPlot]
"""Plots by their own name and that of the teacher."""


def study_plots(results: StudyResults) -> Plots:
    """All plots in which there is something to see.

    They are called `REGRET`, `AGREEMENT`, `LIKELIHOOD`, as `THETA` and `PARAMETERS` say, and, in
    families of scenes, as `family_plot` says.
    """
    return {
        (name, teacher.name): plot
        for teacher in results.teachers
        for name, plot in _plots_of(results, teacher)
        if plot.curves
    }


def family_plot(family: str) -> str:
    """The name of the plot of regret in a family of scenes."""
    return f"families/{family}"


def plot_range(plots: Plots, names: Iterable[str]) -> tuple[float, float]:
    """What plots of these names show upwards, so that they can be compared."""
    ends = [plot.ends for (name, _), plot in plots.items() if name in names]
    low, high = min(end[0] for end in ends), max(end[1] for end in ends)
    margin = 0.06 * (high - low) or 0.5
    return low - margin, high + margin


def _plots_of(results: StudyResults, teacher: Teacher) -> Iterator[tuple[str, PairPlot]]:
    """The plots of one teacher, whether there are curves for them or not."""
    called, sizes = short_teacher_name(teacher), results.sizes

    def curves(column: str) -> list[Curve]:
        return results.curves_of(column, teacher)

    def plot(
        name: str, title: str, found: list[Curve], place: Place = np.asarray,
        truth: FloatArray | None = None,
    ) -> tuple[str, PairPlot]:  # fmt: skip
        return name, PairPlot(title, tuple(found), truth, place)

    logarithm = _logarithm(results.regrets)
    yield plot(REGRET, f"{called}: log10 regret, %", curves("regret_percent"), logarithm)
    percents = [curve.mapped(lambda share: 100.0 * share) for curve in curves("agreement")]
    yield plot(AGREEMENT, f"{called}: best picks, %", percents)
    attained = [along(curve, sizes, curve.mean) for curve in curves("nll_teacher")[:1]]
    losses = curves("nll")
    yield plot(LIKELIHOOD, f"{called}: log-loss, nats", losses, truth=next(iter(attained), None))
    truths = [*unit_vector(teacher.reward), *teacher.parameters.numbers]
    titles = [*(f"θ of {feature}" for feature in FEATURES), *CptParameters.SYMBOLS]
    numbers = [
        [curve.mapped(itemgetter((..., index))) for curve in curves("theta_unit")]
        for index in range(len(FEATURES))
    ] + [curves(column) for column in PARAMETER_COLUMNS]
    for name, title, found, number in zip(
        (*THETA, *PARAMETERS), titles, numbers, truths, strict=True
    ):
        yield plot(name, title, found, truth=np.full(len(sizes), number))
    regrets = {family: _family_curves(results, family) for family in results.families}
    logarithm = _logarithm(RegretRange.around([*chain(*regrets.values())]))
    for family, found in regrets.items():
        own = [curve for curve in found if curve.teacher == teacher.name]
        title = f"{short(family)}: log10 regret, %"
        yield plot(family_plot(family), title, own, logarithm)


def _family_curves(results: StudyResults, family: str) -> list[Curve]:
    """Regret in % of a random action's in a family of scenes, of all teachers."""
    found = (
        results.family_percents(family, teacher, learner)
        for teacher in results.teachers
        for learner in results.learners
    )
    return [curve for curve in found if curve is not None]


def _logarithm(regrets: RegretRange) -> Place:
    """The decimal logarithm of regrets in %; 0 stands at half the smallest mean that is above 0."""
    return lambda values: np.asarray(np.log10(np.maximum(values, 0.5 * regrets.start)))


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
