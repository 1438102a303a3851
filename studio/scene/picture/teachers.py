"""The picture's table of teachers: their parameters, and what they pick."""

from collections.abc import Sequence

from learners import CptParameters
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.lettering import SEMIBOLD
from studio.painter.pens import pen_mark
from studio.scene.judgements import Judgement
from studio.scene.words import pick_told
from studio.style.words import action_label, alternatives


def table_height(canvas: Canvas, count: int) -> float:
    """Height of the table of `count` teachers, px."""
    return 1.5 * canvas.type.small + 1.45 * canvas.type.body * count


def draw_teachers(
    canvas: Canvas, box: Box, names: Sequence[str], judgements: Sequence[Judgement]
) -> None:
    """Write each teacher's parameters and pick among actions of these names."""
    kind, unit, theme = canvas.type, canvas.unit, canvas.theme
    header, *rows = box.rows((1.5 * kind.small, *[1.45 * kind.body] * len(judgements)))
    widths = (92, *[46] * len(CptParameters.SYMBOLS), 150)
    titles = ("teacher", *CptParameters.SYMBOLS, "picks")
    for title, cell in zip(titles, header.columns(widths, 2 * unit), strict=True):
        canvas.fit((cell.left, cell.centre[1]), title, cell.width, kind.small, theme.faint)
    for judgement, row in zip(judgements, rows, strict=True):
        canvas.fill(Box(row.left, row.top, row.right, row.top + canvas.hair), theme.grid)
        name, *cells, pick = row.columns(widths, 2 * unit)
        colour, middle = judgement.colour, row.centre[1]
        pen_mark(canvas, (name.left + 7 * unit, middle), judgement.pen, 5.5 * unit, theme.ground)
        at, room = (name.left + 20 * unit, middle), name.width - 20 * unit
        canvas.fit(at, judgement.label, room, kind.body, theme.legible(colour), SEMIBOLD)
        for given, cell in zip(judgement.parameters.numbers, cells, strict=True):
            wordings = [f"{given:.2f}", f"{given:.2f}".lstrip("0"), f"{given:g}"]
            at = (cell.left, middle)
            canvas.fit(at, wordings, cell.width, kind.small, theme.ink)
        _draw_pick(canvas, pick, names, judgement)


def _draw_pick(canvas: Canvas, cell: Box, names: Sequence[str], judgement: Judgement) -> None:
    """Write what a teacher picks; several actions, of which it is open which, are all named."""
    size, at = canvas.type.body, (cell.left, cell.centre[1])
    likely = [action_label(names[index]) for index in judgement.candidates]
    if judgement.is_sure:
        text = canvas.abbreviated(likely[0], cell.width, size, SEMIBOLD)
        ink = canvas.theme.legible(canvas.theme.action_colour(names[judgement.candidates[0]]))
        canvas.text(at, text, size, ink, SEMIBOLD)
        return
    wordings = [f"open: {pick_told(judgement, names)}"]
    if len(likely) > 2:
        wordings.append(f"open: {alternatives([likely[0], f'{len(likely) - 1} more'])}")
    wordings.append(f"open: {len(likely)} of {len(names)}")
    if canvas.measure(wordings[0], size) > cell.width:
        size = canvas.type.small
    canvas.fit(at, wordings, cell.width, size, canvas.theme.ink)
