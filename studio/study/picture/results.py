"""The results of a study as its picture needs them: who, how many, and what they say in words."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
import pyarrow as pa

from learners import (
    FEATURES,
    CptParameters,
    Curve,
    PairedDifference,
    Teacher,
    learning_curves,
    paired_differences,
)
from studio.arrays import FloatArray
from studio.style.words import counted, learner_name, number, signed

MOST_TEACHERS = 4
"""More than that would be too small to read."""

PARAMETERS = {"alpha": "α", "eta": "η", "lambda": "λ", "gamma": "γ", "delta": "δ"}
"""Columns of the table that hold the parameters of prospect theory, and their letters."""

Row = dict[str, Any]


@dataclass(frozen=True)
class Results:
    """What a study found out up to some number of pairs, about the teachers there is room for.

    Who learned from whom, the curves and the comparisons are those of the whole study; `sizes`
    and `rows` go only as far as was learned.

    Attributes:
        table: one row a fit, of the whole study.
        teachers: who were learned from, as many as there is room for.
        left_out: how many more there are.
        reached: how many pairs were learned from.
        whole: the results of the whole study, if these are a part of it: what is worked out there
            is not worked out again.
    """

    table: pa.Table
    teachers: tuple[Teacher, ...]
    left_out: int
    reached: float = math.inf
    whole: "Results | None" = None

    @classmethod
    def of(cls, table: pa.Table, teachers: Sequence[Teacher]) -> "Results":
        """All results of fits to these teachers, of whom only the first few are shown."""
        shown = tuple(teachers)[:MOST_TEACHERS]
        names = {teacher.name for teacher in shown}
        kept = np.array([name in names for name in table["teacher"].to_pylist()], dtype=bool)
        return cls(table.filter(pa.array(kept)), shown, len(teachers) - len(shown))

    def up_to(self, pairs: float) -> "Results":
        """What was found out by the time of so many pairs."""
        return replace(self, reached=pairs, whole=self.whole or self)

    @cached_property
    def fits(self) -> list[Row]:
        """All fits of the study in plain types."""
        if self.whole is not None:
            return self.whole.fits
        found: list[Row] = self.table.to_pylist()
        return found

    @cached_property
    def regret(self) -> list[Curve]:
        """Regret, in % of a random action's."""
        if self.whole is not None:
            return self.whole.regret
        return _finite(learning_curves(self.table, "regret_percent")) if self.fits else []

    @cached_property
    def agreement(self) -> list[Curve]:
        """Share of scenes in which the teacher's best action is picked, 0 to 1."""
        if self.whole is not None:
            return self.whole.agreement
        return _finite(learning_curves(self.table, "agreement")) if self.fits else []

    @cached_property
    def comparisons(self) -> list[PairedDifference]:
        """Of two learners' regrets, one a teacher; none if there is only one learner."""
        if self.whole is not None:
            return self.whole.comparisons
        if self.compared is None:
            return []
        return paired_differences(self.table, *self.compared, "regret_percent")

    @cached_property
    def rows(self) -> list[Row]:
        """The fits so far."""
        return [row for row in self.fits if row["pairs"] <= self.reached]

    @cached_property
    def learners(self) -> list[str]:
        """Who learned, in the order of the table."""
        return list(dict.fromkeys(row["learner"] for row in self.fits))

    @cached_property
    def all_sizes(self) -> list[int]:
        """Numbers of pairs of the whole study, ascending."""
        return sorted({row["pairs"] for row in self.fits})

    @cached_property
    def sizes(self) -> list[int]:
        """Numbers of pairs so far, ascending."""
        return [pairs for pairs in self.all_sizes if pairs <= self.reached]

    @cached_property
    def shaped(self) -> list[str]:
        """The learners that learn how people weigh and value; `cpt` first."""
        with_shape = {row["learner"] for row in self.fits if parameters_of(row) is not None}
        return sorted(
            (name for name in self.learners if name in with_shape), key=lambda name: name != "cpt"
        )

    @property
    def compared(self) -> tuple[str, str] | None:
        """The learner that is compared, and with whom; None if there are no two."""
        if len(self.learners) < 2:
            return None
        baseline = "eu" if "eu" in self.learners else self.learners[0]
        others = [name for name in (*self.shaped, *self.learners) if name != baseline]
        return others[0], baseline

    @cached_property
    def sharpening(self) -> list[int]:
        """A few numbers of pairs so far, from least to most, to show how something sharpens."""
        sizes = self.sizes
        return sorted({sizes[0], sizes[len(sizes) // 2], sizes[-1]}) if sizes else []

    def fits_of(self, teacher: str, learner: str, pairs: int) -> list[Row]:
        """The fits of one learner to one teacher from so many pairs."""
        return [
            row
            for row in self.fits
            if (row["teacher"], row["learner"], row["pairs"]) == (teacher, learner, pairs)
        ]

    def largest(self, teacher: str, learner: str) -> list[Row]:
        """The fits of one learner to one teacher from the most pairs so far."""
        return self.fits_of(teacher, learner, self.sizes[-1]) if self.sizes else []

    def verdicts(self, teacher: str) -> list[str]:
        """How two learners compare at the most pairs so far; the longest wording first.

        Empty if they cannot be compared there.
        """
        if self.compared is None or not self.sizes:
            return []
        ours, theirs = map(learner_name, self.compared)
        for found in self.comparisons:
            (at,) = np.nonzero(found.pairs == self.sizes[-1])
            if found.teacher != teacher or not len(at):
                continue
            ratio = float(found.ratio[at[0]])
            times = f"{ours}'s regret is {number(ratio, '.2f')} × {theirs}'s"
            brief = f"{ours} {number(ratio, '.2f')} × {theirs}"
            if not np.isfinite(ratio):
                times, brief = f"{ours}'s regret less {theirs}'s", f"{ours} − {theirs}"
            shift, low, high = (
                signed(float(end[at[0]])) for end in (found.difference, found.low, found.high)
            )
            interval = f" [{low}, {high}]" if found.runs[at[0]] > 1 else ""
            pairs = counted(self.sizes[-1], "pair")
            return [
                f"At {pairs} {times}: {shift} percentage points{interval}",
                f"{times}: {shift} percentage points{interval}",
                f"{times}: {shift} % points{interval}",
                f"{brief}: {shift} % points{interval}",
                f"{brief}: {shift}{interval}",
                f"{brief}: {shift}",
            ]
        return []

    def titles(self) -> list[str]:
        """What the picture is about, the longest wording first."""
        rest = ["Learning what people prefer", "Preferences learnt"]
        if self.shaped and len(self.shaped) < len(self.learners):
            return ["Learning what people prefer, with and without their sense of risk", *rest]
        return rest

    def subtitles(self) -> list[str]:
        """What was studied, as a whole, in one line, the longest wording first."""
        rows = self.fits
        if not rows:
            return ["no fits yet"]
        fits = counted(len(rows), "fit")
        seeds = counted(len({row["seed"] for row in rows}), "seed")
        people = counted(len(self.teachers), "teacher")
        if self.left_out:
            people = f"{len(self.teachers)} of {len(self.teachers) + self.left_out} teachers"
        pairs = counted(self.all_sizes[-1], "pair")
        if len(self.all_sizes) > 1:
            pairs = f"{len(self.all_sizes)} sizes of {self.all_sizes[0]} to {pairs}"
        learners = counted(len(self.learners), "learner")
        open_ends = sum(row["converged"] is False for row in rows)
        end = f" · {open_ends} did not converge" if open_ends else ""
        if all(row["converged"] for row in rows):
            end = " · all converged"
        sure = [row["certainty"] for row in rows if row["certainty"] is not None]
        certain = f" · answers {round(100 * float(np.mean(sure)))} % certain" if sure else ""
        short_end = f" · {open_ends} not converged" if open_ends else ""
        return [
            f"{fits}: {people} × {learners} × {pairs} × {seeds} · "
            f"tested on held-out scenes{certain}{end}",
            f"{fits}: {people} × {learners} × {pairs} × {seeds}{certain}{end}",
            f"{fits}: {people} × {learners} × {pairs} × {seeds}{short_end}",
            f"{fits}{short_end}",
        ]

    def notes(self) -> list[str]:
        """What lines and marks mean."""
        if not self.rows:
            return []
        seeds = len({row["seed"] for row in self.rows})
        most = counted(self.sizes[-1], "pair")
        said = []
        if seeds > 1:
            said.append(
                f"Regret (logarithmic axes) and picks: mean over {seeds} seeds, "
                "band: its 95 % bootstrap interval"
            )
            if len(self.learners) > 1:
                said.append(f"[ ]: 95 % interval of the paired difference at {most}")
        if self.shaped:
            shades = ", ".join(str(size) for size in self.sharpening)
            said.append(
                f"Weights and value: {learner_name(self.shaped[0])}, a line a seed"
                + (f" after {shades} pairs" if len(self.sharpening) > 1 else "")
                + ", dashed: teacher; x in the teacher's units"
            )
            said.append(
                "EU: expected utility, CPT: cumulative prospect theory; "
                "α, η: curvature of gains and losses, λ: loss aversion, "
                "γ, δ: weighting of gains' and losses' probabilities"
            )
        each = "a dot a seed, large: mean, " if seeds > 1 else ""
        numbers = "Reward and parameters" if self.shaped else "Reward"
        said.append(f"{numbers} at {most}: {each}bar: teacher")
        if len(self.sizes) > 1:
            said.append(f"Errors: bold {most}, thin {self.sizes[0]}")
        return [f"{note}." for note in said]


def parameters_of(row: Row) -> CptParameters | None:
    """The parameters that a fit learnt; None if its learner has none."""
    found = [row[column] for column in PARAMETERS]
    if any(given is None or not np.isfinite(given) or given <= 0.0 for given in found):
        return None
    return CptParameters(*(float(given) for given in found))


def numbers_of(parameters: CptParameters) -> list[float]:
    """α, η, λ, γ, δ."""
    return [
        float(given)
        for given in (
            parameters.alpha,
            parameters.eta,
            parameters.loss_aversion,
            parameters.gamma,
            parameters.delta,
        )
    ]


def feature_names(count: int) -> list[str]:
    """What the numbers of θ are for."""
    if count == len(FEATURES):
        return list(FEATURES)
    return [f"feature {index + 1}" for index in range(count)]


def calibration(rows: Sequence[Row]) -> FloatArray:
    """Where predictions miss, over all these fits.

    Returns:
        [bins, 2], mean predicted share and how much larger the true one is, both in %; bins
        without predictions are left out.
    """
    sums: dict[int, FloatArray] = {}
    for row in rows:
        columns = ("calibration_count", "calibration_predicted", "calibration_preferred")
        bins = zip(*(row[column] or [] for column in columns), strict=True)
        for place, (count, predicted, preferred) in enumerate(bins):
            if count and predicted is not None and preferred is not None:
                bin_sums = np.array([count, count * predicted, count * preferred], dtype=np.float64)
                sums[place] = sums.get(place, np.zeros(3)) + bin_sums
    points = [
        (predicted / count, (preferred - predicted) / count)
        for _, (count, predicted, preferred) in sorted(sums.items())
    ]
    missed: FloatArray = 100.0 * np.array(points).reshape(-1, 2)
    return missed


def _finite(curves: list[Curve]) -> list[Curve]:
    """The curves that are numbers all along."""
    return [curve for curve in curves if np.isfinite(curve.mean).all()]
