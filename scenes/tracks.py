"""Scenes from real crowds: a moment of a recording, and a robot that crosses it."""

import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from pydantic import ValidationError

from scenes.arrays import FloatArray, IntArray
from scenes.errors import InputError
from scenes.ewap import ANNOTATION_STEP, STANDING_SPEED, Tracks, read_tracks
from scenes.geometry import directions, distance_to_people, distance_to_walls
from scenes.robot_task import check_on_map, position, robot_task
from scenes.scene import GOAL_DISTANCE, PEDESTRIAN_RADIUS, Pedestrian, Position, Scene, segments_of
from scenes.scene_text import one_line

_END_IS_NEAR = 1.0  # a track that ends nearer does not show where the person is headed, m

_LONGEST_TRACK = 150  # steps of a track that are kept: a minute, the longest simulated time

MOMENT = 4.0
"""Least time between two busy moments of a recording, s: neighbouring frames show one crowd."""


def scene_from_tracks(
    path: Path, frame: int, robot_start: Position | None = None, robot_goal: Position | None = None
) -> Scene:
    """The scene of one moment of a recording, with a robot that crosses it.

    People start where they were and as fast as they were, and their true walk is kept as their
    track. Their desired speed is the mean speed of the rest of their track. Their goal lies far
    beyond the end of their track, because people did not stop where the camera's view ends, but the
    force model stops people at their goals. Whoever is slower than `STANDING_SPEED` stands. People
    who are annotated inside a wall or another person are moved out by as little as possible (to
    within 1 cm).

    A start or goal of the robot that is left open is chosen so that the robot narrowly passes as
    many people as possible in the next four seconds; the choice is the same each time. A chosen
    start lies at least 3 m from the middle of the people and at least 1.5 m from each of them.

    Args:
        path: the recording's folder, or its file of annotations.
        frame: number of an annotated frame; the scene's number.
        robot_start: where the robot starts (x, y), m; None leaves it open.
        robot_goal: where the robot is headed (x, y), m; None leaves it open.

    Raises:
        InputError: if the recording cannot be read, nobody is annotated at the frame, or the robot
            would start inside a person or a wall.
    """
    tracks = read_tracks(path)
    check_on_map("robot_start", robot_start)
    check_on_map("robot_goal", robot_goal)
    now = _at_frame(tracks, frame)
    people = tracks.people[now]
    segments = segments_of(tracks.walls)
    starts = _moved_clear(tracks.positions[now], segments)
    try:
        return Scene(
            name=_scene_name(tracks.name, frame),
            robot=robot_task(starts, tracks.velocities[now], segments, robot_start, robot_goal),
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


def busiest_frames(path: Path, count: int = 10) -> list[tuple[int, int]]:
    """The frames with most people, at least `MOMENT` apart, and how many people they show.

    The frame with most people comes first; of two frames with equally many, the earlier one.

    Args:
        path: the recording's folder, or its file of annotations.
        count: how many frames, at least 1; a short recording gives fewer.

    Raises:
        InputError: if the recording cannot be read, or the count is below 1.
    """
    if count < 1:
        raise InputError(f"count: {count} is not allowed: at least 1")
    tracks = read_tracks(path)
    frames, people = np.unique(tracks.frames, return_counts=True)
    apart = _frame_step(tracks) * round(MOMENT / ANNOTATION_STEP)
    chosen: list[tuple[int, int]] = []
    for index in np.lexsort((frames, -people)):
        frame = int(frames[index])
        if all(abs(frame - other) >= apart for other, _ in chosen):
            chosen.append((frame, int(people[index])))
        if len(chosen) == count:
            break
    return chosen


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


def _frame_step(tracks: Tracks) -> int:
    """How many frames lie between one annotated frame and the next."""
    return int(np.diff(np.unique(tracks.frames)).min(initial=np.iinfo(np.int32).max))


def _track(tracks: Tracks, person: int, frame: int) -> tuple[Position, ...]:
    """Where a person was from a frame on, every `TRACK_STEP`, to the nearest centimetre.

    Where an annotation is missing, the person went straight on to the next one.
    """
    later = (tracks.people == person) & (tracks.frames >= frame)
    steps = (tracks.frames[later] - frame) / _frame_step(tracks)
    every = np.arange(min(int(steps[-1]), _LONGEST_TRACK) + 1)
    places = [np.interp(every, steps, along).round(2) + 0.0 for along in tracks.positions[later].T]
    return tuple(position(place) for place in np.stack(places, axis=-1))


def _pedestrian(tracks: Tracks, person: int, frame: int, start: FloatArray) -> Pedestrian:
    later = (tracks.people == person) & (tracks.frames >= frame)
    positions, velocities = tracks.positions[later], tracks.velocities[later]
    place, track = position(start), _track(tracks, person, frame)
    speeds = np.hypot(velocities[:, 0], velocities[:, 1])
    if min(speeds[0], speeds.mean()) < STANDING_SPEED:
        return Pedestrian(start=place, goal=place, desired_speed=0.0, track=track)
    ahead = positions[-1] - start
    if np.hypot(*ahead) < _END_IS_NEAR:
        ahead = velocities[0]
    goal = start + GOAL_DISTANCE * ahead / np.hypot(*ahead)
    try:
        return Pedestrian(
            start=place,
            goal=position(goal),
            desired_speed=float(speeds.mean()),
            velocity=position(velocities[0]),
            track=track,
        )
    except ValidationError as error:
        raise InputError(
            f"{tracks.name}, frame {frame}, person {person}: {one_line(error)}"
        ) from None


def _groups_present(
    groups: tuple[tuple[int, ...], ...], people: IntArray
) -> tuple[tuple[int, ...], ...]:
    """Groups of which two members or more are present, as indices of the people present.

    A person who is in several such groups belongs to the first of them only.
    """
    free = {int(person): place for place, person in enumerate(people)}
    present = []
    for group in groups:
        members = [person for person in dict.fromkeys(group) if person in free]
        if len(members) > 1:
            present.append(tuple(free.pop(person) for person in members))
    return tuple(present)


def _moved_clear(positions: FloatArray, segments: FloatArray) -> FloatArray:
    """The positions, [P, 2]; each that lies inside a wall or another person is moved out of it."""
    clear = positions.copy()
    for index in range(len(clear)):
        others = np.delete(clear, index, axis=0)
        for ring in _rings_around(clear[index]):
            free = distance_to_people(ring, others) >= PEDESTRIAN_RADIUS
            free &= distance_to_walls(ring, segments) >= PEDESTRIAN_RADIUS
            if free.any():
                clear[index] = ring[free.argmax()]
                break
    return clear


def _rings_around(point: FloatArray) -> Iterator[FloatArray]:
    """The point itself, [1, 2], then ever wider rings of points about it, [72, 2], up to 3 m."""
    yield point[None]
    around = directions(72)
    for step in range(1, 301):
        yield point + 0.01 * step * around


def _scene_name(name: str, frame: int) -> str:
    """The recording's name and the frame, in letters that a scene's name may have."""
    ending = f"-{frame}"
    plain = re.sub(r"[^A-Za-z0-9_.\-]", "_", name).lstrip("_.-") or "tracks"
    return plain[: 64 - len(ending)] + ending
