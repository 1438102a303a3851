"""Which regrets the curves of a study reach: the one treatment of a regret of 0."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from learners import Curve


@dataclass(frozen=True)
class RegretRange:
    """Which regrets some curves reach, in %.

    Axes of regret are logarithmic and have no place for 0. An axis therefore begins below the
    least regret that is above 0, of a mean or a seed, and what is 0 or less lies beyond its lower
    end; how far, and with what margins, each medium decides. A single lucky seed does not stretch
    an axis: seeds below a quarter of the least mean lie below the axis.
    """

    least: float  # the smallest above 0 that axes show; infinite if there is none
    most: float  # the largest mean, seed or upper end of an interval; 0 without curves
    has_zero: bool  # whether a mean, or the regret of a seed, is 0
    has_less: bool  # whether the regret of a seed is above 0 but below the smallest regret above

    @classmethod
    def around(cls, curves: Sequence[Curve]) -> "RegretRange":
        """The range of these curves of regret."""
        means = np.concatenate([np.zeros(0), *(curve.mean for curve in curves)])
        highs = np.concatenate([means, *(curve.high for curve in curves)])
        seeds = np.concatenate([means, *(samples for curve in curves for samples in curve.samples)])
        lowest = float(means[means > 0.0].min(initial=np.inf)) / 4.0
        least = max(float(seeds[seeds > 0.0].min(initial=np.inf)), lowest)
        most = max(float(highs.max(initial=0.0)), float(seeds.max(initial=0.0)))
        has_less = bool(((seeds > 0.0) & (seeds < least)).any())
        return cls(least, most, bool((seeds <= 0.0).any()), has_less)

    @property
    def start(self) -> float:
        """The smallest regret above 0 that is shown, or 0.1 % where there is none."""
        return self.least if np.isfinite(self.least) else 0.1
