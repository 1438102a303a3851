"""Running a study: what is finished is kept in a file, so that the study can be interrupted."""

from pathlib import Path

import pyarrow as pa
import pyarrow.parquet as pq

from learners import InputError, Study, missing_tasks, study_batches, whole_table
from studio.files import replacing
from studio.progress import Progress
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


def write_table(path: Path, table: pa.Table) -> None:
    """Write a table as a Parquet file."""
    pq.write_table(table, path, compression="zstd")
