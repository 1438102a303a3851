"""Teachers as a person names them on the command line."""

from collections.abc import Iterable, Sequence
from dataclasses import replace

from learners import CptParameters, Teacher, find_teachers
from studio.errors import InputError


def read_teachers(
    names: Iterable[str], profiles: Sequence[str], beta: float | None
) -> tuple[Teacher, ...]:
    """The teachers of these names, then those of one's own.

    Args:
        names: names of `learners.TEACHERS`.
        profiles: teachers of one's own, each written as its name, `=`, and the numbers of its
            `CptParameters` in their order, with commas between them.
        beta: how decided all of them are; left out, as decided as they are by themselves.

    Raises:
        InputError: if a profile cannot be read; `learners.InputError` if a name is unknown or a
            number is not allowed.
    """
    teachers = [*find_teachers(tuple(names)), *map(_own, profiles)]
    return tuple(teachers if beta is None else (replace(t, beta=beta) for t in teachers))


def _own(profile: str) -> Teacher:
    name, _, listed = profile.partition("=")
    try:
        given = zip(CptParameters.SYMBOLS, listed.split(","), strict=True)
        numbers = [float(number) for _, number in given]
    except ValueError:
        wanted = f"NAME={','.join(CptParameters.SYMBOLS)}"
        raise InputError(f"--profile: {profile!r} is not a profile: {wanted}") from None
    return Teacher(name, CptParameters(*numbers))
