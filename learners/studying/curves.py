"""What the rows of a study say together: learning curves and comparisons, with intervals.

Intervals are 95 % percentile bootstrap intervals of a mean over seeds (Efron and Tibshirani, "An
Introduction to the Bootstrap", 1993, section 13.3), from a fixed seed. Every seed has a split,
pairs and answers of its own, though all from one bank: intervals speak of these scenes.
"""

from dataclasses import dataclass
from itertools import product
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from learners.arrays import FloatArray
from learners.errors import InputError
from learners.seeds import Stream, generator

RESAMPLES = 10_000

COVERAGE = 0.95


@dataclass(frozen=True)
class Spread:
    """What the seeds say of one column at one number of pairs.

    Attributes:
        runs: how many seeds there are.
        mean: mean over seeds; an array [D] for a column of lists, and so are the others.
        std: standard deviation over seeds; 0 for a single seed.
        low: lower end of the 95 % interval of the mean.
        high: upper end.
    """

    runs: int
    mean: Any
    std: Any
    low: Any
    high: Any


@dataclass(frozen=True)
class Curve:
    """How one column of the table changes with the number of pairs n.

    Attributes:
        teacher: who was learned from.
        learner: who learned.
        column: name of the column.
        pairs: [n], ascending.
        runs: [n], how many seeds there are.
        mean: [n], or [n, D] for a column of lists, mean over seeds.
        std: the same shape, standard deviation over seeds; 0 for a single seed.
        low: the same shape, lower end of the 95 % interval of the mean.
        high: the same shape, upper end.
    """

    teacher: str
    learner: str
    column: str
    pairs: NDArray[np.int64]
    runs: NDArray[np.int64]
    mean: FloatArray
    std: FloatArray
    low: FloatArray
    high: FloatArray

    def at(self, pairs: int) -> Spread | None:
        """What the curve says at this number of pairs; None if nobody learned from so many."""
        for place in np.flatnonzero(self.pairs == pairs):
            sides = (each[place] for each in (self.mean, self.std, self.low, self.high))
            return Spread(int(self.runs[place]), *sides)
        return None


@dataclass(frozen=True)
class PairedDifference:
    """How much lower or higher one learner's column is than another's, seed by seed.

    Attributes:
        teacher: who was learned from.
        learner: who is compared.
        baseline: with whom.
        column: name of the column.
        pairs: [n], ascending.
        runs: [n], how many seeds both have.
        difference: [n], mean over seeds of learner − baseline.
        low: [n], lower end of the 95 % interval of that mean.
        high: [n], upper end.
        ratio: [n], mean of the learner over mean of the baseline; not a number over 0.
    """

    teacher: str
    learner: str
    baseline: str
    column: str
    pairs: NDArray[np.int64]
    runs: NDArray[np.int64]
    difference: FloatArray
    low: FloatArray
    high: FloatArray
    ratio: FloatArray


def learning_curves(table: pa.Table, column: str = "regret_percent") -> list[Curve]:
    """One curve a teacher and learner, in the order in which they appear in the table.

    Pairs of teacher and learner that have nothing in the column (α of expected utility) are left
    out.

    Args:
        table: rows of a study.
        column: what to follow; numbers, or lists of numbers of one length such as `theta_unit`.

    Raises:
        InputError: if there is no such column, or it cannot be averaged.
    """
    found = _by_task(table, column)
    curves = []
    for teacher, learner in product(_names(table, "teacher"), _names(table, "learner")):
        runs = {
            pairs: np.array(list(by_seed.values()))
            for (who, whose, pairs), by_seed in sorted(found.items())
            if (who, whose) == (teacher, learner)
        }
        if not runs:
            continue
        intervals = [mean_interval(samples) for samples in runs.values()]
        curves.append(
            Curve(
                teacher,
                learner,
                column,
                pairs=np.array(list(runs)),
                runs=np.array([len(samples) for samples in runs.values()]),
                mean=np.array([samples.mean(axis=0) for samples in runs.values()]),
                std=np.array(
                    [
                        samples.std(axis=0, ddof=1) if len(samples) > 1 else 0.0 * samples[0]
                        for samples in runs.values()
                    ]
                ),
                low=np.array([low for low, _ in intervals]),
                high=np.array([high for _, high in intervals]),
            )
        )
    return curves


def paired_differences(
    table: pa.Table, learner: str = "cpt", baseline: str = "eu", column: str = "regret_percent"
) -> list[PairedDifference]:
    """Compare two learners, paired by seed: both were asked the same questions.

    Args:
        table: rows of a study.
        learner: who is compared.
        baseline: with whom.
        column: what to compare; numbers.

    Returns:
        One comparison a teacher, of the sizes and seeds that both learners have.

    Raises:
        InputError: if there is no such column or learner, or the column cannot be averaged.
    """
    found = _by_task(table, column)
    for name in (learner, baseline):
        if name not in _names(table, "learner"):
            allowed = ", ".join(_names(table, "learner"))
            raise InputError(f"learner {name!r} is not allowed: {allowed}")
    comparisons = []
    for teacher in _names(table, "teacher"):
        runs = {}
        for pairs in sorted({pairs for who, _, pairs in found if who == teacher}):
            ours = found.get((teacher, learner, pairs), {})
            theirs = found.get((teacher, baseline, pairs), {})
            both = sorted(ours.keys() & theirs.keys())
            if both:
                runs[pairs] = np.array([(ours[seed], theirs[seed]) for seed in both])
        if not runs:
            continue
        differences = [samples[:, 0] - samples[:, 1] for samples in runs.values()]
        intervals = [mean_interval(samples) for samples in differences]
        means = np.array([samples.mean(axis=0) for samples in runs.values()])
        with np.errstate(divide="ignore", invalid="ignore"):
            ratio = np.where(means[:, 1] != 0.0, means[:, 0] / means[:, 1], np.nan)
        comparisons.append(
            PairedDifference(
                teacher,
                learner,
                baseline,
                column,
                pairs=np.array(list(runs)),
                runs=np.array([len(samples) for samples in differences]),
                difference=np.array([samples.mean() for samples in differences]),
                low=np.array([low for low, _ in intervals]),
                high=np.array([high for _, high in intervals]),
                ratio=ratio,
            )
        )
    return comparisons


def mean_interval(samples: FloatArray, seed: int = 0) -> tuple[FloatArray, FloatArray]:
    """95 % bootstrap interval of the mean of samples [n, ...], its two ends [...].

    A single sample is its own interval: it says nothing of its spread.
    """
    draws = generator(seed, Stream.BOOTSTRAP).integers(len(samples), size=(RESAMPLES, len(samples)))
    means = samples[draws].mean(axis=1)
    low, high = np.quantile(means, [(1.0 - COVERAGE) / 2.0, (1.0 + COVERAGE) / 2.0], axis=0)
    return low, high


def _by_task(table: pa.Table, column: str) -> dict[tuple[str, str, int], dict[int, Any]]:
    """The column's value of each seed, by teacher, learner and number of pairs."""
    names = ("teacher", "learner", "pairs", "seed", column)
    for name in names:
        if name not in table.column_names:
            raise InputError(f"column {name!r} is not allowed: {', '.join(table.column_names)}")
    kind = table.schema.field(column).type
    of = kind.value_type if pa.types.is_list(kind) else kind
    if not (pa.types.is_floating(of) or pa.types.is_integer(of) or pa.types.is_boolean(of)):
        raise InputError(f"column {column!r} of {kind} is not allowed: a column of numbers")
    found: dict[tuple[str, str, int], dict[int, Any]] = {}
    for teacher, learner, pairs, seed, number in zip(
        *(table[name].to_pylist() for name in names), strict=True
    ):
        if number is not None:
            found.setdefault((teacher, learner, pairs), {})[seed] = number
    return found


def _names(table: pa.Table, column: str) -> list[str]:
    return list(dict.fromkeys(table[column].to_pylist()))
