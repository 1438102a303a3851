"""Which part of the world a view shows."""

import numpy as np

from scenes import Rollouts

Bounds = tuple[float, float, float, float]
"""x0, y0, x1, y1 in m."""

SURROUNDINGS = 3.0
"""What is shown around all that the robot may do, if there is anything, m."""

MARGIN = 0.6
"""Between the outermost thing and the edge of the view, m."""


def bounds_to_show(rollouts: Rollouts) -> Bounds:
    """Everywhere the robot gets under any action, and as much of the scene as lies near."""
    paths = rollouts.robot[..., :2].reshape(-1, 2)
    low, high = paths.min(axis=0), paths.max(axis=0)
    x0, y0, x1, y1 = rollouts.scene.bounds
    low = np.maximum(np.minimum(low, (x0, y0)), low - SURROUNDINGS) - MARGIN
    high = np.minimum(np.maximum(high, (x1, y1)), high + SURROUNDINGS) + MARGIN
    return float(low[0]), float(low[1]), float(high[0]), float(high[1])
