"""Things that can be asked for by name."""

from collections.abc import Collection, Iterable, Mapping
from typing import TypeVar

from learners.errors import InputError

Thing = TypeVar("Thing")


def check_name(field: str, name: object, known: Collection[str]) -> None:
    """Raise `InputError`, which tells the field and all that is known, if a name is unknown."""
    if name not in known:
        raise InputError(f"{field} {name!r} is not allowed: {', '.join(known)}")


def find(field: str, names: Iterable[Thing | str], known: Mapping[str, Thing]) -> tuple[Thing, ...]:
    """The things of these names; a thing in place of a name stands for itself.

    Raises:
        InputError: if a name is unknown.
    """
    found: list[Thing] = []
    for name in names:
        if isinstance(name, str):
            check_name(field, name, known)
            found.append(known[name])
        else:
            found.append(name)
    return tuple(found)
