"""Scenes from real crowds: recordings of pedestrians in the EWAP format.

A recording is a folder that holds `obsmat.txt`: a row for each person in each annotated frame, with
the columns frame, person, x, z, y, vx, vz, vy (m and m/s, z up). Beside it there may be
`groups.txt` (a line for each group, the numbers of its members) and `map.xml` (what stands in the
way: lines and circles). `destinations.txt` is not read: it lists places where people of the whole
recording went, not who went where, and the tracks themselves say that better.

The format and two recordings are from Pellegrini, Ess, Schindler and van Gool, "You'll never walk
alone: modeling social behavior for multi-target tracking", ICCV 2009; the maps are from Amirian et
al., "OpenTraj", ACCV 2020.
"""

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
from numpy.typing import NDArray
from pydantic import ValidationError

from scenes.errors import InputError
from scenes.geometry import FloatArray, distance_to_segments
from scenes.scene import (
    GOAL_DISTANCE,
    PEDESTRIAN_RADIUS,
    ROBOT_RADIUS,
    ROBOT_TASK,
    SHORTEST_WALL,
    Pedestrian,
    Robot,
    Scene,
    Wall,
    one_line,
)

STANDING_SPEED = 0.2
"""Who is slower than this at the frame stands, m/s."""

_COLUMNS = ("frame", "person", "x", "z", "y", "vx", "vz", "vy")

_END_IS_NEAR = 1.0
"""A track that ends within this distance says nothing of where the person is headed, m."""

_ROBOT_APART = 1.5
"""Smallest distance from the robot's start to a person, where the studio chooses it, m."""

_ROBOT_NEAR = 5.0
"""Largest such distance to the nearest person, if there is room, m."""

_SHORTEST_TASK = 1.0
"""Smallest distance from such a start to a goal that is given, m."""

_NARROW_PASS = 1.3
"""Distance between the centres of a robot and a person who narrowly pass, m."""

ANNOTATION_STEP = 0.4
"""Time between two annotated frames in the EWAP format, s."""

MOMENT = 4.0
"""Busy moments of a recording are named at least this far apart, s."""

_MARGIN = 1e-6
"""Who is moved to an allowed distance is moved this much further, against rounding, m."""

Position = tuple[float, float]


@dataclass(frozen=True)
class Tracks:
    """A recording: N annotations, sorted by frame and then by person.

    Attributes:
        name: what the recording is called.
        frames: [N], number of the video frame.
        people: [N], number of the person.
        positions: [N, 2], m.
        velocities: [N, 2], m/s.
        walls: what stands in the way.
        groups: numbers of the people who belong together, in the order of the file.
    """

    name: str
    frames: NDArray[np.int64]
    people: NDArray[np.int64]
    positions: FloatArray
    velocities: FloatArray
    walls: tuple[Wall, ...]
    groups: tuple[tuple[int, ...], ...]


def scene_from_tracks(
    path: Path,
    frame: int,
    robot_start: Position | None = None,
    robot_goal: Position | None = None,
) -> Scene:
    """Read a recording and make a scene of one of its moments; see `scene_at`.

    Args:
        path: the recording's folder, or its file of annotations.
        frame: number of an annotated frame.
        robot_start: where the robot starts (x, y), m; None looks for a telling place.
        robot_goal: where the robot is headed (x, y), m; None looks for one.

    Raises:
        InputError: if the recording cannot be read, or no such scene can be made of it.
    """
    return scene_at(read_tracks(path), frame, robot_start, robot_goal)


def busiest_frames(path: Path, count: int = 10) -> list[tuple[int, int]]:
    """The moments with most people, most first, then the earlier: (frame, people).

    Moments are at least `MOMENT` apart: two neighbouring frames show the same crowd.

    Args:
        path: the recording's folder, or its file of annotations.
        count: how many moments, at least 1; fewer come back from a short recording.

    Raises:
        InputError: if the recording cannot be read, or the count is below 1.
    """
    if count < 1:
        raise InputError(f"count: {count} is not allowed: at least 1")
    frames, people = np.unique(read_tracks(path).frames, return_counts=True)
    step = np.diff(frames).min(initial=np.iinfo(np.int32).max)  # frames between annotations
    apart = step * round(MOMENT / ANNOTATION_STEP)
    chosen: list[tuple[int, int]] = []
    for index in np.lexsort((frames, -people)):
        frame = int(frames[index])
        if all(abs(frame - other) >= apart for other, _ in chosen):
            chosen.append((frame, int(people[index])))
        if len(chosen) == count:
            break
    return chosen


def scene_at(
    tracks: Tracks,
    frame: int,
    robot_start: Position | None = None,
    robot_goal: Position | None = None,
) -> Scene:
    """The scene of one moment of a recording, with a robot that crosses it.

    People start where they were, as fast as they were. They like to walk at the mean speed of the
    rest of their track, towards where it ends and on beyond: the force model stops people at their
    goals, the camera's view does not. Whoever is slower than `STANDING_SPEED` stands. Some
    annotations lie inside a wall or another person; such people are moved out, as little as can be
    (to within 1 cm).

    Where the robot's start or goal is left open, it is placed, or headed, so that it narrowly
    passes as many people as possible in the next four seconds (found by trial, the same each time).
    A start that is left open lies 3 m or more from the people's middle and 1.5 m or more from each.

    Args:
        tracks: the recording.
        frame: number of an annotated frame; the scene's number.
        robot_start: where the robot starts (x, y), m; None looks for a telling place.
        robot_goal: where the robot is headed (x, y), m; None looks for one.

    Raises:
        InputError: if nobody is annotated at the frame, or the robot would start inside a person
            or a wall.
    """
    _check_on_map("robot_start", robot_start)
    _check_on_map("robot_goal", robot_goal)
    now = _at_frame(tracks, frame)
    people = tracks.people[now]
    segments = np.array([(w.start, w.end) for w in tracks.walls]).reshape(-1, 2, 2)
    starts = _moved_clear(tracks.positions[now], segments)
    try:
        return Scene(
            name=_scene_name(tracks.name, frame),
            robot=_robot(starts, tracks.velocities[now], segments, robot_start, robot_goal),
            pedestrians=tuple(
                _pedestrian(tracks, person, frame, start)
                for person, start in zip(people, starts, strict=True)
            ),
            walls=tracks.walls,
            groups=_groups_present(tracks.groups, people),
            family="tracks",
            pattern="recorded",
            number=frame,
        )
    except ValidationError as error:
        raise InputError(f"{tracks.name}, frame {frame}: {one_line(error)}") from None


# Reading


def read_tracks(path: Path) -> Tracks:
    """Read a recording.

    Args:
        path: the recording's folder, or its file of annotations.

    Raises:
        InputError: if a file is missing or malformed.
    """
    file = path / "obsmat.txt" if path.is_dir() else path
    table = _read_table(file)
    frames, people = table[:, 0].astype(np.int64), table[:, 1].astype(np.int64)
    order = np.lexsort((people, frames))
    frames, people = frames[order], people[order]
    twice = np.flatnonzero((np.diff(frames) == 0) & (np.diff(people) == 0))
    for row in twice[:1]:
        raise InputError(f"{file}: person {people[row]} is annotated twice at frame {frames[row]}")
    return Tracks(
        name=file.resolve().parent.name if file.name == "obsmat.txt" else file.stem,
        frames=frames,
        people=people,
        positions=table[order][:, (2, 4)],
        velocities=table[order][:, (5, 7)],
        walls=_read_map(file.with_name("map.xml")),
        groups=_read_groups(file.with_name("groups.txt")),
    )


def _read_table(file: Path) -> FloatArray:
    lines = [line for line in _read_text(file).splitlines() if line.strip()]
    if not lines:
        raise InputError(f"{file}: no annotations in it")
    columns = len(lines[0].split())
    if columns != len(_COLUMNS):
        raise InputError(
            f"{file}: {columns} columns: {len(_COLUMNS)} are needed ({', '.join(_COLUMNS)})"
        )
    try:
        table: FloatArray = np.loadtxt(lines, comments=None, ndmin=2)
    except ValueError as error:
        raise InputError(f"{file}: {str(error).split(';')[0]}") from None
    for row, column in np.argwhere(~np.isfinite(table))[:1]:
        raise InputError(
            f"{file}: {_COLUMNS[column]} is {table[row, column]} in row {row + 1}: "
            "a finite number is needed"
        )
    numbers = table[:, :2]
    odd = (numbers != np.floor(numbers)) | (numbers < 0) | (numbers >= 2**31)
    for row, column in np.argwhere(odd)[:1]:
        raise InputError(
            f"{file}: {_COLUMNS[column]} is {numbers[row, column]:g} in row {row + 1}: "
            "a whole number from 0 to 2147483647 is needed"
        )
    return table


def _read_groups(file: Path) -> tuple[tuple[int, ...], ...]:
    """A group for each line that is not empty; none without the file."""
    if not file.exists():
        return ()
    groups = []
    for number, line in enumerate(_read_text(file).splitlines(), start=1):
        try:
            groups.append(tuple(int(word) for word in line.split()))
        except ValueError:
            raise InputError(
                f"{file}: line {number} is {line.strip()!r}: numbers of people are needed"
            ) from None
    return tuple(group for group in groups if group)


def _read_map(file: Path) -> tuple[Wall, ...]:
    """Lines as walls, circles as polygons; none without the file."""
    if not file.exists():
        return ()
    try:
        root = ElementTree.fromstring(_read_text(file))
    except ElementTree.ParseError as error:
        raise InputError(f"{file}: not XML: {error}") from None
    try:
        return tuple(_walls(file, root))
    except ValidationError as error:
        raise InputError(f"{file}: a wall's {one_line(error)}") from None


def _walls(file: Path, root: ElementTree.Element) -> Iterator[Wall]:
    # {*}: with or without a namespace
    for line in root.findall(".//{*}Line"):
        x1, y1, x2, y2 = (_number(file, line, key) for key in ("x1", "y1", "x2", "y2"))
        yield _long_enough((x1, y1), (x2, y2))
    for circle in root.findall(".//{*}Circle"):
        x, y, radius = (_number(file, circle, key) for key in ("x", "y", "radius"))
        yield from _polygon(x, y, radius)


def _read_text(file: Path) -> str:
    try:
        return file.read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        reason = error.strerror if isinstance(error, OSError) else "not UTF-8 text"
        raise InputError(f"{file}: cannot be read: {reason}") from None


def _number(file: Path, element: ElementTree.Element, key: str) -> float:
    tag, text = element.tag.rpartition("}")[2], element.get(key)
    try:
        value = math.nan if text is None else float(text)
    except ValueError:
        value = math.nan
    least = 0.0 if key == "radius" else -1000.0
    if not least <= value <= 1000.0:
        given = f"no {key}" if text is None else f"{key} {text!r}"
        raise InputError(f"{file}: {tag} has {given}: a number from {least:g} to 1000 is needed")
    return value


def _long_enough(start: Position, end: Position) -> Wall:
    """The wall between two points, lengthened about its middle if it is too short to be one."""
    length = math.dist(start, end)
    if length >= SHORTEST_WALL:
        return Wall(start=start, end=end)
    x, y = 0.5 * (start[0] + end[0]), 0.5 * (start[1] + end[1])
    along = ((end[0] - start[0]) / length, (end[1] - start[1]) / length) if length else (1.0, 0.0)
    half = 0.5 * SHORTEST_WALL + _MARGIN
    return Wall(
        start=(x - half * along[0], y - half * along[1]),
        end=(x + half * along[0], y + half * along[1]),
    )


def _polygon(x: float, y: float, radius: float) -> Iterator[Wall]:
    """A circle as a polygon with corners on it and sides of at least `SHORTEST_WALL`.

    A circle too small even for a triangle is drawn larger.
    """
    side = SHORTEST_WALL + _MARGIN
    radius = max(radius, side / (2.0 * math.sin(math.pi / 3.0)))
    sides = min(24, int(math.pi / math.asin(0.5 * side / radius) + _MARGIN))
    angles = [math.tau * index / sides for index in range(sides + 1)]
    corners = [(x + radius * math.cos(a), y + radius * math.sin(a)) for a in angles]
    yield from (Wall(start=start, end=end) for start, end in pairwise(corners))


# People


def _at_frame(tracks: Tracks, frame: int) -> slice:
    """The annotations of one frame."""
    first, end = np.searchsorted(tracks.frames, (frame, frame + 1))
    if first == end:
        nearest = dict.fromkeys(int(near) for near in tracks.frames[max(0, first - 1) : first + 1])
        raise InputError(
            f"frame: nobody is annotated at frame {frame} of {tracks.name}: the nearest with "
            f"people: {' and '.join(str(near) for near in nearest)}"
        )
    return slice(int(first), int(end))


def _pedestrian(tracks: Tracks, person: int, frame: int, start: FloatArray) -> Pedestrian:
    later = (tracks.people == person) & (tracks.frames >= frame)
    positions, velocities = tracks.positions[later], tracks.velocities[later]
    place = _position(start)
    speeds = np.hypot(velocities[:, 0], velocities[:, 1])
    if min(speeds[0], speeds.mean()) < STANDING_SPEED:
        return Pedestrian(start=place, goal=place, desired_speed=0.0)
    ahead = positions[-1] - start
    if np.hypot(*ahead) < _END_IS_NEAR:
        ahead = velocities[0]
    goal = start + GOAL_DISTANCE * ahead / np.hypot(*ahead)
    try:
        return Pedestrian(
            start=place,
            goal=_position(goal),
            desired_speed=float(speeds.mean()),
            velocity=_position(velocities[0]),
        )
    except ValidationError as error:
        raise InputError(
            f"{tracks.name}, frame {frame}, person {person}: {one_line(error)}"
        ) from None


def _groups_present(
    groups: tuple[tuple[int, ...], ...], people: NDArray[np.int64]
) -> tuple[tuple[int, ...], ...]:
    """Groups with two members present or more, as places in the list of people.

    A person belongs to the first such group only.
    """
    free = {int(person): place for place, person in enumerate(people)}
    present = []
    for group in groups:
        members = [person for person in dict.fromkeys(group) if person in free]
        if len(members) > 1:
            present.append(tuple(free.pop(person) for person in members))
    return tuple(present)


def _moved_clear(positions: FloatArray, segments: FloatArray) -> FloatArray:
    """The positions, [P, 2], with those inside a wall or another person moved out of it."""
    clear = positions.copy()
    for index in range(len(clear)):
        others = np.delete(clear, index, axis=0)
        for place in _rings_around(clear[index]):
            free = _gap_to_people(place, others) >= PEDESTRIAN_RADIUS
            free &= _gap_to_walls(place, segments) >= PEDESTRIAN_RADIUS
            if free.any():
                clear[index] = place[np.flatnonzero(free)[0]]
                break
    return clear


def _rings_around(point: FloatArray) -> Iterator[FloatArray]:
    """The point itself, [1, 2], then ever wider rings of points about it, [72, 2], up to 3 m."""
    yield point[None]
    angles = np.linspace(0.0, math.tau, 72, endpoint=False)
    directions = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    for step in range(1, 301):
        yield point + 0.01 * step * directions


def _gap_to_people(points: FloatArray, people: FloatArray) -> FloatArray:
    """Distance of each point, [N, 2], to the nearest of the people, [N]."""
    apart = np.linalg.norm(points[:, None] - people, axis=-1)
    nearest: FloatArray = apart.min(axis=1, initial=np.inf)
    return nearest


def _gap_to_walls(points: FloatArray, segments: FloatArray) -> FloatArray:
    """Distance of each point, [N, 2], to the nearest wall, [N]."""
    nearest: FloatArray = distance_to_segments(points, segments).min(axis=1, initial=np.inf)
    return nearest


# The robot


def _robot(
    starts: FloatArray,
    velocities: FloatArray,
    segments: FloatArray,
    start: Position | None,
    goal: Position | None,
) -> Robot:
    """The robot's task: as given, and what is not given so that it passes many people narrowly.

    Of the places and directions tried, the best is where most people would narrowly pass within
    four seconds if everybody, robot and people, went straight on, and where no wall is in the way.
    """
    if start is not None:
        _check_robot_start(start, starts, segments)
    if start is not None and goal is not None:
        return Robot(start, goal)
    moving = np.hypot(velocities[:, 0], velocities[:, 1]) >= STANDING_SPEED
    middle = (starts[moving] if moving.any() else starts).mean(axis=0)
    if start is not None:
        tos = np.array(start) + _directions()
        froms = np.broadcast_to(np.array(start), tos.shape)
    else:
        target = middle if goal is None else np.array(goal)
        froms = _free_places(middle, target, starts, segments)
        tos = np.broadcast_to(target, froms.shape)
    headings = (tos - froms) / np.linalg.norm(tos - froms, axis=1)[:, None]
    best = int(np.argmax(_telling(froms, headings, starts, velocities, segments)))
    onwards = np.round(froms[best] + ROBOT_TASK * headings[best], 2)
    return Robot(
        _position(froms[best]) if start is None else start,
        _position(onwards) if goal is None else goal,
    )


def _free_places(
    middle: FloatArray, target: FloatArray, starts: FloatArray, segments: FloatArray
) -> FloatArray:
    """Places on rings about the middle, clear of everything but near people, [N, 2]."""
    rings = [middle + radius * _directions() for radius in (4.0, 3.0, 5.0, 6.0, 8.0, 12.0, 20.0)]
    places: FloatArray = np.concatenate(rings).round(2)
    to_people = _gap_to_people(places, starts)
    free = (to_people >= _ROBOT_APART) & (_gap_to_walls(places, segments) >= 2.0 * ROBOT_RADIUS)
    free &= np.linalg.norm(places - target, axis=1) >= _SHORTEST_TASK
    if not free.any():
        raise InputError("robot_start: no place near the people is free: give one")
    near = free & (to_people <= _ROBOT_NEAR)
    return places[near if near.any() else free]


def _directions() -> FloatArray:
    """Sixteen directions, [16, 2]."""
    angles = np.linspace(0.0, math.tau, 16, endpoint=False)
    return np.stack([np.cos(angles), np.sin(angles)], axis=-1)


def _telling(
    froms: FloatArray,
    headings: FloatArray,
    starts: FloatArray,
    velocities: FloatArray,
    segments: FloatArray,
) -> FloatArray:
    """How many people narrowly pass a robot that sets off straight at 1 m/s, [N].

    Each counts exp(-|distance - 1.3 m|), taken at the closest 1 to 4 s from now: a robot that is
    sure to be hit tells as little as one that nobody meets. A wall in the way rules a place out.
    """
    gap = starts - froms[:, None]  # (N, P, 2)
    closing = velocities - headings[:, None]  # (N, P, 2)
    squared_speed = np.maximum(np.sum(closing**2, axis=-1), 1e-12)
    closest = np.clip(-np.sum(gap * closing, axis=-1) / squared_speed, 1.0, 4.0)  # (N, P)
    passing = np.linalg.norm(gap + closest[..., None] * closing, axis=-1)  # (N, P)
    met = np.exp(-np.abs(passing - _NARROW_PASS)).sum(axis=1)
    way = froms + np.linspace(0.0, 4.0, 17)[:, None, None] * headings  # (17, N, 2)
    to_walls = np.array([_gap_to_walls(places, segments) for places in way])  # (17, N)
    # rounded, so that ties are ties on every machine
    return np.where(to_walls.min(axis=0) < 2.0 * ROBOT_RADIUS, -1.0, met).round(6)


def _check_robot_start(start: Position, starts: FloatArray, segments: FloatArray) -> None:
    place = np.array([start])
    gaps = {
        "person": (_gap_to_people(place, starts)[0], PEDESTRIAN_RADIUS + ROBOT_RADIUS),
        "wall": (_gap_to_walls(place, segments)[0], ROBOT_RADIUS),
    }
    for what, (gap, needed) in gaps.items():
        if gap < needed:
            raise InputError(
                f"robot_start: {_pair(start)} is {gap:.2f} m from the nearest {what}, inside it: "
                f"at least {needed:.2f} m is needed"
            )


def _check_on_map(field: str, place: Position | None) -> None:
    if place is not None and not all(abs(coordinate) <= 1000.0 for coordinate in place):
        raise InputError(
            f"{field}: {_pair(place)} is not allowed: coordinates from -1000 to 1000 m"
        )


def _pair(place: Position) -> str:
    return f"({place[0]:g}, {place[1]:g})"


def _position(point: FloatArray) -> Position:
    return float(point[0]), float(point[1])


def _scene_name(name: str, frame: int) -> str:
    """A name that is a file's: the recording's and the frame."""
    ending = f"-{frame}"
    plain = re.sub(r"[^A-Za-z0-9_.\-]", "_", name).lstrip("_.-") or "tracks"
    return plain[: 64 - len(ending)] + ending
