"""Who takes part in each pattern, and where they find room.

A cast is a list of parties; a party is one person, or a group side by side. Each kind of party
draws its people from a random stream, again and again until they have room in the place.
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from scenes.geometry import distance_to_people, distance_to_walls
from scenes.places import DrawnPlace, Range, beyond
from scenes.scene import (
    GOAL_DISTANCE,
    MEAN_WALKING_SPEED,
    Pedestrian,
    Position,
    segments_of,
    starts_of,
)

_PEOPLE_APART = 0.55  # least distance between starts, m: it leaves room for the noise of starts
_ROBOT_APART = 0.9  # least distance between a person's start and the robot's, m
_WALLS_APART = 0.8  # least distance between a person's start and a wall, m
_SHOULDERS = (0.62, 0.75)  # least and greatest distance between neighbours in a group, m
_TRIES = 60  # how many times a party is drawn for want of room before it is left out
_WALK = (MEAN_WALKING_SPEED, MEAN_WALKING_SPEED)  # range of the desired speed of most people, m/s
_STAND = (0.0, 0.0)  # of people who stand, m/s
_SLOW = (0.4, 0.8)  # of people who are slow, m/s
_STROLL = (0.9, 1.3)  # of people who have company, m/s
_FAST = (1.6, 1.9)  # of people who hurry, m/s

Party = tuple[Pedestrian, ...]


# Kinds of party


@dataclass(frozen=True)
class Along:
    """A party that walks along the robot's way, or stands in it.

    Its middle starts `aside` to the left of the robot's straight way; None puts it anywhere in the
    width of the place.
    """

    ahead: Range  # how far ahead of the robot it starts, m; negative is behind
    way: float  # +1 to walk the robot's way, -1 to come towards it
    speed: Range = _WALK  # desired, m/s
    sizes: tuple[int, int] = (1, 1)  # fewest and most members
    aside: Range | None = None  # m

    def draw(self, rng: np.random.Generator, place: DrawnPlace) -> Party:
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
class Across:
    """A party that crosses the robot's way; it stays empty in a place without a street."""

    early: Range  # how long before the robot the party gets to where their paths cross, s
    sizes: tuple[int, int] = (1, 1)  # fewest and most members

    def draw(self, rng: np.random.Generator, place: DrawnPlace) -> Party:
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
    place: DrawnPlace,
    middle: Position,
    direction: float,
    sizes: tuple[int, int],
    speed: Range,
) -> Party:
    """People side by side who walk in one direction (rad) at one speed."""
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
    rng: np.random.Generator, place: DrawnPlace, start: Position, direction: float
) -> Position:
    """A goal far away in a direction (rad); if an opening is on the way, straight behind it."""
    along = (math.cos(direction), math.sin(direction))
    if place.gate is None or start[0] * along[0] > 0:
        return beyond(start, (start[0] + along[0], start[1] + along[1]), GOAL_DISTANCE)
    return beyond(start, (0.0, rng.uniform(-0.25, 0.25) * place.gate), GOAL_DISTANCE)


# Casts

Cast = list[Along | Across]

_COMING, _GOING = -1.0, 1.0


def _head_on(rng: np.random.Generator) -> Cast:
    near = Along((4.5, 7.5), _COMING)
    pair = Along((7.5, 10.5), _COMING, _STROLL, sizes=(2, 2))
    far = Along((7.5, 11.5), _COMING)
    return [near, pair, far, *_some(rng, pair, 0, 1), *_some(rng, far, 1, 2)]


def _overtaking(rng: np.random.Generator) -> Cast:
    slow = Along((1.5, 3.0), _GOING, _SLOW, aside=(-0.8, 0.8))
    pair = Along((2.5, 4.5), _GOING, _STROLL, sizes=(2, 2))
    ahead = Along((3.5, 6.5), _GOING, _STROLL)
    behind = Along((-4.0, -2.0), _GOING, _FAST)
    return [slow, pair, behind, ahead, *_some(rng, ahead, 0, 2)]


def _crossing(rng: np.random.Generator) -> Cast:
    near = Across((-1.5, 1.5))
    pair = Across((-3.0, -1.0), sizes=(2, 2))
    other = Across((-3.5, 2.5))
    coming = Along((7.0, 11.0), _COMING)
    return [near, pair, near, other, *_some(rng, other, 0, 1), *_some(rng, coming, 0, 1)]


def _group_blocking(rng: np.random.Generator) -> Cast:
    groups: Cast = [
        Along((4.0, 5.2), _COMING, _STAND, sizes=(2, 4), aside=(-1.0, 1.0)),
        Along((5.5, 7.5), _COMING, _STROLL, sizes=(2, 4), aside=(-1.0, 1.0)),
        Along((2.2, 3.5), _GOING, _SLOW, sizes=(2, 4), aside=(-1.0, 1.0)),
    ]
    group = groups[int(rng.integers(len(groups)))]
    pair = Along((7.5, 10.0), _COMING, _STROLL, sizes=(2, 2))
    single = Along((7.0, 11.0), _COMING)
    return [group, pair, *_some(rng, single, 1, 3)]


def _bottleneck(rng: np.random.Generator) -> Cast:
    going = Along((1.0, 3.0), _GOING, _STROLL)
    pair = Along((7.0, 9.5), _COMING, _STROLL, sizes=(2, 2))
    coming = Along((5.5, 9.0), _COMING)
    return [going, pair, coming, going, *_some(rng, pair, 0, 1), *_some(rng, coming, 0, 2)]


def _mixed(rng: np.random.Generator) -> Cast:
    near = Along((4.5, 7.5), _COMING)
    pair = Along((7.0, 10.0), _COMING, _STROLL, sizes=(2, 3))
    crosser = Across((-2.5, 2.5))
    slow = Along((2.5, 4.5), _GOING, _SLOW)
    talking = Along((3.5, 6.5), _COMING, _STAND, sizes=(2, 2))
    behind = Along((-4.0, -2.0), _GOING, _FAST)
    others: Cast = [*_some(rng, talking, 0, 1), *_some(rng, behind, 0, 1)]
    return [near, pair, crosser, crosser, slow, *others]


CASTS: Mapping[str, Callable[[np.random.Generator], Cast]] = {
    "head_on": _head_on,
    "overtaking": _overtaking,
    "crossing": _crossing,
    "group_blocking": _group_blocking,
    "bottleneck": _bottleneck,
    "mixed": _mixed,
}
"""What draws the cast of each pattern."""


def _some(rng: np.random.Generator, party: Along | Across, least: int, most: int) -> Cast:
    """The same kind of party between `least` and `most` times."""
    return [party] * int(rng.integers(least, most, endpoint=True))


# Room


def gather(
    rng: np.random.Generator, place: DrawnPlace, cast: Cast
) -> tuple[Party, tuple[tuple[int, ...], ...]]:
    """The people of a cast who found room, and the groups they form, as indices of people."""
    people: list[Pedestrian] = []
    groups: list[tuple[int, ...]] = []
    for kind in cast:
        party = _with_room(rng, place, people, kind)
        if len(party) > 1:
            groups.append(tuple(range(len(people), len(people) + len(party))))
        people.extend(party)
    return tuple(people), tuple(groups)


def _with_room(
    rng: np.random.Generator, place: DrawnPlace, others: list[Pedestrian], kind: Along | Across
) -> Party:
    """A party that starts clear of everything; an empty one if the place is too full for it."""
    for _ in range(_TRIES):
        party = kind.draw(rng, place)
        if not party or _is_clear(place, others, party):
            return party
    return ()


def _is_clear(place: DrawnPlace, others: list[Pedestrian], party: Party) -> bool:
    starts, theirs = starts_of(party), starts_of(others)
    return bool(
        (distance_to_people(starts, np.array([place.robot.start])) >= _ROBOT_APART).all()
        and (distance_to_people(starts, theirs) >= _PEOPLE_APART).all()
        and (distance_to_walls(starts, segments_of(place.walls)) >= _WALLS_APART).all()
    )
