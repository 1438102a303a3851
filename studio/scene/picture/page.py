"""One still picture of a scene: what every action may lead to, and what the teachers think of it.

At the left, the scene with every rollout's path, and how the teachers weigh probabilities and value
outcomes. At the right, a row an action each, what the outcomes are worth, and below it contacts and
how the five features are distributed.
"""

from collections.abc import Sequence

import numpy as np

from scenes import Rollouts
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.lettering import SEMIBOLD
from studio.scene.framing import bounds_to_show
from studio.scene.judgements import Judgement, utilities
from studio.scene.picture.curves import draw_value_curves, draw_weighting
from studio.scene.picture.outcomes import draw_outcomes
from studio.scene.picture.teachers import draw_teachers, table_height
from studio.scene.picture.titles import findings, subtitles, titles
from studio.scene.picture.utilities import draw_utilities
from studio.scene.picture.view import caption_height, draw_scene
from studio.style.palette import LIGHT, Theme
from studio.style.ticks import round_range

SIZE = (1600, 900)
"""Width and height of the picture unless one asks for others, px."""

_STACKED = 1.3  # a page that is narrower than this, in its heights, is stacked


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
    kind, page = canvas.type, canvas.page
    top = page.top + 1.2 * kind.title + 3.2 * kind.body
    body = Box(page.left, top, page.right, page.bottom)
    scene, worths, outcomes, minds = _parts(canvas, body, rollouts)
    view = draw_scene(canvas, scene, rollouts, judgements)
    drawn = draw_utilities(canvas, worths, rollouts, judgements)
    # few actions need less room than there is
    top = outcomes.top - worths.bottom + drawn.bottom
    draw_outcomes(canvas, Box(outcomes.left, top, outcomes.right, outcomes.bottom), rollouts)
    _draw_minds(canvas, minds, rollouts, judgements)
    ink, faint = canvas.theme.ink, canvas.theme.faint
    lines = (
        (titles(rollouts), kind.title, ink, SEMIBOLD),
        (findings(judgements, rollouts.names) if judgements else [""], kind.body, ink, SEMIBOLD),
        (subtitles(rollouts, view.bounds), kind.body, faint, 400),
    )
    top = page.top
    for wordings, height, colour, weight in lines:
        placed = canvas.fit(
            (page.left, top), wordings, page.width, height, colour, weight, line="top"
        )
        top = placed.bottom + 3 * canvas.unit
    return canvas


def _parts(canvas: Canvas, body: Box, rollouts: Rollouts) -> tuple[Box, Box, Box, Box]:
    """Where the scene, the utilities, the table of outcomes and the teachers lie."""
    gap = canvas.gap
    if canvas.box.width < _STACKED * canvas.box.height:
        scene, worths, outcomes, minds = body.rows((1.15, 1.05, 0.95, 0.75), 0.6 * gap)
        return scene, worths, outcomes, minds
    left, right = body.columns((0.37, 0.63), gap)
    # the more rows, the more room the lower table needs for them
    share = 0.57 if len(rollouts.names) <= 8 else 0.545
    worths, outcomes = right.rows((share, 1.0 - share), 0.4 * gap)
    x0, y0, x1, y1 = bounds_to_show(rollouts)
    # a long scene gets less
    height = left.width * (y1 - y0) / (x1 - x0) + caption_height(canvas, rollouts)
    height = min(max(height, 0.42 * left.height), 0.6 * left.height)
    scene = Box(left.left, left.top, left.right, left.top + height)
    minds = Box(left.left, scene.bottom + 0.5 * gap, left.right, left.bottom)
    return scene, worths, outcomes, minds


def _draw_minds(
    canvas: Canvas, box: Box, rollouts: Rollouts, judgements: Sequence[Judgement]
) -> None:
    """Draw how the teachers weigh and value, and below it their parameters and picks."""
    unit = canvas.unit
    floor = box.bottom - table_height(canvas, len(judgements))
    left, right = Box(box.left, box.top, box.right, floor - 10 * unit).columns(
        (1.0, 1.15), 24 * unit
    )
    draw_weighting(canvas, left, judgements)
    _, reach = round_range(0.0, max(float(np.abs(utilities(rollouts)).max()), 0.01))
    draw_value_curves(canvas, right, judgements, reach)
    table = Box(box.left, floor, box.right, box.bottom)
    draw_teachers(canvas, table, rollouts.names, judgements)
