"""Plots over the number of pairs: a curve a learner, with its interval and every seed.

Where a plot is of regrets, it shows their decimal logarithms, since Rerun has no logarithmic axes.
"""

from collections.abc import Mapping, Sequence

import numpy as np
import rerun as rr

from studio.arrays import FloatArray
from studio.recorder.plots import log_bands
from studio.study.recording import entities
from studio.study.results import StudyResults
from studio.study.series import PairPlot, along, seeds_along
from studio.study.words import learner_called
from studio.style.palette import LIGHT, Colour, blend, learner_pen

_MARKERS: Mapping[str, rr.components.MarkerShapeLike] = {
    **{name: name for name in ("circle", "square", "diamond", "plus")},
    **{"triangle": "up", "triangle_down": "down", "pentagon": "right", "star": "asterisk"},
}  # what Rerun calls markers, or has in their place

Marks = Sequence[tuple[str, str, Colour, float, float]]
"""Whose each mark is (empty for the teacher), what it is, its colour, width, and size, px.

Widths are those of lines, sizes about the radii of dots; 0 stands for none.
"""


def log_pair_plot(
    stream: rr.RecordingStream, results: StudyResults, path: str, plot: PairPlot
) -> None:
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
        marks.append(("", "truth", LIGHT.ink, 1.5, 1.8))
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
    _log_marks(stream, results, path, plot, marks, np.concatenate([*numbers, means], axis=2))
    low, high = plot.place(means[1]), plot.place(means[2])
    names = [f"{learner_called(learner)}: 95 % interval of the mean" for learner in learners]
    times = [rr.TimeColumn(entities.TIMELINE, sequence=results.sizes)]
    middle, reach = (low + high) / 2, (high - low) / 2
    log_bands(stream, f"{path}/interval", times, middle, reach, names, pens, width=0.0)


def _log_marks(
    stream: rr.RecordingStream,
    results: StudyResults,
    path: str,
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
        path,
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
    stream.send_columns(path, times, [*scalars, *values])


def _told(value: float, low: float, high: float) -> str:
    """A number, and its interval if it has one, in words; nothing if there is none."""
    if not np.isfinite(value):
        return ""
    return f"{value:.3g}" + (f" [{low:.3g}, {high:.3g}]" if low != high else "")
