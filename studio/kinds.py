"""Read any recording of the studio, of this edition or an older one."""

from pathlib import Path

from studio.comparison.recording.read import ComparisonRecording, read_comparison
from studio.errors import InputError
from studio.recorder.contents import Contents, read_contents
from studio.scene.recording import entities
from studio.scene.recording.read import SceneRecording, read_scene
from studio.scene.recording.write import SCHEMA_VERSION
from studio.study.recording import entities as learning_entities
from studio.study.recording.read import StudyRecording, read_study
from studio.study.recording.write import SCHEMA_VERSION as STUDY_VERSION

Recording = SceneRecording | ComparisonRecording | StudyRecording


def read_recording(path: Path) -> Recording:
    """Read a recording.

    Raises:
        InputError: if the file is not a whole recording of the studio, or of a newer edition.
    """
    contents = read_contents(path)
    try:
        return _read(contents)
    except InputError:
        raise
    except (ValueError, TypeError, KeyError, IndexError) as error:
        # what a room refuses says what is wrong with it
        raise contents.damaged(str(error)) from None


def _read(contents: Contents) -> Recording:
    if contents.application == entities.APPLICATION:
        _check_version(contents, entities.SIMULATION, SCHEMA_VERSION)
        return read_scene(contents)
    if contents.application == entities.COMPARISON_APPLICATION:
        _check_version(contents, entities.SIMULATION, SCHEMA_VERSION)
        return read_comparison(contents)
    if contents.application == learning_entities.APPLICATION:
        _check_version(contents, learning_entities.STUDY, STUDY_VERSION)
        return read_study(contents)
    raise InputError(
        f"{contents.path}: is a recording of {contents.application!r}, not one of the studio"
    )


def _check_version(contents: Contents, entity: str, newest: int) -> None:
    told = int(contents.static(entity, "schema_version")[0])
    if not 1 <= told <= newest:
        raise InputError(
            f"{contents.path}: is of edition {told}: this version of the studio reads 1 to {newest}"
        )
