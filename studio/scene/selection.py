"""Some of the actions that a scene was simulated under."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from scenes import Rollouts
from studio.errors import InputError

_BY_ACTION = (
    "robot",
    "pedestrians",
    "features",
    "clearance_m",
    "deviation_m",
    "progress_m",
    "person_step",
    "wall_step",
)
"""The arrays of rollouts whose first axis is the actions."""


def places_of(names: Sequence[str], known: Sequence[str]) -> list[int]:
    """Where actions of these names stand among the known ones.

    Raises:
        InputError: if there is no such action.
    """
    for name in names:
        if name not in known:
            raise InputError(f"action: {name!r} is not there: {', '.join(known)}")
    return [known.index(name) for name in names]


def only(rollouts: Rollouts, names: Sequence[str]) -> Rollouts:
    """The rollouts under the actions of these names alone, in the order of the names.

    Its arrays are read-only copies; what does not depend on the action is shared.

    Raises:
        InputError: if no name is given, one is given twice, or there is no such action.
    """
    known = rollouts.names
    if not names:
        raise InputError(f"actions: none given, at least one is needed: {', '.join(known)}")
    places = places_of(names, known)
    if len(set(names)) < len(names):
        raise InputError(f"actions: {', '.join(names)}: each can be taken once")
    taken: dict[str, Any] = {field: getattr(rollouts, field)[places] for field in _BY_ACTION}
    for array in taken.values():
        array.setflags(write=False)
    actions = tuple(rollouts.actions[place] for place in places)
    return replace(rollouts, actions=actions, **taken)
