"""The table of a study, sorted by who learned what from whom."""

import json
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import ArrayLike

from learners import (
    CptParameters,
    Curve,
    InputError,
    SceneRegrets,
    StudyScene,
    Teacher,
    family_curves,
    learning_curves,
    scene_regrets,
    study_scenes,
    telling_scenes,
)
from learners.studying.table import METADATA
from studio.arrays import FloatArray

CPT_COLUMNS = ("alpha", "eta", "lambda", "gamma", "delta")
"""Columns of the five parameters, empty for learners of expected utility."""

CURVE_COLUMNS = (
    "regret_percent",
    "regret",
    "agreement",
    "nll",
    "nll_teacher",
    "theta_cosine",
    "theta_unit",
    *CPT_COLUMNS,
)
"""Columns that are followed as means over seeds."""

FAMILY_COLUMNS = ("regret", "regret_percent")
"""What is followed in each family of scenes, as means over seeds."""

TOLD_SCENES = 6
"""How many scenes are told of, over all teachers; of each teacher at least one."""

Runs = dict[str, list[Any]]
"""Column to its values, one a seed."""


@dataclass(frozen=True)
class Results:
    """What came of a study.

    Attributes:
        table: one row a fit, see `learners.STUDY_SCHEMA`.
        known: the teachers, of whom those without rows are left out.
    """

    table: pa.Table
    known: Sequence[Teacher]

    @cached_property
    def teachers(self) -> tuple[Teacher, ...]:
        """Who was learned from."""
        names = set(self.table["teacher"].to_pylist())
        return tuple(teacher for teacher in self.known if teacher.name in names)

    @cached_property
    def learners(self) -> tuple[str, ...]:
        """Who learned, in the order of the table."""
        return tuple(dict.fromkeys(self.table["learner"].to_pylist()))

    @cached_property
    def sizes(self) -> tuple[int, ...]:
        """Numbers of pairs, ascending."""
        return tuple(sorted(set(self.table["pairs"].to_pylist())))

    @cached_property
    def seeds(self) -> int:
        """How many repetitions there are."""
        return len(set(self.table["seed"].to_pylist()))

    @cached_property
    def study(self) -> dict[str, Any]:
        """What the table says about the study as a whole; empty if nothing."""
        told = (self.table.schema.metadata or {}).get(METADATA, b"{}")
        study: dict[str, Any] = json.loads(told)
        return study

    @cached_property
    def scenes(self) -> dict[int, StudyScene]:
        """The scenes of the study by their ids; none if the table does not tell of them."""
        try:
            return study_scenes(self.table)
        except InputError:
            return {}

    @cached_property
    def families(self) -> tuple[str, ...]:
        """Names of the families of scenes, sorted; none if the table does not tell of them."""
        return tuple(sorted({scene.family for scene in self.scenes.values()}))

    @cached_property
    def telling(self) -> dict[str, tuple[int, ...]]:
        """The scenes that tell most about the learners, by the teacher's name."""
        count = max(1, TOLD_SCENES // len(self.teachers))
        return telling_scenes(self.table, count)

    def random_regret(self, teacher: Teacher, family: str) -> float:
        """What a random action costs a teacher in a family of scenes, on average."""
        return self._random_regrets[teacher.name, family]

    def scene_regrets(self, teacher: Teacher, learner: str, pairs: int) -> SceneRegrets | None:
        """The regret in every scene that was held out; none if there is no such fit."""
        return self._scene_regrets.get((teacher.name, learner, pairs))

    def family_curve(
        self, column: str, family: str, teacher: Teacher, learner: str
    ) -> Curve | None:
        """How a column of `FAMILY_COLUMNS` changes in a family with the number of pairs."""
        return self._family_curves[column].get((family, teacher.name, learner))

    def family_percents(self, family: str, teacher: Teacher, learner: str) -> Curve | None:
        """How regret in a family changes, in % of what a random action costs there, on average."""
        curve = self.family_curve("regret", family, teacher, learner)
        if curve is None:
            return None
        mean, std, low, high = (
            self.percents(teacher, family, side)
            for side in (curve.mean, curve.std, curve.low, curve.high)
        )
        return replace(curve, mean=mean, std=std, low=low, high=high)

    def percents(self, teacher: Teacher, family: str, regrets: ArrayLike) -> FloatArray:
        """Regrets in % of what a random action costs a teacher in a family, on average."""
        cost = self.random_regret(teacher, family)
        # where nothing can be lost, the regret is 0 whatever it is divided by
        percents: FloatArray = 100.0 * np.asarray(regrets) / (cost if cost > 0.0 else 1.0)
        return percents

    def runs(self, teacher: Teacher, learner: str, pairs: int) -> Runs:
        """The fits of one learner to one teacher, by seed; columns are empty if there are none."""
        return self._runs.get((teacher.name, learner, pairs), {name: [] for name in self._columns})

    def curve(self, column: str, teacher: Teacher, learner: str) -> Curve | None:
        """How a column changes with the number of pairs; none if the learner has no such thing."""
        return self._curves[column].get((teacher.name, learner))

    @cached_property
    def _columns(self) -> list[str]:
        return list(self.table.column_names)

    @cached_property
    def _runs(self) -> dict[tuple[str, str, int], Runs]:
        runs: dict[tuple[str, str, int], Runs] = {}
        for row in sorted(self.table.to_pylist(), key=lambda row: int(row["seed"])):
            key = (row["teacher"], row["learner"], row["pairs"])
            columns = runs.setdefault(key, {name: [] for name in self._columns})
            for name, given in row.items():
                columns[name].append(given)
        return runs

    @cached_property
    def _curves(self) -> dict[str, dict[tuple[str, str], Curve]]:
        return {
            column: {
                (curve.teacher, curve.learner): curve
                for curve in learning_curves(self.table, column)
            }
            for column in CURVE_COLUMNS
        }

    @cached_property
    def _scene_regrets(self) -> dict[tuple[str, str, int], SceneRegrets]:
        return {
            (each.teacher, each.learner, each.pairs): each for each in scene_regrets(self.table)
        }

    @cached_property
    def _random_regrets(self) -> dict[tuple[str, str], float]:
        costs: dict[tuple[str, str], list[float]] = {}
        for scene in self.scenes.values():
            for teacher, cost in scene.random_regret.items():
                costs.setdefault((teacher, scene.family), []).append(cost)
        return {key: float(np.mean(given)) for key, given in costs.items()}

    @cached_property
    def _family_curves(self) -> dict[str, dict[tuple[str, str, str], Curve]]:
        return {
            column: {
                (family, curve.teacher, curve.learner): curve
                for family, curves in family_curves(self.table, column).items()
                for curve in curves
            }
            for column in FAMILY_COLUMNS
        }


def learnt_parameters(runs: Runs) -> list[CptParameters]:
    """The parameters of each fit; all ones where there are none, which is expected utility."""
    return [
        CptParameters(*(1.0 if number is None else number for number in numbers))
        for numbers in zip(*(runs[column] for column in CPT_COLUMNS), strict=True)
    ]


def true_parameters(teacher: Teacher) -> tuple[float, ...]:
    """The teacher's parameters in the order of their columns."""
    people = teacher.parameters
    return people.alpha, people.eta, people.loss_aversion, people.gamma, people.delta


def length(theta: Sequence[float]) -> float:
    """Euclidean length of θ."""
    return float(np.sqrt(np.sum(np.square(theta))))
