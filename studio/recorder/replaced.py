"""What a recording may replace: itself, and nothing else unless a person says so."""

import warnings
from collections.abc import Sequence
from pathlib import Path

from rerun.chunk import RrdReader
from rerun.error_utils import RerunWarning

from studio.errors import InputError


def check_same_recording(files: Sequence[Path], new: Path) -> None:
    """Make sure that files which are there already are of the very recording that replaces them.

    Recordings are the same if they have the same id, which their kind makes of all that they come
    from: scene, seed, settings.

    Args:
        files: of the recording, which comes first, and of what is painted from it.
        new: the recording that shall go there.

    Raises:
        InputError: if one of the files is, or may be, of something else.
    """
    recording, *painted = files
    if recording.exists():
        if _id_in(recording) != _id_in(new):
            raise in_the_way(recording, "is of another scene or other settings")
        return
    for picture in painted:
        if picture.exists():
            raise in_the_way(picture, "is there, but not the recording that says what it shows")


def in_the_way(path: Path, why: str) -> InputError:
    """The error to raise where a file would be replaced that may be of something else."""
    return InputError(f"{path}: {why}: --name gives the new files another name, --force replaces")


def _id_in(path: Path) -> tuple[str, str] | None:
    """The ids of application and recording in a file; None if it is no whole recording."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error", RerunWarning)
            [entry] = RrdReader(path).recordings()
    except (OSError, RuntimeError, ValueError, RerunWarning):
        return None
    return entry.application_id, entry.recording_id
