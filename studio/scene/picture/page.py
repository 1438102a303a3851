"""One still picture of a scene: what every action may lead to, and what the teachers think of it.

Above, the scene with every rollout's path, and how the teachers weigh probabilities and value
outcomes. Below, one row an action: contacts, how the five features are distributed, and its value
to each teacher.
"""

from collections.abc import Sequence

from scenes import Rollouts
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.scene.framing import bounds_to_show
from studio.scene.judgements import Judgement
from studio.scene.picture.actions import ActionTable
from studio.scene.picture.teachers import draw_teachers
from studio.scene.picture.titles import draw_heading, subtitles, titles
from studio.scene.picture.view import draw_scene
from studio.style.palette import LIGHT, Theme

SIZE = (1600, 900)
"""Width and height of the picture unless one asks for others, px."""

_STACKED = 1.5  # an upper part that is narrower than this, in its heights, is stacked


def compose_picture(
    rollouts: Rollouts,
    judgements: Sequence[Judgement],
    size: tuple[int, int] = SIZE,
    theme: Theme = LIGHT,
) -> Canvas:
    """Draw the picture of a scene, of this width and height in px.

    Raises:
        InputError: if the size is not allowed.
    """
    canvas = Canvas(*size, theme.of(rollouts.names))
    unit, page = canvas.unit, canvas.page
    heading = draw_heading(canvas, page, titles(rollouts), subtitles(rollouts), page.width)
    body_top = heading.bottom + 16 * unit
    table = ActionTable.fit(canvas, Box(page.left, body_top, page.right, page.bottom), rollouts)
    upper = Box(page.left, body_top, page.right, table.box.top - 26 * unit)
    scene, teachers = _halves(upper, rollouts, canvas.gap)
    draw_scene(canvas, scene, rollouts, judgements)
    draw_teachers(canvas, teachers, rollouts, judgements)
    table.draw(canvas, rollouts, judgements)
    return canvas


def _halves(upper: Box, rollouts: Rollouts, gap: float) -> tuple[Box, Box]:
    """Where the scene and the teachers lie: side by side, or on a high page below one another."""
    if upper.width < _STACKED * upper.height:
        scene, teachers = upper.rows((1.9, 1.0), 0.6 * gap)
        return scene, teachers
    x0, y0, x1, y1 = bounds_to_show(rollouts)
    # a long scene gets more
    share = (x1 - x0) / (y1 - y0) * upper.height / upper.width
    share = min(max(share, 0.5), 0.67)
    scene, teachers = upper.columns((share, 1.0 - share), gap)
    return scene, teachers
