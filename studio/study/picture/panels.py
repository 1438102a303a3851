"""The frame that the plots of a study have in common."""

from collections.abc import Sequence

from studio.painter.axes import caption, foot
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas


def named_panel(canvas: Canvas, box: Box, wordings: Sequence[str], left: float = 0.0) -> Box:
    """Write the name of a plot along the top of its box.

    Returns:
        The plot's panel, with room for labels under it and, of the width `left` (px), beside it.
    """
    rest = caption(canvas, box, wordings)
    return Box(rest.left + left, rest.top, rest.right, rest.bottom - foot(canvas))
