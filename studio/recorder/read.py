"""Read any recording of the studio, of this edition or an older one."""

from pathlib import Path

from studio.errors import InputError
from studio.recorder import entities, learning_entities
from studio.recorder.contents import read_contents
from studio.recorder.learning import SCHEMA_VERSION as STUDY_VERSION
from studio.recorder.read_scene import SceneRecording, read_scene
from studio.recorder.read_study import StudyRecording, read_study
from studio.recorder.recording import SCHEMA_VERSION as SCENE_VERSION

Recording = SceneRecording | StudyRecording


def read_recording(path: Path) -> Recording:
    """Read a recording.

    Raises:
        InputError: if the file is not a whole recording of the studio, or of a newer edition.
    """
    contents = read_contents(path)
    if contents.application == entities.APPLICATION:
        told = contents.static(entities.SIMULATION, "schema_version")[0]
        _check_version(path, told, SCENE_VERSION)
        return read_scene(contents)
    if contents.application == learning_entities.APPLICATION:
        told = contents.static(learning_entities.STUDY, "schema_version")[0]
        _check_version(path, told, STUDY_VERSION)
        return read_study(contents)
    raise InputError(f"{path}: is a recording of {contents.application!r}, not one of the studio")


def _check_version(path: Path, told: int, newest: int) -> None:
    if not 1 <= told <= newest:
        raise InputError(
            f"{path}: is of edition {told}: this version of the studio reads up to {newest}"
        )
