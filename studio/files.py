"""Files: output that is written as a whole or not at all, and what a recording begins with."""

import os
import re
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from studio.errors import InputError, RunError


@contextmanager
def replacing(*paths: Path, option: str = "--out") -> Iterator[list[Path]]:
    """Temporary names beside the final ones; the files are moved there when the block succeeds.

    A reader never finds half a file, and old files survive a failure or an interruption. Missing
    folders are made, and removed if the block fails. Whether the files can be written is found out
    before the block begins.

    Args:
        paths: where the files shall be.
        option: by which the user named these paths, for messages.

    Raises:
        InputError: if a path is a folder, or its folder cannot be made or written to.
        RunError: if writing fails, for example because the disk is full.
    """
    made: list[Path] = []
    parts = [path.with_name(f".{path.stem}.{os.getpid()}.part{path.suffix}") for path in paths]
    try:
        for path, part in zip(paths, parts, strict=True):
            _prepare(path, part, made, option)
        yield parts
        for path, part in zip(paths, parts, strict=True):
            part.replace(path)
        made.clear()
    except OSError as error:
        final = {str(part): path for path, part in zip(paths, parts, strict=True)}
        if error.filename is not None and str(error.filename) not in final:
            raise
        name = final.get(str(error.filename), paths[0])
        raise RunError(f"{name}: cannot be written: {error.strerror or error}") from error
    finally:
        for part in parts:
            with suppress(OSError):  # it was never made, or its folder was not
                part.unlink()
        with suppress(OSError):  # a folder that holds something stays
            for folder in reversed(made):
                folder.rmdir()


def _prepare(path: Path, part: Path, made: list[Path], option: str) -> None:
    """Make a path's folder, noting what is made, and the empty temporary file."""
    try:
        missing = [folder for folder in (path.parent, *path.parent.parents) if not folder.exists()]
        for folder in reversed(missing):
            folder.mkdir()
            made.append(folder)
        if path.is_dir():
            raise InputError(f"{option}: {path}: is a folder: the name of a file is needed")
        part.touch()
    except OSError as error:
        raise InputError(f"{option}: {path}: cannot be written: {error.strerror}") from None


def file_name(*words: str) -> str:
    """The name of a file, without an ending, made of words that may have any characters."""
    return "-".join(re.sub(r"[^\w.-]", "_", word) for word in words)


def checked_name(name: str) -> str:
    """The name that a person gives to files, without a folder and without an ending.

    Raises:
        InputError: if files cannot have this name.
    """
    if not name or name != file_name(name) or name.startswith(".") or len(name) > 200:
        raise InputError(
            f"--name: {name[:200]!r} is not allowed: up to 200 letters, digits, dots, - and _, "
            "without a folder, and not beginning with a dot"
        )
    return name


def check_is_recording(path: Path) -> None:
    """Make sure that a file begins like a Rerun recording.

    Raises:
        InputError: if it does not, or cannot be read.
    """
    try:
        with path.open("rb") as file:
            start = file.read(3)
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    if not start:
        raise InputError(f"{path}: is empty: a recording (.rrd) is needed")
    if start != b"RRF":
        raise InputError(f"{path}: is not a recording (.rrd)")
