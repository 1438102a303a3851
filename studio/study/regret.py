"""Which regrets the curves of a study reach: the one treatment of a regret of 0."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from learners import Curve


@dataclass(frozen=True)
class RegretRange:
    """Which regrets some curves reach, in %.

    Axes of regret are logarithmic and have no place for 0. An axis therefore begins below the
    least mean that is above 0, and what is 0 or less lies beyond its lower end; how far, and with
    what margins, each medium decides.
    """

    least: float  # the smallest mean above 0; infinite if there is none
    most: float  # the largest mean or upper end of an interval; 0 without curves
    has_zero: bool  # whether a mean is 0

    @classmethod
    def around(cls, curves: Sequence[Curve]) -> "RegretRange":
        """The range of these curves of regret."""
        means = np.concatenate([np.zeros(0), *(curve.mean for curve in curves)])
        highs = np.concatenate([means, *(curve.high for curve in curves)])
        least = float(means[means > 0.0].min(initial=np.inf))
        return cls(least, float(highs.max(initial=0.0)), bool((means <= 0.0).any()))

    @property
    def start(self) -> float:
        """The smallest mean above 0, or 0.1 % where there is none."""
        return self.least if np.isfinite(self.least) else 0.1
