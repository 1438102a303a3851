"""The second page of a study: what was learned from whom, beside what is true.

One column a teacher. From above: regret over the number of pairs, the weighting and the value
function that were learnt beside the true ones, the parameters, and how well preferences and picks
are predicted. A single teacher gets the page to himself, in two columns.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from learners import Teacher
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.lettering import SEMIBOLD
from studio.scene.picture.titles import draw_heading
from studio.study.picture.finding import MOST_TEACHERS, SIZE
from studio.study.picture.heads import draw_head, head_height
from studio.study.picture.minds import draw_calibration, draw_parameters, draw_shapes
from studio.study.picture.progress import draw_agreement, draw_regret
from studio.study.picture.scales import Scales
from studio.study.results import Stage, StudyResults
from studio.study.words import notes, reached, study_subtitles, study_titles
from studio.style.palette import LIGHT, Theme

_BETWEEN = 14  # from row to row of plots, in units of the page
_NOTE_STEP = 1.25  # from line to line of the notes, in sizes of their type
_WIDE = 1.2  # a teacher's part of the page that is wider than this many heights has two columns


def compose_study_picture(
    results: StudyResults, size: tuple[int, int] = SIZE, theme: Theme = LIGHT
) -> Canvas:
    """Draw what a study learned, of whose teachers the first four are shown; sizes are in px.

    Raises:
        InputError: if the size is not allowed.
    """
    page = lay_out_study(results, size, theme)
    return draw_stage(page, page.results.stages[-1])


@dataclass(frozen=True)
class TeacherColumn:
    """Where the plots about one teacher lie."""

    teacher: Teacher
    head: Box  # for the teacher's name and the verdict
    regret: Box
    shapes: Box | None  # for weights and values; None if no learner learnt any
    parameters: Box
    calibration: Box
    agreement: Box


@dataclass(frozen=True)
class StudyPage:
    """What stays the same at all stages of a study."""

    canvas: Canvas  # with the title of the study
    results: StudyResults  # of the teachers that there is room for
    heading: Box  # where the title lies; the number of pairs is at its right
    columns: tuple[TeacherColumn, ...]  # one a teacher
    notes: Box  # where the notes lie
    more_notes: tuple[str, ...]  # that follow the usual ones
    scales: Scales  # that the plots of all teachers share


def lay_out_study(
    results: StudyResults, size: tuple[int, int], theme: Theme, *more_notes: str
) -> StudyPage:
    """Draw what stays the same at all stages of a study; further notes follow the usual ones.

    Raises:
        InputError: if the size is not allowed.
    """
    left_out = len(results.teachers[MOST_TEACHERS:])
    results = results.among(results.teachers[:MOST_TEACHERS])
    canvas = Canvas(*size, theme)
    kind, unit, page = canvas.type, canvas.unit, canvas.page
    widths = [canvas.measure(reached(stage), kind.title, SEMIBOLD) for stage in results.stages]
    room = page.width - max(widths) - kind.title
    heading = draw_heading(
        canvas, page, study_titles(results), study_subtitles(results, left_out), room
    )
    lines = max(len(_note_lines(canvas, page, stage, more_notes)) for stage in results.stages)
    notes_top = page.bottom - lines * _NOTE_STEP * kind.small
    notes_box = Box(page.left, notes_top, page.right, page.bottom)
    body = Box(page.left, heading.bottom + 16 * unit, page.right, notes_top - 8 * unit)
    boxes = body.columns([1.0] * max(len(results.teachers), 1), canvas.gap)
    columns = tuple(
        _lay_out_column(canvas, box, results, teacher)
        for teacher, box in zip(results.teachers, boxes, strict=False)
    )
    scales = Scales.around(results)
    return StudyPage(canvas, results, heading, columns, notes_box, more_notes, scales)


def _lay_out_column(
    canvas: Canvas, box: Box, results: StudyResults, teacher: Teacher
) -> TeacherColumn:
    kind, unit, gap = canvas.type, canvas.unit, _BETWEEN * canvas.unit
    head = Box(box.left, box.top, box.right, box.top + head_height(canvas, results))
    rest = Box(box.left, head.bottom + 0.8 * gap, box.right, box.bottom)
    minds = 2 if results.shaped else 1
    if rest.width > _WIDE * rest.height:
        left, right = rest.columns((1.1, 1), canvas.gap)
        regret, predictions = left.rows((1.7, 1), gap)
        *shapes, parameters = right.rows([1.0] * minds, gap)
    else:
        heights = {1: [2.3, 1.2, 1.45], 2: [2.1, 1.3, 1.4, 1.2]}[minds]
        if results.shaped:
            # plots no higher than wide, so that slopes can be compared, and their names
            rows = rest.height - (len(heights) - 1) * gap
            share = min((rest.width / 3 + 2.5 * kind.small) / rows, heights[1] / sum(heights))
            heights[1] = share / (1.0 - share) * (sum(heights) - heights[1])
        regret, *shapes, parameters, predictions = rest.rows(heights, gap)
    calibration, agreement = predictions.columns((1, 1.25), 20 * unit)
    shapes_box = shapes[0] if shapes else None
    return TeacherColumn(teacher, head, regret, shapes_box, parameters, calibration, agreement)


def draw_stage(page: StudyPage, stage: Stage) -> Canvas:
    """Draw what was found by a stage, on a copy of the page that was laid out for the study."""
    canvas = page.canvas.copy()
    kind, ink, scales = canvas.type, canvas.theme.ink, page.scales
    corner = (page.heading.right, page.heading.top)
    canvas.text(corner, reached(stage), kind.title, ink, SEMIBOLD, anchor="right", line="top")
    for column in page.columns:
        teacher = column.teacher
        draw_head(canvas, column.head, stage, teacher)
        if column.shapes is not None:
            draw_shapes(canvas, column.shapes, stage, teacher, scales)
        draw_parameters(canvas, column.parameters, stage, teacher, scales)
        draw_calibration(canvas, column.calibration, stage, teacher, scales)
        draw_regret(canvas, column.regret, stage, teacher, scales)
        draw_agreement(canvas, column.agreement, stage, teacher, scales)
    for index, line in enumerate(_note_lines(canvas, page.notes, stage, page.more_notes)):
        top = page.notes.top + index * _NOTE_STEP * kind.small
        canvas.text((page.notes.left, top), line, kind.small, canvas.theme.faint, line="top")
    return canvas


def _note_lines(canvas: Canvas, box: Box, stage: Stage, more: Sequence[str]) -> list[str]:
    """What lines and marks mean, broken into lines of the box's width."""
    return canvas.wrapped([*notes(stage), *more], box.width, canvas.type.small)
