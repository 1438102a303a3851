"""The action table in a recording: all outcomes of all actions, and what teachers make of them.

It lies on a page of its own, on which its texts are about 0.2 high. Where there are many actions,
rows get lower and the table no taller, so that its words keep their room.
"""

import numpy as np
import rerun as rr

from scenes import FEATURES, Rollouts
from studio.arrays import Bounds, FloatArray
from studio.recorder.drawing import Drawing
from studio.scene.judgements import Judgement
from studio.scene.measures import measures
from studio.scene.recording import entities
from studio.scene.recording.moving import rounded
from studio.style.palette import LIGHT, Theme, blend
from studio.style.ticks import round_ticks
from studio.style.words import number, short_label

# lengths on the page
COLUMN_WIDTH = 1.4
ROW_HEIGHT = 0.45  # of a row where there is room
TALLEST_TABLE = 3.6  # all rows at most
HALF_TICK_LETTER = 0.05  # half the width of a letter below the table
TABLE_LETTER = 0.12  # width of a letter in the names of the actions where the view is small

GOLDEN_RATIO = 0.618034  # multiples of it are spread evenly over whole numbers


def log_action_table(
    stream: rr.RecordingStream, rollouts: Rollouts, judgements: tuple[Judgement, ...], theme: Theme
) -> None:
    """Draw the table: a row an action, a column a feature and a teacher.

    Every column has a scale of its own, in metres where that is a unit. A small dot is an outcome,
    a large one the median of a feature or the value to a teacher, who picks the action with the
    black ring.
    """
    drawing, names, count = Drawing(lift=0.1), rollouts.names, rollouts.count
    colours = [theme.action_colour(name) for name in names]
    height = row_height(len(names))
    rows = -height * (np.arange(len(names), dtype=np.float64) + 0.5)
    # the dots of a row are spread upwards evenly, so that they do not hide one another
    heights = rows[:, None] + 0.6 * height * (np.arange(count) * GOLDEN_RATIO % 1.0 - 0.5)
    clouds = []
    for row, name in zip(rows, names, strict=True):
        drawing.text((-name_room(names) / 2.0, row), short_label(name))
    for column, measure in enumerate(measures(rollouts)):
        places = draw_column(drawing, column, measure.title, measure.values, rows)
        clouds.append(np.stack([places, heights], axis=-1))  # (A, K, 2)
        for place, row, colour in zip(places, rows, colours, strict=True):
            drawing.dot((np.median(place), row), colour, 9.0)
    for column, judgement in enumerate(judgements, start=len(FEATURES)):
        places = draw_column(drawing, column, f"V {judgement.label}", judgement.values, rows)
        drawing.dot((places[judgement.best], rows[judgement.best]), LIGHT.ink, 17.0)
        for place, row, colour in zip(places, rows, colours, strict=True):
            drawing.dot((place, row), colour, 11.0)
    drawing.log(stream, entities.ACTION_TABLE)
    faint = [blend(colour, LIGHT.panel, 0.5) for colour in colours]
    stream.log(
        entities.ACTION_TABLE_OUTCOMES,
        rr.Points2D(
            rounded(np.stack(clouds, axis=1)).reshape(-1, 2),
            colors=np.repeat(faint, len(FEATURES) * count, axis=0),
            radii=rr.Radius.ui_points(1.4),
            draw_order=15.0,
        ),
        static=True,
    )


def draw_column(
    drawing: Drawing, column: int, title: str, values: FloatArray, rows: FloatArray
) -> FloatArray:
    """Draw the title, the zero line and the ends of the scale of a column.

    Returns:
        Where the values lie across, in the shape of the values.
    """
    left, width = column * COLUMN_WIDTH, 0.8 * COLUMN_WIDTH
    low, *_, high = round_ticks(float(values.min()), float(values.max()))
    stretch = width / (high - low)
    zero, bottom = left - low * stretch, rows[-1] + rows[0]
    drawing.line([(zero, 0.0), (zero, bottom)], LIGHT.faint, 1.0)
    drawing.text((left + width / 2, 0.26), title)
    for end, inwards in ((low, 1.0), (high, -1.0)):
        # wide words a little farther in, so that they do not touch those of the next column
        inset = inwards * HALF_TICK_LETTER * len(number(end))
        drawing.text((zero + stretch * end + inset, bottom - 0.15), number(end))
    return zero + stretch * values


def action_table_bounds(names: tuple[str, ...], teachers: int) -> Bounds:
    """What a view of the action table must show."""
    actions, right = len(names), (len(FEATURES) + teachers) * COLUMN_WIDTH
    return -name_room(names), -row_height(actions) * actions - 0.4, right, 0.48


def row_height(actions: int) -> float:
    """Height of a row of a table of this many actions."""
    return min(ROW_HEIGHT, TALLEST_TABLE / actions)


def name_room(names: tuple[str, ...]) -> float:
    """How much room the names of the actions take beside the table."""
    return 0.3 + TABLE_LETTER * max(len(short_label(name)) for name in names)
