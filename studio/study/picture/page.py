"""One still picture of a study: who learned what from whom, and how fast.

One column a teacher. From above: regret over the number of pairs, the weighting and the value
function that were learnt beside the true ones, the parameters, and how well preferences and picks
are predicted. A single teacher gets the page to himself, in two columns.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import pyarrow as pa

from learners import Teacher
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.lettering import SEMIBOLD
from studio.scene.picture.titles import draw_heading
from studio.study.picture.minds import draw_calibration, draw_parameters, draw_shapes
from studio.study.picture.progress import draw_agreement, draw_regret
from studio.study.picture.results import PARAMETERS, Results, numbers_of
from studio.study.picture.scales import Scales
from studio.style.palette import LIGHT, Theme, teacher_colour
from studio.style.words import counted, number, teacher_name

SIZE = (1600, 1000)

_BETWEEN = 14  # rows
_NOTE_STEP = 1.25  # from line to line of the notes, in sizes of their type
_WIDE = 1.2  # a page for one teacher that is so many times as wide as high gets two columns


def compose_learning_picture(
    table: pa.Table,
    teachers: Sequence[Teacher],
    size: tuple[int, int] = SIZE,
    theme: Theme = LIGHT,
) -> Canvas:
    """Draw the picture of a study.

    Args:
        table: one row a fit, see `learners.run_study`; it may be incomplete.
        teachers: who were learned from; of more than four, the first four are shown.
        size: width and height, px.
        theme: of the page.

    Returns:
        The canvas, which holds the pixels and knows where its texts are.

    Raises:
        InputError: if the size is not allowed.
    """
    results = Results.of(table, teachers)
    page = lay_out(results, size, theme)
    return draw_page(page, results)


# The page


@dataclass(frozen=True)
class Column:
    """Where the things to say of one teacher lie.

    Attributes:
        teacher: who was learned from.
        head: the teacher and the verdict.
        regret: the plot of regret.
        shapes: of weights and values; None if nobody learnt any.
        parameters: of reward and parameters.
        calibration: of errors of predictions.
        agreement: of picks.
    """

    teacher: Teacher
    head: Box
    regret: Box
    shapes: Box | None
    parameters: Box
    calibration: Box
    agreement: Box


@dataclass(frozen=True)
class Page:
    """What stays the same however far the results go.

    Attributes:
        canvas: with the title of the study.
        heading: where it lies, and the number of pairs at its right.
        columns: one a teacher.
        notes: where the notes begin and end.
        scales: of all plots.
    """

    canvas: Canvas
    heading: Box
    columns: tuple[Column, ...]
    notes: Box
    scales: Scales


def lay_out(results: Results, size: tuple[int, int], theme: Theme) -> Page:
    """Draw what stays the same however far the results of a study go.

    Raises:
        InputError: if the size is not allowed.
    """
    canvas = Canvas(*size, theme)
    kind, unit, page = canvas.type, canvas.unit, canvas.page
    stages = [results.up_to(pairs) for pairs in results.all_sizes]
    counts = [canvas.measure(_count(stage), kind.title, SEMIBOLD) for stage in stages]
    room = page.width - max(counts, default=0.0) - kind.title
    heading = draw_heading(canvas, page, results.titles(), results.subtitles(), room)
    lines = max((len(_notes(canvas, page, stage)) for stage in stages), default=0)
    notes_top = page.bottom - lines * _NOTE_STEP * kind.small
    notes = Box(page.left, notes_top, page.right, page.bottom)
    body = Box(page.left, heading.bottom + 16 * unit, page.right, notes.top - 8 * unit)
    boxes = body.columns([1.0] * max(len(results.teachers), 1), canvas.gap)
    columns = tuple(
        _lay_out_column(canvas, box, results, teacher)
        for teacher, box in zip(results.teachers, boxes, strict=False)
    )
    return Page(canvas, heading, columns, notes, Scales.around(results))


def _lay_out_column(canvas: Canvas, box: Box, results: Results, teacher: Teacher) -> Column:
    kind, unit, gap = canvas.type, canvas.unit, _BETWEEN * canvas.unit
    # two lines, each of which may end a pixel lower than it is high
    height = 9 * unit + kind.heading + 1
    height += 2 * unit + kind.small + 1 if results.compared else 0
    head = Box(box.left, box.top, box.right, box.top + height)
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
    return Column(teacher, head, regret, shapes_box, parameters, calibration, agreement)


def draw_page(page: Page, results: Results) -> Canvas:
    """Draw the results, as far as they go, on a page that was laid out for them.

    Returns:
        A canvas of its own.
    """
    canvas = page.canvas.copy()
    kind, scales = canvas.type, page.scales
    canvas.text(
        (page.heading.right, page.heading.top),
        _count(results),
        kind.title,
        canvas.theme.ink,
        SEMIBOLD,
        anchor="right",
        line="top",
    )
    for column in page.columns:
        teacher = column.teacher
        _draw_head(canvas, column.head, results, teacher)
        if column.shapes is not None:
            draw_shapes(canvas, column.shapes, results, teacher, scales)
        draw_parameters(canvas, column.parameters, results, teacher, scales)
        draw_calibration(canvas, column.calibration, results, teacher, scales)
        draw_regret(canvas, column.regret, results, teacher, scales)
        draw_agreement(canvas, column.agreement, results, teacher, scales)
    for index, line in enumerate(_notes(canvas, page.notes, results)):
        top = page.notes.top + index * _NOTE_STEP * kind.small
        canvas.text((page.notes.left, top), line, kind.small, canvas.theme.faint, line="top")
    return canvas


def _count(results: Results) -> str:
    """How many pairs were learned from, for the top of the page."""
    return counted(results.sizes[-1], "pair") if results.sizes else ""


def _notes(canvas: Canvas, box: Box, results: Results) -> list[str]:
    """What lines and marks mean, in lines."""
    return canvas.wrapped(results.notes(), box.width, canvas.type.small)


def _draw_head(canvas: Canvas, box: Box, results: Results, teacher: Teacher) -> None:
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
    given = zip(PARAMETERS.values(), numbers_of(teacher.parameters), strict=True)
    said = "  ".join(f"{letter} {number(value, '.3g')}" for letter, value in given)
    if canvas.measure(said, kind.small) <= box.right - written.right - 14 * unit:
        at = (box.right, written.centre[1])
        canvas.text(at, said, kind.small, canvas.theme.faint, anchor="right")
    verdicts = results.verdicts(teacher.name)
    if verdicts:
        verdict = canvas.fitted(verdicts, box.width, kind.small)
        at = (box.left, written.bottom + 2 * unit)
        canvas.text(at, verdict, kind.small, canvas.theme.ink, line="top")
