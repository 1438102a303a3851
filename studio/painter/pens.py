"""Curves in the pen of whoever they belong to: colour, dashes and a marker."""

import math

import numpy as np

from studio.arrays import FloatArray
from studio.painter.boxes import Point
from studio.painter.canvas import Canvas
from studio.style.palette import Marker, Pen

# corners of a marker, the direction of the first in degrees, and how much larger than a disc it is
_CORNERS: dict[Marker, tuple[int, float, float]] = {
    "square": (4, 45.0, 1.25),
    "triangle": (3, -90.0, 1.4),
    "diamond": (4, 0.0, 1.3),
    "triangle_down": (3, 90.0, 1.4),
    "pentagon": (5, -90.0, 1.2),
}


def pen_path(canvas: Canvas, points: FloatArray, pen: Pen, width: float) -> None:
    """Draw a curve [N, 2] of this width (px) in the colour and the dashes of a pen."""
    if not pen.dashes or len(points) < 2:
        canvas.line(points, pen.colour, width)
        return
    along = np.append(0.0, np.hypot(*np.diff(points, axis=0).T).cumsum())
    start, strokes = 0.0, [width * length for length in pen.dashes]
    while start < along[-1]:
        for index, length in enumerate(strokes):
            end = min(start + length, along[-1])
            if index % 2 == 0 and end > start:
                inner = along[(along > start) & (along < end)]
                stops = np.concatenate([[start], inner, [end]])
                piece = [np.interp(stops, along, points[:, axis]) for axis in (0, 1)]
                canvas.line(np.stack(piece, axis=-1), pen.colour, width)
            start += length


def pen_marker(canvas: Canvas, at: Point, pen: Pen, radius: float) -> None:
    """Draw the marker of a pen (px), with a rim that keeps it apart from what is below."""
    rim, inside = canvas.theme.ground, pen.colour if pen.filled else canvas.theme.ground
    thick = max(1.0, 0.42 * radius)
    _shape(canvas, at, pen.marker, radius + 1.3 * canvas.unit, rim)
    _shape(canvas, at, pen.marker, radius, pen.colour)
    if not pen.filled:
        _shape(canvas, at, pen.marker, radius - thick, inside)


def _shape(
    canvas: Canvas, at: Point, marker: Marker, radius: float, colour: tuple[int, int, int]
) -> None:
    middle = np.array(at)
    if marker == "circle":
        canvas.disc(middle, radius, colour)
    elif marker == "plus":
        for reach in (np.array([1.25 * radius, 0.0]), np.array([0.0, 1.25 * radius])):
            canvas.line([middle - reach, middle + reach], colour, 0.8 * radius)
    else:
        count, turn, size = (10, -90.0, 1.45) if marker == "star" else _CORNERS[marker]
        reaches = np.full(count, size * radius)
        if marker == "star":
            reaches[1::2] *= 0.5
        angles = np.radians(turn) + math.tau / count * np.arange(count)
        around = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
        canvas.polygon(middle + reaches[:, None] * around, colour)
