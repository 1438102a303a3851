"""How the teachers rank the actions, in a recording: where their minds part.

The figure lies on a page of its own, on which its texts are about 0.2 high. Where there are many
actions, rows get lower and the figure no taller, so that its words keep their room.
"""

from itertools import pairwise

import numpy as np
import rerun as rr

from studio.arrays import Bounds, FloatArray
from studio.recorder.drawing import Drawing
from studio.scene.judgements import Judgement
from studio.scene.recording import entities
from studio.style.palette import Theme
from studio.style.words import number, short_label

# lengths on the page
COLUMN_PITCH = 2.0  # from one column to the next
ROW_PITCH = 0.34  # from one row to the next where there is room
TALLEST_FIGURE = 2.4  # all rows at most
HEADER = 0.36  # height of the names of the teachers above the first row
VALUE_LEFT = 0.34  # from a dot to the value at the right of it
VALUE_RISE = 0.36  # of a value above its dot, in rows
LEVEL = 0.6  # from a dot on, the line to the next one stays level under the value
RANKS_LETTER = 0.062  # width of a letter in the names of the actions beside the figure

LEAST_ROWS = 4  # that a view has room for: with fewer, they would be enormous


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
    pitch = row_pitch(len(names))
    levels = [-pitch * judgement.ranks for judgement in judgements]
    for column, judgement in enumerate(judgements):
        x = column * COLUMN_PITCH
        drawing.text((x, HEADER), judgement.label)
        for name, y, value in zip(names, levels[column], judgement.values, strict=True):
            drawing.dot((x, y), theme.action_colour(name), 13.0)
            drawing.text((x + VALUE_LEFT, y + VALUE_RISE * pitch), number(value, ".3f"))
    for column, (here, there) in enumerate(pairwise(levels)):
        for name, y, next_y in zip(names, here, there, strict=True):
            width = 2.0 if y == next_y else 5.0
            drawing.line(bend(column, y, next_y), theme.action_colour(name), width)
    for index, name in enumerate(map(short_label, names)):
        aside = 0.25 + RANKS_LETTER * len(name) / 2
        drawing.text((-aside, levels[0][index]), name)
        if len(judgements) > 1:
            right = (len(judgements) - 1) * COLUMN_PITCH + VALUE_LEFT + 0.15
            drawing.text((right + aside, levels[-1][index]), name)
    drawing.log(stream, entities.RANKS)


def row_pitch(actions: int) -> float:
    """Distance of one rank from the next among this many actions."""
    return min(ROW_PITCH, TALLEST_FIGURE / actions)


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
    aside = 0.4 + RANKS_LETTER * max(len(short_label(name)) for name in names)
    bottom = -row_pitch(len(names)) * max(len(names), LEAST_ROWS)
    right = (teachers - 1) * COLUMN_PITCH + VALUE_LEFT + 0.2 + aside
    return -aside, bottom + 0.1, right, HEADER + 0.24
