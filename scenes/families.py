"""Generated scenes: four families of place, six patterns of how people meet in them.

Everything is drawn from a seed and a number: a seed names an endless series of scenes, and each of
them can be made again without the others. The robot starts on the left, already driving, and faces
right, towards its goal; the people it will meet are a few seconds away. Places are made for the
social force model, which has no path planning: everyone walks straight at the goal. So whoever must
pass a door has a goal straight behind it, and goals are so far away that nobody arrives.
"""

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from types import MappingProxyType

from scenes.casts import CASTS, gather
from scenes.errors import LARGEST_SEED, InputError, check_whole
from scenes.places import PLACES
from scenes.scene import LARGEST_NUMBER, Scene
from scenes.streams import scene_stream


@dataclass(frozen=True)
class Family:
    """A kind of place."""

    description: str  # what it looks like, in one line
    patterns: tuple[str, ...]  # how people can meet there; the first is taken if none is asked for


PATTERNS: Mapping[str, str] = MappingProxyType(
    {
        "head_on": "people come towards the robot",
        "overtaking": "slow people ahead walk the robot's way, faster ones come from behind",
        "crossing": "people cross the robot's path from both sides",
        "group_blocking": "a group abreast, walking or standing, is in the robot's way",
        "bottleneck": "people from both sides and the robot want through one opening",
        "mixed": "some come, some cross, some walk the robot's way, some stand",
    }
)
"""How people meet, and what that looks like in one line."""

FAMILIES: Mapping[str, Family] = MappingProxyType(
    {
        "corridor": Family(
            "a straight corridor between two long walls",
            ("head_on", "overtaking", "group_blocking", "mixed"),
        ),
        "intersection": Family(
            "two corridors that cross at a right angle",
            ("crossing", "head_on", "group_blocking", "mixed"),
        ),
        "doorway": Family(
            "a room that a wall with one opening divides",
            ("bottleneck", "head_on", "group_blocking", "mixed"),
        ),
        "open": Family(
            "a square without walls",
            ("mixed", "head_on", "overtaking", "crossing", "group_blocking"),
        ),
    }
)


def load_scene(
    family_or_name: str, pattern: str | None = None, seed: int = 0, number: int = 0
) -> Scene:
    """Draw a scene.

    Args:
        family_or_name: one of `FAMILIES`, for example "doorway".
        pattern: one of the family's patterns; None takes the first of them, which shows the family
            best ("doorway" alone is two-way traffic through the opening).
        seed: seed of the series, 0 to 2**63 - 1.
        number: which scene of the series, 0 to 2**31 - 1.

    Returns:
        The scene; its name is the family's. The same arguments give the same scene, whatever was
        drawn before.

    Raises:
        InputError: if there is no such family, the family has no such pattern, or a number is out
            of range.
    """
    _check_known("family", family_or_name, FAMILIES)
    patterns = FAMILIES[family_or_name].patterns
    pattern = patterns[0] if pattern is None else pattern
    if pattern not in patterns:
        raise InputError(
            f"pattern: {family_or_name} has no pattern {pattern!r}: choose from "
            f"{', '.join(patterns)}"
        )
    check_whole("seed", seed, 0, LARGEST_SEED)
    check_whole("number", number, 0, LARGEST_NUMBER)
    rng = scene_stream(seed, number)
    place = PLACES[family_or_name](rng)
    people, groups = gather(rng, place, CASTS[pattern](rng))
    return Scene(
        name=family_or_name,
        robot=place.robot,
        pedestrians=people,
        walls=place.walls,
        groups=groups,
        family=family_or_name,
        pattern=pattern,
        number=number,
    )


def sample_scene(
    seed: int,
    number: int,
    families: Collection[str] | None = None,
    patterns: Collection[str] | None = None,
) -> Scene:
    """Draw one scene of a balanced series.

    Consecutive numbers take the families in turn, and each family takes its patterns in turn, so
    any stretch of the series has each family equally often (to within one).

    Args:
        seed: seed of the series, 0 to 2**63 - 1.
        number: which scene of the series, 0 to 2**31 - 1.
        families: families to draw from; None is all of them.
        patterns: patterns to draw from; None is all of them. A family without any of these
            patterns is left out.

    Raises:
        InputError: if a name is unknown, a number is out of range, or nothing is left to draw from.
    """
    check_whole("number", number, 0, LARGEST_NUMBER)
    choices = _choices(families, patterns)
    turn, place = divmod(number, len(choices))
    family, its_patterns = choices[place]
    return load_scene(family, its_patterns[turn % len(its_patterns)], seed, number)


# What the caller may ask for


def _choices(
    families: Collection[str] | None, patterns: Collection[str] | None
) -> list[tuple[str, list[str]]]:
    """The families to draw from, each with its patterns, in the order of `FAMILIES`."""
    for family in families or ():
        _check_known("family", family, FAMILIES)
    for pattern in patterns or ():
        _check_known("pattern", pattern, PATTERNS)
    kept = [
        (name, [p for p in family.patterns if patterns is None or p in patterns])
        for name, family in FAMILIES.items()
        if families is None or name in families
    ]
    choices = [(name, its_patterns) for name, its_patterns in kept if its_patterns]
    if not choices:
        raise InputError(
            f"no scene is left to draw: families {_listed(families)} with patterns "
            f"{_listed(patterns)}; see the patterns of each family"
        )
    return choices


def _listed(names: Collection[str] | None) -> str:
    if names is None:
        return "of all kinds"
    return ", ".join(names) if names else "of no kind"


def _check_known(field: str, name: str, allowed: Collection[str]) -> None:
    if name not in allowed:
        raise InputError(f"{field}: {name!r} is unknown: choose from {', '.join(allowed)}")
