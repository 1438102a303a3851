"""The first page of a study: its finding, the regret of every learner, one panel a teacher."""

from dataclasses import dataclass

from learners import Teacher
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.lettering import SEMIBOLD
from studio.scene.picture.titles import draw_heading
from studio.study.picture.heads import draw_teacher_head, teacher_head_height
from studio.study.picture.panels import draw_notes, notes_height, title_room
from studio.study.picture.progress import draw_regret
from studio.study.picture.scales import Scales
from studio.study.results import Stage, StudyResults
from studio.study.words import finding_notes, findings_told, reached, study_subtitles
from studio.style.palette import LIGHT, Theme

SIZE = (1600, 900)
"""Width and height of a page of a study unless one asks for others, px."""

MOST_TEACHERS = 4
"""Panels of more teachers would be too narrow to read."""


@dataclass(frozen=True)
class FindingPage:
    """What stays the same at all stages of a study."""

    canvas: Canvas  # with the subtitle and the notes
    results: StudyResults  # of the teachers that there is room for
    heading: Box  # where the title lies; the number of pairs is at its right
    room: float  # for the title, px
    panels: tuple[tuple[Teacher, Box, Box], ...]  # each teacher with a head and a plot below it
    scales: Scales  # that the plots of all teachers share


def compose_finding(
    results: StudyResults, size: tuple[int, int] = SIZE, theme: Theme = LIGHT
) -> Canvas:
    """Draw the finding of a study, of whose teachers the first four are shown; sizes are in px.

    Raises:
        InputError: if the size is not allowed.
    """
    page = lay_out_finding(results, size, theme)
    return draw_finding(page, page.results.stages[-1])


def lay_out_finding(
    results: StudyResults, size: tuple[int, int], theme: Theme, *more_notes: str
) -> FindingPage:
    """Draw what stays the same, and say where the rest goes; further notes follow the usual ones.

    Raises:
        InputError: if the size is not allowed.
    """
    left_out = len(results.teachers[MOST_TEACHERS:])
    results = results.among(results.teachers[:MOST_TEACHERS])
    canvas = Canvas(*size, theme)
    kind, unit, page = canvas.type, canvas.unit, canvas.page
    room = title_room(canvas, results)
    # the title differs from stage to stage
    heading = draw_heading(canvas, page, [""], study_subtitles(results, left_out), room)
    notes = canvas.wrapped([*finding_notes(results), *more_notes], page.width, kind.small)
    top = page.bottom - notes_height(canvas, len(notes))
    draw_notes(canvas, page.left, top, notes)
    body = Box(page.left, heading.bottom + 18 * unit, page.right, top - 12 * unit)
    panels = []
    boxes = _panels(body, max(len(results.teachers), 1), canvas.gap)
    for teacher, box in zip(results.teachers, boxes, strict=False):
        head = Box(box.left, box.top, box.right, box.top + teacher_head_height(canvas, results))
        plot = Box(box.left, head.bottom + 12 * unit, box.right, box.bottom)
        panels.append((teacher, head, plot))
    return FindingPage(canvas, results, heading, room, tuple(panels), Scales.around(results))


def draw_finding(page: FindingPage, stage: Stage) -> Canvas:
    """Draw what was found by a stage, on a copy of the page that was laid out for the study."""
    canvas = page.canvas.copy()
    corner, size = (page.heading.right, page.heading.top), canvas.type.title
    ink, start = canvas.theme.ink, (page.heading.left, page.heading.top)
    canvas.fit(start, findings_told(stage), page.room, size, ink, SEMIBOLD, line="top")
    canvas.text(corner, reached(stage), size, ink, SEMIBOLD, anchor="right", line="top")
    for teacher, head, plot in page.panels:
        draw_teacher_head(canvas, head, stage, teacher)
        draw_regret(canvas, plot, stage, teacher, page.scales)
    return canvas


def _panels(body: Box, count: int, gap: float) -> list[Box]:
    """Boxes for this many panels: in one row, or in two where four would be too narrow."""
    one_row = body.columns([1.0] * count, gap)
    if count < MOST_TEACHERS or one_row[0].width > 0.75 * body.height:
        return [*one_row]
    return [box for row in body.rows([1.0, 1.0], gap) for box in row.columns([1.0, 1.0], gap)]
