"""How the outcomes of each action are distributed, in a recording.

A figure lies on a page whose unit is the width of a panel. Its panels stand side by side: a
histogram a feature, and the gap to the nearest person over time.
"""

import numpy as np
import rerun as rr

from scenes import FEATURES, Rollouts
from studio.arrays import Bounds, FloatArray, IntArray
from studio.recorder.drawing import OVERLAP, PAGE_RESOLUTION, Drawing
from studio.scene.measures import Measure, gap_over_time, measures
from studio.scene.recording import entities
from studio.style.palette import LIGHT, Colour, Theme, blend
from studio.style.ticks import round_step
from studio.style.words import rounded_number

# lengths on the page
PANEL_WIDTH, PANEL_HEIGHT, PANEL_GAP = 1.0, 0.8, 0.36
DISTRIBUTIONS_PITCH = PANEL_WIDTH + PANEL_GAP  # from the left of a panel to that of the next
STROKE = 0.02  # how far apart the strokes that fill a bar are at most

# how far the histogram of each of the `FEATURES` reaches from 0 at least
LEAST_RANGES = dict(zip(FEATURES, (1.0, 0.2, 1.0, 1.0, 2.0), strict=True))
MOST_BINS = 25  # of a histogram of values on one side of 0
ROUNDING = 1e-9  # a value that leaves the bins by this share of one does so by rounding only


def log_distributions(stream: rr.RecordingStream, rollouts: Rollouts, theme: Theme) -> None:
    """Draw the figure of each action."""
    shown = [(measure, bin_edges(measure)) for measure in measures(rollouts)]
    if rollouts.scene.pedestrians:
        gap_quantiles = np.quantile(gap_over_time(rollouts), [0.1, 0.5, 0.9], axis=1)  # (3, A, T+1)
    for index, name in enumerate(rollouts.names):
        drawing, touched = Drawing(lift=0.06, resolution=PAGE_RESOLUTION), rollouts.touched[index]
        colour = theme.action_colour(name)
        for column, (measure, edges) in enumerate(shown):
            values = measure.values[index]
            counts = [np.histogram(some, edges)[0] for some in (values[touched], values)]
            left = column * DISTRIBUTIONS_PITCH
            colours = (theme.contact, colour)
            draw_counts(drawing, left, measure, edges, np.stack(counts), colours)
        if rollouts.scene.pedestrians:
            left = len(FEATURES) * DISTRIBUTIONS_PITCH
            ends = float(min(0.0, gap_quantiles.min())), float(gap_quantiles.max())
            draw_band(drawing, left, rollouts.horizon, ends, gap_quantiles[:, index], colour)
        drawing.log(stream, entities.distributions(name))


def draw_counts(
    drawing: Drawing,
    left: float,
    measure: Measure,
    edges: FloatArray,
    counts: IntArray,
    colours: tuple[Colour, Colour],
) -> None:
    """Draw a histogram into the panel that begins at `left`.

    Counts [2, B] are those of the outcomes with contact and of all in bins with B + 1 edges;
    colours are those of the outcomes with contact and of the others, which lie above them.
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
    draw_frame(drawing, left, measure.title)
    low, high, margin = edges[0], edges[-1], 0.0
    if measure.is_counted:  # whole numbers, written below the middle of their bins
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

    The panel shows gaps between two ends (m) up to the horizon (s). Quantiles [3, T+1] are the
    10 %, 50 % and 90 % quantiles, m.
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


def bin_edges(measure: Measure) -> FloatArray:
    """Edges of the bins of a measure, [B+1]: round ones, 0 among them, which hold all values.

    Whole numbers are in the middle of bins of width 1.
    """
    values, least = measure.values, LEAST_RANGES[measure.feature]
    low, high = min(0.0, float(values.min())), max(least, float(values.max()))
    width, aside = round_step((1.0 - ROUNDING) * max(-low, high), MOST_BINS), 0.0
    if measure.is_counted:
        width, aside = 1.0, 0.5
    first, last = np.floor(low / width + ROUNDING), np.ceil(high / width - ROUNDING)
    edges: FloatArray = width * np.arange(first - aside, last + aside + 1.0)
    edges[[0, -1]] += (-ROUNDING * width, ROUNDING * width)
    return edges


def distributions_bounds(rollouts: Rollouts) -> Bounds:
    """What a view of a figure of distributions must show."""
    panels = len(FEATURES) + (1 if rollouts.scene.pedestrians else 0)
    return -0.25, -0.32, panels * DISTRIBUTIONS_PITCH - PANEL_GAP + 0.15, PANEL_HEIGHT + 0.25
