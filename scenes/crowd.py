"""What an engine is given: how people set out, and what surrounds them."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np

from scenes.arrays import FloatArray, IntArray
from scenes.scene import Scene

ForceSet = Literal["extended", "helbing-molnar"]
"""A force set of the social force model."""

WALL_POINTS_PER_METRE = 10.0
"""How many points stand for a metre of wall in the forces, 1/m (pysocialforce's resolution)."""


class Crowd(NamedTuple):
    """How P people set out in each of K rollouts, and what shakes them over T steps.

    It is a tuple because compiled code takes tuples.
    """

    starts: FloatArray  # [K, P, 2], m
    velocities: FloatArray  # [K, P, 2], at time 0, m/s
    goals: FloatArray  # [K, P, 2], m
    desired_speeds: FloatArray  # [K, P], m/s; 0 is a person who stands
    accelerations: FloatArray  # [K, T, P, 2], the fluctuation of each step, m/s²

    @property
    def people(self) -> int:
        """P."""
        return int(self.starts.shape[1])

    @property
    def steps(self) -> int:
        """T."""
        return int(self.accelerations.shape[1])


@dataclass(frozen=True)
class Surroundings:
    """What stays the same in every rollout of a scene."""

    wall_points: tuple[FloatArray, ...]  # for each wall, points along it, [n, 2], m
    groups: tuple[tuple[int, ...], ...]  # indices of people who walk together

    @property
    def group_of(self) -> IntArray:
        """Number of each person's group, up to the last who has one; -1 is a person without one."""
        members = [member for group in self.groups for member in group]
        group_of = np.full(max(members, default=-1) + 1, -1, dtype=np.int64)
        for number, group in enumerate(self.groups):
            group_of[list(group)] = number
        return group_of


Walk = Callable[[Crowd, Surroundings, FloatArray, ForceSet, bool, float], FloatArray]
"""What every engine offers under the name `walk`; `scenes.batched.walk` says what it is given."""


def surroundings_of(scene: Scene) -> Surroundings:
    """The walls and groups of a scene as the forces see them."""
    points = []
    for start, end in scene.wall_segments:
        # pysocialforce samples its obstacles so.
        count = max(1, int(np.linalg.norm(start - end) * WALL_POINTS_PER_METRE))
        points.append(np.linspace(start, end, count))
    return Surroundings(tuple(points), scene.groups)
