"""Where the names of the actions stand in the world, so that they hide little and not each other.

The viewer writes labels in a size of its own, so how much of the world they take can only be
estimated: it is what they take where the overview is small.
"""

import numpy as np

from studio.framing import Bounds
from studio.judgements import FloatArray

VIEW_WIDTH, VIEW_HEIGHT = 780.0, 400.0
"""Of the view of the world in a viewer that is 1280 pixels wide and 800 high, px."""

LETTER_WIDTH, PADDING, LABEL_HEIGHT = 7.0, 16.0, 24.0
"""Of a letter, around the letters on both sides, and of the whole label, px."""

DISTANCES = (0.75, 1.25, 2.0, 3.0, 4.5, 6.0)
"""How far from what it names a label may stand, in its own heights."""

DIRECTIONS = 16
"""In how many directions around it."""

COST_OF_HIDING, COST_OF_DISTANCE, COST_OF_TURNING = 60.0, 0.4, 1.0
"""Of hiding the ways of a whole action; of a label's height; of standing behind, not ahead."""

COST_OF_WALL = 3.0
"""Of hiding a wall."""

WALL_POINTS = 20
"""A wall is seen at so many points."""

FORBIDDEN = 1e3
"""Cost of hiding another label, or of leaving the view."""


def metres_per_pixel(bounds: Bounds) -> float:
    """How large a pixel is in a small view of these bounds, m."""
    x0, y0, x1, y1 = bounds
    return max((x1 - x0) / VIEW_WIDTH, (y1 - y0) / VIEW_HEIGHT)


def half_size(words: str, bounds: Bounds) -> FloatArray:
    """Half the width and half the height of a label in a small view of these bounds, m."""
    size = np.array([LETTER_WIDTH * len(words) + PADDING, LABEL_HEIGHT])
    return size * metres_per_pixel(bounds) / 2.0


def leader(end: FloatArray, middle: FloatArray, half: FloatArray) -> FloatArray:
    """The line from what a label names to the edge of the label, [2, 2], m."""
    away = np.abs(end - middle)
    inside = float(np.min(half / np.maximum(away, half)))
    return np.stack([end, middle + inside * (end - middle)])


def label_places(
    labels: tuple[str, ...], ways: FloatArray, walls: FloatArray, bounds: Bounds
) -> FloatArray:
    """The middle of each label: near the end of what it names, and where little else is.

    Args:
        labels: the words.
        ways: [A, N, T, 2], N ways that each of the A labels names; they must not be hidden.
        walls: [W, 2, 2], the ends of walls, m.
        bounds: what the view shows.

    Returns:
        [A, 2], m.
    """
    height = LABEL_HEIGHT * metres_per_pixel(bounds)
    angles = np.linspace(0.0, 2.0 * np.pi, DIRECTIONS, endpoint=False)
    low, high = np.array(bounds).reshape(2, 2)
    traces = ways.reshape(-1, 2)
    along_walls = np.linspace(0.0, 1.0, WALL_POINTS)[:, None, None]
    bricks = (walls[:, 0] + along_walls * (walls[:, 1] - walls[:, 0])).reshape(-1, 2)
    middles = ways.mean(axis=1)  # (A, T, 2)
    places: list[FloatArray] = []
    halves: list[FloatArray] = []
    for words, middle in zip(labels, middles, strict=True):
        half = half_size(words, bounds)
        along = middle[-1] - middle[0]
        turned = np.arctan2(along[1], along[0]) + angles
        ahead = np.stack([np.cos(turned), np.sin(turned)], axis=-1)
        reach = half + np.array(DISTANCES)[:, None, None] * height
        candidates = (middle[-1] + ahead * reach).reshape(-1, 2)
        away = np.repeat(DISTANCES, DIRECTIONS)
        turning = np.tile(1.0 - np.cos(angles), len(DISTANCES)) / 2.0
        is_hidden = np.all(np.abs(traces - candidates[:, None]) <= half, axis=-1)
        hides_wall = np.all(np.abs(bricks - candidates[:, None]) <= half, axis=-1).any(axis=1)
        is_outside = np.any((candidates - half < low) | (candidates + half > high), axis=-1)
        cost = COST_OF_DISTANCE * away + COST_OF_TURNING * turning
        cost += COST_OF_HIDING * is_hidden.mean(axis=1) * len(labels) + COST_OF_WALL * hides_wall
        cost += FORBIDDEN * is_outside
        for place, other in zip(places, halves, strict=True):
            overlaps = np.all(np.abs(candidates - place) < half + other, axis=-1)
            cost += FORBIDDEN * overlaps
        places.append(candidates[cost.argmin()])
        halves.append(half)
    return np.stack(places)
