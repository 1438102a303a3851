"""The head above a teacher's plots: who was learned from, and with which parameters."""

from collections.abc import Sequence

from learners import Teacher
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.lettering import SEMIBOLD
from studio.study.words import parameters_told
from studio.style.palette import teacher_colour
from studio.style.words import teacher_name


def draw_heads(canvas: Canvas, boxes: Sequence[Box], teachers: Sequence[Teacher]) -> list[Box]:
    """Write who was learned from along the top of each teacher's box, and their parameters.

    The parameters of all teachers stand beside the names, or below them where one of them would not
    have room.

    Returns:
        What is left of the boxes.
    """
    kind, unit = canvas.type, canvas.unit
    gap, name_line = 14 * unit, 9 * unit + kind.heading + 1
    beside = all(
        canvas.measure(_title(teacher), kind.heading, SEMIBOLD)
        + gap
        + canvas.measure(parameters_told(teacher), kind.small)
        <= box.width
        for teacher, box in zip(teachers, boxes, strict=False)
    )
    rest = []
    for teacher, box in zip(teachers, boxes, strict=False):
        colour = canvas.theme.legible(teacher_colour(teacher.name))
        canvas.fill(Box(box.left, box.top, box.right, box.top + max(2.0, 3 * unit)), colour)
        title = _title(teacher)
        if canvas.measure(title, kind.heading, SEMIBOLD) > box.width:
            name = teacher_name(teacher.name)
            title = canvas.abbreviated(name, box.width, kind.heading, SEMIBOLD)
        at = (box.left, box.top + 9 * unit)
        written = canvas.text(at, title, kind.heading, colour, SEMIBOLD, line="top")
        said, faint = parameters_told(teacher), canvas.theme.faint
        if beside:
            canvas.text((box.right, written.centre[1]), said, kind.small, faint, anchor="right")
        elif canvas.measure(said, kind.small) <= box.width:
            below = (box.left, written.bottom + 2 * unit)
            canvas.text(below, said, kind.small, faint, line="top")
        # lines may end a pixel lower than they are high
        height = name_line if beside else name_line + 2 * unit + kind.small + 1
        rest.append(Box(box.left, box.top + height, box.right, box.bottom))
    return rest


def _title(teacher: Teacher) -> str:
    return f"Teacher: {teacher_name(teacher.name)}"
