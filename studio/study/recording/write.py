"""Write what a study found, how learners come to know their teachers, as a Rerun recording.

`recordings/README.md` is the reference of what a recording holds; `SCHEMA_VERSION` counts its
editions.
"""

import hashlib
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import rerun as rr
import tomli_w

from studio.recorder.pages import log_page, package_versions
from studio.recorder.stream import recording_to
from studio.study.again import study_command
from studio.study.links import Links
from studio.study.picture.scales import Scales
from studio.study.recording import entities
from studio.study.recording.blueprint import study_blueprint
from studio.study.recording.calibration import log_calibration
from studio.study.recording.pages import (
    about_study_page,
    scenes_page,
    study_summary_page,
    teacher_page,
)
from studio.study.recording.painted import log_key, log_shapes
from studio.study.recording.plots import log_pair_plot
from studio.study.recording.tables import log_fits, log_tables
from studio.study.results import StudyResults
from studio.study.series import study_plots

SCHEMA_VERSION = 3
"""Edition of the layout that `recordings/README.md` describes."""


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
    plots, scales = study_plots(results), Scales.around(results)
    identity, blueprint = _identity(results, settings), study_blueprint(results, plots)
    with recording_to(path, entities.APPLICATION, identity, blueprint) as stream:
        stream.set_log_tick_enabled(False)
        log_study_properties(stream, results, settings, versions)
        log_fits(stream, results)
        log_tables(stream, results)
        log_key(stream, results)
        for (name, teacher_name), plot in plots.items():
            log_pair_plot(stream, results, entities.curves(teacher_name, name), plot)
        for teacher in results.teachers:
            log_calibration(stream, results, teacher)
            if results.shaped:
                log_shapes(stream, results, teacher, scales)
            for pairs in results.sizes:
                stream.set_time(entities.TIMELINE, sequence=pairs)
                page = teacher_page(results, teacher, pairs)
                log_page(stream, entities.page(teacher.name), page, static=False)
                if results.scenes:
                    page = scenes_page(results, links or {}, teacher, pairs)
                    log_page(stream, entities.scenes_about(teacher.name), page, static=False)
            stream.reset_time()
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


def _identity(results: StudyResults, settings: Mapping[str, Any]) -> str:
    """An id that is the same for the same study: opened twice, it is one recording."""
    made_of = (
        [teacher.description() for teacher in results.teachers],
        results.study,
        results.table.to_pylist(),
        sorted(settings.items()),
    )
    return f"learning-{hashlib.sha256(repr(made_of).encode()).hexdigest()[:12]}"
