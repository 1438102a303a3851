"""The figure of one action's outcomes as a recording shows it: axes on which icons and dots gather.

What gathers is not on it, since it answers when hovered: a recording lays it over the figure.
"""

from dataclasses import dataclass

import numpy as np

from scenes import Rollouts
from studio.arrays import FloatArray, PixelArray
from studio.comparison.dots import DOT_RADIUS, Dots, DotScale, IconGrid, dot_measures
from studio.comparison.picture.dots import draw_dot_axis
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.scene.measures import contact_kinds
from studio.style.palette import Theme

FIGURE_SIZE = (1240, 440)
"""Width and height of the figure, px: twice what a view of it usually takes."""

_CANVAS = (2560, 1440)  # that it is drawn on, whose type is as large as this figure needs, px
_ICONS = Box(20.0, 14.0, 1220.0, 84.0)  # where icons lie on the figure, px
_DOTS = Box(20.0, 112.0, 1220.0, 352.0)  # where dots lie, px
_GAP = 60.0  # between plots of dots, px
_ICON_PITCH, _DOT_PITCH = 34.0, 20.0  # the largest distance from one icon to the next, and of dots


@dataclass(frozen=True)
class PlacedDots:
    """Dots of outcomes on the figure, all as large."""

    name: str  # what they show
    dots: Dots
    places: FloatArray  # [N, 2], where they lie, px
    radius: float  # px


def paint_dots(
    rollouts: Rollouts, side: int, theme: Theme
) -> tuple[PixelArray, tuple[PlacedDots, ...]]:
    """The figure of a side, [height, width, 3], and what gathers on it: icons, then dots."""
    canvas = Canvas(*_CANVAS, theme)
    icons = Dots.of(np.zeros(rollouts.count), contact_kinds(rollouts)[side])
    grid = IconGrid.fit(_ICONS.width, _ICONS.height, len(icons.kinds), _ICON_PITCH)
    places, radius = grid.places() + np.array([_ICONS.left, _ICONS.top]), DOT_RADIUS * grid.pitch
    for place in places:
        canvas.disc(place, radius, theme.grid)
    placed, shown = [PlacedDots("icons", icons, places, radius)], dot_measures(rollouts)
    rooms = _DOTS.columns([1.0] * len(shown), _GAP)
    scales = DotScale.fit_all(shown, rooms[0].width, _DOTS.height, _DOT_PITCH)
    for measure, room, scale in zip(shown, rooms, scales, strict=True):
        draw_dot_axis(canvas, room, measure)
        dots, floor = measure.dots[side], np.array([room.left, room.bottom])
        places = floor + scale.middles(side, dots) * np.array([1.0, -1.0])
        placed.append(PlacedDots(measure.names[-1], dots, places, DOT_RADIUS * scale.pitch))
    width, height = FIGURE_SIZE
    return canvas.pixels[:height, :width], tuple(placed)
