"""Which part of the world a view shows."""

import numpy as np
from numpy.typing import NDArray

from scenes import Rollouts
from scenes.scene import PEDESTRIAN_RADIUS, ROBOT_RADIUS
from studio.arrays import Bounds

SURROUNDINGS = 1.6
"""What is shown around all that the robot may do, if there is anything, m."""

MARGIN = 0.4
"""Between the outermost thing and the edge of the view, m."""

NEAR = 1.0
"""A gap below which a person has to do with the robot, m."""


def bounds_to_show(rollouts: Rollouts) -> Bounds:
    """Everywhere the robot gets under any action, and as much of the scene as lies near."""
    paths = rollouts.robot[..., :2].reshape(-1, 2)
    low, high = paths.min(axis=0), paths.max(axis=0)
    x0, y0, x1, y1 = rollouts.scene.bounds
    low = np.maximum(np.minimum(low, (x0, y0)), low - SURROUNDINGS) - MARGIN
    high = np.minimum(np.maximum(high, (x1, y1)), high + SURROUNDINGS) + MARGIN
    return float(low[0]), float(low[1]), float(high[0]), float(high[1])


def bounds_of_shape(rollouts: Rollouts, width: float, height: float) -> Bounds:
    """The bounds to show, grown in one direction until width and height stand in this proportion.

    They grow towards the robot's goal and towards where the people start who have to do with it.
    """
    x0, y0, x1, y1 = bounds_to_show(rollouts)
    low, high = np.array([x0, y0]), np.array([x1, y1])
    shape = np.array([width, height])
    half = shape * ((high - low) / shape).max() / 2
    telling = np.concatenate([_starts_of_those_near(rollouts), [rollouts.scene.robot.goal]])
    wanted_low = np.minimum(low, telling.min(axis=0) - MARGIN)
    wanted_high = np.maximum(high, telling.max(axis=0) + MARGIN)
    # whatever else is in view, the bounds to show are
    centre = np.clip((wanted_low + wanted_high) / 2, high - half, low + half)
    (x0, y0), (x1, y1) = centre - half, centre + half
    return float(x0), float(y0), float(x1), float(y1)


def _starts_of_those_near(rollouts: Rollouts) -> NDArray[np.float64]:
    """Where the people start [N, 2] who come near the robot in any rollout of any action, m."""
    away = rollouts.pedestrians - rollouts.robot[:, :, :, None, :2]
    reach = NEAR + ROBOT_RADIUS + PEDESTRIAN_RADIUS
    near = (np.hypot(away[..., 0], away[..., 1]) < reach).any(axis=(0, 1, 2))
    starts: NDArray[np.float64] = rollouts.scene.starts[near]
    return starts
