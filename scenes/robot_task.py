"""The robot's task in a scene from a real crowd: where it starts and where it is headed."""

import numpy as np

from scenes.arrays import FloatArray
from scenes.errors import InputError
from scenes.ewap import STANDING_SPEED
from scenes.geometry import directions, distance_to_people, distance_to_walls
from scenes.scene import PEDESTRIAN_RADIUS, ROBOT_RADIUS, ROBOT_TASK, Position, Robot

_ROBOT_APART = 1.5  # least distance from a start that is chosen for the robot to a person, m
_ROBOT_NEAR = 5.0  # greatest distance from such a start to the nearest person, if there is room, m
_SHORTEST_TASK = 1.0  # least distance from such a start to a goal that is given, m
_NARROW_PASS = 1.3  # distance between the centres of a robot and a person who narrowly pass, m


def robot_task(
    starts: FloatArray,
    velocities: FloatArray,
    segments: FloatArray,
    start: Position | None,
    goal: Position | None,
) -> Robot:
    """The robot's task; a start or goal that is None is chosen so that many people pass narrowly.

    Several starts or headings are tried. The best has no wall in its way, and most people would
    narrowly pass the robot within four seconds if everybody, robot and people, went straight on.

    Args:
        starts: where the people are, [P, 2], m.
        velocities: how they move, [P, 2], m/s.
        segments: both ends of every wall, [W, 2, 2], m.
        start: where the robot starts, m.
        goal: where it is headed, m.

    Raises:
        InputError: if the given start lies inside a person or a wall, or no place is free for one.
    """
    if start is not None:
        _check_robot_start(start, starts, segments)
    if start is not None and goal is not None:
        return Robot(start, goal)
    moving = np.hypot(velocities[:, 0], velocities[:, 1]) >= STANDING_SPEED
    middle = (starts[moving] if moving.any() else starts).mean(axis=0)
    if start is not None:
        tos = np.array(start) + directions(16)
        froms = np.broadcast_to(np.array(start), tos.shape)
    else:
        target = middle if goal is None else np.array(goal)
        froms = _free_places(middle, target, starts, segments)
        tos = np.broadcast_to(target, froms.shape)
    headings = (tos - froms) / np.linalg.norm(tos - froms, axis=1)[:, None]
    best = int(np.argmax(_people_passed(froms, headings, starts, velocities, segments)))
    onwards = np.round(froms[best] + ROBOT_TASK * headings[best], 2)
    return Robot(
        position(froms[best]) if start is None else start,
        position(onwards) if goal is None else goal,
    )


def _free_places(
    middle: FloatArray, target: FloatArray, starts: FloatArray, segments: FloatArray
) -> FloatArray:
    """Places on rings about the middle that are clear of everything but near people, [N, 2]."""
    rings = [middle + radius * directions(16) for radius in (4.0, 3.0, 5.0, 6.0, 8.0, 12.0, 20.0)]
    places: FloatArray = np.concatenate(rings).round(2)
    to_people = distance_to_people(places, starts)
    free = (to_people >= _ROBOT_APART) & (distance_to_walls(places, segments) >= 2.0 * ROBOT_RADIUS)
    free &= np.linalg.norm(places - target, axis=1) >= _SHORTEST_TASK
    if not free.any():
        raise InputError("robot_start: no place near the people is free: give one")
    near = free & (to_people <= _ROBOT_NEAR)
    return places[near if near.any() else free]


def _people_passed(
    froms: FloatArray,
    headings: FloatArray,
    starts: FloatArray,
    velocities: FloatArray,
    segments: FloatArray,
) -> FloatArray:
    """How many people narrowly pass a robot that sets off straight at 1 m/s from each place, [N].

    A person counts exp(-|d - 1.3 m|), where d is the smallest distance between 1 and 4 s from now:
    a robot that is sure to be hit shows as little as one that nobody meets. A wall in the way gives
    -1, which rules the place out.
    """
    apart = starts - froms[:, None]  # (N, P, 2)
    closing = velocities - headings[:, None]  # (N, P, 2)
    squared_speed = np.maximum(np.sum(closing**2, axis=-1), 1e-12)
    closest = np.clip(-np.sum(apart * closing, axis=-1) / squared_speed, 1.0, 4.0)  # (N, P)
    passing = np.linalg.norm(apart + closest[..., None] * closing, axis=-1)  # (N, P)
    met = np.exp(-np.abs(passing - _NARROW_PASS)).sum(axis=1)
    way = froms + np.linspace(0.0, 4.0, 17)[:, None, None] * headings  # (17, N, 2)
    to_walls = np.array([distance_to_walls(places, segments) for places in way])  # (17, N)
    # rounded, so that ties are ties on every machine
    return np.where(to_walls.min(axis=0) < 2.0 * ROBOT_RADIUS, -1.0, met).round(6)


def _check_robot_start(start: Position, starts: FloatArray, segments: FloatArray) -> None:
    """Make sure that the robot's given start lies inside nobody and no wall."""
    place = np.array([start])
    distances = {
        "person": (distance_to_people(place, starts)[0], PEDESTRIAN_RADIUS + ROBOT_RADIUS),
        "wall": (distance_to_walls(place, segments)[0], ROBOT_RADIUS),
    }
    for what, (distance, needed) in distances.items():
        if distance < needed:
            raise InputError(
                f"robot_start: {_pair(start)} is {distance:.2f} m from the nearest {what}, "
                f"inside it: at least {needed:.2f} m is needed"
            )


def check_on_map(field: str, place: Position | None) -> None:
    """Make sure that a given start or goal has coordinates that a scene allows."""
    if place is not None and not all(abs(coordinate) <= 1000.0 for coordinate in place):
        raise InputError(
            f"{field}: {_pair(place)} is not allowed: coordinates from -1000 to 1000 m"
        )


def _pair(place: Position) -> str:
    return f"({place[0]:g}, {place[1]:g})"


def position(point: FloatArray) -> Position:
    """The point, [2], as x and y."""
    return float(point[0]), float(point[1])
