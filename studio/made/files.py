"""The files of a recording: itself, and the picture and film that are painted from it."""

from __future__ import annotations

from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from studio.files import replacing

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from studio.progress import Quiet
    from studio.recording import Excerpt, Look, Recording


def files_of(stem: Path, png: bool, mp4: bool) -> tuple[Path, ...]:
    """The recording of this path without an ending, and the picture and film that are wanted."""
    suffixes = [".rrd", *([".png"] if png else []), *([".mp4"] if mp4 else [])]
    return tuple(stem.with_name(f"{stem.name}{suffix}") for suffix in suffixes)


@contextmanager
def recording_into(files: Sequence[Path], force: bool, progress: Quiet) -> Iterator[Path]:
    """Where the block writes a recording, which all files are there of once it has succeeded.

    The pictures are painted from what was just recorded, not from what was simulated: the
    picture is the data.

    Args:
        files: of the recording, see `files_of`.
        force: whether they may replace files of something else.
        progress: told how far a film is.

    Raises:
        InputError: if they cannot be written, or would replace files of something else.
    """
    with replacing(*files) as [part, *pictures]:
        yield part
        if not force:
            from studio.recorder.replaced import check_same_recording

            check_same_recording(files, part)
        if pictures:
            from studio.kinds import read_recording

            paint(pictures, read_recording(part), progress)


def paint(
    parts: Sequence[Path],
    recording: Recording,
    progress: Quiet,
    look: Look | None = None,
    excerpt: Excerpt | None = None,
) -> None:
    """Paint a recording into files, and tell how far a film is."""
    from studio.recording import write_picture

    for part in parts:
        if part.suffix == ".png":
            write_picture(part, recording, look, excerpt)
        else:
            with progress.steps("film") as done:
                write_picture(part, recording, look, excerpt, done)
