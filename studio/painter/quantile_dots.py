"""Quantile dot plots: some dots that stand for all values, stacked where values are alike.

A value's chance is seen by counting dots (Fernandes et al., "Uncertainty Displays Using Quantile
Dotplots or CDFs Improve Transit Decision-Making", CHI 2018).
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from studio.arrays import FloatArray, IntArray
from studio.painter.axes import Axis

MOST_DOTS = 50
"""How many dots stand for all values if there are more values than this."""


@dataclass(frozen=True)
class QuantileDots:
    """N dots of several kinds, of which each stands for equally many values."""

    values: FloatArray  # [N], ascending among those of a kind, where the dots lie
    kinds: IntArray  # [N], of each dot, ascending
    sources: IntArray  # [N], index of the one value that a dot stands for, -1 if it is for several

    @classmethod
    def of(cls, values: FloatArray, kinds: IntArray) -> "QuantileDots":
        """Dots for values [K] of kinds [K], which are numbered from 0: K, or `MOST_DOTS` if fewer.

        Each kind has its share of the dots, rounded, and its own quantiles.
        """
        order = np.lexsort((values, kinds))
        if len(values) <= MOST_DOTS:
            return cls(values[order], kinds[order], order)
        numbers = _shared_out(np.bincount(kinds), MOST_DOTS)
        own = [
            np.quantile(values[kinds == kind], (np.arange(number) + 0.5) / number)
            for kind, number in enumerate(numbers)
            if number
        ]
        labels = np.repeat(np.arange(len(numbers)), numbers)
        return cls(np.concatenate(own), labels, np.full(MOST_DOTS, -1))


def _shared_out(sizes: IntArray, count: int) -> list[int]:
    """Whole numbers in proportion to the sizes that add up to the count, by largest remainder."""
    exact = sizes * count / sizes.sum()
    whole = np.floor(exact + 1e-9).astype(np.int64)
    order = np.argsort(whole - exact, kind="stable")
    whole[order[: count - int(whole.sum())]] += 1
    shares: list[int] = whole.tolist()
    return shares


@dataclass(frozen=True)
class DotStacks:
    """How large dots are, and how they are stacked in several plots of one scale."""

    axis: Axis  # across
    pitch: float  # distance from one dot to the next beside it, px
    height: float  # of the room for stacks, px

    @classmethod
    def fit(
        cls, plots: Sequence[QuantileDots], axis: Axis, height: float, smallest: float
    ) -> "DotStacks":
        """The largest dots of which the highest stack is as high as the room, or the smallest."""
        pitch = height
        while pitch > smallest:
            stacks = cls(axis, pitch, height)
            highest = max(int(np.bincount(stacks.bins(dots)).max(initial=0)) for dots in plots)
            if highest * pitch <= height:
                return stacks
            pitch *= 0.95
        return cls(axis, smallest, height)

    def bins(self, dots: QuantileDots) -> IntArray:
        """Which stack each dot belongs to, [N], counted from the start of the axis."""
        along = (self.axis.along(dots.values) - self.axis.start) / self.pitch
        return np.floor(along).astype(np.int64)

    def middles(self, dots: QuantileDots) -> FloatArray:
        """Middles of the dots [N, 2], px to the right on the page and up from the floor of a plot.

        The first kind lies lowest. Stacks that are too high for the room are pressed together.
        """
        bins = self.bins(dots)
        number = np.zeros(len(bins), dtype=np.int64)
        for one in np.unique(bins):
            inside = bins == one
            number[inside] = np.arange(inside.sum())
        high = np.bincount(bins)[bins]
        step = np.minimum(self.pitch, (self.height - self.pitch) / np.maximum(high - 1, 1))
        x = self.axis.start + (bins + 0.5) * self.pitch
        middles: FloatArray = np.stack([x, 0.5 * self.pitch + number * step], axis=-1)
        return middles
