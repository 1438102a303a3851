"""Marks in plots: dots, crosses, icons, histograms, bands and dashed curves."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np

from studio.arrays import FloatArray, IntArray
from studio.painter.axes import Axis
from studio.painter.boxes import Box, Point
from studio.painter.canvas import Canvas
from studio.style.palette import Colour

_ICON_ROWS = 5  # icons that stand one below the other in an icon array
_SMALLEST_PITCH = 3.0  # from one icon to the next, px
_BAND = 0.22  # how opaque a band is


def dot(canvas: Canvas, x: float, y: float, colour: Colour, radius: float) -> None:
    """Draw a disc that a rim keeps apart from what is below; its radius grows with the page."""
    canvas.disc((x, y), (radius + 1.3) * canvas.unit, canvas.theme.ground)
    canvas.disc((x, y), radius * canvas.unit, colour)


def crosses(
    canvas: Canvas, places: FloatArray, radius: float, colour: Colour, rim: Colour | None = None
) -> None:
    """Draw an × at each place [N, 2], px, with as much (px) from its middle to its ends.

    They may have a rim, which lies below all of them.
    """
    reach, pen = 0.85 * radius, max(1.0, 0.5 * radius)
    strokes = reach * np.array([[(-1.0, -1.0), (1.0, 1.0)], [(-1.0, 1.0), (1.0, -1.0)]])
    lines = (places[:, None, None] + strokes).reshape(-1, 2, 2)
    if rim is not None:
        canvas.lines(lines, rim, pen + max(1.6, 0.5 * radius))
    canvas.lines(lines, colour, pen)


def cross(
    canvas: Canvas, at: Point | FloatArray, radius: float, colour: Colour, rim: Colour | None = None
) -> None:
    """Draw one ×, see `crosses`."""
    crosses(canvas, np.array([at], dtype=np.float64), radius, colour, rim)


def hollow_square(
    canvas: Canvas, at: Point | FloatArray, radius: float, colour: Colour, inside: Colour
) -> None:
    """Draw the outline of a square, as far (px) from its middle to its sides."""
    # on whole pixels, or thin outlines would be pale
    pen = max(1, round(0.4 * radius))
    side = max(round(2 * radius), 2 * pen + 1)
    left, top = round(float(at[0]) - side / 2), round(float(at[1]) - side / 2)
    outer = Box(left, top, left + side, top + side)
    canvas.fill(outer, colour)
    canvas.fill(outer.inset(pen), inside)


def draw_icons(
    canvas: Canvas, box: Box, people: int, walls: int, count: int, colour: Colour
) -> None:
    """Draw an icon array at the left of a box, an icon for each of `count` outcomes.

    Outcomes that touched a person come first, as crosses, then those that touched a wall only, as
    squares; all others are discs. Where icons would be too small to tell apart, a bar stands for
    them that fills with red, striped for walls.
    """
    theme = canvas.theme
    pitch = min(box.width / math.ceil(count / _ICON_ROWS), box.height / _ICON_ROWS)
    if pitch < _SMALLEST_PITCH:
        middle, ends = box.centre[1], [0.0, people / count, (people + walls) / count]
        bar = Box(box.left, middle - 4 * canvas.unit, box.right, middle + 4 * canvas.unit)
        canvas.fill(bar, theme.grid)
        parts = [box.left + box.width * end for end in ends]
        for left, right, is_wall in ((*parts[:2], False), (*parts[1:], True)):
            if right > left:
                part = Box(left, bar.top, max(right, left + 1), bar.bottom)
                canvas.fill(part, theme.contact)
                if is_wall:
                    _stripe(canvas, part)
        return
    top, radius = box.centre[1] - _ICON_ROWS * pitch / 2, 0.38 * pitch
    for index in range(count):
        column, row = divmod(index, _ICON_ROWS)
        centre = (box.left + (column + 0.5) * pitch, top + (row + 0.5) * pitch)
        if index < people:
            cross(canvas, centre, 0.95 * radius, theme.contact)
        elif index < people + walls:
            hollow_square(canvas, centre, 0.9 * radius, theme.contact, theme.ground)
        else:
            canvas.disc(centre, radius, colour)


@dataclass(frozen=True)
class Histogram:
    """How many values fall into each of B bins, of three kinds that are stacked, the first lowest.

    What is stacked are the outcomes in which a person was touched, those in which only a wall was,
    and all others.
    """

    edges: FloatArray  # [B + 1], ends of the bins
    counts: IntArray  # [3, B]
    mean: float  # of all values, within the edges

    @classmethod
    def of(cls, values: FloatArray, edges: FloatArray, kinds: IntArray) -> "Histogram":
        """Count values [K] of these kinds [K] (0, 1 or 2); those off the edges count at an end."""
        inside, bins = np.clip(values, edges[0], edges[-1]), len(edges) - 1
        # several times as fast as np.histogram
        places = np.minimum(np.searchsorted(edges, inside, side="right") - 1, bins - 1)
        counts = np.bincount(kinds * bins + places, minlength=3 * bins).reshape(3, bins)
        return cls(edges, counts, float(inside.mean()))

    @property
    def highest(self) -> int:
        """How many values the fullest bin holds."""
        return int(self.counts.sum(axis=0).max())


def draw_histogram(
    canvas: Canvas, box: Box, axis: Axis, histogram: Histogram, most: int, colour: Colour
) -> None:
    """Draw a histogram in a box that is as high as a bin that holds `most` values.

    Outcomes in which a person was touched are red at the bottom; those in which a wall was are
    striped above them. A dot marks the mean. A bin that holds anything is at least a sliver high:
    what is rare matters. One that holds more than `most` fills the box, broken below its top.
    """
    sliver, gap, red = max(2.0, 2 * canvas.unit), max(1.0, canvas.unit), canvas.theme.contact
    pixels = np.rint(axis.along(histogram.edges)).tolist()
    stacks = histogram.counts.T.tolist()
    for left, right, (people, walls, others) in zip(pixels, pixels[1:], stacks, strict=False):
        total = people + walls + others
        if not total:
            continue
        height = max(box.height * min(total / most, 1.0), sliver)
        end = max(right - gap, left + 1)
        canvas.fill(Box(left, box.bottom - height, end, box.bottom), colour)
        if people + walls:
            top = box.bottom - max(height * (people + walls) / total, sliver)
            canvas.fill(Box(left, top, end, box.bottom), red)
            if walls:
                floor = box.bottom - (max(height * people / total, sliver) if people else 0.0)
                _stripe(canvas, Box(left, top, end, floor))
        if total > most:
            notch = box.top + 2 * sliver
            canvas.fill(Box(left, notch, end, notch + sliver), canvas.theme.ground)
    dot(canvas, axis.at(histogram.mean), box.bottom, canvas.theme.ink, 3.2)


def _stripe(canvas: Canvas, box: Box) -> None:
    """Let the ground shine through a box in level stripes, from the second one on."""
    pitch = max(2, round(3 * canvas.unit))
    for top in range(round(box.bottom) - pitch, round(box.top) - 1, -pitch):
        if top >= round(box.top):
            canvas.fill(Box(box.left, top, box.right, top + pitch // 2), canvas.theme.ground)


def band(
    canvas: Canvas, panel: Box, x: FloatArray, low: FloatArray, high: FloatArray, colour: Colour
) -> None:
    """Fill, translucently, between two lines at the pixels x."""
    part = canvas.clipped(panel)
    filled = part.copy()
    there, back = np.stack([x, low], axis=-1), np.stack([x, high], axis=-1)[::-1]
    filled.polygon(np.concatenate([there, back]), colour)
    cv2.addWeighted(filled.pixels, _BAND, part.pixels, 1.0 - _BAND, 0.0, dst=part.pixels)


def dashed_path(
    canvas: Canvas,
    points: FloatArray,
    colour: Colour,
    width: float,
    dashes: Sequence[float] | None = None,
) -> None:
    """Draw a curve [N, 2] in dashes: lengths of dashes and gaps in turn, px, over and over.

    Left out, dashes are as long as the gaps between them.
    """
    lengths = [6 * canvas.unit] * 2 if dashes is None else list(dashes)
    along = np.append(0.0, np.hypot(*np.diff(points, axis=0).T).cumsum())
    start, place = 0.0, 0
    while start < along[-1]:
        end = start + max(lengths[place % len(lengths)], 0.5)
        if place % 2 == 0:
            steps = np.linspace(start, min(end, along[-1]), 7)
            piece = [np.interp(steps, along, points[:, axis]) for axis in (0, 1)]
            canvas.line(np.stack(piece, axis=-1), colour, width)
        start, place = end, place + 1
