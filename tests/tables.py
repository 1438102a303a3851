"""Tables as a study writes them, made up without a fit."""

import json
from collections.abc import Callable, Sequence
from itertools import product
from typing import Any

import pyarrow as pa

from learners import PARAMETER_COLUMNS, STUDY_SCHEMA, TEACHERS, Teacher, unit_vector

SCENES = 12
BINS = 10
FAMILIES = ("doorway", "open")

Columns = Callable[[Teacher, str, int, int], dict[str, Any]]
"""From teacher, learner, number of pairs and seed to the columns that a test is about."""


def study_table(
    columns: Columns = lambda *_: {},
    teachers: Sequence[Teacher] = tuple(TEACHERS.values()),
    learners: Sequence[str] = ("eu", "cpt"),
    sizes: Sequence[int] = (25, 100),
    seeds: int = 3,
) -> pa.Table:
    """A table of the study's schema and metadata; learners know their teachers unless told not."""
    rows = [
        perfect_fit(teacher, learner, pairs, seed) | columns(teacher, learner, pairs, seed)
        for pairs, teacher, learner, seed in product(sizes, teachers, learners, range(seeds))
    ]
    told = {
        "bank": "abc",
        "held_out": 0.5,
        "teachers": {teacher.name: teacher.description() for teacher in teachers},
        "learners": {learner: {"name": learner} for learner in learners},
        "scenes": [
            {
                "scene": scene,
                "family": FAMILIES[scene % len(FAMILIES)],
                "pattern": "mixed",
                "best": {teacher.name: "stop" for teacher in teachers},
                "random_regret": {teacher.name: 0.04 + 0.002 * scene for teacher in teachers},
            }
            for scene in range(SCENES)
        ],
    }
    schema = STUDY_SCHEMA.with_metadata({"prospect_study": json.dumps(told)})
    return pa.Table.from_pylist(rows, schema=schema)


def perfect_fit(teacher: Teacher, learner: str, pairs: int, seed: int) -> dict[str, Any]:
    """The row of a learner who knows the teacher; every other scene is held out."""
    numbers = [None] * len(PARAMETER_COLUMNS) if learner == "eu" else teacher.parameters.numbers
    held_out = list(range(seed % 2, SCENES, 2))
    predicted = [(place + 0.5) / BINS for place in range(BINS)]
    return {
        "teacher": teacher.name,
        "learner": learner,
        "pairs": pairs,
        "seed": seed,
        "regret": 0.0,
        "regret_percent": 0.0,
        "nll": 0.4,
        "certainty": 0.8,
        "theta": list(teacher.reward),
        **dict(zip(PARAMETER_COLUMNS, numbers, strict=True)),
        "reference": 0.0,
        "theta_unit": unit_vector(teacher.reward).tolist(),
        "theta_cosine": 1.0,
        "agreement": 1.0,
        "nll_teacher": 0.4,
        "nll_training": 0.3,
        "repeated": 0,
        "converged": True,
        "steps": 9,
        "expected_decrease": 1e-9,
        "calibration_count": [10] * BINS,
        "calibration_predicted": predicted,
        "calibration_preferred": predicted,
        "held_out_scenes": held_out,
        "scene_regret": [0.0] * len(held_out),
        "scene_picks": ["stop"] * len(held_out),
    }
