"""Outcomes drawn as dots that gather one by one."""

from dataclasses import dataclass

import numpy as np

from studio.arrays import BoolArray
from studio.comparison.dots import BINS, DOT_RADIUS, DotMeasure, DotScale, IconGrid
from studio.painter.axes import Axis, draw_ticks
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.style.palette import Colour, blend
from studio.style.ticks import ticks

_SMALLEST_PITCH = 2.0  # px; closer dots cannot be told apart, so bars stand for them


@dataclass(frozen=True)
class IconArray:
    """One dot an outcome: those in contact fill up from the left, the rest from the right."""

    box: Box  # that the array takes up
    grid: IconGrid  # where the dots lie in the box

    @classmethod
    def fit(cls, room: Box, count: int, largest_pitch: float) -> "IconArray":
        """The one with the largest dots, at the left of a room and in the middle of its height."""
        grid = IconGrid.fit(room.width, room.height, count, largest_pitch)
        top = room.centre[1] - grid.height / 2
        return cls(Box(room.left, top, room.left + grid.width, top + grid.height), grid)

    def draw(self, canvas: Canvas, touched: int, others: int, colour: Colour) -> None:
        """Draw the array when `touched` outcomes had contact and `others` had none."""
        count, pitch = self.grid.count, self.grid.pitch
        colours = [canvas.theme.contact, canvas.theme.grid, blend(colour, canvas.theme.ground, 0.5)]
        numbers = [touched, count - touched - others, others]
        # dots drawn twice on the same place would have harder edges
        canvas.fill(self.box.inset(-1), canvas.theme.ground)
        if pitch < _SMALLEST_PITCH:
            ends = self.box.left + self.box.width * np.cumsum([0, *numbers]) / count
            for left, right, shade in zip(ends, ends[1:], colours, strict=False):
                if right > left:
                    canvas.fill(Box(left, self.box.top, right, self.box.bottom), shade)
            return
        middles = np.array([self.box.left, self.box.top]) + self.grid.places()
        shades = np.repeat(np.array(colours), numbers, axis=0).tolist()
        for middle, shade in zip(middles, shades, strict=True):
            canvas.disc(middle, DOT_RADIUS * pitch, tuple(shade))


class DotPlot:
    """One side's dots for one measure, which pile up as outcomes arrive; contacts lie below."""

    def __init__(self, room: Box, scale: DotScale, side: int, contact: BoolArray) -> None:
        """Stand the dots on the bottom of a bare room (px); contact [K] is that of the outcomes."""
        self._room, self._scale = room, scale
        self._bins, self._contact = scale.bins[side], contact
        self._drawn = np.zeros((2, BINS), np.int64)

    def draw(self, canvas: Canvas, count: int, colour: Colour) -> None:
        """Draw the first `count` outcomes on a canvas that shows some of them already."""
        bins, contact = self._bins[:count], self._contact[:count]
        stacks = np.stack(
            [np.bincount(bins[chosen], minlength=BINS) for chosen in (contact, ~contact)]
        )
        for index in np.flatnonzero((stacks != self._drawn).any(axis=0)):
            touched, others = stacks[:, index].tolist()
            self._draw_stack(canvas, int(index), touched, others, colour)
        self._drawn = stacks

    def _draw_stack(
        self, canvas: Canvas, index: int, touched: int, others: int, colour: Colour
    ) -> None:
        room, scale, red = self._room, self._scale, canvas.theme.contact
        left = room.left + index * scale.width
        # within its own pixels, so that the order in which stacks are drawn does not show
        cell = canvas.clipped(Box(left, room.top, left + scale.width, room.bottom))
        cell.fill(cell.box, canvas.theme.ground)
        total = touched + others
        if not has_dots(scale):
            half, middle = scale.abreast * scale.pitch / 2, left + scale.width / 2
            for number, shade in ((total, colour), (touched, red)):
                if number:
                    top = room.bottom - number / scale.abreast * scale.pitch
                    cell.fill(Box(middle - half, top, middle + half, room.bottom), shade)
            return
        for number in range(total):
            across, up = scale.middle(index, number)
            shade = red if number < touched else colour
            at = (room.left + across, room.bottom - up)
            cell.disc(at, DOT_RADIUS * scale.pitch, shade)


@dataclass(frozen=True)
class DotAxis(Axis):
    """The axis of a measure, whose lowest value may be set apart."""

    measure: DotMeasure  # what lies along it

    def at(self, value: float) -> float:
        """Where a value lies, px."""
        return self.start + self.measure.at(value) * (self.end - self.start)


def has_dots(scale: DotScale) -> bool:
    """Whether there is room for dots of a scale in px, or bars stand for them."""
    return scale.pitch >= _SMALLEST_PITCH


def draw_dot_axis(canvas: Canvas, room: Box, measure: DotMeasure) -> None:
    """Draw the axis under the room for dots (px), its ticks, and below them what it measures."""
    unit, small = canvas.unit, canvas.type.small
    for start, end in measure.lines():
        left, right = room.left + start * room.width, room.left + end * room.width
        canvas.fill(Box(left, room.bottom, right, room.bottom + canvas.hair), canvas.theme.faint)
    axis = DotAxis(measure.low, measure.high, room.left, room.right, measure)
    top = room.bottom + 5 * unit
    draw_ticks(canvas, axis, top, ticks(measure.low, measure.high, 5))
    at, ink = (room.centre[0], top + 1.1 * small), canvas.theme.ink
    canvas.fit(at, measure.names, room.width, small, ink, anchor="centre", line="top")
