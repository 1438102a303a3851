"""Output files that are whole or not there."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from studio.errors import InputError


def writable_folder(folder: Path, option: str) -> Path:
    """Make sure that files can be written to a folder, creating it if need be.

    Args:
        folder: the folder.
        option: what the user calls it, for the message.

    Raises:
        InputError: if it cannot be created or written to.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"{option}: {folder}: cannot be created: {error.strerror}") from None
    if not os.access(folder, os.W_OK | os.X_OK):
        raise InputError(f"{option}: {folder}: cannot be written to: permission denied")
    return folder


@contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """A temporary name beside the final one, moved into place only when the block succeeds.

    A reader never finds half a file, and an old file survives a failure or an interruption.
    """
    part = path.with_name(f".{path.stem}.{os.getpid()}.part{path.suffix}")
    try:
        yield part
        part.replace(path)
    finally:
        part.unlink(missing_ok=True)
