"""The painter's figures in a recording: what outcomes are worth, and the minds of the teachers.

They are those of the picture. On the figure of what outcomes are worth, dots answer when hovered,
and a ring an action marks the outcome of the rollout that the timeline `rollout` shows.
"""

from collections.abc import Sequence

import numpy as np
import rerun as rr

from scenes import Rollouts
from studio.arrays import Bounds, PixelArray
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.quantile_dots import QuantileDots
from studio.scene.judgements import Judgement, utilities
from studio.scene.measures import NOTHING, contact_kinds
from studio.scene.picture.curves import draw_value_curves, draw_weighting
from studio.scene.picture.ranks import draw_ranks
from studio.scene.picture.teachers import draw_teachers, table_height
from studio.scene.picture.utilities import DrawnUtilities, draw_utilities
from studio.scene.recording import entities
from studio.scene.recording.moving import clear_rollouts_from, log_over_time, turn_column
from studio.scene.words import rollouts_told
from studio.style.palette import Theme
from studio.style.ticks import round_range
from studio.style.words import action_label

SIZE = (2000, 1100)  # of figures, px: twice what views of them usually take
DOT, RING = 2.5, 12.0  # radii, px of the figure; the painted dots below are larger
WINDOW = 0.105  # half the height of the view of the dots of an action, in widths of it
ASIDE = 40.0  # at the right of the dots there, px


def paint_utilities(
    rollouts: Rollouts, judgements: Sequence[Judgement], theme: Theme
) -> tuple[PixelArray, DrawnUtilities]:
    """The figure of what the outcomes of all actions are worth, and where its dots lie."""
    canvas = Canvas(*SIZE, theme)
    drawn = draw_utilities(canvas, canvas.page, rollouts, judgements)
    return canvas.pixels[: round(drawn.bottom + canvas.page.top)], drawn


def window_on(drawn: DrawnUtilities, index: int) -> Bounds:
    """Which part of that figure is about one action, px; of one that it leaves out the end."""
    places = drawn.dots[min(index, len(drawn.dots) - 1)]
    right = max(float(each[:, 0].max()) for each in drawn.dots) + ASIDE
    middle = float(places[:, 1].max())
    return 0.0, middle - WINDOW * right, right, middle + WINDOW * right


def log_dots_that_answer(
    stream: rr.RecordingStream, rollouts: Rollouts, drawn: DrawnUtilities, theme: Theme
) -> None:
    """Let dots that stand for one rollout answer, and put rings around those of each in turn."""
    count, worths, kinds = rollouts.paths, utilities(rollouts), contact_kinds(rollouts)
    dots, told, colours, rings = [], [], [], []
    for index, (places, sources) in enumerate(zip(drawn.dots, drawn.rollouts, strict=True)):
        name, words = rollouts.names[index], rollouts_told(rollouts, index)
        for place, source in zip(places.tolist(), sources.tolist(), strict=True):
            if source >= 0:
                touched = kinds[index, source] != NOTHING
                dots.append(place)
                told.append(f"{action_label(name)}, {words[source]}")
                colours.append(theme.contact if touched else theme.action_colour(name))
        those = QuantileDots.of(worths[index], kinds[index])
        # a dot that stands for several rollouts is that of the nearest of its kind
        away = np.abs(those.values[:, None] - worths[index, :count])
        away[those.kinds[:, None] != kinds[index, :count]] = np.inf
        rings.append(places[away.argmin(axis=0)])
    if dots:
        points = rr.Points2D(dots, colors=colours, radii=DOT, draw_order=1.0)
        stream.log(f"{entities.UTILITIES}/outcomes", points, rr.AnyValues(told=told), static=True)
    ring = rr.Ellipses2D.from_fields(
        colors=theme.ink, line_radii=rr.Radius.ui_points(1.0), draw_order=3.0
    )
    centres = np.stack(rings, axis=1)  # (M, A, 2)
    columns = rr.Ellipses2D.columns(
        half_sizes=[(RING, RING)] * (count * len(rings)), centers=centres.reshape(-1, 2)
    ).partition([len(rings)] * count)
    path = f"{entities.UTILITIES}/rollout"
    log_over_time(stream, path, [turn_column(rollouts)], [ring], columns)
    if count < rollouts.count:
        clear_rollouts_from(stream, path, count)


def paint_minds(rollouts: Rollouts, judgements: Sequence[Judgement], theme: Theme) -> PixelArray:
    """How the teachers weigh and value, what they are like, and how they rank the actions."""
    canvas = Canvas(*SIZE, theme)
    left, right = canvas.page.columns((6.0, 7.0), canvas.gap)
    _, reach = round_range(0.0, max(float(np.abs(utilities(rollouts)).max()), 0.01))
    square = Box(left.left, left.top, left.right, left.top + 0.5 * left.width)
    weights, values = square.columns((1.0, 1.0), canvas.gap)
    draw_weighting(canvas, weights, judgements)
    draw_value_curves(canvas, values, judgements, reach)
    floor = square.bottom + canvas.gap + table_height(canvas, len(judgements))
    table = Box(left.left, square.bottom + canvas.gap, left.right, floor)
    draw_teachers(canvas, table, rollouts.names, judgements)
    draw_ranks(canvas, Box(right.left, right.top, right.right, floor), rollouts.names, judgements)
    return canvas.pixels[: round(floor + canvas.page.top)]
