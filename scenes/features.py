"""What a rollout is described by: five features.

Each feature is scaled by a fixed constant, never by the data, so that a reward θ means the same in
every outcome bank.
"""

from dataclasses import dataclass

import numpy as np

from scenes.arrays import BoolArray, FloatArray, IntArray
from scenes.geometry import distance_to_walls, lengths
from scenes.scene import PEDESTRIAN_RADIUS, ROBOT_RADIUS, Scene

FEATURES = ("clearance", "deviation", "progress", "smoothness", "collisions")
"""The features φ, in the order of every feature axis and of the reward θ."""

CLEARANCE_SCALE = 2.0
"""The gap from which on the clearance is 1, m."""

DEVIATION_SCALE = 0.5
"""How far people are pushed off their paths, on average, at deviation 1, m."""

PROGRESS_SPEED = 1.0
"""How fast the robot nears its goal, over the whole horizon, at progress 1, m/s."""


@dataclass(frozen=True, kw_only=True)
class Outcomes:
    """What came of K rollouts under each of A actions.

    Attributes:
        features: [A, K, 5], scaled, in the order of `FEATURES`.
        clearance_m: [A, K], smallest gap between the robot and any pedestrian, clipped to 0 to
            2 m (2 m among no pedestrians), m.
        deviation_m: [A, K], mean over pedestrians and time of the distance between a pedestrian's
            path and the one without the robot, m.
        progress_m: [A, K], how much closer the robot got to its goal, m.
        person_step: [A, K], first step at which the robot touches a pedestrian; -1 if it never
            does.
        wall_step: [A, K], first step at which the robot touches a wall; -1 if it never does.
    """

    features: FloatArray
    clearance_m: FloatArray
    deviation_m: FloatArray
    progress_m: FloatArray
    person_step: IntArray
    wall_step: IntArray

    @property
    def count(self) -> int:
        """How many outcomes there are of each action, K."""
        return int(self.features.shape[1])

    @property
    def contact_step(self) -> IntArray:
        """[A, K]: first step at which the robot touches a pedestrian or a wall; -1 for never."""
        earlier = np.minimum(self.person_step, self.wall_step)
        # where one of the two is -1, the other one tells
        return np.where(earlier >= 0, earlier, np.maximum(self.person_step, self.wall_step))

    @property
    def touched(self) -> BoolArray:
        """[A, K]: whether the robot ever touches a pedestrian or a wall."""
        touched: BoolArray = self.contact_step >= 0
        return touched

    @property
    def wall_touched(self) -> BoolArray:
        """[A, K]: whether the robot ever touches a wall."""
        touched: BoolArray = self.wall_step >= 0
        return touched

    @property
    def people_touched(self) -> IntArray:
        """[A, K]: how many pedestrians the robot touches, which `collisions` counts with walls."""
        collisions = self.features[..., FEATURES.index("collisions")]
        return np.rint(collisions).astype(np.int64) - self.wall_touched


def gaps(robot: FloatArray, pedestrians: FloatArray) -> FloatArray:
    """Gap between the robot, [..., 3] (x and y in m, heading in rad), and each pedestrian, m.

    Pedestrians are at [..., P, 2], m. Gaps are [..., P], negative where two overlap.
    """
    return lengths(pedestrians - robot[..., None, :2]) - (ROBOT_RADIUS + PEDESTRIAN_RADIUS)


def distances_to_goal(robot: FloatArray, scene: Scene) -> FloatArray:
    """How far the robot, [..., 3] (x and y in m, heading in rad), is from its goal, [...], m."""
    return lengths(robot[..., :2] - np.array(scene.robot.goal))


def describe(
    scene: Scene, robot: FloatArray, pedestrians: FloatArray, without_robot: FloatArray, dt: float
) -> Outcomes:
    """Describe rollouts by their features.

    Args:
        scene: has the walls and the robot's goal.
        robot: [A, K, T+1, 3], x and y in m, heading in rad.
        pedestrians: [A, K, T+1, P, 2], m.
        without_robot: [K, T+1, P, 2], m.
        dt: length of a step, s.
    """
    gap = gaps(robot, pedestrians)  # (A, K, T+1, P)
    clearance = np.clip(gap.min(axis=(2, 3), initial=CLEARANCE_SCALE), 0.0, CLEARANCE_SCALE)
    aside = lengths(pedestrians - without_robot)  # (A, K, T+1, P)
    deviation = aside.mean(axis=(2, 3)) if aside.shape[-1] else np.zeros(robot.shape[:2])
    to_goal = distances_to_goal(robot, scene)  # (A, K, T+1)
    progress = to_goal[..., 0] - to_goal[..., -1]
    turning = np.abs(np.diff(robot[..., 2], axis=-1)).sum(axis=-1)  # (A, K)

    touches_people = gap < 0.0  # (A, K, T+1, P)
    touches_wall: BoolArray = distance_to_walls(robot[..., :2], scene.wall_segments) < ROBOT_RADIUS
    collisions = touches_people.any(axis=2).sum(axis=-1) + touches_wall.any(axis=-1)

    horizon = (robot.shape[2] - 1) * dt
    features = np.stack(
        [
            clearance / CLEARANCE_SCALE,
            deviation / DEVIATION_SCALE,
            progress / (PROGRESS_SPEED * horizon),
            1.0 / (1.0 + turning),
            collisions.astype(np.float64),
        ],
        axis=-1,
    )
    return Outcomes(
        features=features,
        clearance_m=clearance,
        deviation_m=deviation,
        progress_m=progress,
        person_step=first_step(np.any(touches_people, axis=-1)),
        wall_step=first_step(touches_wall),
    )


def first_step(happens: BoolArray) -> IntArray:
    """The first step at which something happens that is told for every one, -1 for never.

    Steps are the last axis: [..., T+1] gives [...].
    """
    return np.where(happens.any(axis=-1), happens.argmax(axis=-1), -1)
