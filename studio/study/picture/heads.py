"""The head above a teacher's plots: who was learned from, their parameters, who learned better."""

from learners import Teacher
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.lettering import ASCENT, DESCENT, SEMIBOLD
from studio.study.results import Stage, StudyResults
from studio.study.words import parameters_told, verdicts
from studio.style.palette import teacher_colour
from studio.style.words import teacher_name


def teacher_head_height(canvas: Canvas, results: StudyResults) -> float:
    """How high the head of a teacher is, px."""
    kind, unit = canvas.type, canvas.unit
    # two lines, each of which may end a pixel lower than it is high
    height = 9 * unit + kind.heading + 1
    return height + (2 * unit + kind.small + 1 if results.paired else 0)


def draw_teacher_head(canvas: Canvas, box: Box, stage: Stage, teacher: Teacher) -> None:
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
