"""Learning curves: how regret, agreement and likelihood change with the number of pairs."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
import rerun as rr

from learners import Curve, Teacher
from studio.arrays import FloatArray
from studio.recorder.axes import (
    KEY_STEP,
    LIFT,
    Axes,
    Scale,
    draw_key,
    key_left,
    ratio_scale,
    sizes_scale,
)
from studio.recorder.drawing import Drawing
from studio.study.recording import entities
from studio.study.recording.over_pairs import changing_figure, learner_entries
from studio.study.regret import RegretRange
from studio.study.results import StudyResults
from studio.study.words import teacher_called
from studio.style.palette import LIGHT, Colour, blend, learner_colour
from studio.style.ticks import round_step

_HEIGHT = 0.95  # of the page of a curve, which is 1 wide
_LEAST_REGRET = 0.01  # where the scale of regret begins at the lowest, %
_LEAST_STEP = 0.01  # from tick to tick of the share of best actions found
_MOST_STEPS = 10  # of that share; the words at more ticks would touch
_STROKES = 240  # that fill a band
_BAND_OPACITY = 0.25  # of bands, on the ground and on one another


@dataclass(frozen=True)
class CurveFigure:
    """A figure of a column of the table."""

    name: str  # of the figure, as a part of entity paths
    column: str  # what is followed
    title: str  # of the view that shows the figure
    scale: Callable[[Sequence[Curve]], Scale]  # made of the curves of all teachers
    falls: bool = True  # whether curves fall, so that there is room for a key in the upper right
    truth: str | None = None  # column of what the teacher attains; None if that is not drawn

    def axes(self, results: StudyResults) -> Axes:
        """What the figures of all teachers are drawn on."""
        columns = [self.column, *([self.truth] if self.truth else [])]
        curves = [curve for column in columns for curve in results.curves(column)]
        return Axes(sizes_scale(results.sizes), self.scale(curves), _HEIGHT)


def regret_scale(curves: Sequence[Curve]) -> Scale:
    """The scale of regrets in %; a regret of 0 lies at its lower end."""
    regrets = RegretRange.around(curves)
    highest = max(regrets.most, 3.0 * _LEAST_REGRET)
    return ratio_scale(max(_LEAST_REGRET, min(regrets.least, highest)), highest, unit=" %")


def agreement_scale(curves: Sequence[Curve]) -> Scale:
    """The scale of shares of scenes, up to 1."""
    below = 1.0 - min(curve.low.min() for curve in curves)
    step = round_step(max(below, _MOST_STEPS * _LEAST_STEP), _MOST_STEPS)
    steps = max(1, int(np.ceil(below / step - 1e-9)))
    ticks = [1.0 - step * place for place in range(steps, -1, -1)]
    return Scale(tuple(ticks), tuple(f"{100.0 * tick:.0f} %" for tick in ticks))


def likelihood_scale(curves: Sequence[Curve]) -> Scale:
    """The scale of negative log-likelihoods in nats."""
    means = np.concatenate([curve.mean for curve in curves])
    lowest = max(float(means.min()), 1e-3)
    return ratio_scale(lowest, max(float(means.max()), 1.5 * lowest), (1.0, 2.0, 3.0, 5.0))


REGRET_CURVES = CurveFigure(entities.REGRET, "regret_percent", "regret over pairs", regret_scale)
AGREEMENT_CURVES = CurveFigure(
    entities.AGREEMENT, "agreement", "best action found", agreement_scale, falls=False
)
LIKELIHOOD_CURVES = CurveFigure(
    entities.LIKELIHOOD,
    "nll",
    "negative log-likelihood, nats a pair, over pairs",
    likelihood_scale,
    truth="nll_teacher",
)


def log_curve_figure(
    stream: rr.RecordingStream, results: StudyResults, teacher: Teacher, kind: CurveFigure
) -> None:
    """Draw one column: a line for the mean over seeds, a band for its 95 % interval."""
    path, axes = entities.figure(teacher.name, kind.name), kind.axes(results)
    curves = results.curves_of(kind.column, teacher)
    drawing = Drawing(lift=LIFT)
    draw_bands(drawing, axes, curves)
    axes.draw(drawing)
    for curve in curves:
        means = axes.points(curve.pairs, curve.mean)
        drawing.line(means, learner_colour(curve.learner), 3.5)
        for spot in means:
            drawing.dot(spot, learner_colour(curve.learner), 7.0)
    entries = learner_entries(curve.learner for curve in curves)
    if kind.truth:
        best = results.curves_of(kind.truth, teacher)[0]
        drawing.dashes(axes.points(best.pairs, best.mean), LIGHT.ink, 2.5)
        entries.append((teacher_called(teacher), None))
    top = _HEIGHT - 0.06 if kind.falls else 0.06 + KEY_STEP * (len(entries) - 1)
    draw_key(drawing, entries, key_left(words for words, _ in entries), top)
    drawing.log(stream, path)
    for pairs, cursor in changing_figure(stream, results, path):
        across = float(axes.x(pairs))
        cursor.line([(across, 0.0), (across, _HEIGHT)], LIGHT.faint, 1.0)
        for curve in curves:
            spread = curve.at(pairs)
            if spread is not None:
                spot = axes.points(pairs, spread.mean).tolist()
                cursor.dot(spot, LIGHT.ink, 15.0)
                cursor.dot(spot, learner_colour(curve.learner), 11.0)


def draw_bands(drawing: Drawing, axes: Axes, curves: Sequence[Curve]) -> None:
    """Fill the 95 % interval of each mean; where two overlap, their colours mix."""
    bands: list[tuple[Colour, FloatArray, FloatArray, FloatArray]] = []
    for curve in curves:
        colour = blend(learner_colour(curve.learner), LIGHT.panel, _BAND_OPACITY)
        low, high = axes.points(curve.pairs, curve.low), axes.points(curve.pairs, curve.high)
        if len(curve.pairs) == 1:
            drawing.line([low[0], high[0]], colour, 12.0)
            continue
        x = np.linspace(low[0, 0], low[-1, 0], _STROKES)
        bottom, top = (np.interp(x, *side.T) for side in (low, high))
        drawing.fill(x, bottom, top, colour)
        for under, its_x, its_bottom, its_top in bands:
            if np.array_equal(x, its_x):
                mixed = blend(learner_colour(curve.learner), under, _BAND_OPACITY)
                fill_where_there_is_room(
                    drawing, x, np.maximum(bottom, its_bottom), np.minimum(top, its_top), mixed
                )
        bands.append((colour, x, bottom, top))


def fill_where_there_is_room(
    drawing: Drawing, x: FloatArray, low: FloatArray, high: FloatArray, colour: Colour
) -> None:
    """Fill the area between two curves wherever the second is the higher one."""
    room = (high > low).astype(np.int64)
    starts, ends = (np.flatnonzero(np.diff(room, prepend=0, append=0) == turn) for turn in (1, -1))
    for start, end in zip(starts, ends, strict=True):
        if end - start > 1:
            part = slice(start, end)
            drawing.fill(x[part], low[part], high[part], colour)
