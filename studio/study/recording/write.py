"""Write what a study found, how learners come to know their teachers, as a Rerun recording.

`recordings/README.md` is the reference of what a recording holds; `SCHEMA_VERSION` counts its
editions.
"""

import hashlib
import json
from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import rerun as rr
import tomli_w
from numpy.typing import NDArray

from learners import Teacher
from studio.recorder.drawing import log_ground, y_upwards
from studio.recorder.pages import log_page, package_versions
from studio.recorder.stream import recording_to
from studio.study.links import Links
from studio.study.recording import entities
from studio.study.recording.blueprint import study_blueprint
from studio.study.recording.calibration import log_calibration
from studio.study.recording.curves import (
    AGREEMENT_CURVES,
    LIKELIHOOD_CURVES,
    REGRET_CURVES,
    log_curve_figure,
)
from studio.study.recording.families import log_families, log_family_numbers
from studio.study.recording.minds import log_minds
from studio.study.recording.over_pairs import each_size, log_changing_page, sides
from studio.study.recording.pages import (
    about_study_page,
    study_command,
    study_summary_page,
    teacher_page,
)
from studio.study.recording.scenes import scenes_page
from studio.study.results import CURVE_COLUMNS, StudyResults

SCHEMA_VERSION = 2
"""Edition of the layout that `recordings/README.md` describes."""

_NAMED = ("teacher", "learner", "pairs")  # columns that entity path and time tell
_WHOLE = ("seed", "repeated", "steps", "calibration_count", "held_out_scenes")  # whole numbers


def write_study_recording(
    path: Path,
    results: StudyResults,
    settings: Mapping[str, str | float | bool],
    links: Links | None = None,
) -> None:
    """Write a recording of a study.

    Args:
        path: the `.rrd` file to write.
        results: of the study; teachers without fits are left out.
        settings: what else the recording shall say about itself, kept as its property
            `settings`; `outcomes`, the bank, goes into the command that makes it again.
        links: the recordings of scenes of the study to which the pages link.

    Raises:
        OSError: if the file cannot be written.
    """
    results = results.among(results.taught)
    versions = package_versions()
    identity, blueprint = _identity(results, settings), study_blueprint(results)
    with recording_to(path, entities.APPLICATION, identity, blueprint) as stream:
        stream.set_log_tick_enabled(False)
        log_study_properties(stream, results, settings, versions)
        log_ground(stream)
        stream.log(entities.FIGURES, y_upwards(), static=True)
        for teacher in results.teachers:
            for kind in (REGRET_CURVES, AGREEMENT_CURVES, LIKELIHOOD_CURVES):
                log_curve_figure(stream, results, teacher, kind)
            log_minds(stream, results, teacher)
            log_calibration(stream, results, teacher)
            log_numbers(stream, results, teacher)
            log_changing_page(
                stream,
                results,
                entities.page(teacher.name),
                partial(teacher_page, results, teacher),
            )
            if results.scenes:
                log_families(stream, results, teacher)
                log_family_numbers(stream, results, teacher)
        if results.scenes:
            page = partial(scenes_page, results, links or {})
            log_changing_page(stream, results, entities.SCENES, page)
        log_page(stream, entities.SUMMARY, study_summary_page(results))
        log_page(stream, entities.ABOUT, about_study_page(results, settings, versions))


def log_study_properties(
    stream: rr.RecordingStream,
    results: StudyResults,
    settings: Mapping[str, Any],
    versions: Mapping[str, str],
) -> None:
    """Name the recording and say what is needed to make it again."""
    stream.send_recording_name(
        f"learning from {', '.join(teacher.name for teacher in results.teachers)}"
    )
    teachers = {teacher.name: teacher.description() for teacher in results.teachers}
    stream.send_property(
        "study",
        rr.AnyValues(
            schema_version=SCHEMA_VERSION,
            command=study_command(results, settings),
            teachers=tomli_w.dumps(teachers),
            learners=list(results.learners),
            pairs=list(results.sizes),
            seeds=results.seeds,
            study=json.dumps(results.study, sort_keys=True),
            versions=tomli_w.dumps(versions),
        ),
    )
    if settings:
        stream.send_property("settings", rr.AnyValues(**settings))


def log_numbers(stream: rr.RecordingStream, results: StudyResults, teacher: Teacher) -> None:
    """Keep the numbers of every fit, and of the curves their mean, std and interval."""
    for pairs in each_size(stream, results):
        for learner in results.learners:
            rows = results.fits_of(teacher, learner, pairs)
            if not rows:
                continue
            fits: dict[str, Any] = {
                column: np.concatenate([_numbers(column, row[column]) for row in rows])
                for column, first in rows[0].items()
                if column not in _NAMED and first is not None
            }
            stream.log(entities.fits(teacher.name, learner), rr.AnyValues(**fits))
            spreads: dict[str, Any] = {
                column: np.array(sides(spread)).ravel()
                for column in CURVE_COLUMNS
                if (spread := results.spread(column, teacher, learner, pairs))
            }
            stream.log(entities.curves(teacher.name, learner), rr.AnyValues(**spreads))


def _numbers(column: str, given: Any) -> NDArray[Any]:
    """What one row has in a column, as one array; nothing (null) is not a number."""
    if isinstance(given, bool) or column == "scene_picks":
        return np.atleast_1d(given)
    return np.atleast_1d(np.array(given, dtype=np.int64 if column in _WHOLE else np.float64))


def _identity(results: StudyResults, settings: Mapping[str, Any]) -> str:
    """An id that is the same for the same study: opened twice, it is one recording."""
    made_of = (
        [teacher.description() for teacher in results.teachers],
        results.study,
        results.table.to_pylist(),
        sorted(settings.items()),
    )
    return f"learning-{hashlib.sha256(repr(made_of).encode()).hexdigest()[:12]}"
