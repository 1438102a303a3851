"""How sure numbers are that come from rollouts, which are a sample of what may happen.

A bootstrap from fifty rollouts would not do for values that weigh rare outcomes heavily: what has
happened in none of them it cannot draw. Over forty scenes, its 95 % intervals held what another
fifty rollouts said in 73 % of cases for the teacher Strong. Draws from a thousand rollouts of the
same scene did in 94 %. `studio.scene.reference` simulates those.
"""

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from studio.arrays import FloatArray, IntArray

COVERAGE = 0.95
"""Share of intervals that hold the true value, and how sure a pick must be to be called one."""

RESAMPLES = 1000
"""How often rollouts are drawn anew; a share of draws of 95 % is then known to ± 0.7 points."""

_NORMAL_QUANTILE = 1.959964  # 97.5 % of the standard normal distribution lie below


@dataclass(frozen=True)
class Estimate:
    """A number that comes from a sample, with its 95 % interval, in the number's own unit."""

    value: float
    low: float  # lower end of the interval
    high: float  # upper end of the interval


def wilson(happened: int, count: int) -> Estimate:
    """How often something happens that happened in some of `count` rollouts, as a share.

    The interval is Wilson's score interval ("Probable Inference, the Law of Succession, and
    Statistical Inference", J. American Statistical Association 22, 1927), which is never empty:
    nothing in 50 rollouts may still happen once in 14.
    """
    share, square = happened / count, _NORMAL_QUANTILE**2
    middle = (share + square / (2 * count)) / (1 + square / count)
    spread = math.sqrt(share * (1 - share) / count + square / (4 * count**2))
    reach = _NORMAL_QUANTILE * spread / (1 + square / count)
    # the ends of the interval are those of the range where nothing, or everything, happened
    return Estimate(
        share,
        max(middle - reach, 0.0) if happened else 0.0,
        min(middle + reach, 1.0) if happened < count else 1.0,
    )


def interval(samples: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The two ends between which 95 % of samples [R, ...] lie, each [...]."""
    low, high = np.quantile(samples, [(1.0 - COVERAGE) / 2.0, (1.0 + COVERAGE) / 2.0], axis=0)
    return low, high


@lru_cache(maxsize=2)
def resampled_counts(size: int, pool: int) -> IntArray:
    """How often each of `pool` rollouts is there when `size` of them are drawn, [R, pool].

    All actions of a scene share the noise of a rollout, so one draw of rollouts is for all of them.
    The draws depend on nothing but the two numbers.
    """
    generator = np.random.Generator(np.random.Philox(np.random.SeedSequence([size, pool])))
    counts = generator.multinomial(size, np.full(pool, 1.0 / pool), size=RESAMPLES)
    counts.setflags(write=False)
    return counts
