"""Outcomes as dots that gather one by one: icon arrays, and dot plots on a common axis.

Every dot is one outcome. What both sides of a comparison share, bins and the size of dots, is
found from both, so equal numbers look equal.

References: Garcia-Retamero and Galesic, "Communicating treatment risk reduction to people with low
numeracy skills", American Journal of Public Health 2009 (icon arrays with one denominator);
Fernandes et al., "Uncertainty displays using quantile dotplots or CDFs improve transit
decision-making", CHI 2018 (one dot an outcome).
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from studio.painter.canvas import Box, Canvas, FloatArray
from studio.painter.plots import Axis, BoolArray, draw_ticks, ticks
from studio.palette import Colour, blend

BINS = 24
"""Of a dot plot."""

_SMALLEST_PITCH = 2.0  # px; closer dots cannot be told apart, so bars stand for them
_DOT = 0.42  # radius of a dot in pitches


@dataclass(frozen=True)
class IconArray:
    """One dot an outcome, in columns: those in contact fill up from the left, the rest from right.

    So no dot ever changes its colour once it has one, and in the end the two meet.

    Attributes:
        box: what it takes up, px.
        count: how many outcomes there will be.
        rows: how many dots a column has.
        pitch: from one dot to the next, px.
    """

    box: Box
    count: int
    rows: int
    pitch: float

    @classmethod
    def fit(cls, box: Box, count: int, largest_pitch: float) -> "IconArray":
        """The one with the largest dots, at the left of a box and in the middle of its height."""

        def pitch(rows: int) -> float:
            return min(box.width / math.ceil(count / rows), box.height / rows, largest_pitch)

        rows = max(range(1, min(count, 100) + 1), key=pitch)
        width, height = math.ceil(count / rows) * pitch(rows), rows * pitch(rows)
        top = box.centre[1] - height / 2
        taken = Box(box.left, top, box.left + width, top + height)
        return cls(taken, count, rows, pitch(rows))

    def draw(self, canvas: Canvas, touched: int, others: int, colour: Colour) -> None:
        """Draw it when so many outcomes had contact and so many others had none."""
        colours = [canvas.theme.contact, canvas.theme.grid, blend(colour, canvas.theme.ground, 0.5)]
        ends = np.cumsum([0, touched, self.count - touched - others, others])
        if self.pitch < _SMALLEST_PITCH:
            marks = self.box.left + self.box.width * ends / self.count
            for left, right, shade in zip(marks, marks[1:], colours, strict=False):
                if right > left:
                    canvas.fill(Box(left, self.box.top, right, self.box.bottom), shade)
            return
        # dots drawn twice on the same place would have harder edges
        canvas.fill(self.box.inset(-1), canvas.theme.ground)
        for first, last, shade in zip(ends, ends[1:], colours, strict=False):
            for index in range(first, last):
                column, row = divmod(index, self.rows)
                x = self.box.left + (column + 0.5) * self.pitch
                canvas.disc((x, self.box.top + (row + 0.5) * self.pitch), _DOT * self.pitch, shade)


@dataclass(frozen=True)
class DotScale:
    """Where the dots of a measure lie, on every side alike.

    Attributes:
        low: left end of the axis, in the unit of the measure.
        high: right end.
        bins: [A, K], the bin that each outcome falls into.
        abreast: how many dots stand side by side in a bin.
        pitch: from one dot to the next, px.
    """

    low: float
    high: float
    bins: NDArray[np.int64]
    abreast: int
    pitch: float

    @classmethod
    def fit(
        cls, values: FloatArray, ends: tuple[float, float], room: Box, largest_pitch: float
    ) -> "DotScale":
        """The scale with the largest dots at which the tallest stack stays in the room.

        Args:
            values: [A, K].
            ends: of the axis; values beyond count in the outermost bins.
            room: for the dots of one side, px.
            largest_pitch: px.
        """
        low, high = ends
        shares = np.clip((values - low) / (high - low), 0.0, 1.0)
        # a value on the edge of two bins counts in the right one, whatever rounding does to it
        bins = np.minimum(np.floor(shares * BINS + 1e-9), BINS - 1).astype(np.int64)
        tallest = max(int(np.bincount(row).max()) for row in bins)
        width = room.width / BINS

        def pitch(abreast: int) -> float:
            stacked = math.ceil(tallest / abreast)
            return min(width / abreast, room.height / stacked, largest_pitch)

        abreast = max(range(1, 101), key=pitch)
        return cls(low, high, bins, abreast, pitch(abreast))

    @property
    def has_dots(self) -> bool:
        """Whether there is room for dots, or bars stand for them."""
        return self.pitch >= _SMALLEST_PITCH


class DotPlot:
    """One side's dots for one measure, which pile up as outcomes arrive; contacts lie below."""

    def __init__(self, room: Box, scale: DotScale, side: int, contact: BoolArray) -> None:
        """Take where the dots go.

        Args:
            room: for the dots, px; they stand on its bottom, on the bare page.
            scale: of the measure.
            side: which row of the scale's bins.
            contact: [K], which outcomes touched something.
        """
        self._room, self._scale = room, scale
        self._bins, self._contact = scale.bins[side], contact
        self._drawn = np.zeros((2, BINS), np.int64)

    def draw(self, canvas: Canvas, count: int, colour: Colour) -> None:
        """Draw the first `count` outcomes on a canvas that shows some of them already."""
        bins, contact = self._bins[:count], self._contact[:count]
        stacks = np.stack(
            [np.bincount(bins[chosen], minlength=BINS) for chosen in (contact, ~contact)]
        )
        for place in np.flatnonzero((stacks != self._drawn).any(axis=0)):
            touched, others = stacks[:, place].tolist()
            self._draw_stack(canvas, int(place), touched, others, colour)
        self._drawn = stacks

    def _draw_stack(
        self, canvas: Canvas, place: int, touched: int, others: int, colour: Colour
    ) -> None:
        room, pitch, abreast = self._room, self._scale.pitch, self._scale.abreast
        width, red = room.width / BINS, canvas.theme.contact
        left, right = room.left + place * width, room.left + (place + 1) * width
        # within its own pixels, so that the order in which stacks are drawn does not show
        cell = canvas.clipped(Box(left, room.top, right, room.bottom))
        cell.fill(cell.box, canvas.theme.ground)
        middle, total = (left + right) / 2, touched + others
        if not self._scale.has_dots:
            half = abreast * pitch / 2
            for number, shade in ((total, colour), (touched, red)):
                if number:
                    top = room.bottom - number / abreast * pitch
                    cell.fill(Box(middle - half, top, middle + half, room.bottom), shade)
            return
        for index in range(total):
            row, column = divmod(index, abreast)
            x = middle + (column - (abreast - 1) / 2) * pitch
            at = (x, room.bottom - (row + 0.5) * pitch)
            cell.disc(at, _DOT * pitch, red if index < touched else colour)


def draw_dot_axis(canvas: Canvas, room: Box, scale: DotScale, names: Sequence[str]) -> None:
    """Draw the axis under the room for dots, its ticks, and below them what it measures.

    Args:
        canvas: to draw on.
        room: for the dots, px.
        scale: of the measure.
        names: what it measures, the longest wording first.
    """
    unit, small = canvas.unit, canvas.type.small
    canvas.fill(
        Box(room.left, room.bottom, room.right, room.bottom + canvas.hair), canvas.theme.faint
    )
    axis = Axis(scale.low, scale.high, room.left, room.right)
    top = room.bottom + 5 * unit
    draw_ticks(canvas, axis, top, ticks(scale.low, scale.high, 5))
    name = canvas.fitted(names, room.width, small)
    at = (room.centre[0], top + 1.1 * small)
    canvas.text(at, name, small, canvas.theme.ink, anchor="centre", line="top")
