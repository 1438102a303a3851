"""Axes that figures are drawn on: linear or logarithmic, on a page.

The page is 1 wide, its lower left corner is (0, 0), and all lengths are in this unit.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from studio.arrays import Bounds, FloatArray
from studio.recorder.drawing import Drawing
from studio.style.palette import LIGHT, Colour
from studio.style.ticks import round_numbers
from studio.style.words import number

LIFT = 0.03
"""How much higher than their places texts are put."""

KEY_STEP = 0.1
"""From row to row of a key."""

_KEY_INDENT = 0.14  # from the left of a key to its words
_HALF_A_LETTER = 0.012  # half the width that a letter usually takes
_ROOM_FOR_WORDS = 0.15  # words at ticks that are closer than this are left out


@dataclass(frozen=True)
class Scale:
    """Numbers along one side of a figure."""

    ticks: tuple[float, ...]  # ascending, from one end of the scale to the other
    words: tuple[str, ...]  # what is written at each tick; nothing where it is empty
    logarithmic: bool = False  # whether equal lengths are equal ratios

    def __call__(self, numbers: ArrayLike) -> FloatArray:
        """How far along the scale numbers lie, 0 to 1; those beyond its ends lie at the ends."""
        ends = np.array([self.ticks[0], self.ticks[-1]], dtype=np.float64)
        places = np.clip(np.asarray(numbers, dtype=np.float64), *ends)
        if self.logarithmic:
            ends, places = np.log10(ends), np.log10(places)
        along: FloatArray = (places - ends[0]) / (ends[1] - ends[0])
        return along


@dataclass(frozen=True)
class Axes:
    """What a figure is drawn on: a page with one scale across and one upwards."""

    x: Scale
    y: Scale
    height: float = 1.0

    def points(self, x: ArrayLike, y: ArrayLike) -> FloatArray:
        """Where numbers lie on the page, [N, 2]."""
        return np.stack([self.x(x), self.height * self.y(y)], axis=-1)

    def draw(self, drawing: Drawing) -> None:
        """Draw lines at all ticks and write the words."""
        for tick, words in zip(self.x.ticks, self.x.words, strict=True):
            across = float(self.x(tick))
            drawing.line([(across, 0.0), (across, self.height)], line_colour(tick), 1.0)
            if words:
                drawing.text((across, -0.08), words)
        for tick, words in zip(self.y.ticks, self.y.words, strict=True):
            up = self.height * float(self.y(tick))
            drawing.line([(0.0, up), (1.0, up)], line_colour(tick), 1.0)
            if words:
                drawing.text((-0.085, up), words)

    @property
    def bounds(self) -> Bounds:
        """What a view of the figure must show."""
        return -0.18, -0.14, 1.08, self.height + 0.06


def key_left(words: Iterable[str]) -> float:
    """Where a key with these words begins, so that it ends where the page does."""
    longest = max(map(len, words))
    return max(0.2, min(0.6, 1.0 - _KEY_INDENT - 2.0 * _HALF_A_LETTER * longest))


def draw_key(
    drawing: Drawing, entries: Iterable[tuple[str, Colour | None]], left: float, top: float
) -> None:
    """Say what the lines stand for; what has no colour is the truth, dark and dashed."""
    for row, (words, colour) in enumerate(entries):
        y = top - KEY_STEP * row
        ends = np.array([(left, y), (left + 0.08, y)])
        if colour is None:
            drawing.dashes(ends, LIGHT.ink, 2.5)
        else:
            drawing.line(ends, colour, 4.0)
        drawing.text((left + _KEY_INDENT + _HALF_A_LETTER * len(words), y), words)


def linear(ticks: Sequence[float]) -> Scale:
    """A linear scale with these ticks."""
    return Scale(tuple(ticks), tuple(number(tick) for tick in ticks))


def sizes_scale(sizes: Sequence[int]) -> Scale:
    """A logarithmic scale of sizes, with a tick at each and words where there is room."""
    if len(sizes) == 1:
        return Scale((sizes[0] / 2.0, sizes[0], sizes[0] * 2.0), ("", str(sizes[0]), ""), True)
    scale = Scale(tuple(sizes), (), True)
    words, last = [""] * len(sizes), np.inf
    for index in reversed(range(len(sizes))):
        place = float(scale(sizes[index]))
        if last - place >= _ROOM_FOR_WORDS:
            words[index], last = str(sizes[index]), place
    return Scale(scale.ticks, tuple(words), True)


def ratio_scale(
    low: float, high: float, digits: Sequence[float] = (1.0, 3.0), unit: str = ""
) -> Scale:
    """A logarithmic scale with at least two ticks at round numbers of these digits.

    It begins with the largest such number that is at most `low`, and ends with the smallest that is
    at least `high`.
    """
    numbers = round_numbers(low / 10.0, 100.0 * high, digits)
    first = max(place for place, number in enumerate(numbers) if number <= low)
    last = min(place for place, number in enumerate(numbers) if number >= high)
    ticks = tuple(numbers[first : max(last, first + 1) + 1])
    return Scale(ticks, tuple(f"{number(tick)}{unit}" for tick in ticks), True)


def line_colour(tick: float) -> Colour:
    """The colour of the line at a tick, of which the one at 0 stands out."""
    return LIGHT.faint if tick == 0.0 else LIGHT.grid
