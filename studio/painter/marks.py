"""Marks in plots: dots, icons, histograms, bands and dashed curves."""

import math

import cv2
import numpy as np

from studio.arrays import BoolArray, FloatArray
from studio.painter.axes import Axis
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.style.palette import Colour

_ICON_ROWS = 5  # icons that stand one below the other in an icon array
_BAND = 0.22  # how opaque a band is


def dot(canvas: Canvas, x: float, y: float, colour: Colour, radius: float) -> None:
    """Draw a disc that a rim keeps apart from what is below; its radius grows with the page."""
    canvas.disc((x, y), (radius + 1.3) * canvas.unit, canvas.theme.ground)
    canvas.disc((x, y), radius * canvas.unit, colour)


def icon_pitch(box: Box, count: int) -> float:
    """Distance between the `count` icons of an array in a box, px; 0 if they would be too small."""
    pitch = min(box.width / math.ceil(count / _ICON_ROWS), box.height / _ICON_ROWS)
    return pitch if pitch >= 3.0 else 0.0


def draw_icons(canvas: Canvas, box: Box, touched: int, count: int, colour: Colour) -> Box:
    """Draw an icon array of `count` dots, the `touched` first ones red, for contact.

    Where dots would be too small to tell apart, a bar stands for them that fills with red.

    Returns:
        The box that it takes up, at the left of the given one.
    """
    pitch, middle = icon_pitch(box, count), box.centre[1]
    if not pitch:
        bar = Box(box.left, middle - 4 * canvas.unit, box.right, middle + 4 * canvas.unit)
        canvas.fill(bar, canvas.theme.grid)
        if touched:
            share = max(bar.width * touched / count, 1.0)
            canvas.fill(Box(bar.left, bar.top, bar.left + share, bar.bottom), canvas.theme.contact)
        return bar
    top = middle - _ICON_ROWS * pitch / 2
    for index in range(count):
        column, row = divmod(index, _ICON_ROWS)
        centre = (box.left + (column + 0.5) * pitch, top + (row + 0.5) * pitch)
        canvas.disc(centre, 0.38 * pitch, canvas.theme.contact if index < touched else colour)
    width, height = math.ceil(count / _ICON_ROWS) * pitch, _ICON_ROWS * pitch
    return Box(box.left, top, box.left + width, top + height)


def draw_histogram(
    canvas: Canvas,
    box: Box,
    axis: Axis,
    values: FloatArray,
    edges: FloatArray,
    colour: Colour,
    contact: BoolArray,
) -> None:
    """Draw a histogram of values [K], scaled to its own peak, as high as the box.

    What had contact [K] is red at the bottom, and a dot marks the mean. A bin that holds anything
    is at least a sliver high: what is rare matters. Values beyond the edges of the bins [B + 1]
    count in the first or last bin.
    """
    inside = np.clip(values, edges[0], edges[-1])
    counts, touched = (np.histogram(some, edges)[0] for some in (inside, inside[contact]))
    sliver, gap = max(2.0, 2 * canvas.unit), max(1.0, canvas.unit)
    pixels = np.rint(axis.along(edges))
    for left, right, count, red in zip(pixels, pixels[1:], counts, touched, strict=False):
        if not count:
            continue
        height = max(box.height * count / counts.max(), sliver)
        bar = Box(left, box.bottom - height, max(right - gap, left + 1), box.bottom)
        canvas.fill(bar, colour)
        if red:
            top = box.bottom - max(height * red / count, sliver)
            canvas.fill(Box(bar.left, top, bar.right, box.bottom), canvas.theme.contact)
    dot(canvas, axis.at(float(inside.mean())), box.bottom, canvas.theme.ink, 3.2)


def band(
    canvas: Canvas, panel: Box, x: FloatArray, low: FloatArray, high: FloatArray, colour: Colour
) -> None:
    """Fill, translucently, between two lines at the pixels x."""
    part = canvas.clipped(panel)
    filled = part.copy()
    there, back = np.stack([x, low], axis=-1), np.stack([x, high], axis=-1)[::-1]
    filled.polygon(np.concatenate([there, back]), colour)
    cv2.addWeighted(filled.pixels, _BAND, part.pixels, 1.0 - _BAND, 0.0, dst=part.pixels)


def dashed_path(canvas: Canvas, points: FloatArray, colour: Colour, width: float) -> None:
    """Draw a curve [N, 2] in dashes as long as the gaps between them."""
    dash = 6 * canvas.unit
    along = np.append(0.0, np.hypot(*np.diff(points, axis=0).T).cumsum())
    for start in np.arange(0.0, along[-1], 2 * dash):
        steps = np.linspace(start, min(start + dash, along[-1]), 7)
        piece = [np.interp(steps, along, points[:, axis]) for axis in (0, 1)]
        canvas.line(np.stack(piece, axis=-1), colour, width)
