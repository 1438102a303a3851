"""The second page of a study: what was learned from whom, beside what is true.

One column a teacher. From above: the weighting and the value function that were learnt beside the
true ones, the reward and the parameters of risk, and how well preferences and picks are predicted.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from learners import Teacher
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.lettering import SEMIBOLD
from studio.painter.pens import pen_mark
from studio.scene.picture.titles import draw_heading
from studio.study.picture.finding import MOST_TEACHERS, SIZE
from studio.study.picture.heads import draw_teacher_head, teacher_head_height
from studio.study.picture.minds import draw_calibration, draw_reward, draw_risk, draw_shapes
from studio.study.picture.panels import draw_notes, notes_height, title_room
from studio.study.picture.progress import draw_agreement
from studio.study.picture.scales import Scales
from studio.study.results import Stage, StudyResults
from studio.study.words import error_notes, notes, reached, study_subtitles, study_titles
from studio.style.palette import LIGHT, Theme, learner_pen
from studio.style.words import learner_name

_BETWEEN = 14  # from row to row of plots, in units of the page
_NARROW = 29  # a column narrower than this many sizes of small type has one plot a row
_LOW = 34  # such a column has no room for errors if it is lower than this many sizes of small type


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
    shapes: Box | None  # for weights and values; None if no learner learnt any
    reward: Box
    risk: Box | None  # for parameters of prospect theory; None likewise
    calibration: Box | None  # for errors of predictions; None if there is no room for them
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
    unit, page = canvas.unit, canvas.page
    room = title_room(canvas, results)
    heading = draw_heading(
        canvas, page, study_titles(results), study_subtitles(results, left_out), room
    )
    _draw_learners(canvas, heading, results)
    lines = max(
        len(_note_lines(canvas, page, stage, (*error_notes(stage), *more_notes)))
        for stage in results.stages
    )
    notes_top = page.bottom - notes_height(canvas, lines)
    notes_box = Box(page.left, notes_top, page.right, page.bottom)
    body = Box(page.left, heading.bottom + 16 * unit, page.right, notes_top - 8 * unit)
    boxes = body.columns([1.0] * max(len(results.teachers), 1), canvas.gap)
    columns = tuple(
        _lay_out_column(canvas, box, results, teacher)
        for teacher, box in zip(results.teachers, boxes, strict=False)
    )
    scales = Scales.around(results)
    return StudyPage(canvas, results, heading, columns, notes_box, more_notes, scales)


def _draw_learners(canvas: Canvas, heading: Box, results: StudyResults) -> None:
    """Say at the right of the subtitle which mark is whose, if there is room."""
    kind, unit = canvas.type, canvas.unit
    names = [learner_name(learner) for learner in results.learners]
    widths = [canvas.measure(name, kind.body, SEMIBOLD) + 34 * unit for name in names]
    subtitle = canvas.texts[-1].box
    left = heading.right - sum(widths)
    if left < subtitle.right:
        return
    for learner, name, width in zip(results.learners, names, widths, strict=True):
        pen, middle = learner_pen(learner), subtitle.centre[1]
        pen_mark(canvas, (left + 22 * unit, middle), pen, 4.5 * unit, canvas.theme.ground)
        colour = canvas.theme.legible(pen.colour)
        canvas.text((left + 34 * unit, middle), name, kind.body, colour, SEMIBOLD)
        left += width


def _lay_out_column(
    canvas: Canvas, box: Box, results: StudyResults, teacher: Teacher
) -> TeacherColumn:
    unit, gap = canvas.unit, _BETWEEN * canvas.unit
    head = Box(box.left, box.top, box.right, box.top + teacher_head_height(canvas, results))
    rest = Box(box.left, head.bottom + 0.8 * gap, box.right, box.bottom)
    shapes = risk = calibration = None
    if rest.width < _NARROW * canvas.type.small:
        if results.shaped and rest.height < _LOW * canvas.type.small:
            shapes, reward, risk, agreement = rest.rows((0.95, 1.63, 1.63, 1.3), gap)
        elif results.shaped:
            rows = rest.rows((0.95, 1.45, 1.45, 0.8, 1.2), gap)
            shapes, reward, risk, calibration, agreement = rows
        else:
            reward, calibration, agreement = rest.rows((1.7, 1.0, 1.0), gap)
    elif results.shaped:
        shapes, parameters, predictions = rest.rows((1.05, 1.2, 1.0), gap)
        reward, risk = parameters.columns((1.45, 1.0), 20 * unit)
        calibration, agreement = predictions.columns((1.0, 1.25), 20 * unit)
    else:
        reward, predictions = rest.rows((1.2, 1.0), gap)
        calibration, agreement = predictions.columns((1.0, 1.25), 20 * unit)
    return TeacherColumn(teacher, head, shapes, reward, risk, calibration, agreement)


def draw_stage(page: StudyPage, stage: Stage) -> Canvas:
    """Draw what was found by a stage, on a copy of the page that was laid out for the study."""
    canvas = page.canvas.copy()
    kind, ink, scales = canvas.type, canvas.theme.ink, page.scales
    corner = (page.heading.right, page.heading.top)
    canvas.text(corner, reached(stage), kind.title, ink, SEMIBOLD, anchor="right", line="top")
    for column in page.columns:
        teacher = column.teacher
        draw_teacher_head(canvas, column.head, stage, teacher)
        if column.shapes is not None:
            draw_shapes(canvas, column.shapes, stage, teacher, scales)
        draw_reward(canvas, column.reward, stage, teacher, scales)
        if column.risk is not None:
            draw_risk(canvas, column.risk, stage, teacher, scales)
        if column.calibration is not None:
            draw_calibration(canvas, column.calibration, stage, teacher, scales)
        draw_agreement(canvas, column.agreement, stage, teacher, scales)
    more = page.more_notes
    if any(column.calibration is not None for column in page.columns):
        more = (*error_notes(stage), *more)
    lines = _note_lines(canvas, page.notes, stage, more)
    draw_notes(canvas, page.notes.left, page.notes.top, lines)
    return canvas


def _note_lines(canvas: Canvas, box: Box, stage: Stage, more: Sequence[str]) -> list[str]:
    """What lines and marks mean, broken into lines of the box's width."""
    return canvas.wrapped([*notes(stage), *more], box.width, canvas.type.small)
