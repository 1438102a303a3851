"""Running a study: what is finished is kept in a file, so that the study can be interrupted."""

from collections.abc import Sequence
from pathlib import Path

import pyarrow as pa
import pyarrow.parquet as pq

from learners import (
    STUDY_SCHEMA,
    InputError,
    Study,
    Task,
    missing_tasks,
    study_batches,
    study_tasks,
    whole_table,
)
from studio.files import replacing
from studio.progress import Progress
from studio.recorder.replaced import in_the_way
from studio.study.results import StudyResults


def run_or_resume(study: Study, unfinished: Path, progress: Progress) -> StudyResults:
    """Run a study, from where an interrupted run of it stopped.

    The file `unfinished` keeps the finished rows for whoever continues, and stays; `progress` is
    told after every fit how many of how many are done.

    Raises:
        InputError: if the file cannot be written to.
    """
    parts = finished_rows(study, unfinished)
    for batch in study_batches(study, parts[0] if parts else None, progress=progress):
        parts.append(batch)
        with replacing(unfinished) as [part]:
            write_table(part, whole_table(study, parts))
    return StudyResults(whole_table(study, parts), study.teachers)


def finished_rows(study: Study, unfinished: Path) -> list[pa.Table]:
    """The rows that an interrupted run of this very study left behind, one table or none."""
    try:
        table = pq.read_table(unfinished)
        missing_tasks(study, table)
    except (OSError, pa.ArrowInvalid, InputError):
        return []
    return [table]


def check_loses_no_fits(study: Study, files: Sequence[Path], unfinished: Path) -> None:
    """Make sure that a study replaces no fits but its own.

    A table may be replaced if the study makes every fit of it again: of the same bank and the same
    teachers and learners, with as many pairs and seeds or more.

    Args:
        study: the one to run.
        files: of its table, which comes first, and of what is made from it.
        unfinished: the file in which an interrupted run keeps what it has finished.

    Raises:
        studio.errors.InputError: if one of them holds, or may hold, something else.
    """
    table, *others = files
    if table.exists():
        if not _is_within(study, table):
            raise in_the_way(table, "holds fits that are not of this study")
    else:
        for other in others:
            if other.exists():
                raise in_the_way(other, "is there, but not the table that says of which study")
    if _is_of_this_edition(unfinished) and not _is_within(study, unfinished):
        raise in_the_way(unfinished, "holds what another study finished before it was interrupted")


def _is_within(study: Study, path: Path) -> bool:
    """Whether a study makes every fit that a table holds."""
    tasks = study_tasks(study)
    return any(
        set(map(Task, *(rows[name].to_pylist() for name in Task._fields))) <= {*tasks}
        for rows in finished_rows(study, path)
    )


def _is_of_this_edition(path: Path) -> bool:
    """Whether a file is a table as this version of the studio writes it, of whichever study."""
    try:
        return set(STUDY_SCHEMA.names) <= set(pq.read_schema(path).names)
    except (OSError, pa.ArrowInvalid):
        return False


def write_table(path: Path, table: pa.Table) -> None:
    """Write a table as a Parquet file."""
    pq.write_table(table, path, compression="zstd")
