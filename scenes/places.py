"""The four kinds of place: walls, the robot's task, and where people can be among them."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from scenes.scene import ROBOT_TASK, Position, Robot, Wall

Range = tuple[float, float]
"""The least and the most that may be drawn."""


@dataclass(frozen=True)
class DrawnPlace:
    """A place as it was drawn for one scene; None stands for what is missing."""

    robot: Robot
    walls: tuple[Wall, ...]
    half_width: float  # how far from the axis y = 0 people start at most who walk along it, m
    gate: float | None = None  # half the width of the opening at x = 0 that everybody must pass, m
    street: Range | None = None  # least and greatest x at which people cross y = 0, m
    spread: float = 0.0  # how far people's directions stray from the axes at most, rad


def _corridor(rng: np.random.Generator) -> DrawnPlace:
    # The walls of the force model keep people a metre away, and people must get past the robot in
    # the space between: in a corridor of 4 m or less they walk into it.
    half = 0.5 * rng.uniform(4.6, 6.0)
    start = (-4.0, rng.uniform(-0.4, 0.4))
    walls = (Wall((-9.0, half), (9.0, half)), Wall((-9.0, -half), (9.0, -half)))
    return DrawnPlace(_heading_along_x(start), walls, half_width=half - 1.0)


def _intersection(rng: np.random.Generator) -> DrawnPlace:
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
    return DrawnPlace(_heading_along_x(start), tuple(walls), half_width=half - 1.0, street=street)


def _doorway(rng: np.random.Generator) -> DrawnPlace:
    # The walls of the force model let nobody through an opening of less than about 1.5 m.
    gate = 0.5 * rng.uniform(1.6, 2.4)
    start = (-rng.uniform(4.0, 5.4), rng.uniform(-1.2, 1.2))
    door = (0.0, rng.uniform(-0.1, 0.1) * gate)
    walls = (
        Wall((0.0, gate), (0.0, 3.0)),
        Wall((0.0, -3.0), (0.0, -gate)),
        Wall((-9.0, 3.0), (8.0, 3.0)),
        Wall((-9.0, -3.0), (8.0, -3.0)),
    )
    robot = Robot(start, beyond(start, door, ROBOT_TASK))
    return DrawnPlace(robot, walls, half_width=1.4, gate=gate)


def _open(rng: np.random.Generator) -> DrawnPlace:
    start = (-4.0, rng.uniform(-0.5, 0.5))
    return DrawnPlace(_heading_along_x(start), (), half_width=2.0, street=(-2.5, 1.0), spread=0.3)


def _heading_along_x(start: Position) -> Robot:
    return Robot(start, (start[0] + ROBOT_TASK, start[1]))


PLACES: Mapping[str, Callable[[np.random.Generator], DrawnPlace]] = {
    "corridor": _corridor,
    "intersection": _intersection,
    "doorway": _doorway,
    "open": _open,
}
"""What draws a place of each family."""


def beyond(start: Position, via: Position, distance: float) -> Position:
    """The point at a distance (m) from the start, in the direction of another point."""
    scale = distance / math.dist(start, via)
    return (start[0] + scale * (via[0] - start[0]), start[1] + scale * (via[1] - start[1]))
