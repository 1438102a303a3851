"""The plan of a study: who teaches, who learns, from how many pairs, and how many times."""

import hashlib
from dataclasses import asdict, dataclass
from functools import cached_property
from typing import Any, NamedTuple

from learners.arrays import FloatArray
from learners.asking.prospects import Prospects
from learners.errors import InputError
from learners.fitting.fits import Learner
from learners.judging.teachers import Teacher
from learners.studying.split import HELD_OUT, split_scenes

SIZES = (25, 50, 100, 200, 500, 1000, 2000)
"""Numbers of pairs to learn from."""


@dataclass(frozen=True)
class StudyScene:
    """A scene of a study, and what its actions are worth to the teachers, whoever learns.

    Attributes:
        scene: its id in the bank.
        family: the kind of scene.
        pattern: how people meet in it.
        best: the action that each teacher would pick, by the teacher's name.
        random_regret: what an action picked at random would cost each teacher, by the teacher's
            name, in units of value.
    """

    scene: int
    family: str
    pattern: str
    best: dict[str, str]
    random_regret: dict[str, float]


class Task(NamedTuple):
    """One fit of a study, which becomes one row of its table."""

    pairs: int
    teacher: str
    learner: str
    seed: int


@dataclass(frozen=True)
class Study:
    """What to study.

    Attributes:
        prospects: the scenes to learn from and to test on.
        teachers: the teachers to learn from, each name once.
        learners: the learners to fit, each name once.
        sizes: numbers of pairs to learn from, each once.
        seeds: how many repetitions; their seeds count from 0.
        held_out: share of the scenes that is kept back for the test.

    Raises:
        InputError: if something is missing, stands there twice or is out of range.
    """

    prospects: Prospects
    teachers: tuple[Teacher, ...]
    learners: tuple[Learner, ...]
    sizes: tuple[int, ...] = SIZES
    seeds: int = 5
    held_out: float = HELD_OUT

    def __post_init__(self) -> None:
        names: dict[str, list[Any]] = {
            "teachers": [teacher.name for teacher in self.teachers],
            "learners": [learner.name for learner in self.learners],
            "pairs": list(self.sizes),
        }
        for field, given in names.items():
            if not given:
                raise InputError(f"{field}: none is given: one or more is needed")
            if len(set(given)) != len(given):
                raise InputError(f"{field}: {given} is not allowed: each once")
        if min(self.sizes) < 1:
            raise InputError(f"pairs {min(self.sizes)} is not allowed: 1 or more")
        if self.seeds < 1:
            raise InputError(f"seeds {self.seeds} is not allowed: 1 or more")
        split_scenes(self.prospects, 0, self.held_out)  # refuses what cannot be split
        for teacher in self.teachers:
            teacher.values(self.prospects.features[:1, :1])  # refuses a reward that does not fit

    @cached_property
    def truths(self) -> dict[str, FloatArray]:
        """What all prospects are worth to each teacher, [S, A], by the teacher's name."""
        return {teacher.name: teacher.values(self.prospects.features) for teacher in self.teachers}

    @cached_property
    def scenes(self) -> tuple[StudyScene, ...]:
        """The scenes of the study, in the order of the prospects."""
        there, truths = self.prospects, self.truths
        best = {name: truth.argmax(axis=1) for name, truth in truths.items()}
        costs = {name: truth.max(axis=1) - truth.mean(axis=1) for name, truth in truths.items()}
        return tuple(
            StudyScene(
                scene=int(scene),
                family=there.families[place],
                pattern=there.patterns[place],
                best={name: there.actions[picks[place]] for name, picks in best.items()},
                random_regret={name: float(cost[place]) for name, cost in costs.items()},
            )
            for place, scene in enumerate(there.scenes)
        )

    @cached_property
    def metadata(self) -> dict[str, Any]:
        """All that a row depends on besides its own task, in plain types, for the table to keep."""
        digest = hashlib.sha256(self.prospects.features.tobytes())
        digest.update(repr((self.prospects.families, self.prospects.actions)).encode())
        return {
            "bank": digest.hexdigest(),
            "held_out": self.held_out,
            "teachers": {teacher.name: teacher.description() for teacher in self.teachers},
            "learners": {learner.name: learner.description() for learner in self.learners},
            "scenes": [asdict(scene) for scene in self.scenes],
        }


def study_tasks(study: Study) -> tuple[Task, ...]:
    """All tasks of a study in the order of its table: by pairs, teacher, learner and seed."""
    return tuple(
        Task(pairs, teacher.name, learner.name, seed)
        for pairs in sorted(study.sizes)
        for teacher in study.teachers
        for learner in study.learners
        for seed in range(study.seeds)
    )
