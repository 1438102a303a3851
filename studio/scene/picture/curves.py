"""How teachers weigh probabilities and value gains and losses, as curves."""

from collections.abc import Sequence

import numpy as np

from learners import value, weight
from studio.arrays import FloatArray
from studio.painter.axes import Axis, caption, foot, ground, gutter, labels_below, labels_beside
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.labels import end_labels
from studio.painter.lettering import SEMIBOLD
from studio.painter.pens import pen_line, pen_mark
from studio.scene.judgements import Judgement
from studio.style.ticks import ticks
from studio.style.words import number

_MARKED = (0.15, 0.5, 0.85)  # where along a curve its marks lie, as shares of its length


def draw_weighting(canvas: Canvas, box: Box, judgements: Sequence[Judgement]) -> None:
    """Draw how much a probability counts for each teacher: of losses bold, of gains thin."""
    unit, small = canvas.unit, canvas.type.small
    titles = [
        "Weight w(p) of a probability p · thin: gains",
        "Weight w(p) · thin: gains",
        "w(p) · thin: gains",
        "w(p)",
    ]
    across, up, panel = _frame(canvas, box, titles, (0.0, 1.0), (0.0, 1.0), "p")
    p = np.linspace(0.0, 1.0, 201)
    for judgement in judgements:
        own = judgement.parameters
        for curvature, width in ((own.gamma, 1.5), (own.delta, 3)):
            curve = np.stack([across.along(p), up.along(weight(p, curvature))], axis=-1)
            pen_line(canvas, curve, judgement.pen, width * unit)
    for judgement in judgements:
        curve = weight(p, judgement.parameters.delta)
        _mark(canvas, judgement, np.stack([across.along(p), up.along(curve)], axis=-1))
    # below the curves, where p is large, there is room
    step, right = 1.2 * small, panel.right - 4 * unit
    if len(judgements) * step > 0.55 * panel.height:
        return
    for place, judgement in enumerate(reversed(judgements)):
        at = (right, panel.bottom - 0.4 * small - (place + 0.4) * step)
        ink = canvas.theme.legible(judgement.colour)
        canvas.fit(at, judgement.label, 0.5 * panel.width, small, ink, SEMIBOLD, anchor="right")


def draw_value_curves(
    canvas: Canvas, box: Box, judgements: Sequence[Judgement], reach: float
) -> None:
    """Draw what gains and losses up to a utility (`reach`) are worth to each teacher."""
    x = np.linspace(-reach, reach, 201)
    curves = [value(x, judgement.parameters) for judgement in judgements]
    lowest = min((float(curve.min()) for curve in curves), default=-reach)
    highest = max((float(curve.max()) for curve in curves), default=reach)
    small, unit = canvas.type.small, canvas.unit
    names = [judgement.label for judgement in judgements]
    room = min(
        max((canvas.measure(name, small, SEMIBOLD) for name in names), default=0.0), 72 * unit
    )
    plot = Box(box.left, box.top, box.right - room - 6 * unit, box.bottom)
    titles = ["Value v(x) of a utility x", "Value v(x)", "v(x)"]
    up_range = (lowest * 1.05, highest * 1.25)
    across, up, panel = _frame(canvas, plot, titles, (-reach, reach), up_range, "x")
    hair, faint = canvas.hair, canvas.theme.faint
    x_zero, y_zero = round(across.at(0.0)), round(up.at(0.0))
    canvas.fill(Box(x_zero, panel.top, x_zero + hair, panel.bottom), faint)
    canvas.fill(Box(panel.left, y_zero, panel.right, y_zero + hair), faint)
    ends = []
    for judgement, curve in zip(judgements, curves, strict=True):
        line = np.stack([across.along(x), up.along(curve)], axis=-1)
        pen_line(canvas, line, judgement.pen, 3 * unit)
        _mark(canvas, judgement, line)
        ends.append((float(line[-1, 1]), [judgement.label], judgement.colour))
    column = Box(panel.right, panel.top, box.right, panel.bottom)
    end_labels(canvas, panel.right + 6 * unit, column, ends)


def _mark(canvas: Canvas, judgement: Judgement, line: FloatArray) -> None:
    """Put the teacher's mark on a curve [N, 2], px, in some places."""
    for share in _MARKED:
        x, y = line[round(share * (len(line) - 1))].tolist()
        pen_mark(canvas, (x, y), judgement.pen, 4.2 * canvas.unit, canvas.theme.panel)


def _frame(
    canvas: Canvas,
    box: Box,
    titles: Sequence[str],
    x_range: tuple[float, float],
    y_range: tuple[float, float],
    what: str,
) -> tuple[Axis, Axis, Box]:
    """Draw title, ground, grid and numbers of a plot; its axes across and upwards, its panel."""
    rest = caption(canvas, box, titles)
    x_ticks, y_ticks = ticks(*x_range, 4), ticks(*y_range, 4 if y_range[0] >= 0.0 else 5)
    left = rest.left + gutter(canvas, [number(y) for y in y_ticks])
    # no taller than wide, so that slopes can be compared
    bottom = min(rest.bottom - foot(canvas), rest.top + rest.right - left)
    panel = Box(left, rest.top, rest.right, bottom)
    across = Axis(*x_range, panel.left, panel.right)
    up = Axis(*y_range, panel.bottom, panel.top)
    ground(canvas, panel, [across.at(x) for x in x_ticks], [up.at(y) for y in y_ticks])
    labels_below(canvas, panel, across.at, x_ticks, what)
    labels_beside(canvas, panel, up.at, y_ticks)
    return across, up, panel
