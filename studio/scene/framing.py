"""Which part of the world a view shows."""

import numpy as np

from scenes import Rollouts
from scenes.features import gaps
from studio.arrays import Bounds

SURROUNDINGS = 1.6  # beyond everywhere the robot gets, where there is anything to see, m
MARGIN = 0.4  # from the outermost thing in the view to its edge, m
NEAR = 1.0  # who comes closer to the robot than this gap matters to the view, m


def bounds_to_show(rollouts: Rollouts) -> Bounds:
    """Everywhere the robot gets under any action, and what of the scene lies near to that."""
    paths = rollouts.robot[..., :2].reshape(-1, 2)
    low, high = paths.min(axis=0), paths.max(axis=0)
    x0, y0, x1, y1 = rollouts.scene.bounds
    low = np.maximum(np.minimum(low, (x0, y0)), low - SURROUNDINGS) - MARGIN
    high = np.minimum(np.maximum(high, (x1, y1)), high + SURROUNDINGS) + MARGIN
    return float(low[0]), float(low[1]), float(high[0]), float(high[1])


def bounds_of_shape(rollouts: Rollouts, width: float, height: float) -> Bounds:
    """The bounds to show, grown in one direction until they have the shape of width to height.

    They grow towards the robot's goal and towards where the people start who come near the robot.
    """
    x0, y0, x1, y1 = bounds_to_show(rollouts)
    low, high = np.array([x0, y0]), np.array([x1, y1])
    shape = np.array([width, height])
    half = shape * ((high - low) / shape).max() / 2
    comes_near = (gaps(rollouts.robot, rollouts.pedestrians) < NEAR).any(axis=(0, 1, 2))
    scene = rollouts.scene
    telling = np.concatenate([scene.starts[comes_near], [scene.robot.goal]])
    wanted_low = np.minimum(low, telling.min(axis=0) - MARGIN)
    wanted_high = np.maximum(high, telling.max(axis=0) + MARGIN)
    # whatever else is in view, the bounds to show are
    centre = np.clip((wanted_low + wanted_high) / 2, high - half, low + half)
    (x0, y0), (x1, y1) = centre - half, centre + half
    return float(x0), float(y0), float(x1), float(y1)
