"""How learners get better with more pairs: regret, and agreement with the teacher's best action."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from learners import Curve, Teacher
from studio.naming import learner_name, number
from studio.painter.canvas import SEMIBOLD, Box, Canvas, FloatArray
from studio.painter.learning_plots import (
    LogAxis,
    band,
    caption,
    decades,
    dot,
    end_labels,
    foot,
    ground,
    gutter,
    labels_below,
    labels_beside,
)
from studio.painter.learning_results import Results
from studio.painter.learning_scales import Scales
from studio.painter.plots import Axis, ticks
from studio.palette import Colour, blend, learner_colour


def draw_regret(
    canvas: Canvas, box: Box, results: Results, teacher: Teacher, scales: Scales
) -> None:
    """Draw how regret falls with the number of pairs, both logarithmic."""
    kind = canvas.type
    wordings = [
        "Held-out regret, % of a random action's",
        "Held-out regret, % of random",
        "Regret, % of random",
        "Regret, %",
    ]
    rest = caption(canvas, box, wordings)
    low, high = scales.regret
    marks = decades(low, high)
    left = gutter(canvas, [number(mark) for mark in marks])
    curves = [curve for curve in results.regret if curve.teacher == teacher.name]
    panel = Box(rest.left + left, rest.top, rest.right, rest.bottom - foot(canvas))
    strip = 1.5 * kind.small if scales.has_zero else 0.0
    up = LogAxis(low, high, panel.bottom - strip, panel.top, panel.bottom - 0.35 * strip)
    if scales.has_zero:
        marks = [0.0, *marks]
    ends = [(curve, _wordings(curve, _percent(curve.mean[-1]))) for curve in curves]
    _draw_curves(canvas, panel, results, ends, up, marks, 1.0)
    if not curves:
        canvas.text(panel.centre, "no fits yet", kind.small, canvas.theme.faint, anchor="centre")


def draw_agreement(
    canvas: Canvas, box: Box, results: Results, teacher: Teacher, scales: Scales
) -> None:
    """Draw in what share of scenes the teacher's best action is picked."""
    wordings = [
        "Picks the teacher's best action, % of scenes",
        "Picks the best action, %",
        "Best action picked, %",
        "Best picks, %",
        "Agreement",
    ]
    rest = caption(canvas, box, wordings)
    marks = [mark for mark in ticks(scales.agreement, 100.0, 4) if mark <= 100.0]
    left = gutter(canvas, [number(mark) for mark in marks])
    panel = Box(rest.left + left, rest.top, rest.right, rest.bottom - foot(canvas))
    # a margin keeps dots at the top whole
    up = Axis(scales.agreement, 100.0, panel.bottom, panel.top + 6 * canvas.unit)
    curves = [curve for curve in results.agreement if curve.teacher == teacher.name]
    ends = [(curve, _wordings(curve, f"{100 * curve.mean[-1]:.0f}")) for curve in curves]
    _draw_curves(canvas, panel, results, ends, up, marks, 100.0)


def _draw_curves(
    canvas: Canvas,
    panel: Box,
    results: Results,
    ends: Sequence[tuple[Curve, list[str]]],
    up: Axis | LogAxis,
    marks: Sequence[float],
    scale: float,
) -> None:
    """Draw curves over the number of pairs, with bands, whiskers and names at their ends."""
    unit, size = canvas.unit, canvas.type.small
    named = max((canvas.measure(texts[0], size, SEMIBOLD) for _, texts in ends), default=0.0)
    room = min(named + 10 * unit, 0.4 * panel.width)
    pen = 9 * unit
    if results.sizes:
        first, last = float(results.sizes[0]), float(results.sizes[-1])
        if first == last:
            first = last / 4.0  # a single dot lies beside its name
    else:
        first, last = 1.0, 10.0
    start, end = panel.left + pen, panel.right - room - pen
    across = LogAxis(first, last, start, end, start)
    ground(
        canvas,
        panel,
        across=[across.at(pairs) for pairs in results.sizes],
        up=[up.at(mark) for mark in marks],
    )
    labels_beside(canvas, panel, up.at, marks)
    plot = Box(panel.left, panel.top, panel.right - room, panel.bottom)
    written = labels_below(canvas, plot, across.at, [float(pairs) for pairs in results.sizes], "")
    if written and canvas.measure("pairs", size) + 8 * unit <= panel.right - written.right:
        at = (written.right + 8 * unit, panel.bottom + 0.2 * size)
        canvas.text(at, "pairs", size, canvas.theme.faint, line="top")
    lines = [_Line.of(curve, across, up, scale) for curve, _ in ends]
    part = canvas.clipped(plot)
    for line in lines:
        if len(line.x) > 1 and (line.runs > 1).any():
            band(canvas, plot, line.x, line.low, line.high, line.colour)
    for index, line in enumerate(lines):
        faint = blend(line.colour, canvas.theme.panel, 0.6)
        beside = 3.2 * unit * (index - (len(lines) - 1) / 2)
        for x, y in zip(line.x[line.runs > 1], line.whiskers[line.runs > 1], strict=True):
            part.line([(x + beside, y[0]), (x + beside, y[1])], faint, canvas.hair)
    for line in lines:
        part.line(np.stack([line.x, line.y], axis=-1), line.colour, 2.6 * unit)
    for line in lines:
        for x, y in zip(line.x, line.y, strict=True):
            dot(part, float(x), float(y), line.colour, 3.4)
    column = Box(plot.right, panel.top, panel.right, panel.bottom)
    labels = [
        (float(line.y[-1]), texts, line.colour)
        for line, (_, texts) in zip(lines, ends, strict=True)
    ]
    end_labels(canvas, plot.right, column, labels)


@dataclass(frozen=True)
class _Line:
    """A learning curve on the page, px.

    Attributes:
        colour: of the learner.
        runs: [n], how many seeds there are.
        x: [n], where the numbers of pairs lie.
        y: [n], where the means lie.
        low: [n], lower ends of the intervals of the mean.
        high: [n], upper ends.
        whiskers: [n, 2], the mean − and + one standard deviation.
    """

    colour: Colour
    runs: NDArray[np.int64]
    x: FloatArray
    y: FloatArray
    low: FloatArray
    high: FloatArray
    whiskers: FloatArray

    @classmethod
    def of(cls, curve: Curve, across: LogAxis, up: Axis | LogAxis, scale: float) -> "_Line":
        """The curve between these axes, its values multiplied by the scale."""
        spread = np.stack([curve.mean - curve.std, curve.mean + curve.std], axis=-1)
        return cls(
            learner_colour(curve.learner),
            curve.runs,
            across.along(curve.pairs),
            *(up.along(scale * values) for values in (curve.mean, curve.low, curve.high, spread)),
        )


def _wordings(curve: Curve, end: str) -> list[str]:
    """What is written at the end of a curve, the longest wording first."""
    name = learner_name(curve.learner)
    return [f"{name} {end}", name]


def _percent(share: float) -> str:
    """A percentage to about two digits."""
    if share <= 0.0:
        return "0 %"
    digits = 0 if share >= 9.95 else 1 if share >= 0.995 else 2
    return f"{share:.{digits}f} %" if share >= 0.005 else "< 0.01 %"
