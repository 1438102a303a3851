"""Plots that compare runs: frames with axes, bands, and names at the ends of lines."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import ArrayLike

from studio.arrays import FloatArray
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.lettering import SEMIBOLD
from studio.style.palette import Colour
from studio.style.words import number

_BAND = 0.22
"""How opaque a band is."""


@dataclass(frozen=True)
class LogAxis:
    """A logarithmic axis that also has a place for 0.

    Attributes:
        low: the smallest value above 0 that it shows.
        high: the largest one.
        start: where `low` lies, px.
        end: where `high` lies, px.
        zero: where 0 lies, px; the same as `start` if the axis shows no 0.
    """

    low: float
    high: float
    start: float
    end: float
    zero: float

    def along(self, values: ArrayLike) -> FloatArray:
        """Where values lie, px; those off the axis lie at its end, and 0 and less at 0."""
        given = np.asarray(values, dtype=np.float64)
        shares = np.log(np.clip(given, self.low, self.high) / self.low) / math.log(
            self.high / self.low
        )
        pixels = self.start + shares * (self.end - self.start)
        placed: FloatArray = np.where(given > 0.0, pixels, self.zero)
        return placed

    def at(self, value: float) -> float:
        """Where a value lies, px."""
        return float(self.along(value))


def caption(canvas: Canvas, box: Box, wordings: str | Sequence[str]) -> Box:
    """Write the name of a plot along the top of its box.

    Returns:
        What is left of the box.
    """
    size = canvas.type.small
    text = canvas.fitted(wordings, box.width, size, SEMIBOLD)
    canvas.text((box.left, box.top), text, size, canvas.theme.ink, SEMIBOLD, line="top")
    return Box(box.left, box.top + 1.45 * size, box.right, box.bottom)


def foot(canvas: Canvas) -> float:
    """Height of the line of labels under a plot, px."""
    return 1.4 * canvas.type.small


def gutter(canvas: Canvas, labels: Sequence[str]) -> float:
    """Width of the labels at the left of a plot, px."""
    widths = [canvas.measure(label, canvas.type.small) for label in labels]
    return max(widths, default=0.0) + 7 * canvas.unit


def ground(
    canvas: Canvas, panel: Box, across: Sequence[float] = (), up: Sequence[float] = ()
) -> None:
    """Fill a plot's panel and draw the grid through these pixels."""
    canvas.fill(panel, canvas.theme.panel)
    for x in across:
        left = min(round(x), round(panel.right) - canvas.hair)
        canvas.fill(Box(left, panel.top, left + canvas.hair, panel.bottom), canvas.theme.grid)
    for y in up:
        top = min(round(y), round(panel.bottom) - canvas.hair)
        canvas.fill(Box(panel.left, top, panel.right, top + canvas.hair), canvas.theme.grid)


def labels_below(
    canvas: Canvas, panel: Box, at: Callable[[float], float], values: Sequence[float], more: str
) -> Box | None:
    """Write values under a plot, the ends first, then what there is room for.

    Args:
        canvas: to draw on.
        panel: of the plot.
        at: where a value lies, px.
        values: to write, ascending.
        more: words that say what they are, in the middle if there is room.

    Returns:
        The box of the rightmost label.
    """
    size, gap = canvas.type.small, 6 * canvas.unit
    order = [*values[-1:], *values[:-1]]
    texts = [(at(value), number(value)) for value in order]
    if more:
        texts.insert(min(2, len(texts)), (panel.centre[0], more))
    taken: list[Box] = []
    top = panel.bottom + 0.2 * size
    for x, text in texts:
        half = canvas.measure(text, size) / 2
        centre = min(max(x, panel.left + half), panel.right - half)
        box = canvas.text_box((centre, top), text, size, anchor="centre", line="top")
        # a hair of rounding is not an overflow
        fits = panel.left - 1 <= box.left and box.right <= panel.right + 1
        if fits and not any(box.overlaps(other) for other in taken):
            canvas.text((centre, top), text, size, canvas.theme.faint, anchor="centre", line="top")
            taken.append(Box(box.left - gap, box.top, box.right + gap, box.bottom))
    rightmost = max(taken, key=lambda box: box.right, default=None)
    return rightmost and Box(
        rightmost.left + gap, rightmost.top, rightmost.right - gap, rightmost.bottom
    )


def labels_beside(
    canvas: Canvas, panel: Box, at: Callable[[float], float], values: Sequence[float]
) -> None:
    """Write values at the left of a plot, the ends first, then what there is room for."""
    size = canvas.type.small
    right, taken = panel.left - 6 * canvas.unit, list[Box]()
    for value in [*values[:1], *values[-1:], *values[1:-1]]:
        half = 0.5 * size
        # inside of the plot's height: what is above and below belongs to others
        middle = min(max(at(value), panel.top + half), panel.bottom - half)
        box = canvas.text_box((right, middle), number(value), size, anchor="right")
        if not any(box.overlaps(other) for other in taken):
            taken.append(
                canvas.text(
                    (right, middle), number(value), size, canvas.theme.faint, anchor="right"
                )
            )


def band(
    canvas: Canvas, panel: Box, x: FloatArray, low: FloatArray, high: FloatArray, colour: Colour
) -> None:
    """Fill, translucently, between two lines at the pixels x."""
    part = canvas.clipped(panel)
    filled = part.copy()
    there = np.stack([x, low], axis=-1)
    back = np.stack([x, high], axis=-1)[::-1]
    filled.polygon(np.concatenate([there, back]), colour)
    cv2.addWeighted(filled.pixels, _BAND, part.pixels, 1.0 - _BAND, 0.0, dst=part.pixels)


def dashed_path(canvas: Canvas, points: FloatArray, colour: Colour, width: float) -> None:
    """Draw a curve [N, 2] in dashes as long as the gaps between them."""
    dash = 6 * canvas.unit
    lengths = np.hypot(*np.diff(points, axis=0).T)
    along = np.concatenate([[0.0], lengths.cumsum()])
    for start in np.arange(0.0, along[-1], 2 * dash):
        steps = np.linspace(start, min(start + dash, along[-1]), 7)
        piece = [np.interp(steps, along, points[:, axis]) for axis in (0, 1)]
        canvas.line(np.stack(piece, axis=-1), colour, width)


def dot(canvas: Canvas, x: float, y: float, colour: Colour, radius: float = 4.0) -> None:
    """Draw a disc that a rim keeps apart from what is below; radius in units of the page."""
    canvas.disc((x, y), (radius + 1.3) * canvas.unit, canvas.theme.ground)
    canvas.disc((x, y), radius * canvas.unit, colour)


def end_labels(
    canvas: Canvas,
    left: float,
    column: Box,
    labels: Sequence[tuple[float, Sequence[str], Colour]],
) -> None:
    """Write names beside the ends of lines, moved apart where they would touch.

    Args:
        canvas: to draw on.
        left: where the names begin, px.
        column: how high, low and far to the right names may lie.
        labels: of each line the height of its end, px, wordings, and its colour.
    """
    size = canvas.type.small
    step = 1.12 * size
    shown = sorted(labels, key=lambda label: label[0])[: max(1, int(column.height / step))]
    heights = [y for y, _, _ in shown]
    centres = spread_apart(heights, step, column.top + step / 2, column.bottom - step / 2)
    for middle, (_, wordings, colour) in zip(centres, shown, strict=True):
        text = canvas.fitted(wordings, column.right - left, size, SEMIBOLD)
        canvas.text((left, middle), text, size, canvas.theme.legible(colour), SEMIBOLD)


def spread_apart(heights: Sequence[float], step: float, low: float, high: float) -> list[float]:
    """Heights moved so far apart that neighbours are a step away from one another.

    Args:
        heights: ascending, px.
        step: least distance, px; that many steps fit between `low` and `high`.
        low: least height allowed, px.
        high: largest height allowed, px.
    """
    spread = list(heights)
    last = len(spread) - 1
    for _ in range(30):
        for index in range(last):
            push = max(spread[index] + step - spread[index + 1], 0.0) / 2
            spread[index] -= push
            spread[index + 1] += push
    # what is left to do is exact, and keeps to the limits
    for index in range(last + 1):
        spread[index] = max(spread[index], spread[index - 1] + step if index else low)
    for index in range(last, -1, -1):
        spread[index] = min(spread[index], spread[index + 1] - step if index < last else high)
    return spread


def wrapped(canvas: Canvas, sentences: Sequence[str], width: float, size: int) -> list[str]:
    """Sentences one after another, broken into lines that are no wider than this, px."""
    lines: list[str] = []
    for word in " ".join(sentences).split(" "):
        longer = f"{lines[-1]} {word}" if lines else word
        if lines and canvas.measure(longer, size) <= width:
            lines[-1] = longer
        else:
            lines.append(word)
    return lines
