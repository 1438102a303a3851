"""How the teachers rank the actions, in a recording: where their minds part."""

from itertools import pairwise

import numpy as np
import rerun as rr
from numpy.typing import NDArray

from studio.arrays import Bounds, FloatArray
from studio.recorder.drawing import Drawing
from studio.scene.judgements import Judgement
from studio.scene.recording import entities
from studio.style.palette import Theme
from studio.style.words import number, short, teacher_name

COLUMN_PITCH, TALLEST_ROW, TALLEST_FIGURE = 2.0, 0.34, 2.4
"""Between the columns and the rows of the figure, in units of the page: where there are many
actions, rows get lower and not the figure taller, so that words keep their room."""

HEADER = 0.36
"""How high above the first row the names of the teachers stand, in units of the page."""

VALUE_LEFT, VALUE_RISE, LEVEL = 0.34, 0.36, 0.6
"""How far right of a dot its value stands, in units of the page, and how far above it, in rows;
how far the line to the next dot stays level under the value, in units of the page."""

LETTER_WIDTH = 0.062
"""Of the words beside the figure, in units of the page."""

LEAST_ROWS = 4
"""A view has room for at least so many rows: with fewer actions they would be enormous."""


def log_ranks(
    stream: rr.RecordingStream,
    names: tuple[str, ...],
    judgements: tuple[Judgement, ...],
    theme: Theme,
) -> None:
    """Draw a column a teacher with the actions from the best to the worst, and their values.

    A line an action joins its places. It is bold where the next teacher gives it another rank.
    """
    drawing = Drawing(lift=0.07)
    rise = VALUE_RISE * row_pitch(len(names))
    places = [ranks(judgement.values) for judgement in judgements]
    levels = [-row_pitch(len(names)) * rank for rank in places]
    for column, judgement in enumerate(judgements):
        x = column * COLUMN_PITCH
        drawing.text((x, HEADER), teacher_name(judgement.teacher))
        for name, y, value in zip(names, levels[column], judgement.values, strict=True):
            drawing.dot((x, y), theme.action_colour(name), 13.0)
            drawing.text((x + VALUE_LEFT, y + rise), number(value, ".3f"))
    for column, (here, there) in enumerate(pairwise(levels)):
        for name, y, next_y in zip(names, here, there, strict=True):
            width = 2.0 if y == next_y else 5.0
            drawing.line(bend(column, y, next_y), theme.action_colour(name), width)
    for index, name in enumerate(map(short, names)):
        aside = 0.25 + LETTER_WIDTH * len(name) / 2
        drawing.text((-aside, levels[0][index]), name)
        if len(judgements) > 1:
            right = (len(judgements) - 1) * COLUMN_PITCH + VALUE_LEFT + 0.15
            drawing.text((right + aside, levels[-1][index]), name)
    drawing.log(stream, entities.RANKS)


def ranks(values: FloatArray) -> NDArray[np.int64]:
    """The rank of each of A values, 0 for the largest; of equal ones the earlier is first."""
    order = np.argsort(-values, kind="stable")
    return np.argsort(order)


def discordant_pairs(one: FloatArray, other: FloatArray) -> list[tuple[int, int]]:
    """Pairs of actions that two teachers with these values [A] prefer the other way round.

    The first of a pair is what the first teacher prefers; what leads to a tie is no such pair.
    Pairs come in the order of the first teacher's preference.
    """
    order = np.argsort(-one, kind="stable").tolist()
    return [
        (better, worse)
        for place, better in enumerate(order)
        for worse in order[place + 1 :]
        if one[better] > one[worse] and other[better] < other[worse]
    ]


def row_pitch(actions: int) -> float:
    """Between one rank and the next, in units of the page."""
    return min(TALLEST_ROW, TALLEST_FIGURE / actions)


def bend(column: int, level: float, next_level: float) -> FloatArray:
    """The line from a dot in one column to the dot in the next, level at its ends."""
    along = np.linspace(0.0, 1.0, 13)
    start = column * COLUMN_PITCH
    x = start + LEVEL + (COLUMN_PITCH - LEVEL) * along
    turn = along**2 * (3.0 - 2.0 * along)
    bent = np.stack([x, level + (next_level - level) * turn], axis=-1)
    return np.concatenate([[(start, level)], bent])


def ranks_bounds(names: tuple[str, ...], teachers: int) -> Bounds:
    """What a view of the ranks must show."""
    aside = 0.4 + LETTER_WIDTH * max(len(short(name)) for name in names)
    bottom = -row_pitch(len(names)) * max(len(names), LEAST_ROWS)
    right = (teachers - 1) * COLUMN_PITCH + VALUE_LEFT + 0.2 + aside
    return -aside, bottom + 0.1, right, HEADER + 0.24
