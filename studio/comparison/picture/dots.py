"""Outcomes drawn as icons and dots that gather one by one; contact is a × or a square."""

from dataclasses import dataclass

import numpy as np

from studio.arrays import FloatArray
from studio.comparison.dots import BINS, DOT_RADIUS, DotMeasure, Dots, DotScale, IconGrid
from studio.painter.axes import Axis, draw_ticks
from studio.painter.boxes import Box, Point
from studio.painter.canvas import Canvas
from studio.painter.marks import cross, hollow_square
from studio.scene.measures import NOTHING, PERSON, WALL
from studio.style.palette import Colour, blend
from studio.style.ticks import ticks

_SMALLEST_PITCH = 2.5  # px; closer icons cannot be told apart, so a bar stands for them
_KINDS = 3  # of outcomes: those that touched a person, a wall alone, nothing


@dataclass(frozen=True)
class IconArray:
    """One icon an outcome: those in contact fill up from the left, the rest from the right."""

    box: Box  # that the array takes up
    grid: IconGrid  # where the icons lie in the box

    @classmethod
    def fit(cls, room: Box, count: int, largest_pitch: float) -> "IconArray":
        """The one with the largest icons, at the left of a room and in the middle of its height."""
        grid = IconGrid.fit(room.width, room.height, count, largest_pitch)
        top = room.centre[1] - grid.height / 2
        return cls(Box(room.left, top, room.left + grid.width, top + grid.height), grid)

    def draw(self, canvas: Canvas, people: int, walls: int, others: int, colour: Colour) -> None:
        """Draw the array when so many outcomes touched a person, a wall alone, and nothing."""
        count, pitch, theme = self.grid.count, self.grid.pitch, canvas.theme
        numbers = [people, walls, count - people - walls - others, others]
        pale = blend(colour, theme.ground, 0.5)
        # icons drawn twice on the same place would have harder edges
        canvas.fill(self.box.inset(-1), theme.ground)
        if pitch < _SMALLEST_PITCH:
            ends = self.box.left + self.box.width * np.cumsum([0, *numbers]) / count
            shades = [theme.contact, blend(theme.contact, theme.ground, 0.5), theme.grid, pale]
            for left, right, shade in zip(ends, ends[1:], shades, strict=False):
                if right > left:
                    canvas.fill(Box(left, self.box.top, right, self.box.bottom), shade)
            return
        middles = np.array([self.box.left, self.box.top]) + self.grid.places()
        kinds = np.repeat([PERSON, WALL, NOTHING, NOTHING], numbers).tolist()
        shades = [theme.grid] * numbers[2] + [pale] * numbers[3]
        shades = [pale] * (people + walls) + shades
        for middle, kind, shade in zip(middles, kinds, shades, strict=True):
            draw_mark(canvas, middle, kind, DOT_RADIUS * pitch, shade)


class DotPlot:
    """One side's dots for one measure, which pile up as outcomes arrive; contacts lie below."""

    def __init__(self, room: Box, scale: DotScale, side: int, dots: Dots) -> None:
        """Stand the dots of a side on the bottom of a bare room, px."""
        self._room, self._scale = room, scale
        self._bins, self._dots = scale.bins[side], dots
        self._drawn = np.zeros((_KINDS, BINS), np.int64)

    def draw(self, canvas: Canvas, count: int, colour: Colour) -> None:
        """Draw the dots of the first `count` outcomes where some of them are shown already."""
        here = self._dots.arrivals <= count
        stacks = np.stack(
            [
                np.bincount(self._bins[here & (self._dots.kinds == kind)], minlength=BINS)
                for kind in range(_KINDS)
            ]
        )
        for index in np.flatnonzero((stacks != self._drawn).any(axis=0)):
            kinds = np.repeat(np.arange(_KINDS), stacks[:, index]).tolist()
            self._draw_stack(canvas, int(index), kinds, colour)
        self._drawn = stacks

    def _draw_stack(self, canvas: Canvas, index: int, kinds: list[int], colour: Colour) -> None:
        room, scale = self._room, self._scale
        left = room.left + index * scale.width
        # within its own pixels, so that the order in which stacks are drawn does not show
        cell = canvas.clipped(Box(left, room.top, left + scale.width, room.bottom))
        cell.fill(cell.box, canvas.theme.ground)
        for number, kind in enumerate(kinds):
            across, up = scale.middle(index, number)
            at = (room.left + across, room.bottom - up)
            draw_mark(cell, at, kind, DOT_RADIUS * scale.pitch, colour)


@dataclass(frozen=True)
class DotAxis(Axis):
    """The axis of a measure, whose lowest value may be set apart."""

    measure: DotMeasure  # what lies along it

    def at(self, value: float) -> float:
        """Where a value lies, px."""
        return self.start + self.measure.at(value) * (self.end - self.start)


def draw_mark(
    canvas: Canvas, at: Point | FloatArray, kind: int, radius: float, colour: Colour
) -> None:
    """Draw the mark of outcomes of a kind: a red × or square after contact, else a disc."""
    theme = canvas.theme
    if kind == PERSON:
        cross(canvas, at, 0.8 * radius, theme.contact)  # no larger: its neighbours stay apart
    elif kind == WALL:
        hollow_square(canvas, at, 0.9 * radius, theme.contact, theme.ground)
    else:
        canvas.disc(at, radius, colour)


def draw_dot_axis(canvas: Canvas, room: Box, measure: DotMeasure) -> None:
    """Draw the axis under the room for dots (px), its ticks, and below them what it measures."""
    unit, small, theme = canvas.unit, canvas.type.small, canvas.theme
    for start, end in measure.lines():
        left, right = room.left + start * room.width, room.left + end * room.width
        canvas.fill(Box(left, room.bottom, right, room.bottom + canvas.hair), theme.faint)
    axis = DotAxis(measure.low, measure.high, room.left, room.right, measure)
    values = ticks(measure.low, measure.high, 4)
    for value in values:
        x = min(axis.at(value), room.right - canvas.hair)
        canvas.fill(Box(x, room.bottom, x + canvas.hair, room.bottom + 4 * unit), theme.faint)
    top = room.bottom + 6 * unit
    draw_ticks(canvas, axis, top, values)
    at, ink = (room.centre[0], top + 1.1 * small), theme.ink
    canvas.fit(at, measure.names, room.width, small, ink, anchor="centre", line="top")
