"""Where dots lie that each stand for one outcome: icon arrays, and dot plots on a common axis.

What both sides of a comparison share, bins and the size of dots, is found from both, so equal
numbers look equal.

References: Garcia-Retamero and Galesic, "Communicating treatment risk reduction to people with low
numeracy skills", American Journal of Public Health 2009 (icon arrays with one denominator);
Fernandes et al., "Uncertainty displays using quantile dotplots or CDFs improve transit
decision-making", CHI 2018 (one dot an outcome).
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from scenes import Rollouts
from studio.arrays import FloatArray, IntArray
from studio.style.ticks import round_range

BINS = 24
"""How many bins a dot plot has."""

DOT_RADIUS = 0.42
"""Radius of a dot in pitches; a pitch is the distance from one dot to the next."""

_APART = 2  # bins at the left that set the lowest value apart: one of its own, and an empty one
_MOST_ROWS = 100  # of dots in an icon array; no more stand abreast in a bin


@dataclass(frozen=True)
class DotMeasure:
    """What a dot plot shows of every outcome.

    If bins are set apart before those of the axis, the first of all is for nothing but the lowest
    value.
    """

    names: tuple[str, ...]  # what is measured, with its unit, the longest wording first
    values: FloatArray  # [A, K]
    low: float  # left end of the axis, 0 unless there are values below
    high: float  # right end of the axis
    apart: int = 0  # how many bins come before those of the axis

    def bins(self) -> IntArray:
        """The bin that each outcome falls into, [A, K]."""
        shares = (self.values - self.low) / (self.high - self.low)
        along = BINS - self.apart
        # a value on the edge of two bins counts in the right one, whatever rounding does to it
        bins = self.apart + np.clip(np.floor(shares * along + 1e-9), 0, along - 1).astype(np.int64)
        return np.where(self.values <= self.low, 0, bins)

    def at(self, value: float) -> float:
        """Where a value lies on the axis, as a share of the width of the plot."""
        if self.apart and value <= self.low:
            return 0.5 / BINS
        share = (value - self.low) / (self.high - self.low)
        return (self.apart + share * (BINS - self.apart)) / BINS

    def lines(self) -> list[tuple[float, float]]:
        """Where the pieces of the axis begin and end, as shares of the width of the plot.

        It is broken where a bin is set apart.
        """
        own = [(0.0, 1.0 / BINS)] if self.apart else []
        return [*own, (self.apart / BINS, 1.0)]


def dot_measures(rollouts: Rollouts) -> tuple[DotMeasure, ...]:
    """What to show of outcomes: progress, and the gap to people if there are any.

    A gap of 0, when the robot touches somebody, is set apart from all other gaps, however small.
    """
    progress, gap = rollouts.progress_m, rollouts.clearance_m
    ends = round_range(min(0.0, float(progress.min())), float(progress.max()))
    shown = [
        DotMeasure(("progress towards the goal, m", "progress, m", "progress"), progress, *ends)
    ]
    if rollouts.scene.pedestrians:
        ends = round_range(0.0, max(float(gap.max()), 0.1))
        names = ("smallest gap to a person, m", "gap to a person, m", "gap")
        shown.append(DotMeasure(names, gap, *ends, _APART))
    return tuple(shown)


@dataclass(frozen=True)
class IconGrid:
    """An array of dots in columns: contacts fill it up from the left, the rest from the right.

    So no dot ever changes its colour once it has one, and in the end contacts and the rest meet.
    Lengths are in the unit of the room that the array was fitted to.
    """

    count: int  # of outcomes
    rows: int  # how many dots a column has
    pitch: float  # distance from one dot to the next

    @classmethod
    def fit(cls, width: float, height: float, count: int, largest_pitch: float) -> "IconGrid":
        """The array with the largest dots."""

        def pitch(rows: int) -> float:
            return min(width / math.ceil(count / rows), height / rows, largest_pitch)

        rows = max(range(1, min(count, _MOST_ROWS) + 1), key=pitch)
        return cls(count, rows, pitch(rows))

    @property
    def width(self) -> float:
        """Width of all columns together."""
        return math.ceil(self.count / self.rows) * self.pitch

    @property
    def height(self) -> float:
        """Height of a column."""
        return self.rows * self.pitch

    def places(self) -> FloatArray:
        """Middle of every dot, [count, 2], from the top left corner, down."""
        column, row = np.divmod(np.arange(self.count), self.rows)
        middles: FloatArray = (np.stack([column, row], axis=-1) + 0.5) * self.pitch
        return middles


@dataclass(frozen=True)
class DotScale:
    """How the dots of a measure are stacked, under every action alike.

    Lengths are in the unit of the room that the scale was fitted to.
    """

    bins: IntArray  # [A, K], the bin that each outcome falls into
    width: float  # of a bin
    abreast: int  # how many dots stand side by side in a bin
    pitch: float  # distance from one dot to the next

    @classmethod
    def fit_all(
        cls, shown: Sequence[DotMeasure], width: float, height: float, largest_pitch: float
    ) -> "list[DotScale]":
        """Scales of several measures with dots of one size, the largest that suits them all."""
        pitches = [cls.fit(measure, width, height, largest_pitch).pitch for measure in shown]
        return [cls.fit(measure, width, height, min(pitches)) for measure in shown]

    @classmethod
    def fit(
        cls, measure: DotMeasure, width: float, height: float, largest_pitch: float
    ) -> "DotScale":
        """The scale with the largest dots at which the tallest stack stays in the room."""
        bins = measure.bins()
        tallest = max(int(np.bincount(row).max()) for row in bins)

        def pitch(abreast: int) -> float:
            stacked = math.ceil(tallest / abreast)
            return min(width / BINS / abreast, height / stacked, largest_pitch)

        abreast = max(range(1, _MOST_ROWS + 1), key=pitch)
        return cls(bins, width / BINS, abreast, pitch(abreast))

    def middle(self, index: int, number: int) -> tuple[float, float]:
        """Middle of a dot, from the bottom left corner, up, given its bin and its number there."""
        row, column = divmod(number, self.abreast)
        across = (index + 0.5) * self.width + (column - (self.abreast - 1) / 2) * self.pitch
        return across, (row + 0.5) * self.pitch
