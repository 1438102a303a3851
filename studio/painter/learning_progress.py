"""How learners get better with more pairs: regret, and agreement with the teacher's best action."""

from collections.abc import Callable, Sequence
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
    """Draw how regret fell with the number of pairs so far, both logarithmic."""
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
    drawn = _draw_curves(canvas, panel, results, curves, up, marks, 1.0, _percent)
    if not drawn:
        canvas.text(panel.centre, "no fits yet", kind.small, canvas.theme.faint, anchor="centre")


def draw_agreement(
    canvas: Canvas, box: Box, results: Results, teacher: Teacher, scales: Scales
) -> None:
    """Draw in what share of scenes the teacher's best action was picked so far."""
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
    _draw_curves(canvas, panel, results, curves, up, marks, 100.0, "{:.0f}".format)


def _draw_curves(
    canvas: Canvas,
    panel: Box,
    results: Results,
    curves: Sequence[Curve],
    up: Axis | LogAxis,
    marks: Sequence[float],
    scale: float,
    say: Callable[[float], str],
) -> int:
    """Draw curves over the number of pairs, with bands, whiskers and names at their ends.

    They go as far as the results do; their names stand to the right of the farthest end.

    Args:
        canvas: to draw on.
        panel: where, px.
        results: how far the curves go.
        curves: of the whole study.
        up: the vertical axis.
        marks: values to write beside it.
        scale: what the curves' values are multiplied by.
        say: turns such a value into words.

    Returns:
        How many curves have begun.
    """
    unit, size = canvas.unit, canvas.type.small
    wordings = [_wordings(curve, [say(scale * mean) for mean in curve.mean]) for curve in curves]
    widest = [canvas.measure(said, size, SEMIBOLD) for texts in wordings for said, _ in texts]
    room = min(max(widest, default=0.0) + 10 * unit, 0.46 * panel.width)
    pen = 9 * unit
    sizes = [float(pairs) for pairs in results.all_sizes]
    first, last = (sizes[0], sizes[-1]) if sizes else (1.0, 10.0)
    if first == last:
        first = last / 4.0  # a single dot lies beside its name
    start, end = panel.left + pen, panel.right - room - pen
    across = LogAxis(first, last, start, end, start)
    ground(
        canvas,
        panel,
        across=[across.at(pairs) for pairs in sizes],
        up=[up.at(mark) for mark in marks],
    )
    labels_beside(canvas, panel, up.at, marks)
    plot = Box(panel.left, panel.top, panel.right - room, panel.bottom)
    written = labels_below(canvas, plot, across.at, sizes, "")
    if written and canvas.measure("pairs", size) + 8 * unit <= panel.right - written.right:
        at = (written.right + 8 * unit, panel.bottom + 0.2 * size)
        canvas.text(at, "pairs", size, canvas.theme.faint, line="top")
    begun = [
        (_Line.of(curve, across, up, scale).up_to(across.at(results.reached)), texts)
        for curve, texts in zip(curves, wordings, strict=True)
        if curve.pairs[0] <= results.reached
    ]
    lines = [line for line, _ in begun]
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
        for x, y in zip(line.x[line.runs > 0], line.y[line.runs > 0], strict=True):
            dot(part, float(x), float(y), line.colour, 3.4)
    left = max((float(line.x[-1]) for line in lines), default=end) + pen
    labels = [
        (float(line.y[-1]), texts[np.count_nonzero(line.runs) - 1], line.colour)
        for line, texts in begun
    ]
    end_labels(canvas, left, Box(left, panel.top, left + room, panel.bottom), labels)
    return len(lines)


@dataclass(frozen=True)
class _Line:
    """A learning curve on the page, px.

    Attributes:
        colour: of the learner.
        runs: [n], how many seeds there are; 0 where the line is on its way to the next mean.
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

    def up_to(self, x: float) -> "_Line":
        """The line from its first mean as far as x, px."""
        # a hundredth of a pixel is a matter of rounding
        passed = max(1, int(np.searchsorted(self.x, x + 0.01)))
        if passed == len(self.x):
            return self
        share = (x - self.x[passed - 1]) / (self.x[passed] - self.x[passed - 1])

        def cut(values: FloatArray) -> FloatArray:
            end = (1.0 - share) * values[passed - 1] + share * values[passed]
            kept: FloatArray = np.concatenate([values[:passed], end[None]])
            return kept

        return _Line(
            self.colour,
            np.append(self.runs[:passed], 0),
            *map(cut, (self.x, self.y, self.low, self.high, self.whiskers)),
        )


def _wordings(curve: Curve, values: Sequence[str]) -> list[tuple[str, str]]:
    """What is written where a curve has each of these values, the longer wording first."""
    name = learner_name(curve.learner)
    return [(f"{name} {value}", name) for value in values]


def _percent(share: float) -> str:
    """A percentage to about two digits."""
    if share <= 0.0:
        return "0 %"
    digits = 0 if share >= 9.95 else 1 if share >= 0.995 else 2
    return f"{share:.{digits}f} %" if share >= 0.005 else "< 0.01 %"
