"""The figure of where minds part: how every teacher ranks the actions."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from studio.arrays import FloatArray
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.lettering import REGULAR, SEMIBOLD
from studio.painter.marks import dot
from studio.painter.pens import pen_mark
from studio.scene.judgements import Judgement
from studio.style.words import action_label, rounded_number

_TALLEST_ROW = 60.0  # in units of the page
_SAME, _OTHER = 1.5, 4.0  # width of a line to the same rank and to another one, units of the page


def draw_ranks(
    canvas: Canvas, box: Box, names: tuple[str, ...], judgements: Sequence[Judgement]
) -> None:
    """Draw a column a teacher with the actions from the best to the worst and their values V.

    A line an action joins its places, bold where the next teacher gives it another rank. What a
    teacher picks, or may pick where that is open, is written bold.
    """
    if not judgements:
        return
    kind, unit = canvas.type, canvas.unit
    labels = [action_label(name) for name in names]
    widest = max(canvas.measure(label, kind.body, SEMIBOLD) for label in labels)
    aside = min(widest + 16 * unit, 0.24 * box.width)
    right = aside if len(judgements) > 1 else box.width - aside
    plot = Box(box.left + aside, box.top, box.right - right, box.bottom)
    head = 2.0 * kind.heading
    pitch = min((box.height - head) / len(names), _TALLEST_ROW * unit)
    value_width = canvas.measure("−0.000", kind.body, SEMIBOLD) + 20 * unit
    step = (plot.width - value_width) / max(len(judgements) - 1, 1)
    columns = plot.left + 8 * unit + step * np.arange(len(judgements))
    levels: list[FloatArray] = [
        plot.top + head + (judgement.ranks.astype(np.float64) + 0.5) * pitch
        for judgement in judgements
    ]
    for place, (here, there) in enumerate(pairwise(levels)):
        ends = columns[place] + value_width, columns[place + 1] - 8 * unit
        for name, start, end in zip(names, here.tolist(), there.tolist(), strict=True):
            width = (_SAME if start == end else _OTHER) * unit
            colour = canvas.theme.action_colour(name)
            canvas.line(_bend(*ends, start, end), colour, width)
    for x, heights, judgement in zip(columns.tolist(), levels, judgements, strict=True):
        _draw_column(canvas, x, plot.top, heights, names, judgement)
    sides = [(box.left + aside - 8 * unit, levels[0], "right")]
    if len(judgements) > 1:
        sides.append((columns[-1] + value_width, levels[-1], "left"))
    for x, heights, anchor in sides:
        for name, label, y in zip(names, labels, heights.tolist(), strict=True):
            text = canvas.abbreviated(label, aside - 12 * unit, kind.body, SEMIBOLD)
            ink = canvas.theme.legible(canvas.theme.action_colour(name))
            canvas.text((x, y), text, kind.body, ink, SEMIBOLD, anchor=anchor)


def _draw_column(
    canvas: Canvas,
    x: float,
    top: float,
    heights: FloatArray,
    names: Sequence[str],
    judgement: Judgement,
) -> None:
    """Draw a teacher's dots at a column (px) with the values beside them, below the name."""
    kind, unit, theme = canvas.type, canvas.unit, canvas.theme
    at = (x + 2 * unit, top + 0.6 * kind.heading)
    pen_mark(canvas, at, judgement.pen, 5.5 * unit, theme.ground)
    ink, left = theme.legible(judgement.colour), (x + 16 * unit, at[1])
    canvas.fit(left, judgement.label, 8 * kind.heading, kind.heading, ink, SEMIBOLD)
    rows = zip(names, heights.tolist(), judgement.values.tolist(), strict=True)
    for index, (name, y, value) in enumerate(rows):
        dot(canvas, x, y, theme.action_colour(name), 6.0)
        weight = SEMIBOLD if index in judgement.candidates else REGULAR
        told = rounded_number(value, 3, ".3f")
        canvas.text((x + 12 * unit, y), told, kind.body, theme.ink, weight)


def _bend(left: float, right: float, start: float, end: float) -> FloatArray:
    """A line from one height to another, [N, 2], px, level at both ends."""
    along = np.linspace(0.0, 1.0, 25)
    turn = along**2 * (3.0 - 2.0 * along)
    return np.stack([left + (right - left) * along, start + (end - start) * turn], axis=-1)
