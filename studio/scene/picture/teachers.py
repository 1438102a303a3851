"""The picture's account of the teachers: how they weigh and value, and what they pick."""

from collections.abc import Sequence

import numpy as np

from learners import value, weight
from scenes import Rollouts
from studio.painter.axes import Axis
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.lettering import SEMIBOLD
from studio.scene.judgements import Judgement, utilities
from studio.style.palette import teacher_colour
from studio.style.ticks import round_range, ticks
from studio.style.words import action_label, number, teacher_name

_PROBABILITY = ["probability p · thin: of gains, bold: of losses", "probability p", "p"]


def draw_teachers(
    canvas: Canvas, box: Box, rollouts: Rollouts, judgements: Sequence[Judgement]
) -> None:
    """Draw the teachers' weighting and value curves, and below them their parameters and picks.

    Args:
        canvas: to draw on.
        box: where, px.
        rollouts: of the scene under each action.
        judgements: the teachers.
    """
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
    _draw_parameters(canvas, table, rollouts, judgements)


def _frame(
    canvas: Canvas,
    box: Box,
    title: str,
    below: Sequence[str],
    x_range: tuple[float, float],
    y_range: tuple[float, float],
) -> tuple[Axis, Axis]:
    """Draw the title and the frame of a curve plot.

    Returns:
        Its horizontal and its vertical axis.
    """
    kind, unit = canvas.type, canvas.unit
    canvas.text(
        (box.left, box.top),
        canvas.fitted(title, box.width, kind.heading, SEMIBOLD),
        kind.heading,
        canvas.theme.ink,
        SEMIBOLD,
        line="top",
    )
    panel = Box(box.left, box.top + 1.5 * kind.heading, box.right, box.bottom - 1.4 * kind.small)
    canvas.fill(panel, canvas.theme.panel)
    across = Axis(*x_range, panel.left, panel.right)
    up = Axis(*y_range, panel.bottom, panel.top)
    for x in ticks(*x_range, 4):
        at = round(across.at(x))
        canvas.fill(Box(at, panel.top, at + canvas.hair, panel.bottom), canvas.theme.grid)
    for y in ticks(*y_range, 4):
        at = round(up.at(y))
        canvas.fill(Box(panel.left, at, panel.right, at + canvas.hair), canvas.theme.grid)
    low, high = number(x_range[0]), number(x_range[1])
    top = panel.bottom + 0.2 * kind.small
    first = canvas.text((panel.left, top), low, kind.small, canvas.theme.faint, line="top")
    last = canvas.text(
        (panel.right, top), high, kind.small, canvas.theme.faint, anchor="right", line="top"
    )
    room = 2 * min(box.centre[0] - first.right, last.left - box.centre[0]) - 8 * unit
    canvas.text(
        (box.centre[0], top),
        canvas.fitted(below, room, kind.small),
        kind.small,
        canvas.theme.faint,
        anchor="centre",
        line="top",
    )
    return across, up


def _draw_weighting(canvas: Canvas, box: Box, judgements: Sequence[Judgement]) -> None:
    """Draw how likely a probability feels to each teacher: losses solid, gains thin."""
    across, up = _frame(canvas, box, "Probability weighting", _PROBABILITY, (0.0, 1.0), (0.0, 1.0))
    p = np.linspace(0.0, 1.0, 201)
    for judgement in judgements:
        for curvature, width in (
            (judgement.parameters.gamma, 1.5),
            (judgement.parameters.delta, 3),
        ):
            curve = np.stack([across.along(p), up.along(weight(p, curvature))], axis=-1)
            canvas.line(curve, teacher_colour(judgement.teacher), width * canvas.unit)


def _draw_values(
    canvas: Canvas, box: Box, rollouts: Rollouts, judgements: Sequence[Judgement]
) -> None:
    """Draw what gains and losses as large as this scene's are worth to each teacher."""
    _, reach = round_range(0.0, max(float(np.abs(utilities(rollouts)).max()), 0.01))
    x = np.linspace(-reach, reach, 201)
    curves = {judgement.teacher: value(x, judgement.parameters) for judgement in judgements}
    lowest = min((float(curve.min()) for curve in curves.values()), default=-reach)
    highest = max((float(curve.max()) for curve in curves.values()), default=reach)
    across, up = _frame(
        canvas, box, "Value", ["utility x", "x"], (-reach, reach), (lowest * 1.05, highest * 1.25)
    )
    for x_or_y in (
        Box(across.at(0.0), up.end, across.at(0.0) + canvas.hair, up.start),
        Box(across.start, up.at(0.0), across.end, up.at(0.0) + canvas.hair),
    ):
        canvas.fill(x_or_y, canvas.theme.faint)
    for teacher, curve in curves.items():
        line = np.stack([across.along(x), up.along(curve)], axis=-1)
        canvas.line(line, teacher_colour(teacher), 3 * canvas.unit)


def _draw_parameters(
    canvas: Canvas, box: Box, rollouts: Rollouts, judgements: Sequence[Judgement]
) -> None:
    """Write each teacher's parameters and pick; the swatches are the legend of the curves."""
    kind, unit = canvas.type, canvas.unit
    heights = (1.5 * kind.small, *[1.55 * kind.body] * len(judgements))
    header, *rows = box.rows(heights)
    widths = (88, 44, 44, 44, 44, 44, 150)
    titles = ("teacher", "α", "η", "λ", "γ", "δ", "picks")
    for title, cell in zip(titles, header.columns(widths, 2 * unit), strict=True):
        canvas.text(
            (cell.left, cell.centre[1]),
            canvas.fitted(title, cell.width, kind.small),
            kind.small,
            canvas.theme.faint,
        )
    for judgement, row in zip(judgements, rows, strict=True):
        canvas.fill(Box(row.left, row.top, row.right, row.top + canvas.hair), canvas.theme.grid)
        name, *cells, pick = row.columns(widths, 2 * unit)
        colour, middle = teacher_colour(judgement.teacher), row.centre[1]
        canvas.fill(
            Box(name.left, middle - 2 * unit, name.left + 16 * unit, middle + 2 * unit), colour
        )
        left = name.left + 22 * unit
        text = canvas.fitted(
            teacher_name(judgement.teacher), name.right - left, kind.body, SEMIBOLD
        )
        canvas.text((left, middle), text, kind.body, canvas.theme.legible(colour), SEMIBOLD)
        parameters = judgement.parameters
        numbers = (
            parameters.alpha,
            parameters.eta,
            parameters.loss_aversion,
            parameters.gamma,
            parameters.delta,
        )
        for given, cell in zip(numbers, cells, strict=True):
            canvas.text(
                (cell.left, middle),
                canvas.fitted(
                    [f"{given:.2f}", f"{given:.2f}".lstrip("0")],
                    cell.width - 4 * unit,
                    kind.small,
                ),
                kind.small,
                canvas.theme.ink,
            )
        best = rollouts.actions[judgement.best].name
        canvas.text(
            (pick.left, middle),
            canvas.abbreviated(action_label(best), pick.width, kind.body, SEMIBOLD),
            kind.body,
            canvas.theme.legible(canvas.theme.action_colour(best)),
            SEMIBOLD,
        )
