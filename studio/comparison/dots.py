"""Where dots lie that stand for outcomes: icon arrays, and dot plots on a common axis.

What both sides of a comparison share, bins and the size of dots, is found from both, so equal
numbers look equal.

References: Garcia-Retamero and Galesic, "Communicating treatment risk reduction to people with low
numeracy skills", American Journal of Public Health 2009 (icon arrays with one denominator);
Fernandes et al., "Uncertainty displays using quantile dotplots or CDFs improve transit
decision-making", CHI 2018 (each dot stands for equally many outcomes).
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from scenes import Rollouts
from scenes.features import CLEARANCE_SCALE
from studio.arrays import FloatArray, IntArray
from studio.painter.quantile_dots import QuantileDots
from studio.scene.measures import contact_kinds
from studio.style.ticks import round_range

BINS = 18
"""How many bins a dot plot has."""

DOT_RADIUS = 0.42
"""Radius of a dot in pitches; a pitch is the distance from one dot to the next."""

_APART = 2  # bins at the left that set the lowest value apart: one of its own, and an empty one
_MOST_ROWS = 100  # of dots in an icon array; no more stand abreast in a bin
_LEAST_DEVIATION = 0.2  # right end of its axis at least, m: less is hardly seen


@dataclass(frozen=True)
class Dots:
    """N dots that stand for the K outcomes of one action, and gather as these come to their end."""

    values: FloatArray  # [N], where they lie
    kinds: IntArray  # [N], what the robot touched: see `studio.scene.measures.contact_kinds`
    arrivals: IntArray  # [N], how many outcomes have come to their end when the dot is there

    @classmethod
    def of(cls, values: FloatArray, kinds: IntArray) -> "Dots":
        """The dots for values [K] of these kinds [K], in their order: one each unless K is large.

        A dot that stands for several outcomes is there as soon as half of them are.
        """
        dots = QuantileDots.of(values, kinds)
        arrivals = []
        for kind in np.unique(dots.kinds):
            [places] = np.nonzero(kinds == kind)
            ranked = places[np.argsort(values[places], kind="stable")] + 1
            groups = np.array_split(ranked, (dots.kinds == kind).sum())
            arrivals += [np.sort(group)[(len(group) - 1) // 2] for group in groups]
        return cls(dots.values, dots.kinds, np.array(arrivals, np.int64))


@dataclass(frozen=True)
class DotMeasure:
    """What a dot plot shows of every outcome.

    If bins are set apart before those of the axis, the first of all is for nothing but the lowest
    value.
    """

    names: tuple[str, ...]  # what is measured, with its unit, the longest wording first
    dots: tuple[Dots, ...]  # of each action
    low: float  # left end of the axis, 0 unless there are values below
    high: float  # right end of the axis
    apart: int = 0  # how many bins come before those of the axis

    def bins(self, values: FloatArray) -> IntArray:
        """The bin that each value falls into."""
        shares = (values - self.low) / (self.high - self.low)
        along = BINS - self.apart
        # a value on the edge of two bins counts in the right one, whatever rounding does to it
        bins = self.apart + np.clip(np.floor(shares * along + 1e-9), 0, along - 1).astype(np.int64)
        return np.where(values <= self.low, 0, bins)

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
    """What to show of outcomes: progress, and if there are people how near and how much in the way.

    A gap of 0, when the robot touches somebody, is set apart from all other gaps, however small.
    """
    kinds = contact_kinds(rollouts)

    def measure(
        names: tuple[str, ...], values: FloatArray, ends: tuple[float, float], apart: int = 0
    ) -> DotMeasure:
        dots = (Dots.of(*own) for own in zip(values, kinds, strict=True))
        return DotMeasure(names, tuple(dots), *ends, apart)

    progress, gap, aside = rollouts.progress_m, rollouts.clearance_m, rollouts.deviation_m
    ends = round_range(min(0.0, float(progress.min())), float(progress.max()))
    names = ("progress towards the goal, m", "progress to the goal, m", "progress, m", "progress")
    shown = [measure(names, progress, ends)]
    if rollouts.scene.pedestrians:
        ends = round_range(0.0, max(float(gap.max()), 0.1))
        # gaps are clipped
        more = f" ({CLEARANCE_SCALE:g}: or more)" if ends[1] >= CLEARANCE_SCALE else ""
        names = (f"smallest gap to a person, m{more}", "gap to a person, m", "gap, m", "gap")
        shown.append(measure(names, gap, ends, _APART))
        ends = round_range(0.0, max(float(aside.max()), _LEAST_DEVIATION))
        names = ("people are pushed aside, m", "people aside, m", "aside, m", "aside")
        shown.append(measure(names, aside, ends))
    return tuple(shown)


@dataclass(frozen=True)
class IconGrid:
    """An array of icons in columns: contacts fill it up from the left, the rest from the right.

    So no icon ever turns into that of no contact, and in the end contacts and the rest meet.
    Lengths are in the unit of the room that the array was fitted to.
    """

    count: int  # of outcomes
    rows: int  # how many icons a column has
    pitch: float  # distance from one icon to the next

    @classmethod
    def fit(cls, width: float, height: float, count: int, largest_pitch: float) -> "IconGrid":
        """The array with the largest icons."""

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
        """Middle of every icon, [count, 2], from the top left corner, down."""
        column, row = np.divmod(np.arange(self.count), self.rows)
        middles: FloatArray = (np.stack([column, row], axis=-1) + 0.5) * self.pitch
        return middles


@dataclass(frozen=True)
class DotScale:
    """How the dots of a measure are stacked, under every action alike.

    Lengths are in the unit of the room that the scale was fitted to.
    """

    bins: tuple[IntArray, ...]  # the bin that each dot of each action falls into, [N] each
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
        bins = tuple(measure.bins(dots.values) for dots in measure.dots)
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

    def middles(self, side: int, dots: Dots) -> FloatArray:
        """Middles of the dots of an action once all are there, [N, 2].

        In a stack contacts lie lowest, and what arrives later lies higher.
        """
        middles: FloatArray = np.empty((len(dots.values), 2))
        order, landed = np.lexsort((dots.arrivals, dots.kinds)), [0] * BINS
        for place in order.tolist():
            index = int(self.bins[side][place])
            middles[place] = self.middle(index, landed[index])
            landed[index] += 1
        return middles
