"""The picture's account of the teachers: how they weigh and value, and what they pick."""

from collections.abc import Sequence

import numpy as np

from learners import CptParameters, value, weight
from scenes import Rollouts
from studio.painter.axes import Axis
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.lettering import SEMIBOLD
from studio.scene.judgements import Judgement, utilities
from studio.style.ticks import round_range, ticks
from studio.style.words import action_label, number

_PROBABILITY = ["probability p · thin: of gains, bold: of losses", "probability p", "p"]


def draw_teachers(
    canvas: Canvas, box: Box, rollouts: Rollouts, judgements: Sequence[Judgement]
) -> None:
    """Draw the teachers' weighting and value curves, and below them their parameters and picks."""
    kind, unit = canvas.type, canvas.unit
    row = 1.55 * kind.body
    table_height = row * len(judgements) + 1.5 * kind.small
    # no taller than wide, so that slopes can be compared
    tallest = box.width / 2 + 2 * kind.heading
    floor = min(box.bottom - table_height - 14 * unit, box.top + tallest)
    left, right = Box(box.left, box.top, box.right, floor).columns((1, 1), 40 * unit)
    _draw_weighting(canvas, left, judgements)
    _draw_values(canvas, right, rollouts, judgements)
    table_top = floor + 14 * unit
    table = Box(box.left, table_top, box.right, table_top + table_height)
    _draw_table(canvas, table, rollouts, judgements)


def _frame(
    canvas: Canvas,
    box: Box,
    title: str,
    below: Sequence[str],
    x_range: tuple[float, float],
    y_range: tuple[float, float],
) -> tuple[Axis, Axis]:
    """Draw the title and the frame of a curve plot; returns its axes across and upwards."""
    kind, unit, theme, corner = canvas.type, canvas.unit, canvas.theme, (box.left, box.top)
    canvas.fit(corner, title, box.width, kind.heading, theme.ink, SEMIBOLD, line="top")
    panel = Box(box.left, box.top + 1.5 * kind.heading, box.right, box.bottom - 1.4 * kind.small)
    canvas.fill(panel, theme.panel)
    across = Axis(*x_range, panel.left, panel.right)
    up = Axis(*y_range, panel.bottom, panel.top)
    for x in ticks(*x_range, 4):
        at = round(across.at(x))
        canvas.fill(Box(at, panel.top, at + canvas.hair, panel.bottom), theme.grid)
    for y in ticks(*y_range, 4):
        at = round(up.at(y))
        canvas.fill(Box(panel.left, at, panel.right, at + canvas.hair), theme.grid)
    low, high = map(number, x_range)
    small, faint, top = kind.small, theme.faint, panel.bottom + 0.2 * kind.small
    first = canvas.text((panel.left, top), low, small, faint, line="top")
    last = canvas.text((panel.right, top), high, small, faint, anchor="right", line="top")
    middle = box.centre[0]
    room = 2 * min(middle - first.right, last.left - middle) - 8 * unit
    canvas.fit((middle, top), below, room, small, faint, anchor="centre", line="top")
    return across, up


def _draw_weighting(canvas: Canvas, box: Box, judgements: Sequence[Judgement]) -> None:
    """Draw how likely a probability feels to each teacher: losses solid, gains thin."""
    across, up = _frame(canvas, box, "Probability weighting", _PROBABILITY, (0.0, 1.0), (0.0, 1.0))
    p = np.linspace(0.0, 1.0, 201)
    for judgement in judgements:
        of_gains, of_losses = judgement.parameters.gamma, judgement.parameters.delta
        for curvature, width in ((of_gains, 1.5), (of_losses, 3)):
            curve = np.stack([across.along(p), up.along(weight(p, curvature))], axis=-1)
            canvas.line(curve, judgement.colour, width * canvas.unit)


def _draw_values(
    canvas: Canvas, box: Box, rollouts: Rollouts, judgements: Sequence[Judgement]
) -> None:
    """Draw what gains and losses as large as this scene's are worth to each teacher."""
    _, reach = round_range(0.0, max(float(np.abs(utilities(rollouts)).max()), 0.01))
    x = np.linspace(-reach, reach, 201)
    curves = [value(x, judgement.parameters) for judgement in judgements]
    lowest = min((float(curve.min()) for curve in curves), default=-reach)
    highest = max((float(curve.max()) for curve in curves), default=reach)
    across, up = _frame(
        canvas, box, "Value", ["utility x", "x"], (-reach, reach), (lowest * 1.05, highest * 1.25)
    )
    x_zero, y_zero, hair, faint = across.at(0.0), up.at(0.0), canvas.hair, canvas.theme.faint
    canvas.fill(Box(x_zero, up.end, x_zero + hair, up.start), faint)
    canvas.fill(Box(across.start, y_zero, across.end, y_zero + hair), faint)
    for judgement, curve in zip(judgements, curves, strict=True):
        line = np.stack([across.along(x), up.along(curve)], axis=-1)
        canvas.line(line, judgement.colour, 3 * canvas.unit)


def _draw_table(
    canvas: Canvas, box: Box, rollouts: Rollouts, judgements: Sequence[Judgement]
) -> None:
    """Write each teacher's parameters and pick; the swatches are the legend of the curves."""
    kind, unit, theme = canvas.type, canvas.unit, canvas.theme
    header, *rows = box.rows((1.5 * kind.small, *[1.55 * kind.body] * len(judgements)))
    widths = (88, *[44] * len(CptParameters.SYMBOLS), 150)
    titles = ("teacher", *CptParameters.SYMBOLS, "picks")
    for title, cell in zip(titles, header.columns(widths, 2 * unit), strict=True):
        canvas.fit((cell.left, cell.centre[1]), title, cell.width, kind.small, theme.faint)
    for judgement, row in zip(judgements, rows, strict=True):
        canvas.fill(Box(row.left, row.top, row.right, row.top + canvas.hair), theme.grid)
        name, *cells, pick = row.columns(widths, 2 * unit)
        colour, middle = judgement.colour, row.centre[1]
        swatch = Box(name.left, middle - 2 * unit, name.left + 16 * unit, middle + 2 * unit)
        canvas.fill(swatch, colour)
        at, room = (name.left + 22 * unit, middle), name.width - 22 * unit
        canvas.fit(at, judgement.label, room, kind.body, theme.legible(colour), SEMIBOLD)
        for given, cell in zip(judgement.parameters.numbers, cells, strict=True):
            wordings = [f"{given:.2f}", f"{given:.2f}".lstrip("0")]
            at, room = (cell.left, middle), cell.width - 4 * unit
            canvas.fit(at, wordings, room, kind.small, theme.ink)
        best = rollouts.names[judgement.best]
        text = canvas.abbreviated(action_label(best), pick.width, kind.body, SEMIBOLD)
        ink = theme.legible(theme.action_colour(best))
        canvas.text((pick.left, middle), text, kind.body, ink, SEMIBOLD)
