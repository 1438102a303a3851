"""How learners get better with more pairs: regret, and agreement with the teacher's best action."""

from collections.abc import Callable, Sequence

import numpy as np

from learners import Curve, Teacher
from studio.painter.axes import Axis, LogAxis, ground, gutter, labels_below, labels_beside
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.labels import end_labels
from studio.painter.lettering import SEMIBOLD
from studio.painter.marks import band, dot
from studio.study.picture.panels import named_panel
from studio.study.picture.scales import Scales
from studio.study.results import Stage
from studio.study.words import NO_FITS
from studio.style.palette import learner_colour
from studio.style.ticks import decades, ticks
from studio.style.words import learner_name, number


def draw_regret(canvas: Canvas, box: Box, stage: Stage, teacher: Teacher, scales: Scales) -> None:
    """Draw how regret fell with the number of pairs so far, both logarithmic."""
    kind = canvas.type
    wordings = [
        "Held-out regret, % of a random action's",
        "Held-out regret, % of random",
        "Regret, % of random",
        "Regret, %",
    ]
    low, high = scales.regret
    marks = decades(low, high)
    panel = named_panel(canvas, box, wordings, gutter(canvas, list(map(number, marks))))
    has_zero = stage.results.regrets.has_zero
    strip = 1.5 * kind.small if has_zero else 0.0
    up = LogAxis(low, high, panel.bottom - strip, panel.top, panel.bottom - 0.35 * strip)
    marks = [0.0, *marks] if has_zero else marks
    curves = stage.results.curves_of("regret_percent", teacher)
    drawn = _draw_curves(canvas, panel, stage, curves, up, marks, 1.0, _percent)
    if not drawn:
        canvas.text(panel.centre, NO_FITS, kind.small, canvas.theme.faint, anchor="centre")


def draw_agreement(
    canvas: Canvas, box: Box, stage: Stage, teacher: Teacher, scales: Scales
) -> None:
    """Draw in what share of scenes the teacher's best action was picked so far."""
    wordings = [
        "Picks the teacher's best action, % of scenes",
        "Picks the best action, %",
        "Best action picked, %",
        "Best picks, %",
        "Agreement",
    ]
    marks = [mark for mark in ticks(scales.agreement, 100.0, 4) if mark <= 100.0]
    panel = named_panel(canvas, box, wordings, gutter(canvas, list(map(number, marks))))
    # a margin keeps dots at the top whole
    up = Axis(scales.agreement, 100.0, panel.bottom, panel.top + 6 * canvas.unit)
    curves = stage.results.curves_of("agreement", teacher)
    _draw_curves(canvas, panel, stage, curves, up, marks, 100.0, "{:.0f}".format)


def _draw_curves(
    canvas: Canvas,
    panel: Box,
    stage: Stage,
    curves: Sequence[Curve],
    up: Axis | LogAxis,
    marks: Sequence[float],
    scale: float,
    say: Callable[[float], str],
) -> int:
    """Draw curves over the number of pairs, with bands, and names at their ends.

    They go as far as the stage does; their names stand to the right of the farthest end. The axis
    upwards is that of the curves' values times `scale`, which `say` turns into words.
    Returned is how many curves have begun.
    """
    unit, size = canvas.unit, canvas.type.small

    def wordings(curve: Curve, mean: float) -> list[str]:
        name = learner_name(curve.learner)
        return [f"{name} {say(scale * mean)}", name]

    longest = [wordings(curve, mean)[0] for curve in curves for mean in curve.mean]
    widest = [canvas.measure(said, size, SEMIBOLD) for said in longest]
    room = min(max(widest, default=0.0) + 10 * unit, 0.46 * panel.width)
    pen = 9 * unit
    sizes = [float(pairs) for pairs in stage.results.sizes]
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
    written = labels_below(canvas, panel, across.at, sizes, "")
    if written and canvas.measure("pairs", size) + 8 * unit <= panel.right - written.right:
        at = (written.right + 8 * unit, panel.bottom + 0.2 * size)
        canvas.text(at, "pairs", size, canvas.theme.faint, line="top")
    begun = [curve for curve in map(stage.so_far, curves) if len(curve.pairs)]
    colours = [learner_colour(curve.learner) for curve in begun]
    paths = [
        np.stack([across.along(curve.pairs), up.along(scale * curve.mean)], axis=-1)
        for curve in begun
    ]
    for curve, colour in zip(begun, colours, strict=True):
        if len(curve.pairs) > 1 and (curve.runs > 1).any():
            low, high = up.along(scale * curve.low), up.along(scale * curve.high)
            band(canvas, plot, across.along(curve.pairs), low, high, colour)
    part = canvas.clipped(plot)
    for path, colour in zip(paths, colours, strict=True):
        part.line(path, colour, 2.6 * unit)
    for path, colour in zip(paths, colours, strict=True):
        for x, y in path.tolist():
            dot(part, x, y, colour, 3.4)
    left = max((float(path[-1, 0]) for path in paths), default=end) + pen
    labels = [
        (float(path[-1, 1]), wordings(curve, curve.mean[-1]), colour)
        for curve, path, colour in zip(begun, paths, colours, strict=True)
    ]
    end_labels(canvas, left, Box(left, panel.top, left + room, panel.bottom), labels)
    return len(begun)


def _percent(share: float) -> str:
    """A percentage to about two digits."""
    if share <= 0.0:
        return "0 %"
    digits = 0 if share >= 9.95 else 1 if share >= 0.995 else 2
    return f"{share:.{digits}f} %" if share >= 0.005 else "< 0.01 %"
