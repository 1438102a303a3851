"""Plots over the number of pairs: a curve a learner, with its interval and every seed.

Where a plot is of regrets, it shows their decimal logarithms, since Rerun has no logarithmic axes.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import chain
from operator import itemgetter
from typing import Any

import numpy as np
import rerun as rr
from numpy.typing import ArrayLike, NDArray
from rerun import escape_entity_path_part as entity_part

from learners import FEATURES, PARAMETER_COLUMNS, CptParameters, Curve, Teacher, unit_vector
from studio.arrays import FloatArray
from studio.recorder.plots import log_bands
from studio.study.recording import entities
from studio.study.regret import RegretRange
from studio.study.results import StudyResults
from studio.study.words import learner_called, short_teacher_name
from studio.style.palette import LIGHT, Colour, blend, learner_pen
from studio.style.words import short

REGRET, AGREEMENT, LIKELIHOOD = "regret", "agreement", "likelihood"
THETA = [f"theta/{feature}" for feature in FEATURES]
PARAMETERS = [f"parameters/{column}" for column in PARAMETER_COLUMNS]

_MARKERS: Mapping[str, rr.components.MarkerShapeLike] = {
    **{name: name for name in ("circle", "square", "diamond", "plus")},
    **{"triangle": "up", "triangle_down": "down", "pentagon": "right", "star": "asterisk"},
}  # what Rerun calls markers, or has in their place

Place = Callable[[ArrayLike], FloatArray]
"""Gives where numbers stand in a plot."""


@dataclass(frozen=True)
class PairPlot:
    """A plot of one column: how it changes for all who learn from one teacher."""

    path: str  # its entity
    title: str  # of its view
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
    return f"families/{entity_part(family)}"


def plot_range(plots: Plots, names: Iterable[str]) -> tuple[float, float]:
    """What views of the plots of these names show upwards, so that they can be compared."""
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
        path = entities.curves(teacher.name, name)
        return name, PairPlot(path, f"{called}: {title}", tuple(found), truth, place)

    logarithm = _logarithm(results.regrets)
    yield plot(REGRET, "log10 of regret, %", curves("regret_percent"), logarithm)
    percents = [curve.mapped(lambda share: 100.0 * share) for curve in curves("agreement")]
    yield plot(AGREEMENT, "best picks, %", percents)
    attained = [_along(curve, sizes, curve.mean) for curve in curves("nll_teacher")[:1]]
    losses = curves("nll")
    yield plot(LIKELIHOOD, "log-loss, nats", losses, truth=next(iter(attained), None))
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
        title = f"{short(family)}, log10 of regret, %"
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


@dataclass(frozen=True)
class _Marks:
    """Marks of a plot that look alike: lines, or rows of dots."""

    words: list[str]  # what each of N is
    learners: list[str]  # whose it is; empty for the teacher
    colours: list[Colour]
    width: float  # of lines, px; 0 for none
    size: float  # of dots, about their radius, px; 0 for none
    sides: list[FloatArray]  # numbers [sizes, N], then perhaps both ends of their intervals

    @property
    def told(self) -> NDArray[np.str_]:
        """The numbers with their intervals in words, [sizes, N]; empty where there is none."""
        return np.array([[_told(each) for each in row] for row in np.stack(self.sides, axis=-1)])


def log_pair_plot(stream: rr.RecordingStream, results: StudyResults, plot: PairPlot) -> None:
    """Add a plot to a recording: means and, below them, bands for their intervals, seeds, truth.

    Plots of regret, of which one seed may carry the mean, also have interquartile means. Beside the
    marks stands in words what they are: numbers would be plotted, too.
    """
    curves, ground = plot.curves, LIGHT.ground
    learners = [curve.learner for curve in curves]
    colours = [learner_pen(learner).colour for learner in learners]

    def sides(*names: str) -> list[FloatArray]:
        return [
            np.stack([_along(curve, results.sizes, getattr(curve, each)) for curve in curves], 1)
            for each in names
        ]

    found = [_seeds(results, curve) for curve in curves]
    whose = [
        (learner, seed) for learner, (own, _) in zip(learners, found, strict=True) for seed in own
    ]
    own = [learner for learner, _ in whose]
    pale = [blend(learner_pen(learner).colour, ground, 0.6) for learner in own]
    numbers = [np.concatenate([each for _, each in found], axis=1)]
    marks = [_Marks([f"seed {seed}" for _, seed in whose], own, pale, 0.0, 1.8, numbers)]
    if plot.truth is not None:
        marks.append(_Marks(["truth"], [""], [LIGHT.ink], 1.5, 0.0, [plot.truth[:, None]]))
    if plot.place is not np.asarray:
        thin = [blend(colour, LIGHT.ink, 0.6) for colour in colours]
        numbers = sides("middle", "middle_low", "middle_high")
        words = ["interquartile mean"] * len(curves)
        marks.append(_Marks(words, learners, thin, 1.0, 0.0, numbers))
    means = sides("mean", "low", "high")
    marks.append(_Marks(["mean"] * len(curves), learners, colours, 2.5, 3.5, means))

    every = [
        (learner, words, colour, each)
        for each in marks
        for learner, words, colour in zip(each.learners, each.words, each.colours, strict=True)
    ]
    look: dict[str, Any] = {
        "names": [
            f"{learner_called(name) if name else 'teacher'}: {words}" for name, words, *_ in every
        ],
        "colors": [colour for *_, colour, _ in every],
    }
    stream.log(
        plot.path,
        rr.SeriesLines(**look, widths=[each.width for *_, each in every]),
        rr.SeriesPoints(
            **look,
            markers=[_MARKERS[learner_pen(learner).marker] for learner, *_ in every],
            marker_sizes=[each.size for *_, each in every],
        ),
        rr.AnyValues(
            teacher=curves[0].teacher,
            learner=[learner for learner, *_ in every],
            what=[words for _, words, *_ in every],
        ),
        static=True,
    )
    places = plot.place(np.concatenate([each.sides[0] for each in marks], axis=1))
    told = np.concatenate([each.told for each in marks], axis=1)
    lengths = [len(every)] * len(places)
    times = [rr.TimeColumn(entities.TIMELINE, sequence=results.sizes)]
    stream.send_columns(
        plot.path,
        times,
        [
            *rr.Scalars.columns(scalars=places.ravel()).partition(lengths),
            *rr.AnyValues.columns(value=told.ravel().tolist()).partition(lengths),
        ],
    )
    low, high = (plot.place(side) for side in means[1:])
    names = [f"{learner_called(learner)}: 95 % interval of the mean" for learner in learners]
    path, middle, reach = f"{plot.path}/interval", (low + high) / 2, (high - low) / 2
    log_bands(stream, path, times, middle, reach, names, colours, width=0.0)


def _told(numbers: FloatArray) -> str:
    """A number, and its interval if it has one, in words; nothing if there is none."""
    value, *ends = numbers.tolist()
    if not np.isfinite(value):
        return ""
    return f"{value:.3g}" + (" [{:.3g}, {:.3g}]".format(*ends) if len(set(ends)) > 1 else "")


def _along(curve: Curve, sizes: tuple[int, ...], numbers: FloatArray) -> FloatArray:
    """Numbers of a curve after each of these sizes, not a number where the curve has no point."""
    found = np.full(len(sizes), np.nan)
    found[np.searchsorted(sizes, curve.pairs)] = numbers
    return found


def _seeds(results: StudyResults, curve: Curve) -> tuple[list[int], FloatArray]:
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
