"""A study's table without a study, as quick to make as it is small."""

import itertools
import json
from collections.abc import Sequence
from typing import Any

import numpy as np
import pyarrow as pa

from learners import PARAMETER_COLUMNS, STUDY_SCHEMA, TEACHERS, Teacher, unit_vector
from studio.study.results import StudyResults

THREE = tuple(TEACHERS.values())
FAMILIES = ("doorway", "open")
RANDOM_REGRET = {"doorway": 0.05, "open": 0.052}
"""What a random action costs any teacher in a family of scenes, on average."""


def study_fit(
    rng: np.random.Generator, teacher: Teacher, learner: str, pairs: int, seed: int
) -> dict[str, Any]:
    """A fit that errs by an amount that shrinks with the number of pairs."""
    error = 1.0 / np.sqrt(pairs)
    reward = np.array(teacher.reward)
    theta = reward * np.exp(error * rng.standard_normal(len(reward)))
    learnt = np.array(teacher.parameters.numbers) * np.exp(error * rng.uniform(0.5, 1.5, 5))
    parameters = learnt.tolist() if learner != "eu" else [None] * 5
    regret = (60.0 if learner == "eu" else 100.0) / pairs * np.exp(0.3 * rng.standard_normal())
    scene_regret = np.where(rng.random(6) < 0.5, error * rng.uniform(0.0, 0.1, 6), 0.0)
    return {
        "teacher": teacher.name,
        "learner": learner,
        "pairs": pairs,
        "seed": seed,
        "regret": regret / 1000.0,
        "regret_percent": regret,
        "nll": 0.4 + error * rng.uniform(),
        "certainty": 0.8,
        "theta": theta.tolist(),
        **dict(zip(PARAMETER_COLUMNS, parameters, strict=True)),
        "reference": 0.0,
        "theta_unit": unit_vector(theta).tolist(),
        "theta_cosine": 1.0 - error,
        "agreement": 1.0 - 0.4 * error * rng.uniform(),
        "nll_teacher": 0.4,
        "nll_training": 0.3,
        "repeated": 0,
        "converged": True,
        "steps": 9,
        "expected_decrease": 1e-9,
        "calibration_count": [0, *rng.integers(1, 20, 9).tolist()],
        "calibration_predicted": [None, *np.linspace(0.15, 0.95, 9).tolist()],
        "calibration_preferred": [None, *np.linspace(0.25, 0.85, 9).tolist()],
        "held_out_scenes": sorted(np.random.default_rng(seed).permutation(12)[:6].tolist()),
        "scene_regret": scene_regret.tolist(),
        "scene_picks": ["stop" if cost == 0.0 else "forward" for cost in scene_regret],
    }


def study_table(
    teachers: Sequence[Teacher] = THREE,
    learners: Sequence[str] = ("eu", "cpt"),
    sizes: Sequence[int] = (25, 200, 2000),
    seeds: int = 3,
    **columns: Any,
) -> pa.Table:
    """A whole table; what is given of columns stands in every row."""
    rng = np.random.default_rng(0)
    tasks = itertools.product(sizes, teachers, learners, range(seeds))
    rows = [
        study_fit(rng, teacher, learner, pairs, seed) | columns
        for pairs, teacher, learner, seed in tasks
    ]
    scenes = [
        {
            "scene": number,
            "family": FAMILIES[number % 2],
            "pattern": "mixed",
            "best": {teacher.name: "stop" for teacher in teachers},
            "random_regret": {teacher.name: 0.04 + 0.002 * number for teacher in teachers},
        }
        for number in range(12)
    ]
    study = {
        "bank": "abc",
        "held_out": 0.25,
        "learners": {"eu": {"name": "eu", "deviation": 1}},
        "scenes": scenes,
    }
    metadata = {"prospect_study": json.dumps(study)}
    return pa.Table.from_pylist(rows, schema=STUDY_SCHEMA.with_metadata(metadata))


def study_of(teachers: tuple[Teacher, ...] = THREE, *more: Any, **options: Any) -> StudyResults:
    """What comes of the table that `study_table` makes of the same arguments."""
    return StudyResults(study_table(teachers, *more, **options), teachers)


def table_with_a_gap() -> pa.Table:
    """A table of one size and seed in which one regret of a doorway, of EU from EU, is unknown."""
    table = study_table(sizes=(25,), seeds=1)
    first, *rest = table.to_pylist()
    doorway = [number % 2 for number in first["held_out_scenes"]].index(0)
    first["scene_regret"][doorway] = first["regret_percent"] = float("nan")
    return pa.Table.from_pylist([first, *rest], schema=table.schema)
