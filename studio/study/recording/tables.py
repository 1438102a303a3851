"""The numbers of a recording of a study: every fit to be read back, and tables to be looked at."""

from typing import Any

import numpy as np
import pyarrow as pa
import rerun as rr
from numpy.typing import NDArray

from learners import PARAMETER_COLUMNS
from studio.recorder.plots import log_rows
from studio.study.fits import Row
from studio.study.recording import entities
from studio.study.results import StudyResults
from studio.study.rows import learner_rows, scene_rows

_NAMED = ("teacher", "learner", "pairs")  # columns that entity path and time tell
_WHOLE = ("seed", "repeated", "steps", "calibration_count", "held_out_scenes")  # whole numbers
_QUALITIES = ("regret_percent", "agreement", "theta_cosine", "nll")
_OF_FITS = (*_NAMED, "seed", *_QUALITIES, *PARAMETER_COLUMNS)  # columns of the table of fits
_DECIMALS = 3  # of the numbers in tables; those of the fits are exact


def log_fits(stream: rr.RecordingStream, results: StudyResults) -> None:
    """Keep the columns of every fit, with those of one teacher, learner and size together."""
    for teacher in results.teachers:
        for learner in results.learners:
            for pairs in results.sizes:
                rows = results.fits_of(teacher, learner, pairs)
                if not rows:
                    continue
                fits: dict[str, Any] = {
                    column: np.concatenate([_numbers(column, row[column]) for row in rows])
                    for column, first in rows[0].items()
                    if column not in _NAMED and first is not None
                }
                stream.set_time(entities.TIMELINE, sequence=pairs)
                stream.log(entities.fits(teacher.name, learner), rr.AnyValues(**fits))
    stream.reset_time()


def _numbers(column: str, given: Any) -> NDArray[Any]:
    """What one row has in a column, as one array; nothing (null) is not a number."""
    if isinstance(given, bool) or column == "scene_picks":
        return np.atleast_1d(given)
    return np.atleast_1d(np.array(given, dtype=np.int64 if column in _WHOLE else np.float64))


def log_tables(stream: rr.RecordingStream, results: StudyResults) -> None:
    """Add tables of the learners' means with their intervals, of all fits, and of the scenes."""
    fits = [{column: fit[column] for column in _OF_FITS} for fit in results.fits]
    tables = {
        entities.LEARNER_TABLE: list(learner_rows(results)),
        entities.FIT_TABLE: fits,
        entities.SCENE_TABLE: list(scene_rows(results)),
    }
    for path, rows in tables.items():
        if rows:
            log_rows(stream, path, entities.ROWS, _columns(rows))


def _columns(rows: list[Row]) -> dict[str, NDArray[Any]]:
    """The columns of rows, with their numbers rounded; those without any number are left out."""
    columns = {}
    for name, column in zip(rows[0], pa.Table.from_pylist(rows).columns, strict=True):
        if pa.types.is_floating(column.type):
            columns[name] = np.round(column.to_numpy(), _DECIMALS)
        elif not pa.types.is_null(column.type):
            columns[name] = np.array(column.to_pylist())
    return columns
