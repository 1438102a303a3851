"""The study: teachers × learners × numbers of pairs × seeds, fitted and put to the test.

Seed s decides the split of the scenes, the pairs and what is random in the answers; every teacher
is asked the same questions, and a longer series begins with the shorter one. A row depends on its
own task only, neither on what else is studied nor on when, so that a study that was interrupted
continues where it stopped.
"""

import hashlib
import json
import os
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict, dataclass
from functools import cached_property
from itertools import groupby
from typing import Any, NamedTuple

import numpy as np
import pyarrow as pa

from learners.arrays import FloatArray
from learners.asking.preferences import answer, sample_pairs
from learners.asking.prospects import Prospects
from learners.errors import InputError
from learners.fitting.fits import Fit, Learner
from learners.fitting.registry import find_learners
from learners.judging.teachers import Teacher, find_teachers
from learners.studying.evaluation import evaluate
from learners.studying.regrets import METADATA, described_scenes
from learners.studying.split import HELD_OUT, split_scenes

SIZES = (25, 50, 100, 200, 500, 1000, 2000)
"""Numbers of pairs to learn from."""

# lists as Parquet files give them back
_NUMBERS = pa.list_(pa.field("element", pa.float64()))
_COUNTS = pa.list_(pa.field("element", pa.int64()))
_NAMES = pa.list_(pa.field("element", pa.string()))

PARAMETER_COLUMNS = ("alpha", "eta", "lambda", "gamma", "delta")
"""Columns of the parameters of prospect theory, in the order of `CptParameters.SYMBOLS`."""

STUDY_SCHEMA = pa.schema(
    [
        pa.field("teacher", pa.string(), nullable=False),
        pa.field("learner", pa.string(), nullable=False),
        pa.field("pairs", pa.int64(), nullable=False),
        pa.field("seed", pa.int64(), nullable=False),
        pa.field("regret", pa.float64(), nullable=False),
        pa.field("regret_percent", pa.float64(), nullable=False),
        pa.field("nll", pa.float64(), nullable=False),
        pa.field("certainty", pa.float64(), nullable=False),
        pa.field("theta", _NUMBERS, nullable=False),
        pa.field("alpha", pa.float64()),
        pa.field("eta", pa.float64()),
        pa.field("lambda", pa.float64()),
        pa.field("gamma", pa.float64()),
        pa.field("delta", pa.float64()),
        pa.field("reference", pa.float64(), nullable=False),
        pa.field("theta_unit", _NUMBERS, nullable=False),
        pa.field("theta_cosine", pa.float64(), nullable=False),
        pa.field("agreement", pa.float64(), nullable=False),
        pa.field("nll_teacher", pa.float64(), nullable=False),
        pa.field("nll_training", pa.float64(), nullable=False),
        pa.field("repeated", pa.int64(), nullable=False),
        pa.field("converged", pa.bool_(), nullable=False),
        pa.field("steps", pa.int64(), nullable=False),
        pa.field("expected_decrease", pa.float64(), nullable=False),
        pa.field("calibration_count", _COUNTS, nullable=False),
        pa.field("calibration_predicted", _NUMBERS, nullable=False),
        pa.field("calibration_preferred", _NUMBERS, nullable=False),
        pa.field("held_out_scenes", _COUNTS, nullable=False),
        pa.field("scene_regret", _NUMBERS, nullable=False),
        pa.field("scene_picks", _NAMES, nullable=False),
    ]
)
"""Columns of the table, one row a fit.

`regret`, `regret_percent`, `agreement`, `nll`, `nll_teacher` and the `calibration_` lists are those
of `Evaluation`, on held-out scenes; `nll_training` is that of the fit. `certainty` is that of the
answers learned from, `repeated` how many of their questions had been asked before. `theta_unit` is
θ/‖θ‖ and `theta_cosine` the cosine between θ and the teacher's. `alpha` to `delta` are empty for
learners of expected utility, calibration empty (null) in bins without predictions.
`held_out_scenes` are the ids of the scenes that were kept back, ascending; `scene_regret` is the
regret in each of them, in units of value, and `scene_picks` the action picked there. What these
scenes are stands in the metadata, see `study_scenes`.
"""

Progress = Callable[[int, int], None]
"""Is told how many of how many fits are done."""


class Task(NamedTuple):
    """One row to be: who teaches, who learns, from how many pairs, and which repetition."""

    pairs: int
    teacher: str
    learner: str
    seed: int


@dataclass(frozen=True)
class Study:
    """What to study.

    Attributes:
        prospects: the scenes to learn from and to test on.
        teachers: who prefers, each name once.
        learners: who learns, each name once.
        sizes: numbers of pairs, each once.
        seeds: how many repetitions, seeds 0 and up.
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
        """What all prospects are worth to each teacher, [S, A]."""
        return {teacher.name: teacher.values(self.prospects.features) for teacher in self.teachers}

    @cached_property
    def metadata(self) -> dict[str, Any]:
        """What rows of this study depend on, apart from their own task."""
        digest = hashlib.sha256(self.prospects.features.tobytes())
        digest.update(repr((self.prospects.families, self.prospects.actions)).encode())
        return {
            "bank": digest.hexdigest(),
            "held_out": self.held_out,
            "teachers": {teacher.name: teacher.description() for teacher in self.teachers},
            "learners": {learner.name: learner.description() for learner in self.learners},
            "scenes": [asdict(scene) for scene in described_scenes(self.prospects, self.truths)],
        }


def study_tasks(study: Study) -> tuple[Task, ...]:
    """All tasks of a study in the order of its table: by size, teacher, learner and seed."""
    return tuple(
        Task(pairs, teacher.name, learner.name, seed)
        for pairs in sorted(study.sizes)
        for teacher in study.teachers
        for learner in study.learners
        for seed in range(study.seeds)
    )


def missing_tasks(study: Study, table: pa.Table | None) -> tuple[Task, ...]:
    """Tasks of a study that have no row in a table yet, in the order of `study_tasks`.

    Raises:
        InputError: if the table is not of this study: of another bank, another split, or of
            teachers or learners who bear the same names but are others.
    """
    if table is None:
        return study_tasks(study)
    _check_same_study(study, table)
    done = set(_tasks_of(table))
    return tuple(task for task in study_tasks(study) if task not in done)


def study_batches(
    study: Study,
    table: pa.Table | None = None,
    workers: int | None = None,
    progress: Progress | None = None,
) -> Iterator[pa.Table]:
    """Do what is missing and hand over the rows, one batch for each number of pairs.

    To continue an interrupted study, hand in the rows of the batches that were finished.

    Args:
        study: what to study.
        table: rows that are there already.
        workers: how many fits at a time; one per processor if left out.
        progress: told after every fit how many of how many are done.

    Raises:
        InputError: if the table is not of this study.
    """
    missing = missing_tasks(study, table)
    total = len(study_tasks(study))
    done = total - len(missing)
    schema = _schema(study)
    truths = study.truths  # before the threads begin, so that none of them does it again
    with ThreadPoolExecutor(workers or os.cpu_count()) as pool:
        for _, tasks in groupby(missing, key=lambda task: task.pairs):
            rows = []
            for row in pool.map(lambda task: _row(study, truths, task), list(tasks)):
                rows.append(row)
                done += 1
                if progress is not None:
                    progress(done, total)
            yield pa.Table.from_pylist(rows, schema=schema)


def run_study(
    prospects: Prospects,
    teachers: Sequence[Teacher | str] = ("eu", "tk", "strong"),
    learners: Sequence[Learner | str] = ("eu", "cpt"),
    sizes: Sequence[int] = SIZES,
    seeds: int = 5,
    *,
    held_out: float = HELD_OUT,
    table: pa.Table | None = None,
    workers: int | None = None,
    progress: Progress | None = None,
) -> pa.Table:
    """Run a study and hand over its table, see `STUDY_SCHEMA`, in the order of `study_tasks`.

    Args:
        prospects: the scenes to learn from and to test on.
        teachers: who prefers; teachers, or names of `TEACHERS`.
        learners: who learns; learners, or names of `LEARNERS`.
        sizes: numbers of pairs.
        seeds: how many repetitions.
        held_out: share of the scenes that is kept back for the test.
        table: rows that are there already.
        workers: how many fits at a time; one per processor if left out.
        progress: told after every fit how many of how many are done.

    Raises:
        InputError: if something cannot be studied, or the table is of another study.
    """
    study = Study(
        prospects,
        find_teachers(teachers),
        find_learners(learners),
        tuple(sizes),
        seeds,
        held_out,
    )
    batches = list(study_batches(study, table, workers, progress))
    return whole_table(study, batches if table is None else [table, *batches])


def whole_table(study: Study, parts: Sequence[pa.Table]) -> pa.Table:
    """The rows of a study from several tables in one, in the order of `study_tasks`.

    Rows that do not belong to the study, of further seeds for example, are left out.

    Raises:
        InputError: if a table is of another study.
    """
    for part in parts:
        _check_same_study(study, part)
    schema = _schema(study)
    # metadata differ where a part is of a larger or smaller study
    rows = pa.concat_tables([part.select(schema.names).cast(schema) for part in parts])
    places = {task: place for place, task in enumerate(_tasks_of(rows))}
    wanted = [places[task] for task in study_tasks(study) if task in places]
    return rows.take(pa.array(wanted, pa.int64()))


def _row(study: Study, truths: dict[str, FloatArray], task: Task) -> dict[str, Any]:
    teacher = next(t for t in study.teachers if t.name == task.teacher)
    learner = next(le for le in study.learners if le.name == task.learner)
    truth = truths[teacher.name]
    split = split_scenes(study.prospects, task.seed, study.held_out)
    pairs = sample_pairs(study.prospects, task.pairs, task.seed, split.training)
    preferences = answer(truth, pairs, teacher.beta, task.seed)
    fit = learner.fit(study.prospects, preferences, teacher.beta)
    learnt = fit.values(study.prospects.features[split.held_out])
    test = evaluate(learnt, truth[split.held_out], teacher.beta)
    return {
        **task._asdict(),
        "regret": test.regret,
        "regret_percent": test.regret_percent,
        "nll": test.nll,
        "certainty": preferences.certainty,
        **_learnt(fit),
        "theta_cosine": _cosine(fit.theta, np.array(teacher.reward)),
        "agreement": test.agreement,
        "nll_teacher": test.nll_teacher,
        "repeated": preferences.repeated,
        "calibration_count": test.calibration.count.tolist(),
        "calibration_predicted": _null_where_nan(test.calibration.predicted),
        "calibration_preferred": _null_where_nan(test.calibration.preferred),
        "held_out_scenes": study.prospects.scenes[split.held_out].tolist(),
        "scene_regret": test.scene_regret.tolist(),
        "scene_picks": [study.prospects.actions[place] for place in test.scene_picks],
    }


def _learnt(fit: Fit) -> dict[str, Any]:
    numbers = fit.parameters.numbers if fit.parameters else [None] * len(PARAMETER_COLUMNS)
    return {
        "theta": fit.theta.tolist(),
        **dict(zip(PARAMETER_COLUMNS, numbers, strict=True)),
        "reference": fit.reference,
        "theta_unit": fit.unit_theta.tolist(),
        "nll_training": fit.nll,
        "converged": fit.converged,
        "steps": fit.steps,
        "expected_decrease": fit.expected_decrease,
    }


def _cosine(one: FloatArray, other: FloatArray) -> float:
    lengths = float(np.sqrt((one**2).sum() * (other**2).sum()))
    return float((one * other).sum()) / lengths if lengths > 0.0 else 0.0


def _null_where_nan(numbers: FloatArray) -> list[float | None]:
    return [None if np.isnan(number) else number for number in numbers.tolist()]


def _schema(study: Study) -> pa.Schema:
    return STUDY_SCHEMA.with_metadata({METADATA: json.dumps(study.metadata, sort_keys=True)})


def _tasks_of(table: pa.Table) -> list[Task]:
    return [
        Task(*values) for values in zip(*(table[n].to_pylist() for n in Task._fields), strict=True)
    ]


def _check_same_study(study: Study, table: pa.Table) -> None:
    try:
        theirs = json.loads((table.schema.metadata or {})[METADATA])
    except (KeyError, ValueError):
        raise InputError("table: rows without a study are not allowed: rows of a study") from None
    for name in STUDY_SCHEMA.names:
        if name not in table.column_names:
            raise InputError(f"table: rows without {name!r} are not allowed: rows of this edition")
    ours = json.loads(json.dumps(study.metadata))
    for field in ("bank", "held_out"):
        if theirs.get(field) != ours[field]:
            raise InputError(
                f"table: rows of {field} {theirs.get(field)} are not allowed: {ours[field]}"
            )
    for field in ("teachers", "learners"):
        for name in ours[field].keys() & theirs.get(field, {}).keys():
            if theirs[field][name] != ours[field][name]:
                raise InputError(
                    f"table: rows of {field} with another {name!r} are not allowed: "
                    f"{ours[field][name]}"
                )
