"""One action's outcomes as dots that gather along the story: contacts, progress, gaps.

Drawn on a page of width 1; both sides have the same axes.
"""

from collections import defaultdict

import numpy as np
import rerun as rr
from numpy.typing import NDArray

from scenes import Rollouts
from studio.dots import DOT_RADIUS, DotScale, IconGrid, measures
from studio.framing import Bounds
from studio.judgements import FloatArray
from studio.naming import number
from studio.painter.plots import ticks
from studio.palette import Theme, blend
from studio.recorder import entities
from studio.recorder.comparison_story import ends, story_times
from studio.recorder.drawing import Drawing

BOUNDS: Bounds = (-0.02, -0.12, 1.02, 0.34)
"""What a view of the page must show."""

ICONS_TOP, ICONS_HEIGHT, ICONS_WIDTH, ICON_PITCH = 0.32, 0.06, 0.72, 0.03
"""Of the array of icons, whose pitch is at most this, in units of the page."""

DOTS_HEIGHT, DOT_PITCH, GAP = 0.21, 0.02, 0.08
"""Of the dot plots, whose pitch is at most this, and between them, in units of the page."""

COUNT_WIDTH = 0.22
"""About the width of the words that count contacts, in units of the page."""


def log_dots(stream: rr.RecordingStream, rollouts: Rollouts, side: int, theme: Theme) -> None:
    """Draw the axes of one side, and let its dots gather."""
    path = entities.dots(rollouts.actions[side].name)
    colour = theme.action_colour(rollouts.actions[side].name)
    contact = rollouts.contact_step[side] >= 0
    grid = IconGrid.fit(ICONS_WIDTH, ICONS_HEIGHT, len(contact), ICON_PITCH)
    icons = np.array([0.0, ICONS_TOP]) + grid.places() * (1.0, -1.0)
    radius = DOT_RADIUS * grid.pitch
    stream.log(f"{path}/waiting", rr.Points2D(icons, colors=theme.grid, radii=radius), static=True)
    # contacts from the left, the others from the right
    ranks = np.where(contact, contact.cumsum() - 1, len(contact) - (~contact).cumsum())
    pale = blend(colour, theme.panel, 0.5)
    shades = np.where(contact[:, None], theme.contact, pale)
    places, colours, radii = [icons[ranks]], [shades], [np.full(len(contact), radius)]

    axes, shown = Drawing(lift=0.02), measures(rollouts)
    width = (1.0 - GAP * (len(shown) - 1)) / len(shown)
    for column, measure in enumerate(shown):
        left = column * (width + GAP)
        axes.line([(left, 0.0), (left + width, 0.0)], theme.faint, 1.0)
        for tick in ticks(measure.low, measure.high, 5):
            share = (tick - measure.low) / (measure.high - measure.low)
            axes.text((left + share * width, -0.035), number(tick))
        axes.text((left + width / 2, -0.085), measure.names[0])
        scale = DotScale.fit(measure, width, DOTS_HEIGHT, DOT_PITCH)
        places.append(np.array([left, 0.0]) + piled_up(scale, side))
        colours.append(np.where(contact[:, None], theme.contact, colour))
        radii.append(np.full(len(contact), DOT_RADIUS * scale.pitch))
    axes.log(stream, path)
    each = [len(places)] * len(contact)
    stream.log(f"{path}/outcomes", rr.Points2D.from_fields(draw_order=40.0), static=True)
    stream.send_columns(
        f"{path}/outcomes",
        [story_times(ends(len(contact)))],
        rr.Points2D.columns(
            positions=np.stack(places, axis=1).reshape(-1, 2),
            colors=np.stack(colours, axis=1).reshape(-1, 3).astype(np.uint8),
            radii=np.stack(radii, axis=1).ravel(),
        ).partition(each),
    )
    log_count(stream, f"{path}/count", contact, grid.width, theme)


def log_count(
    stream: rr.RecordingStream,
    path: str,
    contact: NDArray[np.bool_],
    left: float,
    theme: Theme,
) -> None:
    """Count the outcomes with contact, in words right of the icons."""
    counts = [0, *contact.cumsum().tolist()]
    place = (left + COUNT_WIDTH / 2, ICONS_TOP - ICONS_HEIGHT / 2 + 0.02)
    stream.log(
        path,
        rr.LineStrips2D.from_fields(radii=0.0, colors=theme.ink, show_labels=True),
        static=True,
    )
    stream.send_columns(
        path,
        [story_times(np.append(0.0, ends(len(contact))))],
        rr.LineStrips2D.columns(
            strips=[[place, place]] * len(counts),
            labels=[f"{count} of {len(contact)} with contact" for count in counts],
        ),
    )


def piled_up(scale: DotScale, side: int) -> FloatArray:
    """Where the dot of each outcome lands if they come one by one, [K, 2]."""
    landed: defaultdict[int, int] = defaultdict(int)
    places = []
    for place in scale.bins[side].tolist():
        places.append(scale.place(place, landed[place]))
        landed[place] += 1
    return np.array(places)
