"""What came of a study: who learned what from whom. All media take their numbers from here."""

import itertools
import json
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import ArrayLike

from learners import (
    Curve,
    Difference,
    InputError,
    PairedDifference,
    SceneRegrets,
    Spread,
    StudyScene,
    Teacher,
    family_curves,
    learning_curves,
    paired_differences,
    scene_regrets,
    study_scenes,
    telling_scenes,
)
from learners.studying.table import METADATA
from studio.arrays import FloatArray
from studio.study.fits import Row, parameters_of
from studio.study.regret import RegretRange

FAMILY_COLUMNS = ("regret", "regret_percent")
"""Columns that are followed in each family of scenes, as means over seeds."""

TOLD_SCENES = 6
"""How many scenes are told of, over all teachers; of each teacher at least one."""


@dataclass(frozen=True)
class StudyResults:
    """What came of a study, complete or not; curves and their intervals are worked out once."""

    table: pa.Table  # one row a fit, see `learners.STUDY_SCHEMA`
    teachers: tuple[Teacher, ...]  # who was learned from; there may be teachers without fits

    def __repr__(self) -> str:
        # the table would fill pages
        who = ", ".join(teacher.name for teacher in self.teachers)
        return f"<StudyResults of {who}: {self.table.num_rows} fits of {', '.join(self.learners)}>"

    def among(self, teachers: tuple[Teacher, ...]) -> "StudyResults":
        """The results of these teachers alone."""
        if teachers == self.teachers:
            return self
        names = {teacher.name for teacher in teachers}
        return StudyResults(self._rows("teacher", names.__contains__), teachers)

    def between(self, low: float, high: float) -> "StudyResults":
        """The results as if the study had been of these numbers of pairs alone, both included."""
        if all(low <= pairs <= high for pairs in self.sizes):
            return self
        return StudyResults(self._rows("pairs", lambda pairs: low <= pairs <= high), self.teachers)

    @cached_property
    def taught(self) -> tuple[Teacher, ...]:
        """The teachers from whom somebody learned."""
        names = {row["teacher"] for row in self.fits}
        return tuple(teacher for teacher in self.teachers if teacher.name in names)

    @cached_property
    def fits(self) -> list[Row]:
        """All fits, in the order of the table."""
        rows: list[Row] = self.table.to_pylist()
        return rows

    @cached_property
    def learners(self) -> tuple[str, ...]:
        """Who learned, in the order of the table."""
        return tuple(dict.fromkeys(row["learner"] for row in self.fits))

    @cached_property
    def sizes(self) -> tuple[int, ...]:
        """Numbers of pairs, ascending."""
        return tuple(sorted({row["pairs"] for row in self.fits}))

    @cached_property
    def seeds(self) -> int:
        """How many repetitions there are."""
        return len({row["seed"] for row in self.fits})

    @cached_property
    def certainty(self) -> float | None:
        """Mean probability of the answers that teachers gave, 0.5 to 1; None if nobody knows."""
        known = [row["certainty"] for row in self.fits if row["certainty"] is not None]
        return float(np.mean(known)) if known else None

    @cached_property
    def unsettled(self) -> int:
        """How many fits did not converge."""
        return sum(row["converged"] is False for row in self.fits)

    @cached_property
    def repeated(self) -> int:
        """How many pairs were asked more than once, of the fit of which most were."""
        return max((row["repeated"] for row in self.fits), default=0)

    @cached_property
    def shaped(self) -> tuple[str, ...]:
        """The learners that learn how people weigh and value; `cpt` first."""
        found = {row["learner"] for row in self.fits if parameters_of(row) is not None}
        ours = (learner for learner in self.learners if learner in found)
        return tuple(sorted(ours, key=lambda learner: learner != "cpt"))

    @property
    def paired(self) -> tuple[str, str] | None:
        """Whose regret is set against whose, `eu` if it can be; None if there are no two."""
        if len(self.learners) < 2:
            return None
        baseline = "eu" if "eu" in self.learners else self.learners[0]
        others = [name for name in (*self.shaped, *self.learners) if name != baseline]
        return others[0], baseline

    def fits_of(self, teacher: Teacher, learner: str, pairs: int) -> list[Row]:
        """The fits of one learner to one teacher from this number of pairs, by seed."""
        return self._fits.get((teacher.name, learner, pairs), [])

    @property
    def stages(self) -> tuple["Stage", ...]:
        """The study after each number of pairs; a single stage if nobody was fitted yet."""
        return tuple(Stage(self, pairs) for pairs in self.sizes or (0,))

    # Curves

    @cached_property
    def curves(self) -> Callable[[str], list[Curve]]:
        """All curves of a column over the number of pairs; those with gaps are left out."""
        return cache(lambda column: _finite(learning_curves(self.table, column)))

    def curves_of(self, column: str, teacher: Teacher) -> list[Curve]:
        """The curves of a column of all who learned from a teacher."""
        return [curve for curve in self.curves(column) if curve.teacher == teacher.name]

    def curve(self, column: str, teacher: Teacher, learner: str) -> Curve | None:
        """The curve of a column; None if the learner has nothing in it."""
        return _found(self.curves(column), teacher, learner)

    def spread(self, column: str, teacher: Teacher, learner: str, pairs: int) -> Spread | None:
        """What the seeds say of a column; None if they say nothing."""
        curve = self.curve(column, teacher, learner)
        return curve.at(pairs) if curve else None

    @cached_property
    def regrets(self) -> RegretRange:
        """Which regrets the curves of `regret_percent` reach."""
        return RegretRange.around(self.curves("regret_percent"))

    def difference(
        self, teacher: Teacher, learner: str, baseline: str, pairs: int
    ) -> Difference | None:
        """How much more regret a learner has than another, in percentage points.

        None without seeds of both.
        """
        for found in self._differences(learner, baseline):
            if found.teacher == teacher.name:
                return found.at(pairs)
        return None

    # Scenes

    @cached_property
    def study(self) -> dict[str, Any]:
        """What the table says about the study as a whole; empty if nothing."""
        metadata = self.table.schema.metadata or {}
        study: dict[str, Any] = json.loads(metadata.get(METADATA, b"{}"))
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
        return telling_scenes(self.table, max(1, TOLD_SCENES // len(self.teachers)))

    @property
    def told_scenes(self) -> list[int]:
        """Ids of the scenes that tell most about the learners of any teacher, each once."""
        return list(dict.fromkeys(itertools.chain(*self.telling.values())))

    def scene_regrets(self, teacher: Teacher, learner: str, pairs: int) -> SceneRegrets | None:
        """The regret in every scene that was held out; None if there is no such fit."""
        return self._scene_regrets.get((teacher.name, learner, pairs))

    def family_curve(
        self, column: str, family: str, teacher: Teacher, learner: str
    ) -> Curve | None:
        """The curve of a column of `FAMILY_COLUMNS` in a family of scenes; None if it has gaps."""
        return _found(self._family_curves(column).get(family, []), teacher, learner)

    def family_percents(self, family: str, teacher: Teacher, learner: str) -> Curve | None:
        """The curve of regret in a family, in % of what a random action costs there on average."""
        curve = self.family_curve("regret", family, teacher, learner)
        if curve is None:
            return None
        return curve.mapped(lambda regrets: self.percents(teacher, family, regrets))

    def percents(self, teacher: Teacher, family: str, regrets: ArrayLike) -> FloatArray:
        """Regrets in % of what a random action costs a teacher in a family, on average."""
        cost = self._random_regrets[teacher.name, family]
        # where nothing can be lost, the regret is 0 whatever it is divided by
        percents: FloatArray = 100.0 * np.asarray(regrets) / (cost if cost > 0.0 else 1.0)
        return percents

    # What the questions above look up

    def _rows(self, column: str, wanted: Callable[[Any], bool]) -> pa.Table:
        kept = [wanted(each) for each in self.table[column].to_pylist()]
        return self.table.filter(pa.array(kept, pa.bool_()))

    @cached_property
    def _fits(self) -> dict[tuple[str, str, int], list[Row]]:
        found: dict[tuple[str, str, int], list[Row]] = {}
        for row in sorted(self.fits, key=lambda row: int(row["seed"])):
            found.setdefault((row["teacher"], row["learner"], row["pairs"]), []).append(row)
        return found

    @cached_property
    def _differences(self) -> Callable[[str, str], list[PairedDifference]]:
        return cache(lambda learner, baseline: paired_differences(self.table, learner, baseline))

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
    def _family_curves(self) -> Callable[[str], dict[str, list[Curve]]]:
        def finite(column: str) -> dict[str, list[Curve]]:
            found = family_curves(self.table, column)
            return {family: _finite(curves) for family, curves in found.items()}

        return cache(finite)


@dataclass(frozen=True)
class Stage:
    """A study as far as a number of pairs: what was found from no more pairs than these."""

    results: StudyResults  # of the whole study
    reached: float  # how many pairs were learned from; need not be a size of the study

    @cached_property
    def sizes(self) -> tuple[int, ...]:
        """Numbers of pairs so far, ascending."""
        return tuple(pairs for pairs in self.results.sizes if pairs <= self.reached)

    @cached_property
    def fits(self) -> list[Row]:
        """The fits so far, in the order of the table."""
        return [row for row in self.results.fits if row["pairs"] <= self.reached]

    @property
    def sharpening(self) -> tuple[int, ...]:
        """A few numbers of pairs so far, from least to most, to show how something sharpens."""
        sizes = self.sizes
        return tuple(sorted({sizes[0], sizes[len(sizes) // 2], sizes[-1]})) if sizes else ()

    def largest(self, teacher: Teacher, learner: str) -> list[Row]:
        """The fits of one learner to one teacher from the most pairs so far."""
        return self.results.fits_of(teacher, learner, self.sizes[-1]) if self.sizes else []


def _finite(curves: list[Curve]) -> list[Curve]:
    """Curves whose means are numbers all along."""
    return [curve for curve in curves if np.isfinite(curve.mean).all()]


def _found(curves: list[Curve], teacher: Teacher, learner: str) -> Curve | None:
    ours = (curve for curve in curves if (curve.teacher, curve.learner) == (teacher.name, learner))
    return next(ours, None)
