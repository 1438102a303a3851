"""The head above a teacher's plots: who was learned from, and with which parameters."""

from collections.abc import Sequence

from learners import Teacher
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.lettering import ASCENT, DESCENT, SEMIBOLD
from studio.study.results import Stage, StudyResults
from studio.study.words import parameters_told, verdicts
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


def draw_head(canvas: Canvas, box: Box, stage: Stage, teacher: Teacher) -> None:
    """Write who was learned from, their parameters, and who learned better."""
    kind, unit = canvas.type, canvas.unit
    colour = canvas.theme.legible(teacher_colour(teacher.name))
    canvas.fill(Box(box.left, box.top, box.right, box.top + max(2.0, 3 * unit)), colour)
    name = teacher_name(teacher.name)
    baseline = box.top + 9 * unit + ASCENT * kind.heading
    for title, size in (
        (f"Teacher: {name}", kind.heading),
        *((name, size) for size in (kind.heading, kind.body, kind.small)),
    ):
        if canvas.measure(title, size, SEMIBOLD) <= box.width:
            break
    else:
        title = canvas.abbreviated(name, box.width, size, SEMIBOLD)
    written = canvas.text((box.left, baseline), title, size, colour, SEMIBOLD, line="base")
    if _has_room_for_parameters(canvas, box, stage.results):
        at = (box.right, written.centre[1])
        canvas.text(at, parameters_told(teacher), kind.small, canvas.theme.faint, anchor="right")
    wordings = verdicts(stage, teacher)
    if wordings:
        verdict = canvas.fitted(wordings, box.width, kind.small)
        at = (box.left, baseline + DESCENT * kind.heading + 2 * unit)
        canvas.text(at, verdict, kind.small, canvas.theme.ink, line="top")


def _has_room_for_parameters(canvas: Canvas, box: Box, results: StudyResults) -> bool:
    """Whether every teacher's name and parameters fit in one line of a head of this width."""
    kind, gap = canvas.type, 14 * canvas.unit
    widths = [
        canvas.measure(f"Teacher: {teacher_name(teacher.name)}", kind.heading, SEMIBOLD)
        + canvas.measure(parameters_told(teacher), kind.small)
        for teacher in results.teachers
    ]
    return max(widths, default=0.0) + gap <= box.width
