"""Pens: lines with dashes, and markers, that say whose a curve is even without its colour."""

import numpy as np

from studio.arrays import FloatArray
from studio.painter.boxes import Point
from studio.painter.canvas import Canvas
from studio.painter.marks import dashed_path
from studio.style.palette import Colour, Marker, Pen

_CORNERS: dict[Marker, tuple[int, float, float]] = {
    "square": (4, 45.0, 1.25),
    "diamond": (4, 0.0, 1.25),
    "triangle": (3, -90.0, 1.4),
    "triangle_down": (3, 90.0, 1.4),
    "pentagon": (5, -90.0, 1.15),
}
"""Of markers with equal sides: how many, the direction of the first corner (degrees), its radius.

With these radii, all markers cover about as much as a circle of radius 1.
"""

_STAR_INSIDE = 0.45  # radius of the inner corners of a star, whose outer ones lie at 1.5
_PLUS_ARM = 0.42  # half the width of the arms of a plus, which reach to 1.25


def pen_line(canvas: Canvas, points: FloatArray, pen: Pen, width: float) -> None:
    """Draw a curve [N, 2], px, with a pen of a width, px."""
    if pen.dashes:
        dashes = [length * width for length in pen.dashes]
        dashed_path(canvas, points, pen.colour, width, dashes)
    else:
        canvas.line(points, pen.colour, width)


def pen_mark(canvas: Canvas, at: Point, pen: Pen, radius: float, ground: Colour) -> None:
    """Draw a pen's marker, with a rim in the colour of the ground around it.

    The radius is that of the circle that it covers as much as, px.
    """
    outline = max(1.0, 0.3 * radius)
    _fill_marker(canvas, at, pen.marker, radius + outline, ground)
    _fill_marker(canvas, at, pen.marker, radius, pen.colour)
    if not pen.filled:
        _fill_marker(canvas, at, pen.marker, max(radius - 1.4 * outline, 0.3 * radius), ground)


def _fill_marker(canvas: Canvas, at: Point, marker: Marker, radius: float, colour: Colour) -> None:
    if marker == "circle":
        canvas.disc(at, radius, colour)
        return
    corners = marker_corners(marker)
    middle = (corners.min(axis=0) + corners.max(axis=0)) / 2
    canvas.polygon(np.array(at) + radius * (corners - middle), colour)


def marker_corners(marker: Marker) -> FloatArray:
    """The corners of a marker that covers about as much as a circle of radius 1, [N, 2]."""
    if marker == "plus":
        quarter = np.array([(_PLUS_ARM, -1.25), (_PLUS_ARM, -_PLUS_ARM), (1.25, -_PLUS_ARM)])
        turns = [np.array([[0.0, 1.0], [-1.0, 0.0]])]
        corners = [quarter]
        for _ in range(3):
            corners.append(corners[-1] @ turns[0])
        return np.concatenate(corners)
    if marker == "star":
        angles = np.radians(-90.0 + 36.0 * np.arange(10))
        radii = np.where(np.arange(10) % 2 == 0, 1.5, 1.5 * _STAR_INSIDE)
        return np.stack([radii * np.cos(angles), radii * np.sin(angles)], axis=-1)
    count, first, radius = _CORNERS[marker]
    angles = np.radians(first + 360.0 / count * np.arange(count))
    return radius * np.stack([np.cos(angles), np.sin(angles)], axis=-1)
