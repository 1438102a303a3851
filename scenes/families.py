"""Generated scenes: four families of place, six patterns of how people meet in them.

Everything is drawn from a seed and a number, so a seed names an endless series of scenes and each
of them can be made again alone. The robot starts on the left, under way, and faces right, towards
its goal; the people it will meet are a few seconds away. Places are made for the social force
model, which has no path planning: everyone walks straight at the goal, so who must pass a door has
a goal that lies behind it in a straight line, and goals are so far away that nobody arrives.
"""

import math
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from scenes.errors import LARGEST_SEED, InputError, check_whole
from scenes.geometry import distance_to_segments
from scenes.scene import (
    GOAL_DISTANCE,
    LARGEST_NUMBER,
    MEAN_WALKING_SPEED,
    ROBOT_TASK,
    Pedestrian,
    Robot,
    Scene,
    Wall,
)


@dataclass(frozen=True)
class Family:
    """A kind of place.

    Attributes:
        description: what it looks like, in one line.
        patterns: how people can meet there; the first is the one that is used unless another is
            asked for.
    """

    description: str
    patterns: tuple[str, ...]


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
"""The kinds of place, and which patterns make sense in each."""

_PEOPLE_APART = 0.55
"""Smallest distance between two people's starts, m: the jitter of starts never makes them touch."""

_ROBOT_APART = 0.9
"""Smallest distance between a person's start and the robot's, m."""

_WALLS_APART = 0.8
"""Smallest distance between a person's start and a wall, m."""

_SHOULDERS = (0.62, 0.75)
"""How far apart people who stand or walk side by side are, m."""

_WALK = (MEAN_WALKING_SPEED, MEAN_WALKING_SPEED)
_STAND = (0.0, 0.0)
_SLOW = (0.4, 0.8)
_STROLL = (0.9, 1.3)
_FAST = (1.6, 1.9)
"""Desired speeds of people who walk as most do, stand, are slow, have company, or hurry, m/s."""

_TRIES = 60
"""How often a place is sought for a party before it stays away."""

_Range = tuple[float, float]
Party = tuple[Pedestrian, ...]


def load_scene(
    family_or_name: str, pattern: str | None = None, seed: int = 0, number: int = 0
) -> Scene:
    """Draw a scene.

    Args:
        family_or_name: one of `FAMILIES`, for example "doorway".
        pattern: one of the family's patterns; None takes the first of them, which is the one
            that shows the family best ("doorway" alone is two-way traffic through the opening).
        seed: seed of the series, 0 to 2**63 - 1.
        number: which scene of the series, 0 to 2**31 - 1.

    Returns:
        The scene; its name is the family's. The same arguments give the same scene, whatever was
        drawn before.

    Raises:
        InputError: if there is no such family, the family has no such pattern, or a number is out
            of range.
    """
    pattern = _checked_pattern(family_or_name, pattern)
    rng = _stream(seed, number)
    place = _PLACES[family_or_name](rng)
    people, groups = _gather(rng, place, _CASTS[pattern](rng))
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

    Consecutive numbers go round the families, and each family goes round its patterns, so that any
    run of scenes has each family equally often (to within one).

    Args:
        seed: seed of the series, 0 to 2**63 - 1.
        number: which scene of the series, 0 to 2**31 - 1.
        families: families to draw from; None is all of them.
        patterns: patterns to draw from; None is all of them. A family that has none of them is
            left out.

    Raises:
        InputError: if a name is unknown, a number is out of range, or nothing is left to draw from.
    """
    check_whole("number", number, 0, LARGEST_NUMBER)
    choices = _choices(families, patterns)
    turn, place = divmod(number, len(choices))
    family, its_patterns = choices[place]
    return load_scene(family, its_patterns[turn % len(its_patterns)], seed, number)


# What the caller may ask for


def _checked_pattern(family: str, pattern: str | None) -> str:
    _check_known("family", family, FAMILIES)
    patterns = FAMILIES[family].patterns
    if pattern is None:
        return patterns[0]
    if pattern not in patterns:
        raise InputError(
            f"pattern: {family} has no pattern {pattern!r}: choose from {', '.join(patterns)}"
        )
    return pattern


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


def _stream(seed: int, number: int) -> np.random.Generator:
    """The scene's own random stream; the noise of rollouts uses counters that start with 0."""
    check_whole("seed", seed, 0, LARGEST_SEED)
    check_whole("number", number, 0, LARGEST_NUMBER)
    key = np.array([seed, number], dtype=np.uint64)
    return np.random.Generator(np.random.Philox(key=key, counter=[0, 0, 0, 1]))


# Places


@dataclass(frozen=True)
class _Place:
    """Where people can be.

    Attributes:
        robot: the robot's task.
        walls: the walls.
        half_width: how far from the axis y = 0 people who walk along it start, m.
        gate: half the width of the opening at x = 0 that one must pass, m; None if there is none.
        street: x between which people cross the axis, m; None where nobody can.
        spread: how far people's directions stray from the axes, rad.
    """

    robot: Robot
    walls: tuple[Wall, ...]
    half_width: float
    gate: float | None = None
    street: _Range | None = None
    spread: float = 0.0


def _corridor(rng: np.random.Generator) -> _Place:
    # Wide: the walls of the force model keep people a metre away, and they must get past the robot
    # in the space between. In 4 m or less they walk into it.
    half = 0.5 * rng.uniform(4.6, 6.0)
    start = (-4.0, rng.uniform(-0.4, 0.4))
    walls = (Wall((-9.0, half), (9.0, half)), Wall((-9.0, -half), (9.0, -half)))
    return _Place(_heading_along_x(start), walls, half_width=half - 1.0)


def _intersection(rng: np.random.Generator) -> _Place:
    half, across = (0.5 * rng.uniform(4.6, 6.0) for _ in range(2))
    start = (-across - rng.uniform(0.6, 1.4), rng.uniform(-0.4, 0.4))
    walls = [
        wall
        for x in (-1.0, 1.0)
        for y in (-1.0, 1.0)
        for wall in (
            Wall((x * across, y * half), (x * 8.0, y * half)),
            Wall((x * across, y * half), (x * across, y * 7.0)),
        )
    ]
    street = (1.0 - across, min(across - 1.0, start[0] + 4.0))
    return _Place(_heading_along_x(start), tuple(walls), half_width=half - 1.0, street=street)


def _doorway(rng: np.random.Generator) -> _Place:
    # Wide: the walls of the force model let nobody through openings below about 1.5 m.
    gate = 0.5 * rng.uniform(1.6, 2.4)
    start = (-rng.uniform(4.0, 5.4), rng.uniform(-1.2, 1.2))
    door = (0.0, rng.uniform(-0.1, 0.1) * gate)
    walls = (
        Wall((0.0, gate), (0.0, 3.0)),
        Wall((0.0, -3.0), (0.0, -gate)),
        Wall((-9.0, 3.0), (8.0, 3.0)),
        Wall((-9.0, -3.0), (8.0, -3.0)),
    )
    robot = Robot(start, _beyond(start, door, ROBOT_TASK))
    return _Place(robot, walls, half_width=1.4, gate=gate)


def _open(rng: np.random.Generator) -> _Place:
    start = (-4.0, rng.uniform(-0.5, 0.5))
    return _Place(_heading_along_x(start), (), half_width=2.0, street=(-2.5, 1.0), spread=0.3)


def _heading_along_x(start: tuple[float, float]) -> Robot:
    return Robot(start, (start[0] + ROBOT_TASK, start[1]))


_PLACES: Mapping[str, Callable[[np.random.Generator], _Place]] = {
    "corridor": _corridor,
    "intersection": _intersection,
    "doorway": _doorway,
    "open": _open,
}


# Parties: one person, or a group side by side


@dataclass(frozen=True)
class _Along:
    """A party that walks along the robot's way, or stands in it.

    Attributes:
        ahead: how far ahead of the robot it starts, m; negative is behind.
        way: +1 to walk the robot's way, -1 to come towards it.
        speed: desired speed, m/s.
        sizes: fewest and most members.
        aside: how far to the left of the robot's straight way its middle starts, m; None is
            anywhere.
    """

    ahead: _Range
    way: float
    speed: _Range = _WALK
    sizes: tuple[int, int] = (1, 1)
    aside: _Range | None = None

    def draw(self, rng: np.random.Generator, place: _Place) -> Party:
        """Draw a party of this kind."""
        (x, y), heading = place.robot.start, place.robot.start_heading
        ahead, width = rng.uniform(*self.ahead), place.half_width
        if self.aside is None:
            middle = (x + ahead, rng.uniform(-width, width))
        else:
            middle = (x + ahead, y + ahead * math.tan(heading) + rng.uniform(*self.aside))
        direction = (0.0 if self.way > 0 else math.pi) + rng.uniform(-place.spread, place.spread)
        return _abreast(rng, place, middle, direction, self.sizes, self.speed)


@dataclass(frozen=True)
class _Across:
    """A party that crosses the robot's way; nobody, where there is no street to come from.

    Attributes:
        early: how long before the robot it gets to where their paths cross, s.
        sizes: fewest and most members.
    """

    early: _Range
    sizes: tuple[int, int] = (1, 1)

    def draw(self, rng: np.random.Generator, place: _Place) -> Party:
        """Draw a party of this kind."""
        if place.street is None:
            return ()
        (x, y), meeting = place.robot.start, rng.uniform(*place.street)
        time = (meeting - x) / place.robot.speed - rng.uniform(*self.early)
        direction = 0.5 * math.pi * rng.choice((-1.0, 1.0))
        direction += rng.uniform(-place.spread, place.spread)
        way = time * MEAN_WALKING_SPEED
        middle = (meeting - way * math.cos(direction), y - way * math.sin(direction))
        return _abreast(rng, place, middle, direction, self.sizes, _WALK)


def _abreast(
    rng: np.random.Generator,
    place: _Place,
    middle: tuple[float, float],
    direction: float,
    sizes: tuple[int, int],
    speed: _Range,
) -> Party:
    """People side by side, facing a direction (rad)."""
    size = int(rng.integers(sizes[0], sizes[1], endpoint=True))
    apart = rng.uniform(*_SHOULDERS)
    desired = rng.uniform(*speed)
    left = (-math.sin(direction), math.cos(direction))
    offsets = [(index - 0.5 * (size - 1)) * apart for index in range(size)]
    starts = [(middle[0] + o * left[0], middle[1] + o * left[1]) for o in offsets]
    return tuple(
        Pedestrian(start, _goal(rng, place, start, direction), desired) for start in starts
    )


def _goal(
    rng: np.random.Generator, place: _Place, start: tuple[float, float], direction: float
) -> tuple[float, float]:
    """A goal far away in a direction (rad), or behind the opening if that is on the way."""
    along = (math.cos(direction), math.sin(direction))
    if place.gate is None or start[0] * along[0] > 0:
        return _beyond(start, (start[0] + along[0], start[1] + along[1]), GOAL_DISTANCE)
    return _beyond(start, (0.0, rng.uniform(-0.25, 0.25) * place.gate), GOAL_DISTANCE)


def _beyond(
    start: tuple[float, float], via: tuple[float, float], distance: float
) -> tuple[float, float]:
    """The point at a distance from the start, in the direction of another point."""
    scale = distance / math.dist(start, via)
    return (start[0] + scale * (via[0] - start[0]), start[1] + scale * (via[1] - start[1]))


# Casts: who takes part in a pattern

_Cast = list[_Along | _Across]

_COMING, _GOING = -1.0, 1.0


def _head_on(rng: np.random.Generator) -> _Cast:
    near = _Along((4.5, 7.5), _COMING)
    pair = _Along((7.5, 10.5), _COMING, _STROLL, sizes=(2, 2))
    far = _Along((7.5, 11.5), _COMING)
    return [near, pair, far, *_some(rng, pair, 0, 1), *_some(rng, far, 1, 2)]


def _overtaking(rng: np.random.Generator) -> _Cast:
    slow = _Along((1.5, 3.0), _GOING, _SLOW, aside=(-0.8, 0.8))
    pair = _Along((2.5, 4.5), _GOING, _STROLL, sizes=(2, 2))
    ahead = _Along((3.5, 6.5), _GOING, _STROLL)
    behind = _Along((-4.0, -2.0), _GOING, _FAST)
    return [slow, pair, behind, ahead, *_some(rng, ahead, 0, 2)]


def _crossing(rng: np.random.Generator) -> _Cast:
    near = _Across((-1.5, 1.5))
    pair = _Across((-3.0, -1.0), sizes=(2, 2))
    other = _Across((-3.5, 2.5))
    coming = _Along((7.0, 11.0), _COMING)
    return [near, pair, near, other, *_some(rng, other, 0, 1), *_some(rng, coming, 0, 1)]


def _group_blocking(rng: np.random.Generator) -> _Cast:
    groups: _Cast = [
        _Along((4.0, 5.2), _COMING, _STAND, sizes=(2, 4), aside=(-1.0, 1.0)),
        _Along((5.5, 7.5), _COMING, _STROLL, sizes=(2, 4), aside=(-1.0, 1.0)),
        _Along((2.2, 3.5), _GOING, _SLOW, sizes=(2, 4), aside=(-1.0, 1.0)),
    ]
    group = groups[int(rng.integers(len(groups)))]
    pair = _Along((7.5, 10.0), _COMING, _STROLL, sizes=(2, 2))
    single = _Along((7.0, 11.0), _COMING)
    return [group, pair, *_some(rng, single, 1, 3)]


def _bottleneck(rng: np.random.Generator) -> _Cast:
    going = _Along((1.0, 3.0), _GOING, _STROLL)
    pair = _Along((7.0, 9.5), _COMING, _STROLL, sizes=(2, 2))
    coming = _Along((5.5, 9.0), _COMING)
    return [going, pair, coming, going, *_some(rng, pair, 0, 1), *_some(rng, coming, 0, 2)]


def _mixed(rng: np.random.Generator) -> _Cast:
    near = _Along((4.5, 7.5), _COMING)
    pair = _Along((7.0, 10.0), _COMING, _STROLL, sizes=(2, 3))
    crosser = _Across((-2.5, 2.5))
    slow = _Along((2.5, 4.5), _GOING, _SLOW)
    talking = _Along((3.5, 6.5), _COMING, _STAND, sizes=(2, 2))
    behind = _Along((-4.0, -2.0), _GOING, _FAST)
    others: _Cast = [*_some(rng, talking, 0, 1), *_some(rng, behind, 0, 1)]
    return [near, pair, crosser, crosser, slow, *others]


_CASTS: Mapping[str, Callable[[np.random.Generator], _Cast]] = {
    "head_on": _head_on,
    "overtaking": _overtaking,
    "crossing": _crossing,
    "group_blocking": _group_blocking,
    "bottleneck": _bottleneck,
    "mixed": _mixed,
}


def _some(rng: np.random.Generator, party: _Along | _Across, least: int, most: int) -> _Cast:
    return [party] * int(rng.integers(least, most, endpoint=True))


# Who finds room


def _gather(
    rng: np.random.Generator, place: _Place, cast: _Cast
) -> tuple[Party, tuple[tuple[int, ...], ...]]:
    """The people of a cast, each party where there is room for it, and who belongs together."""
    people: list[Pedestrian] = []
    groups: list[tuple[int, ...]] = []
    for kind in cast:
        party = _with_room(rng, place, people, kind)
        if len(party) > 1:
            groups.append(tuple(range(len(people), len(people) + len(party))))
        people.extend(party)
    return tuple(people), tuple(groups)


def _with_room(
    rng: np.random.Generator, place: _Place, others: list[Pedestrian], kind: _Along | _Across
) -> Party:
    """A party that starts clear of everything; nobody, if the place is too full for it."""
    for _ in range(_TRIES):
        party = kind.draw(rng, place)
        if not party or _is_clear(place, others, party):
            return party
    return ()


def _is_clear(place: _Place, others: list[Pedestrian], party: Party) -> bool:
    starts = np.array([person.start for person in party])
    if np.hypot(*(starts - place.robot.start).T).min() < _ROBOT_APART:
        return False
    if others:
        theirs = np.array([person.start for person in others])
        if np.linalg.norm(starts[:, None] - theirs, axis=-1).min() < _PEOPLE_APART:
            return False
    segments = np.array([(wall.start, wall.end) for wall in place.walls]).reshape(-1, 2, 2)
    return bool((distance_to_segments(starts, segments) >= _WALLS_APART).all())
