"""The scene: everything about one situation that is not random."""

import math
from collections.abc import Sequence
from typing import Annotated

import numpy as np
from pydantic import ConfigDict, Field
from pydantic.dataclasses import dataclass

from scenes.arrays import FloatArray
from scenes.geometry import distance_to_segments

PEDESTRIAN_RADIUS = 0.20
"""Radius of a pedestrian's disc, m."""

ROBOT_RADIUS = 0.25
"""Radius of the robot's disc, m."""

SHORTEST_WALL = 0.1
"""Length of the shortest wall, m: pedestrians feel a wall through points every 0.1 m."""

MEAN_WALKING_SPEED = 1.34
"""Mean desired speed of pedestrians, m/s (Helbing and Molnár 1995, section III)."""

TRACK_STEP = 0.4
"""Time between two places of a recorded walk, s."""

GOAL_DISTANCE = 40.0
"""How far away the goals lie that are chosen for people, m: nobody walks so far in 10 s."""

ROBOT_TASK = 8.0
"""Distance from the robot's start to a goal that is chosen for it, m."""

LARGEST_NUMBER = 2**31 - 1
"""Largest number of a scene in a series."""

_STRICT = ConfigDict(extra="forbid", allow_inf_nan=False)

Coordinate = Annotated[float, Field(strict=True, ge=-1000.0, le=1000.0)]
SpeedComponent = Annotated[float, Field(strict=True, ge=-5.0, le=5.0)]
Word = Annotated[str, Field(pattern=r"^[a-z][a-z0-9_]{0,31}$")]
Position = tuple[Coordinate, Coordinate]


@dataclass(frozen=True, config=_STRICT)
class Wall:
    """A straight wall between two points (x, y), m."""

    start: Position
    end: Position


@dataclass(frozen=True, config=_STRICT)
class Pedestrian:
    """A person who walks to a goal, or stands.

    Attributes:
        start: where the person is at time 0 (x, y), m.
        goal: where the person wants to be (x, y), m; it means nothing to a person who stands.
        desired_speed: the speed the person likes to walk at, m/s; 0 is a person who stands and
            stays standing.
        velocity: velocity at time 0 (vx, vy), m/s; left out, the person walks at the desired
            speed towards the goal.
        track: where a person of a real crowd truly was from time 0 on, every `TRACK_STEP` (x, y),
            m; left out for people who are made up. Nothing is simulated by it: simulated walks can
            be held against it.
    """

    start: Position
    goal: Position
    desired_speed: Annotated[float, Field(strict=True, ge=0.0, le=5.0)] = MEAN_WALKING_SPEED
    velocity: tuple[SpeedComponent, SpeedComponent] | None = None
    track: Annotated[tuple[Position, ...], Field(min_length=1, max_length=500)] | None = None


@dataclass(frozen=True, config=_STRICT)
class Robot:
    """Where the robot is when it must choose, and where it is headed.

    Attributes:
        start: position at time 0 (x, y), m.
        goal: position it should reach (x, y), m.
        heading: direction it faces at time 0, rad, anticlockwise from x; left out, it faces
            the goal.
        speed: forward speed at time 0, m/s: the robot is under way when it must choose.
    """

    start: Position
    goal: Position
    heading: Annotated[float, Field(strict=True, ge=-math.tau, le=math.tau)] | None = None
    speed: Annotated[float, Field(strict=True, ge=0.0, le=3.0)] = 1.0

    @property
    def start_heading(self) -> float:
        """Direction faced at time 0, rad."""
        if self.heading is not None:
            return self.heading
        return math.atan2(self.goal[1] - self.start[1], self.goal[0] - self.start[0])


@dataclass(frozen=True, config=_STRICT)
class Scene:
    """Walls, pedestrians and the robot's task: one situation, with nothing random left in it.

    Attributes:
        name: what the scene is called; files made from it bear this name.
        pedestrians: the people, in a fixed order that arrays and groups refer to.
        groups: people who walk together, each group a tuple of indices into `pedestrians`.
        family: kind of place: one of the four generated families, or a word of your own.
        pattern: how people meet in it: one of the six patterns, or a word of your own.
        number: which scene of a seeded series this is. It keys the noise, so two scenes of one
            series are never shaken by the same random numbers.

    Raises:
        pydantic.ValidationError: if a value is out of range or the scene contradicts itself
            (`load_scene` and `scene_from_toml` turn it into an `InputError` of one line).
    """

    name: Annotated[str, Field(pattern=r"^[A-Za-z0-9][A-Za-z0-9_.\-]{0,63}$")]
    robot: Robot
    pedestrians: Annotated[tuple[Pedestrian, ...], Field(max_length=500)] = ()
    walls: Annotated[tuple[Wall, ...], Field(max_length=500)] = ()
    groups: tuple[tuple[Annotated[int, Field(strict=True)], ...], ...] = ()
    family: Word = "custom"
    pattern: Word = "custom"
    number: Annotated[int, Field(strict=True, ge=0, le=LARGEST_NUMBER)] = 0

    def __repr__(self) -> str:
        # `scene_to_toml` tells everything
        kind = f"{self.family}, {self.pattern}, number {self.number}"
        inside = f"{len(self.pedestrians)} pedestrians, {len(self.walls)} walls"
        return f"<Scene {self.name}: {kind}, {inside}>"

    def __post_init__(self) -> None:
        _check_walls(self)
        _check_groups(self)
        _check_robot(self)
        _check_pedestrians(self)

    @property
    def wall_segments(self) -> FloatArray:
        """Both ends of every wall, [W, 2, 2], m."""
        return segments_of(self.walls)

    @property
    def starts(self) -> FloatArray:
        """Where the pedestrians are at time 0, [P, 2], m."""
        return starts_of(self.pedestrians)

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """Smallest box around walls, starts and the robot's goal: x0, y0, x1, y1 in m."""
        points = np.concatenate(
            [self.wall_segments.reshape(-1, 2), self.starts, [self.robot.start, self.robot.goal]]
        )
        (x0, y0), (x1, y1) = points.min(axis=0), points.max(axis=0)
        return float(x0), float(y0), float(x1), float(y1)


def segments_of(walls: Sequence[Wall]) -> FloatArray:
    """Both ends of every wall, [W, 2, 2], m."""
    return np.array([(wall.start, wall.end) for wall in walls]).reshape(-1, 2, 2)


def starts_of(people: Sequence[Pedestrian]) -> FloatArray:
    """Where people are at time 0, [P, 2], m."""
    return np.array([person.start for person in people]).reshape(-1, 2)


def _check_walls(scene: Scene) -> None:
    for index, wall in enumerate(scene.walls):
        length = math.dist(wall.start, wall.end)
        if length < SHORTEST_WALL:
            raise ValueError(
                f"walls[{index}] is {length:g} m long: at least {SHORTEST_WALL} m is needed"
            )


def _check_groups(scene: Scene) -> None:
    count, group_of = len(scene.pedestrians), dict[int, int]()
    for index, group in enumerate(scene.groups):
        if len(group) < 2:
            raise ValueError(f"groups[{index}] has {len(group)} members: at least 2 are needed")
        for member in group:
            if not 0 <= member < count:
                raise ValueError(
                    f"groups[{index}] names pedestrian {member}: there are {count}, numbered from 0"
                )
            if member in group_of:
                raise ValueError(
                    f"groups[{index}] names pedestrian {member}, who is in groups"
                    f"[{group_of[member]}] already: a person is in one group at most"
                )
            group_of[member] = index


def _check_robot(scene: Scene) -> None:
    robot = scene.robot
    if math.dist(robot.start, robot.goal) < ROBOT_RADIUS:
        raise ValueError(
            f"robot.goal is {math.dist(robot.start, robot.goal):g} m from robot.start: "
            f"at least {ROBOT_RADIUS} m is needed"
        )
    _check_clear_of_walls(scene, "robot.start", np.array([robot.start]), ROBOT_RADIUS)


def _check_pedestrians(scene: Scene) -> None:
    for index, person in enumerate(scene.pedestrians):
        if person.desired_speed > 0 and person.start == person.goal:
            raise ValueError(
                f"pedestrians[{index}] walks at {person.desired_speed:g} m/s but starts at its "
                "goal: give it another goal, or desired_speed 0 to stand"
            )
    starts = scene.starts
    _check_clear_of_walls(scene, "pedestrians[{}].start", starts, PEDESTRIAN_RADIUS)
    apart = np.linalg.norm(starts[:, None] - starts[None], axis=-1)
    for first, second in np.argwhere(np.triu(apart < PEDESTRIAN_RADIUS, k=1))[:1]:
        raise ValueError(
            f"pedestrians[{first}] and pedestrians[{second}] start {apart[first, second]:.2f} m "
            f"apart, inside each other: at least {PEDESTRIAN_RADIUS} m is needed"
        )
    to_robot = np.linalg.norm(starts - np.array(scene.robot.start), axis=-1)
    needed = PEDESTRIAN_RADIUS + ROBOT_RADIUS
    for index in np.flatnonzero(to_robot < needed)[:1]:
        raise ValueError(
            f"pedestrians[{index}] starts {to_robot[index]:.2f} m from the robot, inside it: "
            f"at least {needed:.2f} m is needed"
        )


def _check_clear_of_walls(scene: Scene, who: str, points: FloatArray, radius: float) -> None:
    if not scene.walls or not len(points):
        return
    distance = distance_to_segments(points, scene.wall_segments)  # (points, walls)
    for index, wall in np.argwhere(distance < radius)[:1]:
        raise ValueError(
            f"{who.format(index)} is {distance[index, wall]:.2f} m from walls[{wall}], inside it: "
            f"at least {radius:.2f} m is needed"
        )
