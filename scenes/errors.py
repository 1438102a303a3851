"""What is raised when the caller's input is wrong."""

from pathlib import Path

LARGEST_SEED = 2**63 - 1
"""Largest seed: seeds fit the 64-bit whole numbers of Parquet and of recordings."""


class InputError(ValueError):
    """The caller gave something that cannot be used.

    The message is one line that names the field, what was given and what is allowed.
    """


def checked_text(file: Path, encoding: str, problem: str = "cannot be read") -> str:
    """The text of a file.

    Raises:
        InputError: if it cannot be read; the message states the problem and says why.
    """
    try:
        return file.read_text(encoding)
    except OSError as error:
        raise InputError(f"{file}: {problem}: {error.strerror}") from None
    except UnicodeDecodeError:
        raise InputError(f"{file}: {problem}: not UTF-8 text") from None


def check_whole(field: str, value: int, least: int, most: int) -> None:
    """Make sure that a number is whole and in range.

    Raises:
        InputError: if it is not.
    """
    try:
        allowed = least <= value.__index__() <= most
    except (AttributeError, TypeError):
        raise InputError(f"{field}: {value!r} is not allowed: a whole number is needed") from None
    if not allowed:
        raise InputError(f"{field}: {value} is not allowed: {least} to {most}")
