"""Plots over the number of pairs: a curve a learner, with its interval and every seed.

Where a plot is of regrets, it shows their decimal logarithms, since Rerun has no logarithmic axes.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain
from operator import itemgetter

import numpy as np
import rerun as rr
from numpy.typing import ArrayLike
from rerun import escape_entity_path_part as entity_part

from learners import FEATURES, PARAMETER_COLUMNS, CptParameters, Curve, Teacher, unit_vector
from studio.arrays import FloatArray
from studio.recorder.plots import log_bands
from studio.study.recording import entities
from studio.study.regret import RegretRange
from studio.study.results import StudyResults
from studio.study.series import along, seeds_along
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
    attained = [along(curve, sizes, curve.mean) for curve in curves("nll_teacher")[:1]]
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


Marks = Sequence[tuple[str, str, Colour, float, float]]
"""Whose each mark is (empty for the teacher), what it is, its colour, width, and size, px.

Widths are those of lines, sizes about the radii of dots; 0 stands for none.
"""


def log_pair_plot(stream: rr.RecordingStream, results: StudyResults, plot: PairPlot) -> None:
    """Add a plot to a recording: means and, below them, bands for their intervals, seeds, truth.

    Plots of regret, of which one seed may carry the mean, also have interquartile means.
    """
    curves = plot.curves
    learners = [curve.learner for curve in curves]
    pens = [learner_pen(learner).colour for learner in learners]

    def sides(*names: str) -> FloatArray:
        """What the curves have of these names, [names, sizes, learners]."""
        of_names = [
            [along(each, results.sizes, getattr(each, name)) for each in curves] for name in names
        ]
        return np.array(of_names).transpose(0, 2, 1)

    marks: list[tuple[str, str, Colour, float, float]] = []
    numbers: list[FloatArray] = []  # [3, sizes, marks]: each with the ends of its interval, if any
    for curve, colour in zip(curves, pens, strict=True):
        seeds, found = seeds_along(results, curve)
        pale = blend(colour, LIGHT.ground, 0.6)
        marks += [(curve.learner, f"seed {seed}", pale, 0.0, 1.8) for seed in seeds]
        numbers.append(np.stack([found] * 3))
    if plot.truth is not None:
        marks.append(("", "truth", LIGHT.ink, 1.5, 0.0))
        numbers.append(np.stack([plot.truth[:, None]] * 3))
    if plot.place is not np.asarray:
        thin = [blend(colour, LIGHT.ink, 0.6) for colour in pens]
        names = ["interquartile mean"] * len(curves)
        marks += [(*each, 1.0, 0.0) for each in zip(learners, names, thin, strict=True)]
        numbers.append(sides("middle", "middle_low", "middle_high"))
    means = sides("mean", "low", "high")
    marks += [
        (*each, 2.5, 3.5) for each in zip(learners, ["mean"] * len(curves), pens, strict=True)
    ]
    _log_marks(stream, results, plot, marks, np.concatenate([*numbers, means], axis=2))
    low, high = plot.place(means[1]), plot.place(means[2])
    names = [f"{learner_called(learner)}: 95 % interval of the mean" for learner in learners]
    times = [rr.TimeColumn(entities.TIMELINE, sequence=results.sizes)]
    path, middle, reach = f"{plot.path}/interval", (low + high) / 2, (high - low) / 2
    log_bands(stream, path, times, middle, reach, names, pens, width=0.0)


def _log_marks(
    stream: rr.RecordingStream,
    results: StudyResults,
    plot: PairPlot,
    marks: Marks,
    numbers: FloatArray,
) -> None:
    """Add marks and their numbers with the ends of their intervals, [3, sizes, marks].

    Beside the marks stands in words what they are: numbers would be plotted, too.
    """
    learners, words, colours, widths, sizes = zip(*marks, strict=True)
    called = [learner_called(learner) if learner else "teacher" for learner in learners]
    names = [f"{name}: {each}" for name, each in zip(called, words, strict=True)]
    markers = [_MARKERS[learner_pen(learner).marker] for learner in learners]
    stream.log(
        plot.path,
        rr.SeriesLines(colors=colours, names=names, widths=widths),
        rr.SeriesPoints(colors=colours, names=names, markers=markers, marker_sizes=sizes),
        rr.AnyValues(teacher=plot.curves[0].teacher, learner=learners, what=words),
        static=True,
    )
    lengths = [len(marks)] * numbers.shape[1]
    told = [_told(*each) for each in numbers.reshape(3, -1).T.tolist()]
    scalars = rr.Scalars.columns(scalars=plot.place(numbers[0]).ravel()).partition(lengths)
    values = rr.AnyValues.columns(value=told).partition(lengths)
    times = [rr.TimeColumn(entities.TIMELINE, sequence=results.sizes)]
    stream.send_columns(plot.path, times, [*scalars, *values])


def _told(value: float, low: float, high: float) -> str:
    """A number, and its interval if it has one, in words; nothing if there is none."""
    if not np.isfinite(value):
        return ""
    return f"{value:.3g}" + (f" [{low:.3g}, {high:.3g}]" if low != high else "")
