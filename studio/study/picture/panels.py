"""The frame that the plots of a study have in common."""

from collections.abc import Sequence

from studio.painter.axes import caption, foot
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.lettering import SEMIBOLD
from studio.study.results import StudyResults
from studio.study.words import reached

_NOTE_STEP = 1.25  # from line to line of the notes, in sizes of their type


def named_panel(canvas: Canvas, box: Box, wordings: Sequence[str], left: float = 0.0) -> Box:
    """Write the name of a plot along the top of its box.

    Returns:
        The plot's panel, with room for labels under it and, of the width `left` (px), beside it.
    """
    rest = caption(canvas, box, wordings)
    return Box(rest.left + left, rest.top, rest.right, rest.bottom - foot(canvas))


def title_room(canvas: Canvas, results: StudyResults) -> float:
    """How much room a page's title has beside the number of pairs, which changes, px."""
    size = canvas.type.title
    widths = [canvas.measure(reached(stage), size, SEMIBOLD) for stage in results.stages]
    return canvas.page.width - max(widths) - size


def notes_height(canvas: Canvas, lines: int) -> float:
    """How much room this many lines of notes take at the foot of a page, px."""
    return lines * _NOTE_STEP * canvas.type.small


def draw_notes(canvas: Canvas, left: float, top: float, lines: Sequence[str]) -> None:
    """Write lines of notes below one another, from a place on (px)."""
    for index, line in enumerate(lines):
        at = (left, top + notes_height(canvas, index))
        canvas.text(at, line, canvas.type.small, canvas.theme.faint, line="top")
