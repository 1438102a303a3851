"""Axes of plots: where values lie, the panel with its grid, and what is written around it.

The panel of a plot is the box within which its marks lie, px.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from studio.arrays import FloatArray
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.lettering import SEMIBOLD
from studio.style.words import number


@dataclass(frozen=True)
class Axis:
    """A linear axis from the value `low` at `start` to the value `high` at `end`, in pixels."""

    low: float
    high: float
    start: float
    end: float

    def at(self, value: float) -> float:
        """Where a value lies, px; values off the axis lie at its end."""
        return float(self.along(value))

    def along(self, values: ArrayLike) -> FloatArray:
        """Where values lie, px; values off the axis lie at its end."""
        away = np.asarray(values, dtype=np.float64) - self.low
        shares = np.clip(away / (self.high - self.low), 0.0, 1.0)
        pixels: FloatArray = self.start + shares * (self.end - self.start)
        return pixels


@dataclass(frozen=True)
class LogAxis(Axis):
    """A logarithmic axis of values above 0 that also has a place for 0."""

    zero: float  # where 0 lies, px; the same as `start` if the axis shows no 0

    def along(self, values: ArrayLike) -> FloatArray:
        """Where values lie, px; those off the axis lie at its end, and 0 and less at 0."""
        given = np.asarray(values, dtype=np.float64)
        away = np.log(np.clip(given, self.low, self.high) / self.low)
        shares = away / math.log(self.high / self.low)
        pixels = self.start + shares * (self.end - self.start)
        placed: FloatArray = np.where(given > 0.0, pixels, self.zero)
        return placed


def caption(canvas: Canvas, box: Box, wordings: str | Sequence[str]) -> Box:
    """Write the name of a plot along the top of its box, and return what is left of the box."""
    size = canvas.type.small
    at = (box.left, box.top)
    canvas.fit(at, wordings, box.width, size, canvas.theme.ink, SEMIBOLD, line="top")
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


def axis_with_ticks(canvas: Canvas, axis: Axis, top: float, values: Sequence[float]) -> None:
    """Draw a horizontal axis at a height (px) with a tick mark at each value, and the values."""
    reach, hair, faint = 4 * canvas.unit, canvas.hair, canvas.theme.faint
    canvas.fill(Box(axis.start, top, axis.end, top + hair), faint)
    for value in values:
        x = min(round(axis.at(value)), round(axis.end) - hair)
        canvas.fill(Box(x, top, x + hair, top + max(reach, 2.0)), faint)
    draw_ticks(canvas, axis, top + reach + 2 * canvas.unit, values)


def draw_ticks(canvas: Canvas, axis: Axis, top: float, values: Sequence[float]) -> None:
    """Write the values under a horizontal axis, leaving out those that would touch.

    The outermost labels are pushed inwards to stay between the ends of the axis.
    """
    size, gap, faint = canvas.type.small, 5 * canvas.unit, canvas.theme.faint
    right_of_last = -math.inf
    for value in values:
        text = number(value)
        half = canvas.measure(text, size) / 2
        centre = min(max(axis.at(value), axis.start + half), axis.end - half)
        if centre - half >= right_of_last + gap:
            box = canvas.text((centre, top), text, size, faint, anchor="centre", line="top")
            right_of_last = box.right


def labels_below(
    canvas: Canvas, panel: Box, at: Callable[[float], float], values: Sequence[float], more: str
) -> Box | None:
    """Write ascending values under a plot, the ends first, then what there is room for.

    A value lies at `at(value)`, px. In the middle, if there is room, `more` says what values are.

    Returns:
        The box of the rightmost label.
    """
    size, gap, top = canvas.type.small, 6 * canvas.unit, panel.bottom + 0.2 * canvas.type.small
    texts = [(at(value), number(value)) for value in (*values[-1:], *values[:-1])]
    if more:
        texts.insert(2, (panel.centre[0], more))
    taken: list[Box] = []
    for x, text in texts:
        half = canvas.measure(text, size) / 2
        centre = min(max(x, panel.left + half), panel.right - half)
        box = canvas.text_box((centre, top), text, size, anchor="centre", line="top")
        # a hair of rounding is not an overflow
        fits = panel.left - 1 <= box.left and box.right <= panel.right + 1
        around = Box(box.left - gap, box.top, box.right + gap, box.bottom)
        if fits and not any(around.overlaps(other) for other in taken):
            canvas.text((centre, top), text, size, canvas.theme.faint, anchor="centre", line="top")
            taken.append(box)
    return max(taken, key=lambda box: box.right, default=None)


def labels_beside(
    canvas: Canvas, panel: Box, at: Callable[[float], float], values: Sequence[float]
) -> None:
    """Write values at the left of a plot, the ends first, then what there is room for."""
    size = canvas.type.small
    right, taken = panel.left - 6 * canvas.unit, list[Box]()
    for value in [*values[:1], *values[-1:], *values[1:-1]]:
        # inside of the plot's height: what is above and below belongs to others
        place = right, min(max(at(value), panel.top + 0.5 * size), panel.bottom - 0.5 * size)
        box = canvas.text_box(place, number(value), size, anchor="right")
        if not any(box.overlaps(other) for other in taken):
            canvas.text(place, number(value), size, canvas.theme.faint, anchor="right")
            taken.append(box)
