"""Small plots: axes, histograms, icon arrays and dots, drawn into a box."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from studio.arrays import BoolArray, FloatArray
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.style.palette import Colour
from studio.style.words import number


@dataclass(frozen=True)
class Axis:
    """A linear axis from one value to another over a stretch of the page.

    Attributes:
        low: value at `start`.
        high: value at `end`.
        start: px.
        end: px.
    """

    low: float
    high: float
    start: float
    end: float

    def at(self, value: float) -> float:
        """Where a value lies, px; values off the axis lie at its end."""
        share = (value - self.low) / (self.high - self.low)
        return self.start + min(max(share, 0.0), 1.0) * (self.end - self.start)

    def along(self, values: FloatArray) -> FloatArray:
        """Where values lie, px; values off the axis lie at its end."""
        shares = np.clip((values - self.low) / (self.high - self.low), 0.0, 1.0)
        pixels: FloatArray = self.start + shares * (self.end - self.start)
        return pixels


def draw_ticks(canvas: Canvas, axis: Axis, top: float, values: Sequence[float]) -> None:
    """Write the values under a horizontal axis, leaving out those that would touch.

    The outermost labels are pushed inwards to stay between the ends of the axis.
    """
    size, gap = canvas.type.small, 5 * canvas.unit
    right_of_last = -math.inf
    for value in values:
        text = number(value)
        half = canvas.measure(text, size) / 2
        centre = min(max(axis.at(value), axis.start + half), axis.end - half)
        if centre - half >= right_of_last + gap:
            box = canvas.text(
                (centre, top), text, size, canvas.theme.faint, anchor="centre", line="top"
            )
            right_of_last = box.right


def draw_histogram(
    canvas: Canvas,
    box: Box,
    axis: Axis,
    values: FloatArray,
    edges: FloatArray,
    colour: Colour,
    contact: BoolArray,
) -> None:
    """Draw a histogram, scaled to its own peak, with the rollouts in contact red at the bottom.

    A dot marks the mean.

    A bin that holds anything is at least a sliver high: rare outcomes are what matters here.

    Args:
        canvas: to draw on.
        box: height of the plot, px.
        axis: where values lie.
        values: [K]; those off the axis count in its first or last bin.
        edges: [B + 1] edges of the bins.
        colour: of the bars.
        contact: [K], which rollouts touched something.
    """
    inside = np.clip(values, edges[0], edges[-1])
    counts, _ = np.histogram(inside, edges)
    touched, _ = np.histogram(inside[contact], edges)
    sliver, gap = max(2.0, 2 * canvas.unit), max(1.0, canvas.unit)
    pixels = np.rint(axis.along(edges))
    for left, right, count, red in zip(pixels, pixels[1:], counts, touched, strict=False):
        if not count:
            continue
        height = max(box.height * count / counts.max(), sliver)
        red_height = max(height * red / count, sliver) if red else 0.0
        bar = Box(left, box.bottom - height, max(right - gap, left + 1), box.bottom)
        canvas.fill(bar, colour)
        if red:
            canvas.fill(
                Box(bar.left, box.bottom - red_height, bar.right, box.bottom), canvas.theme.contact
            )
    mean = (axis.at(float(inside.mean())), box.bottom)
    canvas.disc(mean, 4.5 * canvas.unit, canvas.theme.ground)
    canvas.disc(mean, 3.2 * canvas.unit, canvas.theme.ink)


def icon_columns(count: int, rows: int = 5) -> int:
    """How many columns an icon array of so many icons in so many rows has."""
    return math.ceil(count / rows)


def icon_pitch(box: Box, count: int, rows: int = 5) -> float:
    """Distance between the icons of an array of so many in so many rows, px.

    It is 0 where icons would be too small to tell apart.
    """
    pitch = min(box.width / icon_columns(count, rows), box.height / rows)
    return pitch if pitch >= 3.0 else 0.0


def draw_icons(
    canvas: Canvas, box: Box, touched: int, count: int, colour: Colour, rows: int = 5
) -> Box:
    """Draw an icon array: one dot a rollout, those that touched something first and red.

    Where dots would be too small to tell apart, a bar stands for them that fills with red.

    Returns:
        The box that it takes up, at the left of the given one.
    """
    columns, pitch = icon_columns(count, rows), icon_pitch(box, count, rows)
    if not pitch:
        bar = Box(
            box.left, box.centre[1] - 4 * canvas.unit, box.right, box.centre[1] + 4 * canvas.unit
        )
        canvas.fill(bar, canvas.theme.grid)
        if touched:
            share = max(bar.width * touched / count, 1.0)
            canvas.fill(Box(bar.left, bar.top, bar.left + share, bar.bottom), canvas.theme.contact)
        return bar
    top = box.centre[1] - rows * pitch / 2
    for index in range(count):
        column, row = divmod(index, rows)
        centre = (box.left + (column + 0.5) * pitch, top + (row + 0.5) * pitch)
        canvas.disc(centre, 0.38 * pitch, canvas.theme.contact if index < touched else colour)
    return Box(box.left, top, box.left + columns * pitch, top + rows * pitch)
