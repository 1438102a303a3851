"""The painter's figures in a recording: what outcomes are worth, and the minds of the teachers.

A dot that answers when hovered lies on the figure of its action, in pixels of the figure.
"""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
import rerun as rr

from scenes import Rollouts
from studio.arrays import FloatArray, PixelArray
from studio.painter.axes import Axis, caption
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.lettering import SEMIBOLD
from studio.painter.marks import cross, draw_shape, hollow_square
from studio.painter.quantile_dots import DotStacks, QuantileDots
from studio.recorder.figures import log_figure
from studio.scene.judgements import Judgement, utilities
from studio.scene.measures import NOTHING, PERSON, WALL, contact_kinds
from studio.scene.picture.curves import draw_value_curves, draw_weighting
from studio.scene.picture.teachers import draw_teachers, table_height, teacher_shape
from studio.scene.picture.utilities import draw_utilities
from studio.scene.recording import entities
from studio.scene.recording.answers import told_of_rollouts
from studio.scene.recording.moving import clear_rollouts_from
from studio.style.palette import Theme
from studio.style.ticks import round_range, ticks
from studio.style.words import action_label, number

# sizes of figures, px: twice what views of them usually take
FIGURE_SIZE = (2000, 1100)
DOTS_SIZE = (1200, 280)
CANVAS = (1200, 360)  # that they are drawn on: none is lower

# places on the figure of dots, px
DOTS_LEFT, DOTS_RIGHT, DOTS_TOP, DOTS_FLOOR, AXIS_TOP, KEY_MIDDLE = 24, 1176, 8, 130, 205, 262
TYPE = 22  # size of type on it, px
KEY_ROOM = 200  # for the name of a teacher, px
SMALLEST_PITCH = 4.0  # from dot to dot, px
DOT, MARK, RING = 4.0, 8.0, 12.0  # radii of dots, of marks of contact below, of the ring, px
KEY_WORDINGS = [
    "sure utility worth as much as the action, 95 % interval · ×: touches a person, square: a wall",
    "certainty equivalent, 95 % interval · ×: touches a person, square: a wall",
    "×: touches a person, square: a wall",
    "",
]

RANK_PITCH, LEAST_RANK_PITCH = 4.0, 1.4  # from a row of ranks to the next, in sizes of type


def log_worths(
    stream: rr.RecordingStream, rollouts: Rollouts, judgements: Sequence[Judgement], theme: Theme
) -> None:
    """Draw an axis of utility an action, the dots of its M rollouts, and the teachers' marks."""
    shown = rollouts.with_paths()
    worths, kinds = utilities(shown), contact_kinds(shown)
    orders = [np.lexsort(both) for both in zip(worths, kinds, strict=True)]
    dots = [
        QuantileDots(own[order], kind[order])
        for own, kind, order in zip(worths, kinds, orders, strict=True)
    ]
    ends = [end for each in judgements for end in each.certainty_equivalent_interval]
    everything = np.concatenate([worths.ravel(), *ends, [0.0]])
    axis = Axis(*round_range(everything.min(), everything.max()), DOTS_LEFT, DOTS_RIGHT)
    stacks = DotStacks.fit(dots, axis, DOTS_FLOOR - DOTS_TOP, SMALLEST_PITCH)
    for index, name in enumerate(rollouts.names):
        path, places = entities.dots(name), np.empty((shown.count, 2))
        places[orders[index]] = stacks.middles(dots[index]) * (1.0, -1.0) + (0.0, DOTS_FLOOR)
        canvas = Canvas(*CANVAS, theme)
        draw_worths(canvas, axis, judgements, index)
        for place, kind in zip(places, kinds[index].tolist(), strict=True):
            if kind == PERSON:
                cross(canvas, place, MARK, theme.contact)
            elif kind == WALL:
                hollow_square(canvas, place, MARK, theme.contact, theme.ground)
        log_figure(stream, path, canvas.pixels[: DOTS_SIZE[1]])
        colours = np.where(
            kinds[index, :, None] == NOTHING, theme.action_colour(name), theme.contact
        )
        points = rr.Points2D(places, colors=colours, radii=DOT, draw_order=1.0)
        told = rr.AnyValues(told=told_of_rollouts(rollouts, index))
        stream.log(f"{path}/outcomes", points, told, static=True)
        log_ring(stream, f"{path}/rollout", places, theme)
        if shown.count < rollouts.count:
            clear_rollouts_from(stream, f"{path}/rollout", shown.count)


def log_ring(stream: rr.RecordingStream, path: str, places: FloatArray, theme: Theme) -> None:
    """Put a ring around the place [M, 2] of each rollout in turn."""
    count = len(places)
    # with its look at each moment it takes one chunk instead of two
    rings = rr.Ellipses2D.columns(
        half_sizes=[(RING, RING)] * count,
        centers=places,
        colors=[theme.ink] * count,
        line_radii=rr.Radius.ui_points([1.0] * count),
        draw_order=[3.0] * count,
    )
    turns = [rr.TimeColumn("rollout", sequence=np.arange(count))]
    stream.send_columns(path, turns, rings)


def draw_worths(canvas: Canvas, axis: Axis, judgements: Sequence[Judgement], index: int) -> None:
    """Draw the axis that dots lie on, and certainty equivalents of an action with intervals."""
    theme = canvas.theme
    zero = axis.at(0.0)
    canvas.fill(Box(zero, DOTS_TOP, zero + 1, AXIS_TOP), theme.faint)
    canvas.fill(Box(axis.start, DOTS_FLOOR, axis.end, DOTS_FLOOR + 1), theme.grid)
    canvas.fill(Box(axis.start, AXIS_TOP, axis.end, AXIS_TOP + 2), theme.faint)
    for value in ticks(axis.low, axis.high, 6):
        x = axis.at(value)
        canvas.fill(Box(x - 1, AXIS_TOP, x + 1, AXIS_TOP + 8), theme.faint)
        at = (x, AXIS_TOP + 10)
        canvas.text(at, number(value), TYPE, theme.faint, anchor="centre", line="top")
    lane = (AXIS_TOP - DOTS_FLOOR) / (len(judgements) + 0.5)
    key: float = DOTS_LEFT
    for place, judgement in enumerate(judgements):
        y, colour = DOTS_FLOOR + (place + 0.75) * lane, judgement.colour
        low, high = judgement.certainty_equivalent_interval
        canvas.fill(Box(axis.at(low[index]), y - 1.5, axis.at(high[index]), y + 1.5), colour)
        shape = teacher_shape(judgement.teacher)
        middle = axis.at(judgement.certainty_equivalents[index])
        draw_shape(canvas, shape, (middle, y), min(7.0, 0.4 * lane), colour, theme.ground)
        draw_shape(canvas, shape, (key + 8, KEY_MIDDLE), 7.0, colour, theme.ground)
        at, ink = (key + 22, KEY_MIDDLE), theme.legible(colour)
        key = canvas.fit(at, judgement.label, KEY_ROOM, TYPE, ink, SEMIBOLD).right + 24
    at, room = (key, KEY_MIDDLE), DOTS_RIGHT - key
    canvas.fit(at, KEY_WORDINGS, room, TYPE, theme.faint)


def paint_utilities(
    rollouts: Rollouts, judgements: Sequence[Judgement], theme: Theme
) -> PixelArray:
    """The painter's figure of what the outcomes of all actions are worth."""
    canvas = Canvas(*FIGURE_SIZE, theme)
    draw_utilities(canvas, canvas.page, rollouts, judgements)
    return trimmed(canvas)


def paint_minds(rollouts: Rollouts, judgements: Sequence[Judgement], theme: Theme) -> PixelArray:
    """How the teachers weigh and value, what they are like, and how they rank the actions."""
    canvas = Canvas(*FIGURE_SIZE, theme)
    left, right = canvas.page.columns((8.0, 7.0), 2.0 * canvas.gap)
    _, reach = round_range(0.0, max(float(np.abs(utilities(rollouts)).max()), 0.01))
    square = Box(left.left, left.top, left.right, left.top + 0.5 * left.width)
    weights, values = square.columns((1.0, 1.0), canvas.gap)
    draw_weighting(canvas, weights, judgements)
    draw_value_curves(canvas, values, judgements, reach)
    floor = square.bottom + canvas.gap + table_height(canvas, len(judgements))
    table = Box(left.left, square.bottom + canvas.gap, left.right, floor)
    draw_teachers(canvas, table, rollouts.names, judgements)
    least = right.top + LEAST_RANK_PITCH * canvas.type.body * (len(rollouts.names) + 2)
    ranks = Box(right.left, right.top, right.right, min(max(floor, least), right.bottom))
    draw_ranks(canvas, ranks, rollouts.names, judgements)
    return trimmed(canvas)


def trimmed(canvas: Canvas) -> PixelArray:
    """The pixels of a page without what is empty at its foot, but for the margin."""
    [drawn] = np.nonzero((canvas.pixels != canvas.theme.ground).any(axis=(1, 2)))
    margin = round(canvas.page.top)
    return canvas.pixels[: int(drawn[-1]) + margin]


def draw_ranks(
    canvas: Canvas, box: Box, names: Sequence[str], judgements: Sequence[Judgement]
) -> None:
    """Draw a column a teacher with the actions from the best to the worst, and their values.

    A line an action joins its places. It is bold where the next teacher gives it another rank.
    """
    unit, kind, theme = canvas.unit, canvas.type, canvas.theme
    title = "Rank of each action, the best on top, and its value V"
    top = caption(canvas, box, [title, "Ranks and values V"]).top + kind.heading
    pitch = min((box.bottom - top) / (len(names) + 1), RANK_PITCH * kind.body)
    levels = [top + pitch * (1.0 + judgement.ranks) for judgement in judgements]
    aside, reach = 0.24 * box.width, 52 * unit
    x = np.linspace(box.left + aside, box.right - aside, max(len(judgements), 2))
    for column, (here, there) in enumerate(pairwise(levels)):
        for name, y, next_y in zip(names, here, there, strict=True):
            along = np.linspace(0.0, 1.0, 25)
            bent = y + (next_y - y) * along**2 * (3.0 - 2.0 * along)
            line = np.stack(
                [x[column] + reach + (x[column + 1] - x[column] - 2 * reach) * along, bent], axis=-1
            )
            canvas.line(line, theme.action_colour(name), (1.5 if y == next_y else 4.0) * unit)
    for column, judgement in enumerate(judgements):
        at, ink = (x[column], top), theme.legible(judgement.colour)
        canvas.fit(at, judgement.label, 3 * reach, kind.body, ink, SEMIBOLD, anchor="centre")
        for name, y, value in zip(names, levels[column], judgement.values, strict=True):
            at = (x[column], y)
            ink = theme.legible(theme.action_colour(name))
            canvas.text(at, number(value, ".3f"), kind.body, ink, SEMIBOLD, anchor="centre")
    for name, first, last in zip(names, levels[0], levels[-1], strict=True):
        words = canvas.abbreviated(action_label(name), aside - reach, kind.body)
        ink = theme.legible(theme.action_colour(name))
        canvas.text((x[0] - reach, first), words, kind.body, ink, anchor="right")
        canvas.text((x[len(judgements) - 1] + reach, last), words, kind.body, ink)
