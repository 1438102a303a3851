"""How learners get better with more pairs: regret, and agreement with the teacher's best action."""

from collections.abc import Callable, Sequence

import numpy as np

from learners import Curve, Teacher
from studio.painter.axes import Axis, LogAxis, ground, gutter, labels_below, labels_beside
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.labels import end_labels
from studio.painter.lettering import SEMIBOLD
from studio.painter.marks import band
from studio.painter.pens import pen_line, pen_mark
from studio.study.picture.growth import grown
from studio.study.picture.panels import named_panel
from studio.study.picture.scales import Scales
from studio.study.results import Stage
from studio.study.words import NO_FITS
from studio.style.palette import Pen, blend, learner_pen
from studio.style.ticks import decades, ticks
from studio.style.words import learner_name, number

_ASIDE = 7.0  # from the seeds of one learner to those of the next, in units of the page


def draw_regret(canvas: Canvas, box: Box, stage: Stage, teacher: Teacher, scales: Scales) -> None:
    """Draw how regret fell with the number of pairs so far, both logarithmic, with every seed."""
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
    _draw_curves(canvas, panel, stage, curves, up, marks, 1.0, _percent, seeds_too=True)


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
    seeds_too: bool = False,
) -> None:
    """Draw curves over the number of pairs, with bands, and names at their ends.

    They go as far as the stage does; their names stand to the right of the farthest end. The axis
    upwards is that of the curves' values times `scale`, which `say` turns into words. Every seed
    and the interquartile mean may be drawn, too. Where no curve has begun, it says so.
    """
    unit, size = canvas.unit, canvas.type.small

    def wordings(curve: Curve, mean: float) -> list[str]:
        name = learner_name(curve.learner)
        return [f"{name} {say(scale * mean)}", name]

    longest = [wordings(curve, mean)[0] for curve in curves for mean in curve.mean]
    widest = [canvas.measure(said, size, SEMIBOLD) for said in longest]
    # how far seeds reach to the side of the mean
    reach = (len(curves) / 2 - 0.05) * _ASIDE * unit if seeds_too else 0.0
    margin = max(9 * unit, reach + 7 * unit)
    room = min(max(widest, default=0.0) + 10 * unit, 0.46 * panel.width)
    sizes = [float(pairs) for pairs in stage.results.sizes]
    first, last = (sizes[0], sizes[-1]) if sizes else (1.0, 10.0)
    if first == last:
        first = last / 4.0  # a single dot lies beside its name
    start, end = panel.left + margin, panel.right - room - margin
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
    begun = [each for curve in curves if len((each := grown(curve, stage.reached)).pairs)]
    pens = [learner_pen(curve.learner) for curve in begun]
    paths = [
        np.stack([across.along(curve.pairs), up.along(scale * curve.mean)], axis=-1)
        for curve in begun
    ]
    for curve, pen in zip(begun, pens, strict=True):
        if len(curve.pairs) > 1 and (curve.runs > 1).any():
            low, high = up.along(scale * curve.low), up.along(scale * curve.high)
            band(canvas, plot, across.along(curve.pairs), low, high, pen.colour)
    part = canvas.clipped(plot)
    if seeds_too:
        for place, (curve, pen) in enumerate(zip(begun, pens, strict=True)):
            aside = (place - (len(begun) - 1) / 2) * _ASIDE * unit
            _draw_seeds(part, curve, across, up, scale, pen, aside)
    for path, pen in zip(paths, pens, strict=True):
        pen_line(part, path, pen, 2.6 * unit)
    for curve, path, pen in zip(begun, paths, pens, strict=True):
        for x, y in path[curve.runs > 0].tolist():
            pen_mark(part, (x, y), pen, 3.6 * unit, canvas.theme.panel)
    left = max((float(path[-1, 0]) for path in paths), default=end) + margin
    labels = [
        # between two sizes there is no number to name
        (
            float(path[-1, 1]),
            wordings(curve, curve.mean[-1])[int(curve.runs[-1] == 0) :],
            pen.colour,
        )
        for curve, path, pen in zip(begun, paths, pens, strict=True)
    ]
    end_labels(canvas, left, Box(left, panel.top, left + room, panel.bottom), labels)
    if not begun:
        canvas.text(panel.centre, NO_FITS, size, canvas.theme.faint, anchor="centre")


def _draw_seeds(
    canvas: Canvas,
    curve: Curve,
    across: LogAxis,
    up: Axis | LogAxis,
    scale: float,
    pen: Pen,
    aside: float,
) -> None:
    """Draw a dot for every seed, and a bar with its interval for the interquartile mean.

    A small triangle stands at the foot of the axis for a seed that lies below it.
    They stand a little to the side of the mean (px), so that those of several learners can be told
    apart.
    """
    unit, faint = canvas.unit, blend(pen.colour, canvas.theme.panel, 0.5)
    for pairs, samples, middle, low, high in zip(
        curve.pairs, curve.samples, curve.middle, curve.middle_low, curve.middle_high, strict=False
    ):
        x = across.at(float(pairs)) + aside
        if len(samples) > 1:
            ends = up.along(scale * np.array([low, high]))
            canvas.line(np.stack([[x, x], ends], axis=-1), pen.colour, unit)
        for sample in (scale * samples).tolist():
            if 0.0 < sample < up.low:
                below = Pen(faint, (), "triangle_down")
                pen_mark(canvas, (x, up.start - 4 * unit), below, 2.6 * unit, canvas.theme.panel)
            else:
                # with an outline, so that dots can be told from the bar that they lie on
                canvas.disc((x, up.at(sample)), 2.8 * unit, pen.colour)
                canvas.disc((x, up.at(sample)), 2.8 * unit - max(0.8, 0.8 * unit), faint)
        if len(samples) > 1:
            y, reach = up.at(scale * float(middle)), 0.55 * _ASIDE * unit
            canvas.line([(x - reach, y), (x + reach, y)], pen.colour, 2.4 * unit)


def _percent(share: float) -> str:
    """A percentage to about two digits."""
    if share <= 0.0:
        return "0 %"
    digits = 0 if share >= 9.95 else 1 if share >= 0.995 else 2
    return f"{share:.{digits}f} %" if share >= 0.005 else "< 0.01 %"
