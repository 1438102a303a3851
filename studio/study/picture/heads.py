"""The head above a teacher's plots: who was learned from, their parameters, who learned better."""

from learners import Teacher
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.lettering import SEMIBOLD
from studio.study.results import Stage, StudyResults
from studio.study.words import parameters_told, verdicts
from studio.style.palette import teacher_colour
from studio.style.words import teacher_name


def head_height(canvas: Canvas, results: StudyResults) -> float:
    """How high the head of a teacher is, px."""
    kind, unit = canvas.type, canvas.unit
    # two lines, each of which may end a pixel lower than it is high
    height = 9 * unit + kind.heading + 1
    return height + (2 * unit + kind.small + 1 if results.paired else 0)


def draw_head(canvas: Canvas, box: Box, stage: Stage, teacher: Teacher) -> None:
    """Write who was learned from, their parameters, and who learned better."""
    kind, unit = canvas.type, canvas.unit
    colour = canvas.theme.legible(teacher_colour(teacher.name))
    canvas.fill(Box(box.left, box.top, box.right, box.top + max(2.0, 3 * unit)), colour)
    name = teacher_name(teacher.name)
    title = f"Teacher: {name}"
    if canvas.measure(title, kind.heading, SEMIBOLD) > box.width:
        title = canvas.abbreviated(name, box.width, kind.heading, SEMIBOLD)
    at = (box.left, box.top + 9 * unit)
    written = canvas.text(at, title, kind.heading, colour, SEMIBOLD, line="top")
    said = parameters_told(teacher)
    if canvas.measure(said, kind.small) <= box.right - written.right - 14 * unit:
        at = (box.right, written.centre[1])
        canvas.text(at, said, kind.small, canvas.theme.faint, anchor="right")
    wordings = verdicts(stage, teacher)
    if wordings:
        verdict = canvas.fitted(wordings, box.width, kind.small)
        at = (box.left, written.bottom + 2 * unit)
        canvas.text(at, verdict, kind.small, canvas.theme.ink, line="top")
