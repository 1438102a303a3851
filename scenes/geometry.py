"""Lengths, and distances between points and straight segments.

A segment is given by its two ends; everything is in m.
"""

import math

import numpy as np

from scenes.arrays import FloatArray


def lengths(vectors: FloatArray) -> FloatArray:
    """Length of each vector of the last axis, [..., 2] to [...]."""
    x, y = vectors[..., 0], vectors[..., 1]
    result: FloatArray = np.sqrt(x * x + y * y)
    return result


def directions(count: int) -> FloatArray:
    """Unit vectors in evenly spaced directions, the first along x, [count, 2]."""
    angles = np.linspace(0.0, math.tau, count, endpoint=False)
    return np.stack([np.cos(angles), np.sin(angles)], axis=-1)


def nearest_on_segments(points: FloatArray, segments: FloatArray) -> FloatArray:
    """The point of each segment, [W, 2, 2], nearest to each point, [..., 2]: [..., W, 2]."""
    x, y = points[..., 0, None], points[..., 1, None]  # (..., 1)
    x0, y0 = segments[:, 0, 0], segments[:, 0, 1]  # (W,)
    along_x, along_y = segments[:, 1, 0] - x0, segments[:, 1, 1] - y0
    share = ((x - x0) * along_x + (y - y0) * along_y) / (along_x**2 + along_y**2)
    share = np.minimum(np.maximum(share, 0.0), 1.0)
    return np.stack([x0 + share * along_x, y0 + share * along_y], axis=-1)


def distance_to_segments(points: FloatArray, segments: FloatArray) -> FloatArray:
    """Distance of each point, [..., 2], to each segment, [W, 2, 2]: [..., W]."""
    return lengths(nearest_on_segments(points, segments) - points[..., None, :])


def distance_to_people(points: FloatArray, people: FloatArray) -> FloatArray:
    """Distance of each point, [N, 2], to the nearest of people, [P, 2]: [N], inf without."""
    apart = np.linalg.norm(points[:, None] - people, axis=-1)
    nearest: FloatArray = apart.min(axis=1, initial=np.inf)
    return nearest


def distance_to_walls(points: FloatArray, segments: FloatArray) -> FloatArray:
    """Distance of each point, [..., 2], to the nearest of walls, [W, 2, 2]: [...], inf without."""
    nearest: FloatArray = distance_to_segments(points, segments).min(axis=-1, initial=np.inf)
    return nearest
