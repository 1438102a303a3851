"""Running a study: every learner is fitted to every teacher's answers and put to the test.

The seed of a task decides the split of the scenes, the pairs and what is random in the answers.
Every teacher is asked the same questions, and a longer series of them begins with the shorter one.
A row depends on its own task only, not on what else is studied or when, so a study that was
interrupted continues where it stopped.
"""

import os
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from itertools import groupby
from typing import Any

import numpy as np
import pyarrow as pa

from learners.arrays import FloatArray
from learners.asking.preferences import answer, sample_pairs
from learners.asking.prospects import Prospects
from learners.fitting.fits import Learner
from learners.fitting.registry import find_learners
from learners.judging.teachers import Teacher, find_teachers
from learners.studying.evaluation import evaluate
from learners.studying.plan import SIZES, Study, Task, study_tasks
from learners.studying.split import HELD_OUT, split_scenes
from learners.studying.table import PARAMETER_COLUMNS, missing_tasks, study_schema, whole_table

Progress = Callable[[int, int], None]
"""A function that is told after every fit how many are done, and how many there are in all."""


def study_batches(
    study: Study,
    table: pa.Table | None = None,
    workers: int | None = None,
    progress: Progress | None = None,
) -> Iterator[pa.Table]:
    """Do the fits that are missing and hand over their rows, a batch for each number of pairs.

    The table, workers and progress are those of `run_study`.

    Raises:
        InputError: if the table is not of this study.
    """
    missing = missing_tasks(study, table)
    total = len(study_tasks(study))
    done = total - len(missing)
    schema = study_schema(study)  # finds the truths, too, so that no thread does it again
    with ThreadPoolExecutor(workers or os.cpu_count()) as pool:
        for _, tasks in groupby(missing, key=lambda task: task.pairs):
            rows = []
            for row in pool.map(lambda task: _row(study, task), list(tasks)):
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
        teachers: the teachers to learn from, or their names in `TEACHERS`.
        learners: the learners to fit, or their names in `LEARNERS`.
        sizes: numbers of pairs to learn from.
        seeds: how many repetitions.
        held_out: share of the scenes that is kept back for the test.
        table: the rows that an interrupted study has already.
        workers: how many fits to do at a time; one per processor if left out.
        progress: told how many of the fits are done.

    Raises:
        InputError: if something cannot be studied, or the table is of another study.
    """
    who, fitted = find_teachers(teachers), find_learners(learners)
    study = Study(prospects, who, fitted, tuple(sizes), seeds, held_out)
    batches = list(study_batches(study, table, workers, progress))
    return whole_table(study, batches if table is None else [table, *batches])


def _row(study: Study, task: Task) -> dict[str, Any]:
    teacher = next(t for t in study.teachers if t.name == task.teacher)
    learner = next(le for le in study.learners if le.name == task.learner)
    truth = study.truths[teacher.name]
    split = split_scenes(study.prospects, task.seed, study.held_out)
    pairs = sample_pairs(study.prospects, task.pairs, task.seed, split.training)
    preferences = answer(truth, pairs, teacher.beta, task.seed)
    fit = learner.fit(study.prospects, preferences, teacher.beta)
    learnt = fit.values(study.prospects.features[split.held_out])
    test = evaluate(learnt, truth[split.held_out], teacher.beta)
    numbers = fit.parameters.numbers if fit.parameters else [None] * len(PARAMETER_COLUMNS)
    return {
        **task._asdict(),
        "regret": test.regret,
        "regret_percent": test.regret_percent,
        "nll": test.nll,
        "certainty": preferences.certainty,
        "theta": fit.theta.tolist(),
        **dict(zip(PARAMETER_COLUMNS, numbers, strict=True)),
        "reference": fit.reference,
        "theta_unit": fit.unit_theta.tolist(),
        "theta_cosine": _cosine(fit.theta, np.array(teacher.reward)),
        "agreement": test.agreement,
        "nll_teacher": test.nll_teacher,
        "nll_training": fit.nll,
        "repeated": preferences.repeated,
        "converged": fit.converged,
        "steps": fit.steps,
        "expected_decrease": fit.expected_decrease,
        "calibration_count": test.calibration.count.tolist(),
        "calibration_predicted": _null_where_nan(test.calibration.predicted),
        "calibration_preferred": _null_where_nan(test.calibration.preferred),
        "held_out_scenes": study.prospects.scenes[split.held_out].tolist(),
        "scene_regret": test.scene_regret.tolist(),
        "scene_picks": [study.prospects.actions[place] for place in test.scene_picks],
    }


def _cosine(one: FloatArray, other: FloatArray) -> float:
    lengths = float(np.sqrt((one**2).sum() * (other**2).sum()))
    return float((one * other).sum()) / lengths if lengths > 0.0 else 0.0


def _null_where_nan(numbers: FloatArray) -> list[float | None]:
    return [None if np.isnan(number) else number for number in numbers.tolist()]
