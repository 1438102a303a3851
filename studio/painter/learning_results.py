"""The results of a study as its picture needs them: who, how many, and what they say in words."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import pyarrow as pa

from learners import FEATURES, CptParameters, Curve, Teacher, compare_learners, learning_curves
from studio.naming import counted, learner_name, number
from studio.painter.canvas import FloatArray

MOST_TEACHERS = 4
"""More than that would be too small to read."""

PARAMETERS = {"alpha": "α", "eta": "η", "lambda": "λ", "gamma": "γ", "delta": "δ"}
"""Columns of the table that hold the parameters of prospect theory, and their letters."""

Row = dict[str, Any]


@dataclass(frozen=True)
class Results:
    """What a study found out, about the teachers that there is room for.

    Attributes:
        table: one row a fit.
        teachers: who were learned from, at most `MOST_TEACHERS`.
        left_out: how many more there are.
    """

    table: pa.Table
    teachers: tuple[Teacher, ...]
    left_out: int

    @classmethod
    def of(cls, table: pa.Table, teachers: Sequence[Teacher]) -> "Results":
        """The results of fits to these teachers."""
        shown = tuple(teachers)[:MOST_TEACHERS]
        names = {teacher.name for teacher in shown}
        kept = np.array([name in names for name in table["teacher"].to_pylist()], dtype=bool)
        return cls(table.filter(pa.array(kept)), shown, len(teachers) - len(shown))

    @cached_property
    def rows(self) -> list[Row]:
        """The fits in plain types."""
        found: list[Row] = self.table.to_pylist()
        return found

    @cached_property
    def learners(self) -> list[str]:
        """Who learned, in the order of the table."""
        return list(dict.fromkeys(row["learner"] for row in self.rows))

    @cached_property
    def sizes(self) -> list[int]:
        """Numbers of pairs, ascending."""
        return sorted({row["pairs"] for row in self.rows})

    @cached_property
    def shaped(self) -> list[str]:
        """The learners that learn how people weigh and value; `cpt` first."""
        with_shape = {row["learner"] for row in self.rows if parameters_of(row) is not None}
        return sorted(
            (name for name in self.learners if name in with_shape), key=lambda name: name != "cpt"
        )

    @cached_property
    def sharpening(self) -> list[int]:
        """A few numbers of pairs, from least to most, to show how something sharpens."""
        sizes = self.sizes
        return sorted({sizes[0], sizes[len(sizes) // 2], sizes[-1]}) if sizes else []

    def fits(self, teacher: str, learner: str, pairs: int | None = None) -> list[Row]:
        """The fits of one learner to one teacher, of all sizes or of one."""
        return [
            row
            for row in self.rows
            if (row["teacher"], row["learner"]) == (teacher, learner)
            and (pairs is None or row["pairs"] == pairs)
        ]

    def largest(self, teacher: str, learner: str) -> list[Row]:
        """The fits of one learner to one teacher that had the most pairs."""
        return self.fits(teacher, learner, self.sizes[-1]) if self.sizes else []

    @cached_property
    def regret(self) -> list[Curve]:
        """Regret, in % of a random action's."""
        return _finite(learning_curves(self.table, "regret_percent")) if self.rows else []

    @cached_property
    def agreement(self) -> list[Curve]:
        """Share of scenes in which the teacher's best action is picked, 0 to 1."""
        return _finite(learning_curves(self.table, "agreement")) if self.rows else []

    def verdicts(self, teacher: str) -> list[str]:
        """How two learners compare at the largest size; the longest wording first.

        Empty if there are no two learners.
        """
        if len(self.learners) < 2 or not self.sizes:
            return []
        baseline = "eu" if "eu" in self.learners else self.learners[0]
        others = [name for name in (*self.shaped, *self.learners) if name != baseline]
        for found in compare_learners(self.table, others[0], baseline, "regret_percent"):
            if found.teacher != teacher or found.pairs[-1] != self.sizes[-1]:
                continue
            ours, theirs = learner_name(others[0]), learner_name(baseline)
            ratio = float(found.ratio[-1])
            times = f"{ours}'s regret is {number(ratio, '.2f')} × {theirs}'s"
            brief = f"{ours} {number(ratio, '.2f')} × {theirs}"
            if not np.isfinite(ratio):
                times, brief = f"{ours}'s regret less {theirs}'s", f"{ours} − {theirs}"
            shift, low, high = (
                _signed(float(end[-1])) for end in (found.difference, found.low, found.high)
            )
            interval = f" [{low}, {high}]" if found.runs[-1] > 1 else ""
            pairs = counted(int(found.pairs[-1]), "pair")
            return [
                f"At {pairs} {times}: {shift} points{interval}",
                f"{times}: {shift} points{interval}",
                f"{brief}: {shift} points{interval}",
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
        """What was studied in one line, the longest wording first."""
        rows = self.rows
        if not rows:
            return ["no fits yet"]
        fits = counted(len(rows), "fit")
        seeds = counted(len({row["seed"] for row in rows}), "seed")
        people = counted(len(self.teachers), "teacher")
        if self.left_out:
            people = f"{len(self.teachers)} of {len(self.teachers) + self.left_out} teachers"
        pairs = counted(self.sizes[-1], "pair")
        if len(self.sizes) > 1:
            pairs = f"{len(self.sizes)} sizes of {self.sizes[0]} to {pairs}"
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
                f"Regret and picks: mean over {seeds} seeds, band: its 95 % bootstrap interval, "
                "whiskers: ± 1 standard deviation"
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


def unit_vector(theta: Sequence[float]) -> FloatArray:
    """θ/‖θ‖; zeros if there is nothing to divide by."""
    array = np.array(theta, dtype=np.float64)
    length = float(np.linalg.norm(array))
    unit: FloatArray = array / length if length > 0.0 else array
    return unit


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


def _signed(difference: float) -> str:
    """A difference with two decimals and its sign; one that rounds to 0 has none."""
    text = number(difference, "+.2f")
    return text if text.strip("+−0.") else "0.00"


def _finite(curves: list[Curve]) -> list[Curve]:
    """The curves that are numbers all along."""
    return [curve for curve in curves if np.isfinite(curve.mean).all()]
