"""Read a study back from its recording: the table of its fits, and who was learned from."""

import tomllib
from typing import Any

import pyarrow as pa

from learners import STUDY_SCHEMA, CptParameters, Teacher
from learners.studying.table import METADATA
from studio.recorder.contents import Contents
from studio.study.fits import Row
from studio.study.recording import entities
from studio.study.results import StudyResults


def read_study(contents: Contents) -> StudyResults:
    """Read back what came of a study.

    Columns that an older edition does not have are missing from the table, too.

    Raises:
        InputError: if something is missing.
        ValueError: if something is not as the studio writes it; TypeError, KeyError and IndexError
            mean the same.
    """
    teachers = _teachers(contents)
    learners = contents.static(entities.STUDY, "learners").tolist()
    rows = []
    for teacher in teachers:
        for learner in learners:
            entity = f"/{entities.fits(teacher.name, learner)}"
            for row in contents.rows(entity, entities.TIMELINE):
                rows += _fits(teacher.name, learner, row)
    # as in the study: from few pairs to many, and the seeds of a fit one after another
    rows.sort(key=lambda row: int(row["pairs"]))
    named = set().union(*rows) if rows else set(STUDY_SCHEMA.names)
    schema = pa.schema([field for field in STUDY_SCHEMA if field.name in named])
    told = contents.text(entities.STUDY, "study")
    table = pa.Table.from_pylist(rows, schema.with_metadata({METADATA: told}))
    return StudyResults(table, teachers)


def _teachers(contents: Contents) -> tuple[Teacher, ...]:
    told: dict[str, dict[str, Any]] = tomllib.loads(contents.text(entities.STUDY, "teachers"))
    for description in told.values():
        description["parameters"] = CptParameters(**description["parameters"])
        description["reward"] = tuple(description["reward"])
    return tuple(Teacher(**description) for description in told.values())


def _fits(teacher: str, learner: str, row: Row) -> list[Row]:
    """The rows of the table that one row of the recording holds, one a seed."""
    seeds = row["seed"]
    fits: list[Row] = [
        {field.name: None for field in STUDY_SCHEMA if field.nullable}
        | {"teacher": teacher, "learner": learner, "pairs": row[entities.TIMELINE], "seed": seed}
        for seed in seeds
    ]
    for field in STUDY_SCHEMA:
        given = row.get(field.name)
        if given is None or field.name in (entities.TIMELINE, "seed"):
            continue
        share = len(given) // len(seeds)
        for place, fit in enumerate(fits):
            part = given[place * share : (place + 1) * share]
            if pa.types.is_list(field.type):
                # a bin without predictions has no mean
                fit[field.name] = [None if number != number else number for number in part]
            else:
                (fit[field.name],) = part
    return fits
