"""One still picture of a study: who learned what from whom, and how fast.

One column a teacher. From above: regret over the number of pairs, the weighting and the value
function that were learnt beside the true ones, the parameters, and how well preferences and picks
are predicted. A single teacher gets the page to himself, in two columns.
"""

from collections.abc import Sequence
from pathlib import Path

import pyarrow as pa

from learners import Teacher
from studio.naming import number, teacher_name
from studio.painter.canvas import SEMIBOLD, Box, Canvas, PixelArray
from studio.painter.learning_minds import draw_calibration, draw_parameters, draw_shapes
from studio.painter.learning_plots import wrapped
from studio.painter.learning_progress import draw_agreement, draw_regret
from studio.painter.learning_results import PARAMETERS, Results, numbers_of
from studio.painter.learning_scales import Scales
from studio.palette import LIGHT, Theme, teacher_colour

SIZE = (1600, 1000)

_MARGIN, _GAP = 36, 36  # of the page and between its columns, in units of the reference page
_BETWEEN = 14  # rows
_WIDE = 1.2  # a page for one teacher that is so many times as wide as high gets two columns


def draw_learning_picture(
    table: pa.Table,
    teachers: Sequence[Teacher],
    size: tuple[int, int] = SIZE,
    theme: Theme = LIGHT,
) -> PixelArray:
    """Draw the picture of a study.

    Args:
        table: one row a fit, see `learners.run_study`; it may be incomplete.
        teachers: who were learned from; of more than four, the first four are shown.
        size: width and height, px.
        theme: of the page.

    Returns:
        [height, width, 3], red, green, blue.

    Raises:
        InputError: if the size is not allowed.
    """
    return compose_learning_picture(table, teachers, size, theme).pixels


def write_learning_picture(
    path: Path,
    table: pa.Table,
    teachers: Sequence[Teacher],
    size: tuple[int, int] = SIZE,
    theme: Theme = LIGHT,
) -> None:
    """Write the picture of a study as a PNG file; see `draw_learning_picture`.

    Raises:
        InputError: if the size is not allowed.
        RunError: if the file cannot be written.
    """
    compose_learning_picture(table, teachers, size, theme).save(path)


def compose_learning_picture(
    table: pa.Table,
    teachers: Sequence[Teacher],
    size: tuple[int, int] = SIZE,
    theme: Theme = LIGHT,
) -> Canvas:
    """Draw the picture of a study and keep the canvas, which knows where its texts are.

    Arguments and errors as for `draw_learning_picture`.
    """
    canvas = Canvas(*size, theme)
    results = Results.of(table, teachers)
    unit, page = canvas.unit, canvas.box.inset(_MARGIN * canvas.unit)
    top = _draw_title(canvas, page, results) + 16 * unit
    bottom = _draw_notes(canvas, page, results) - 10 * unit
    scales = Scales.around(results)
    body = Box(page.left, top, page.right, bottom)
    columns = body.columns([1.0] * max(len(results.teachers), 1), _GAP * unit)
    for teacher, column in zip(results.teachers, columns, strict=False):
        _draw_teacher(canvas, column, results, teacher, scales)
    return canvas


def _draw_title(canvas: Canvas, page: Box, results: Results) -> float:
    """Write what the page is about along its top.

    Returns:
        Where the title ends, px from the top.
    """
    kind = canvas.type
    title = canvas.fitted(results.titles(), page.width, kind.title, SEMIBOLD)
    box = canvas.text(
        (page.left, page.top), title, kind.title, canvas.theme.ink, SEMIBOLD, line="top"
    )
    subtitle = canvas.fitted(results.subtitles(), page.width, kind.body)
    at = (page.left, box.bottom + 4 * canvas.unit)
    return canvas.text(at, subtitle, kind.body, canvas.theme.faint, line="top").bottom


def _draw_notes(canvas: Canvas, page: Box, results: Results) -> float:
    """Write what lines and marks mean along the bottom of the page.

    Returns:
        Where the notes begin, px from the top.
    """
    size = canvas.type.small
    bottom = page.bottom
    for line in reversed(wrapped(canvas, results.notes(), page.width, size)):
        at = (page.left, bottom)
        bottom = canvas.text(at, line, size, canvas.theme.faint, line="bottom").top - 0.25 * size
    return bottom


def _draw_teacher(
    canvas: Canvas, column: Box, results: Results, teacher: Teacher, scales: Scales
) -> None:
    """Draw all there is to say of one teacher."""
    gap = _BETWEEN * canvas.unit
    top = _draw_head(canvas, column, results, teacher)
    rest = Box(column.left, top + 0.8 * gap, column.right, column.bottom)
    drawn = [draw_shapes] * bool(results.shaped) + [draw_parameters]
    if rest.width > _WIDE * rest.height:
        left, right = rest.columns((1.1, 1), _GAP * canvas.unit)
        regret, predictions = left.rows((1.7, 1), gap)
        minds = [*right.rows([1.0] * len(drawn), gap)]
    else:
        heights = {1: (2.3, 1.2, 1.45), 2: (2.1, 1.35, 1.3, 1.25)}[len(drawn)]
        regret, *minds, predictions = rest.rows(heights, gap)
    draw_regret(canvas, regret, results, teacher, scales)
    for draw, box in zip(drawn, minds, strict=True):
        draw(canvas, box, results, teacher, scales)
    left, right = predictions.columns((1, 1.25), 20 * canvas.unit)
    draw_calibration(canvas, left, results, teacher, scales)
    draw_agreement(canvas, right, results, teacher, scales)


def _draw_head(canvas: Canvas, box: Box, results: Results, teacher: Teacher) -> float:
    """Write who was learned from, their parameters, and who learned better.

    Returns:
        Where the head ends, px from the top.
    """
    kind, unit = canvas.type, canvas.unit
    colour = canvas.theme.legible(teacher_colour(teacher.name))
    canvas.fill(Box(box.left, box.top, box.right, box.top + max(2.0, 3 * unit)), colour)
    name = teacher_name(teacher.name)
    title = canvas.fitted([f"Teacher: {name}", name], box.width, kind.heading, SEMIBOLD)
    at = (box.left, box.top + 9 * unit)
    written = canvas.text(at, title, kind.heading, colour, SEMIBOLD, line="top")
    given = zip(PARAMETERS.values(), numbers_of(teacher.parameters), strict=True)
    said = "  ".join(f"{letter} {number(value, '.3g')}" for letter, value in given)
    if canvas.measure(said, kind.small) <= box.right - written.right - 14 * unit:
        at = (box.right, written.centre[1])
        canvas.text(at, said, kind.small, canvas.theme.faint, anchor="right")
    verdicts = results.verdicts(teacher.name)
    if not verdicts:
        # one column may have no verdict yet where the others do
        return written.bottom + 1.3 * kind.small * (len(results.learners) > 1)
    verdict = canvas.fitted(verdicts, box.width, kind.small)
    at = (box.left, written.bottom + 2 * unit)
    return canvas.text(at, verdict, kind.small, canvas.theme.ink, line="top").bottom
