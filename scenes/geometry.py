"""Distances between points and straight segments."""

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]


def nearest_on_segments(points: FloatArray, segments: FloatArray) -> FloatArray:
    """The point of each segment that is nearest to each point.

    Args:
        points: [..., 2], m.
        segments: [W, 2, 2], both ends of each segment, m.

    Returns:
        [..., W, 2], m.
    """
    start, along = segments[:, 0], segments[:, 1] - segments[:, 0]  # (W, 2)
    squared_length = np.einsum("wc,wc->w", along, along)
    share = np.einsum("...wc,wc->...w", points[..., None, :] - start, along) / squared_length
    nearest: FloatArray = start + np.clip(share, 0.0, 1.0)[..., None] * along
    return nearest


def distance_to_segments(points: FloatArray, segments: FloatArray) -> FloatArray:
    """Distance of each point to each segment.

    Args:
        points: [..., 2], m.
        segments: [W, 2, 2], both ends of each segment, m.

    Returns:
        [..., W], m.
    """
    gap = points[..., None, :] - nearest_on_segments(points, segments)
    distance: FloatArray = np.hypot(gap[..., 0], gap[..., 1])
    return distance
