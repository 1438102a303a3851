"""The outcomes in a recording: their numbers, how they are distributed, and how actions compare."""

from typing import Any

import numpy as np
import rerun as rr
from numpy.typing import NDArray

from scenes import FEATURES, Rollouts
from scenes.scene import PEDESTRIAN_RADIUS, ROBOT_RADIUS
from studio.arrays import Bounds, FloatArray
from studio.recorder.drawing import OVERLAP, PAGE_RESOLUTION, Drawing
from studio.scene.judgements import Judgement
from studio.scene.recording import entities
from studio.scene.recording.world import rounded, time_columns
from studio.style.palette import LIGHT, Colour, Theme, blend
from studio.style.ticks import round_step, round_ticks
from studio.style.words import number, rounded_number, short, teacher_name

COLLISIONS = "collisions"
"""The feature that is a whole number; the others are measured."""

LEAST_RANGES = {
    "clearance, m": 1.0,
    "deviation, m": 0.2,
    "progress, m": 1.0,
    "smoothness": 1.0,
    COLLISIONS: 2.0,
}
"""The histogram of a measure reaches from 0 at least this far."""

MOST_BINS = 25
"""A histogram of values on one side of 0 has no more bins."""

ROUNDING = 1e-9
"""A value that leaves the bins by this share of one does so by rounding only."""

PANEL_WIDTH, PANEL_HEIGHT, PANEL_GAP = 1.0, 0.8, 0.36
"""Of the panels of a figure of distributions, in units of the page."""

STROKE = 0.02
"""How far apart the strokes that fill a bar are at most, in units of the page."""

COLUMN_WIDTH, TALLEST_ROW, TALLEST_TABLE = 1.4, 0.45, 3.6
"""Of the table that compares actions: where there are many, rows get lower and not the table
taller, so that words keep their room; in units of the page."""

TICK_LETTER_WIDTH = 0.05
"""Half of that of a letter below that table, in units of the page."""

LETTER_WIDTH = 0.12
"""Of the names of actions beside that table where it is small, in units of the page."""

GOLDEN_RATIO = 0.618034


def log_outcomes(stream: rr.RecordingStream, rollouts: Rollouts) -> None:
    """Keep the numbers of every outcome: one row a rollout, the actions one after another."""
    columns: dict[str, Any] = {
        feature: rollouts.features[..., column].ravel() for column, feature in enumerate(FEATURES)
    }
    columns["contact_step"] = rollouts.contact_step.ravel()
    stream.log(entities.OUTCOMES, rr.AnyValues(**columns), static=True)


def log_clearance(stream: rr.RecordingStream, rollouts: Rollouts, theme: Theme) -> None:
    """Plot the median gap to the nearest pedestrian over time, a series an action."""
    medians = np.median(gaps(rollouts), axis=1).T  # (T+1, A)
    stream.send_columns(
        entities.CLEARANCE,
        time_columns(rollouts),
        rr.Scalars.columns(scalars=medians.ravel()).partition([medians.shape[1]] * len(medians)),
    )
    stream.log(
        entities.CLEARANCE,
        rr.SeriesLines(
            colors=[theme.action_colour(name) for name in rollouts.names],
            widths=2.0,
            names=[short(name) for name in rollouts.names],
        ),
        static=True,
    )


def log_distributions(stream: rr.RecordingStream, rollouts: Rollouts, theme: Theme) -> None:
    """Draw a figure an action: a histogram a feature, and clearance over time."""
    values = measures(rollouts)
    edges = {title: bin_edges(title, each) for title, each in values.items()}
    has_contact = rollouts.touched
    if rollouts.scene.pedestrians:
        gap_quantiles = np.quantile(gaps(rollouts), [0.1, 0.5, 0.9], axis=1)  # (3, A, T+1), m
    for index, action in enumerate(rollouts.actions):
        drawing = Drawing(lift=0.06, resolution=PAGE_RESOLUTION)
        colour = theme.action_colour(action.name)
        for column, (title, each) in enumerate(values.items()):
            counts, _ = np.histogram(each[index], edges[title])
            touching, _ = np.histogram(each[index, has_contact[index]], edges[title])
            draw_histogram(
                drawing,
                column * (PANEL_WIDTH + PANEL_GAP),
                title,
                edges[title],
                np.stack([touching, counts]),
                (theme.contact, colour),
            )
        if rollouts.scene.pedestrians:
            left = len(FEATURES) * (PANEL_WIDTH + PANEL_GAP)
            ends = float(min(0.0, gap_quantiles.min())), float(gap_quantiles.max())
            draw_band(drawing, left, rollouts.horizon, ends, gap_quantiles[:, index], colour)
        drawing.log(stream, entities.distributions(action.name))


def draw_histogram(
    drawing: Drawing,
    left: float,
    title: str,
    edges: FloatArray,
    counts: NDArray[np.int64],
    colours: tuple[Colour, Colour],
) -> None:
    """Draw a histogram into the panel that begins at `left`.

    Args:
        drawing: what to draw into.
        left: where the panel begins.
        title: what is counted.
        edges: [B+1], of the bins.
        counts: [2, B], the outcomes with contact, and all.
        colours: of the outcomes with contact, and of the others above them.
    """
    peak, bar = int(counts.max()), PANEL_WIDTH / counts.shape[1]
    strokes = max(3, int(np.ceil(bar / STROKE)))
    # such that the bar with the width of its strokes leaves a little gap to the next
    reach = 0.48 * bar / (1.0 + OVERLAP / (strokes - 1))
    offsets = np.linspace(-reach, reach, strokes)
    for place, (touching, all_together) in enumerate(PANEL_HEIGHT * counts.T / peak):
        x = left + (place + 0.5) * bar + offsets
        for low, high, colour in zip(
            (0.0, touching), (touching, all_together), colours, strict=True
        ):
            if high > low:
                drawing.fill(x, np.full(strokes, low), np.full(strokes, high), colour)
    draw_frame(drawing, left, title)
    low, high, margin = edges[0], edges[-1], 0.0
    if title == COLLISIONS:  # whole numbers, written below the middle of their bins
        low, high, margin = low + 0.5, high - 0.5, bar / 2
    drawing.text((left + margin, -0.15), rounded_number(low, 6))
    drawing.text((left + PANEL_WIDTH - margin, -0.15), rounded_number(high, 6))
    drawing.text((left - 0.13, PANEL_HEIGHT), str(peak))


def draw_band(
    drawing: Drawing,
    left: float,
    horizon: float,
    ends: tuple[float, float],
    quantiles: FloatArray,
    colour: Colour,
) -> None:
    """Draw the median gap over time and its 10 to 90 % band into the panel that begins at `left`.

    Args:
        drawing: what to draw into.
        left: where the panel begins.
        horizon: end of the time axis, s.
        ends: lowest and highest gap, m.
        quantiles: [3, T+1], the 10 %, 50 % and 90 % quantiles, m.
        colour: of the action.
    """
    low, high = ends
    scale = PANEL_HEIGHT / (high - low)
    x = left + np.linspace(0.0, PANEL_WIDTH, quantiles.shape[1])
    bottom, middle, top = scale * (quantiles - low)
    pale = blend(colour, LIGHT.panel, 0.25)
    drawing.fill(x, bottom, top, pale)
    draw_frame(drawing, left, "gap over time")
    drawing.line([(left, -low * scale), (left + PANEL_WIDTH, -low * scale)], LIGHT.faint, 1.0)
    drawing.line(np.stack([x, middle], axis=-1), colour, 3.0)
    drawing.text((left, -0.15), "0 s")
    drawing.text((left + PANEL_WIDTH, -0.15), f"{horizon:g} s")
    drawing.text((left - 0.19, PANEL_HEIGHT), f"{high:.1f} m")
    drawing.text((left - 0.19, -low * scale), "0 m")


def draw_frame(drawing: Drawing, left: float, title: str) -> None:
    """Draw a panel's foot and write its title above it."""
    drawing.line([(left, 0.0), (left + PANEL_WIDTH, 0.0)], LIGHT.faint, 1.0)
    drawing.text((left + PANEL_WIDTH / 2, PANEL_HEIGHT + 0.14), title)


def log_comparison(
    stream: rr.RecordingStream,
    rollouts: Rollouts,
    judgements: tuple[Judgement, ...],
    theme: Theme,
) -> None:
    """Draw a table of all outcomes: a row an action, a column a feature and a teacher.

    Every column has a scale of its own, in metres where that is a unit. A small dot is an outcome,
    a large one the median of a feature or the value to a teacher, who picks the action with the
    black ring.
    """
    drawing, count = Drawing(lift=0.1), rollouts.count
    colours = [theme.action_colour(name) for name in rollouts.names]
    row_height = comparison_row_height(len(colours))
    rows = -row_height * (np.arange(len(colours), dtype=np.float64) + 0.5)
    # the dots of a row are spread upwards evenly, so that they do not hide one another
    heights = rows[:, None] + 0.6 * row_height * (np.arange(count) * GOLDEN_RATIO % 1.0 - 0.5)
    clouds = []
    for row, action in zip(rows, rollouts.actions, strict=True):
        drawing.text((-name_room(rollouts) / 2.0, row), short(action.name))
    values = measures(rollouts)
    for column, (title, each) in enumerate(values.items()):
        places = draw_column(drawing, column, title, each, rows)
        clouds.append(np.stack([places, heights], axis=-1))  # (A, K, 2)
        for place, row, colour in zip(places, rows, colours, strict=True):
            drawing.dot((np.median(place), row), colour, 9.0)
    for column, judgement in enumerate(judgements, start=len(values)):
        title = f"V {teacher_name(judgement.teacher)}"
        places = draw_column(drawing, column, title, judgement.values, rows)
        drawing.dot((places[judgement.best], rows[judgement.best]), LIGHT.ink, 17.0)
        for place, row, colour in zip(places, rows, colours, strict=True):
            drawing.dot((place, row), colour, 11.0)
    drawing.log(stream, entities.COMPARISON)
    faint = [blend(colour, LIGHT.panel, 0.5) for colour in colours]
    stream.log(
        entities.COMPARED_OUTCOMES,
        rr.Points2D(
            rounded(np.stack(clouds, axis=1)).reshape(-1, 2),
            colors=np.repeat(faint, len(values) * count, axis=0),
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
        inset = inwards * TICK_LETTER_WIDTH * len(number(end))
        drawing.text((zero + stretch * end + inset, bottom - 0.15), number(end))
    return zero + stretch * values


def measures(rollouts: Rollouts) -> dict[str, FloatArray]:
    """What outcomes are described by, in the order of `FEATURES`, under their titles.

    Returns:
        [A, K] each, in metres where that is a unit.
    """
    scaled = rollouts.features
    return {
        "clearance, m": rollouts.clearance_m,
        "deviation, m": rollouts.deviation_m,
        "progress, m": rollouts.progress_m,
        "smoothness": scaled[..., FEATURES.index("smoothness")],
        COLLISIONS: scaled[..., FEATURES.index("collisions")],
    }


def gaps(rollouts: Rollouts) -> FloatArray:
    """Gap between each robot and the nearest pedestrian, negative where they overlap.

    Returns:
        [A, K, T+1], m.
    """
    apart = np.linalg.norm(rollouts.pedestrians - rollouts.robot[..., None, :2], axis=-1)
    gap: FloatArray = apart.min(axis=-1) - (ROBOT_RADIUS + PEDESTRIAN_RADIUS)
    return gap


def bin_edges(title: str, values: FloatArray) -> FloatArray:
    """Edges of the bins of a measure: round ones, 0 among them, which hold all values.

    Whole numbers are in the middle of bins of width 1.
    """
    low, high = min(0.0, float(values.min())), max(LEAST_RANGES[title], float(values.max()))
    width, aside = round_step((1.0 - ROUNDING) * max(-low, high), MOST_BINS), 0.0
    if title == COLLISIONS:
        width, aside = 1.0, 0.5
    first, last = np.floor(low / width + ROUNDING), np.ceil(high / width - ROUNDING)
    edges: FloatArray = width * np.arange(first - aside, last + aside + 1.0)
    edges[[0, -1]] += (-ROUNDING * width, ROUNDING * width)
    return edges


def distributions_bounds(rollouts: Rollouts) -> Bounds:
    """What a view of a figure of distributions must show."""
    panels = len(FEATURES) + (1 if rollouts.scene.pedestrians else 0)
    width = panels * (PANEL_WIDTH + PANEL_GAP) - PANEL_GAP
    return -0.25, -0.32, width + 0.15, PANEL_HEIGHT + 0.25


def comparison_bounds(rollouts: Rollouts, teachers: int) -> Bounds:
    """What a view of the comparison must show."""
    columns = len(FEATURES) + teachers
    actions = len(rollouts.actions)
    bottom = -comparison_row_height(actions) * actions - 0.4
    return -name_room(rollouts), bottom, columns * COLUMN_WIDTH, 0.48


def comparison_row_height(actions: int) -> float:
    """Height of a row of the comparison, in units of the page."""
    return min(TALLEST_ROW, TALLEST_TABLE / actions)


def name_room(rollouts: Rollouts) -> float:
    """How much room the names of the actions take beside the comparison."""
    return 0.3 + LETTER_WIDTH * max(len(short(name)) for name in rollouts.names)
