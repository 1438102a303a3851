"""The page of a figure for a paper: its settings, its type, and where things lie on it.

Lengths are in points (pt, 1/72 in), from the lower left corner of the page.
"""

import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, ClassVar

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure
from matplotlib.font_manager import FontProperties
from matplotlib.textpath import text_to_path
from matplotlib.transforms import Affine2D, Transform
from numpy.typing import ArrayLike

from studio.arrays import FloatArray
from studio.study.results import StudyResults
from studio.style.palette import LIGHT, Colour
from studio.style.ticks import decades
from studio.style.words import learner_name, number

TYPE = 7.0  # size of the type of titles and of what stands along the axes, pt
SMALL_TYPE = 6.5  # size of the type of numbers and names, pt
POINT = 72.0  # in an inch
EDGE = 1.0  # of the page, pt
PAD = 3.0  # between what belongs together, pt
SAMPLE = 15.0  # length of a piece of a line beside its name, pt
STEP = 1.3 * SMALL_TYPE  # from a name to the next one below it, pt

_WIDTH = 89.0  # of the figure, mm: one column of a page of two
_INCH = 25.4  # mm
_HEIGHTS = {1: 142.0, 2: 96.0, 3: 74.0, 4: 68.0}  # of a panel by how many there are, pt
_LEAST_HEIGHT = 60.0  # where there are more, pt
_TITLE = 13.0  # above a panel, pt
_GAP = 5.0  # between a panel and the next title, pt
_LONGEST_NAME = 0.38  # of the width of the page
_FONT = "DejaVu Sans"  # comes with matplotlib, so that it is the same everywhere


@contextmanager
def settings() -> Iterator[None]:
    """Have matplotlib as it comes, apart from our settings; a user's own are back afterwards."""
    with mpl.rc_context(), warnings.catch_warnings():
        # letters that the font lacks are shown as boxes
        warnings.filterwarnings("ignore", message="Glyph", category=UserWarning)
        mpl.rcdefaults()
        mpl.rcParams.update(
            {
                "font.family": _FONT,
                "font.size": SMALL_TYPE,
                "text.parse_math": False,  # a dollar sign in a name is one
                "pdf.fonttype": 42,
                "svg.fonttype": "path",
                "svg.hashsalt": "prospect-studio",
            }
        )
        yield


@dataclass(frozen=True)
class RegretAxis:
    """The axis of regret, in %: logarithmic, with a place for 0 below if some mean is 0."""

    low: float  # the smallest value above 0 that it shows
    high: float  # the largest value that it shows
    zero: float  # where 0 lies on the axis; the same as `low` if it shows no 0

    @classmethod
    def around(cls, results: StudyResults) -> "RegretAxis":
        """The axis that holds all curves, and their bands where these keep away from 0."""
        regrets = results.regrets
        lows = np.array([low for curve in results.curves("regret_percent") for low in curve.low])
        low = max(lows[lows > 0.0].min(initial=regrets.start), regrets.start / 3.0) / 1.2
        high = 1.2 * max(regrets.most, 10.0 * low)
        zero = low * (low / high) ** 0.12 if regrets.has_zero else low
        return cls(low, high, zero)

    @property
    def ends(self) -> tuple[float, float]:
        """From where to where the axis reaches."""
        has_zero = self.zero < self.low
        below = self.zero * (self.low / self.high) ** 0.05 if has_zero else self.low
        return below, self.high

    def along(self, regrets: ArrayLike) -> FloatArray:
        """Where regrets lie on the axis."""
        given = np.asarray(regrets, dtype=np.float64)
        placed: FloatArray = np.where(given > 0.0, np.maximum(given, self.low), self.zero)
        return placed

    def share(self, regret: float) -> float:
        """How far up the axis a regret lies, 0 to 1."""
        low, high = self.ends
        return float(np.log(self.along(regret) / low) / np.log(high / low))

    def marks(self) -> list[float]:
        """What numbers stand beside the axis."""
        marks = decades(self.low, self.high)
        return [0.0, *marks] if self.zero < self.low else marks


@dataclass(frozen=True)
class PaperPage:
    """A page of panels, one above the other."""

    results: StudyResults  # what the panels show, one a teacher
    up: RegretAxis  # the axis of regret that panels share
    left: float  # where panels begin, pt
    across: float  # width of a panel, pt

    width: ClassVar[float] = _WIDTH / _INCH * POINT
    foot: ClassVar[float] = EDGE + 1.25 * TYPE + 0.5 * PAD + SMALL_TYPE + PAD

    @classmethod
    def of(cls, results: StudyResults) -> "PaperPage":
        """The page with room for all panels, and for the numbers and names beside them."""
        up = RegretAxis.around(results)
        numbers = [measure(number(mark), SMALL_TYPE) for mark in up.marks()]
        left = EDGE + 1.25 * TYPE + PAD + max(numbers, default=0.0) + PAD
        names = [measure(learner_name(name), SMALL_TYPE) for name in results.learners]
        named = min(max(names, default=0.0), _LONGEST_NAME * cls.width)
        right = PAD + SAMPLE + PAD + named + 2.0 * EDGE
        return cls(results, up, left, cls.width - left - right)

    @property
    def panels(self) -> int:
        """How many panels there are, 1 or more."""
        return max(len(self.results.teachers), 1)

    @property
    def panel(self) -> float:
        """Height of a panel, pt."""
        least = _HEIGHTS.get(self.panels, _LEAST_HEIGHT)
        return max(least, STEP * len(self.results.learners))

    @property
    def height(self) -> float:
        """Height of the page, pt."""
        return self.foot + self.panels * (self.panel + _TITLE + _GAP) - _GAP

    def bottom(self, index: int) -> float:
        """Where a panel's lower edge is, pt; the first panel is the uppermost."""
        return self.foot + (self.panels - 1 - index) * (self.panel + _TITLE + _GAP)

    def top(self, index: int) -> float:
        """Where a panel's upper edge is, pt."""
        return self.bottom(index) + self.panel


def with_room(places: Sequence[float], lengths: Sequence[float], gap: float) -> list[int]:
    """Which of several labels there is room for: the last, the first, then what fits between.

    Given are where the middles of labels lie along an axis, how long labels are along it, and the
    least gap between two; returned are indices, ascending.
    """
    kept: list[int] = []
    everything = range(len(places))
    for one in [*everything[-1:], *everything[:-1]]:
        if all(
            abs(places[one] - places[other]) >= (lengths[one] + lengths[other]) / 2.0 + gap
            for other in kept
        ):
            kept.append(one)
    return sorted(kept)


def write(figure: Figure, x: float, y: float, text: str, size: float, **how: Any) -> None:
    """Write text at a place on the page, pt; `how` are matplotlib's properties of text."""
    figure.text(x, y, text, transform=points(figure), fontsize=size, color=rgb(LIGHT.ink), **how)


def points(figure: Figure) -> Transform:
    """The way from pt on the page to what matplotlib draws on."""
    return Affine2D().scale(1.0 / POINT) + figure.dpi_scale_trans


def measure(text: str, size: float, weight: str = "normal") -> float:
    """Width of text, pt."""
    font = FontProperties(family=_FONT, weight=weight, size=size)
    return float(text_to_path.get_text_width_height_descent(text, font, ismath=False)[0])


def shortened(text: str, room: float, size: float, weight: str = "normal") -> str:
    """Text cut so far that it fits into a width, pt."""
    if measure(text, size, weight) <= room:
        return text
    while text and measure(f"{text}…", size, weight) > room:
        text = text[:-1]
    return f"{text.rstrip()}…"


def rgb(colour: Colour) -> tuple[float, float, float]:
    """A colour as matplotlib takes it."""
    red, green, blue = (channel / 255.0 for channel in colour)
    return red, green, blue
