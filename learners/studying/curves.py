"""What the rows of a study say together: learning curves and paired differences, with intervals.

Intervals are 95 % percentile bootstrap intervals of a mean over seeds (Efron and Tibshirani, "An
Introduction to the Bootstrap", 1993, section 13.3), from a fixed seed. Every seed has a split,
pairs and answers of its own, but all seeds share one bank: intervals speak of the bank's scenes.

One seed of five may carry a mean. Beside it therefore stand the median and the interquartile mean,
which is that of the middle half of the seeds and has an interval of its own (Agarwal et al., "Deep
Reinforcement Learning at the Edge of the Statistical Precipice", NeurIPS 2021). Their bootstrap is
stratified: it draws anew within every task. A curve here is of a single teacher and learner, so
every point of it is one stratum.
"""

from collections.abc import Callable
from dataclasses import dataclass, fields, replace
from functools import lru_cache
from itertools import product
from typing import Any, TypeAlias

import numpy as np
import pyarrow as pa

from learners.arrays import BoolArray, FloatArray, IntArray
from learners.errors import InputError
from learners.names import check_name
from learners.seeds import Stream, generator
from learners.studying.table import TASK_COLUMNS

RESAMPLES = 10_000  # draws of a bootstrap
COVERAGE = 0.95  # share of intervals that hold the true mean

Entry: TypeAlias = Any
"""What a column holds for one fit: a number, or a list of D numbers; for averages an array [D]."""

_Entries: TypeAlias = dict[int, dict[int, Entry]]
"""The entries of one learner by number of pairs and seed."""


@dataclass(frozen=True)
class Spread:
    """What the seeds say of one column after one number of pairs."""

    runs: int  # how many seeds there are
    mean: Entry  # over seeds
    std: Entry  # standard deviation over seeds; 0 for a single seed
    low: Entry  # lower end of the 95 % interval of the mean
    high: Entry  # upper end of that interval
    median: Entry  # over seeds
    middle: Entry  # interquartile mean: of the middle half of the seeds
    middle_low: Entry  # lower end of the 95 % interval of the interquartile mean
    middle_high: Entry  # upper end of that interval
    samples: Entry  # one entry a seed, along the first axis

    def of(self, place: int) -> "Spread":
        """The same of one number of a column of lists."""
        entries = {each.name: getattr(self, each.name) for each in fields(self)}
        return Spread(
            **{
                name: entry if name == "runs" else entry[..., place]
                for name, entry in entries.items()
            }
        )


@dataclass(frozen=True)
class Difference:
    """How much lower or higher one learner's column is than another's after one number of pairs."""

    runs: int  # how many seeds both learners have
    difference: float  # mean over seeds of learner − baseline
    low: float  # lower end of the 95 % interval of that mean
    high: float  # upper end of that interval
    ratio: float  # mean of the learner over mean of the baseline; not a number over 0


@dataclass(frozen=True)
class Curve:
    """How one column of the table changes with the number of pairs: n `Spread`s in a row."""

    teacher: str
    learner: str
    column: str
    pairs: IntArray  # [n], ascending
    runs: IntArray  # [n]
    mean: FloatArray  # [n], or [n, D] for a column of lists; the shape of the seven below too
    std: FloatArray
    low: FloatArray
    high: FloatArray
    median: FloatArray
    middle: FloatArray
    middle_low: FloatArray
    middle_high: FloatArray
    samples: tuple[FloatArray, ...]  # n arrays, [runs] or [runs, D]: one entry a seed

    def at(self, pairs: int) -> Spread | None:
        """What the curve says after this number of pairs; None if it has no such point."""
        if pairs not in self.pairs:
            return None
        place = np.searchsorted(self.pairs, pairs)
        return Spread(
            runs=int(self.runs[place]),
            **{each.name: getattr(self, each.name)[place] for each in fields(Spread)[1:]},
        )

    def where(self, kept: BoolArray) -> "Curve":
        """The curve at some of its points alone, [n]."""
        places = np.flatnonzero(kept)
        points: dict[str, Any] = {
            name: getattr(self, name)[places]
            for name in ("pairs", *(each.name for each in fields(Spread)))
            if name != "samples"
        }
        return replace(self, **points, samples=tuple(self.samples[place] for place in places))

    def mapped(self, change: Callable[[Entry], Entry]) -> "Curve":
        """The curve of the column after a linear change without offset, such as one of unit."""
        numbers: dict[str, Any] = {
            each.name: change(getattr(self, each.name))
            for each in fields(Spread)
            if each.name not in ("runs", "samples")
        }
        return replace(self, **numbers, samples=tuple(map(change, self.samples)))


@dataclass(frozen=True)
class PairedDifference:
    """How two learners differ in one column, by the number of pairs: n `Difference`s in a row."""

    teacher: str
    learner: str
    baseline: str  # the learner that the first one is compared with
    column: str
    pairs: IntArray  # [n], ascending; all below are [n] too
    runs: IntArray
    difference: FloatArray
    low: FloatArray
    high: FloatArray
    ratio: FloatArray

    def at(self, pairs: int) -> Difference | None:
        """How they differ after this number of pairs; None if not both learned from that many."""
        if pairs not in self.pairs:
            return None
        place = np.searchsorted(self.pairs, pairs)
        sides = (float(side[place]) for side in (self.difference, self.low, self.high, self.ratio))
        return Difference(int(self.runs[place]), *sides)


def learning_curves(table: pa.Table, column: str = "regret_percent") -> list[Curve]:
    """One curve for each teacher and learner, in the order in which they appear in the table.

    The column is one of numbers, or of lists of numbers of one length such as `theta_unit`.
    Learners who have nothing in it, such as α in expected utility, have no curve.

    Raises:
        InputError: if there is no such column, or it cannot be averaged.
    """
    found = _by_learner(table, column)
    curves = []
    for teacher, learner in product(_names(table, "teacher"), _names(table, "learner")):
        by_pairs = found.get((teacher, learner), {})
        runs = {pairs: np.array(list(by_pairs[pairs].values())) for pairs in sorted(by_pairs)}
        if runs:
            curves.append(
                Curve(
                    teacher,
                    learner,
                    column,
                    samples=tuple(runs.values()),
                    **_averages(list(runs.values())),
                    **_intervals(runs),
                )
            )
    return curves


def paired_differences(
    table: pa.Table, learner: str = "cpt", baseline: str = "eu", column: str = "regret_percent"
) -> list[PairedDifference]:
    """Compare a learner with a baseline, paired by seed: both were asked the same questions.

    There is one difference for each teacher, of the numbers of pairs and the seeds that both
    learners have. The column is one of numbers.

    Raises:
        InputError: if there is no such column or learner, or the column cannot be averaged.
    """
    found = _by_learner(table, column)
    for name in (learner, baseline):
        check_name("learner", name, _names(table, "learner"))
    paired = []
    for teacher in _names(table, "teacher"):
        ours, theirs = (found.get((teacher, name), {}) for name in (learner, baseline))
        runs = {}
        for pairs in sorted(ours.keys() & theirs.keys()):
            both = sorted(ours[pairs].keys() & theirs[pairs].keys())
            if both:
                runs[pairs] = np.array([(ours[pairs][seed], theirs[pairs][seed]) for seed in both])
        if not runs:
            continue
        differences = {pairs: samples[:, 0] - samples[:, 1] for pairs, samples in runs.items()}
        means = np.array([samples.mean(axis=0) for samples in runs.values()])
        with np.errstate(divide="ignore", invalid="ignore"):
            ratio = np.where(means[:, 1] != 0.0, means[:, 0] / means[:, 1], np.nan)
        paired.append(
            PairedDifference(
                teacher,
                learner,
                baseline,
                column,
                difference=np.array([samples.mean() for samples in differences.values()]),
                ratio=ratio,
                **_intervals(differences),
            )
        )
    return paired


def mean_interval(samples: FloatArray) -> tuple[FloatArray, FloatArray]:
    """95 % bootstrap interval of the mean of samples [n, ...], its two ends [...].

    The interval of a single sample is that sample, which says nothing of its spread.
    """
    return _ends(np.einsum("rn,n...->r...", _shares(len(samples))[0], samples))


def middle_mean(samples: FloatArray) -> FloatArray:
    """Interquartile mean of samples [n, ...], [...]: a quarter is left out at either end.

    A quarter of n samples is rounded down, so that of fewer than four none is left out.
    """
    left_out = len(samples) // 4
    mean: FloatArray = np.sort(samples, axis=0)[left_out : len(samples) - left_out].mean(axis=0)
    return mean


def middle_interval(samples: FloatArray) -> tuple[FloatArray, FloatArray]:
    """95 % bootstrap interval of the interquartile mean of samples [n, ...], two ends [...]."""
    # of sorted samples, the middle ones of a draw are those of the middle places of its ranks
    ranked = np.sort(samples, axis=0)
    return _ends(np.einsum("rn,n...->r...", _shares(len(samples))[1], ranked))


@lru_cache(maxsize=4)  # a study has few numbers of seeds, and the shares of many take room
def _shares(count: int) -> tuple[FloatArray, FloatArray]:
    """How much each of n samples counts in draws of n of them, the same draws every time.

    Returns:
        [RESAMPLES, n] shares of a mean over the draw, and the same of its interquartile mean, for
        samples in ascending order.
    """
    drawn = np.sort(generator(0, Stream.BOOTSTRAP).integers(count, size=(RESAMPLES, count)), axis=1)
    left_out = count // 4
    shares = []
    for places in (drawn, drawn[:, left_out : count - left_out]):
        cells = (places + count * np.arange(RESAMPLES)[:, None]).ravel()
        counts = np.bincount(cells, minlength=RESAMPLES * count).reshape(RESAMPLES, count)
        shares.append(counts / places.shape[1])
    return shares[0], shares[1]


def _ends(draws: FloatArray) -> tuple[FloatArray, FloatArray]:
    low, high = np.quantile(draws, [(1.0 - COVERAGE) / 2.0, (1.0 + COVERAGE) / 2.0], axis=0)
    return low, high


def _averages(runs: list[FloatArray]) -> dict[str, Any]:
    """What stands in the middle of the samples of each number of pairs, and how they scatter."""
    middles = [middle_interval(samples) for samples in runs]
    return {
        "mean": np.array([samples.mean(axis=0) for samples in runs]),
        "std": np.array(
            [
                samples.std(axis=0, ddof=1) if len(samples) > 1 else 0.0 * samples[0]
                for samples in runs
            ]
        ),
        "median": np.array([np.median(samples, axis=0) for samples in runs]),
        "middle": np.array([middle_mean(samples) for samples in runs]),
        "middle_low": np.array([low for low, _ in middles]),
        "middle_high": np.array([high for _, high in middles]),
    }


def _intervals(runs: dict[int, FloatArray]) -> dict[str, Any]:
    """What curves and differences share, from the samples of the seeds by number of pairs."""
    intervals = [mean_interval(samples) for samples in runs.values()]
    return {
        "pairs": np.array(list(runs)),
        "runs": np.array([len(samples) for samples in runs.values()]),
        "low": np.array([low for low, _ in intervals]),
        "high": np.array([high for _, high in intervals]),
    }


def _by_learner(table: pa.Table, column: str) -> dict[tuple[str, str], _Entries]:
    """The column's entries by teacher and learner."""
    names = (*TASK_COLUMNS, column)
    for name in names:
        check_name("column", name, table.column_names)
    kind = table.schema.field(column).type
    of = kind.value_type if pa.types.is_list(kind) else kind
    if not (pa.types.is_floating(of) or pa.types.is_integer(of) or pa.types.is_boolean(of)):
        raise InputError(f"column {column!r} of {kind} is not allowed: a column of numbers")
    found: dict[tuple[str, str], _Entries] = {}
    rows = zip(*(table[name].to_pylist() for name in names), strict=True)
    for teacher, learner, pairs, seed, entry in rows:
        if entry is not None:
            found.setdefault((teacher, learner), {}).setdefault(pairs, {})[seed] = entry
    return found


def _names(table: pa.Table, column: str) -> list[str]:
    return list(dict.fromkeys(table[column].to_pylist()))
