"""Where the names of the actions stand in the world, so that they hide little and not each other.

The viewer writes labels in a size of its own, so how much of the world they take can only be
estimated: it is what they take where the overview is small.
"""

import numpy as np

from studio.arrays import BoolArray, Bounds, FloatArray
from studio.style.places import choose_places, places_around

# the view of the world in a viewer that is 1280 pixels wide and 800 high
VIEW_WIDTH, VIEW_HEIGHT = 780.0, 400.0  # px
LETTER_WIDTH = 7.0  # px
PADDING = 16.0  # width of the frame on both sides of the words together, px
LABEL_HEIGHT = 24.0  # px
LARGEST_VIEW = 2.0  # views up to this many times as large have lines that reach their labels

DISTANCES = (0.25, 0.75, 1.25, 2.0, 3.0, 4.5, 6.0)  # of a label from its thing, in label heights
DIRECTIONS = 16  # in which a label may stand around what it names
WALL_POINTS = 20  # points of a wall that tell whether a label hides it
ROUNDS = 4  # how often each label is placed anew, once it is known where the others are
NEARER = 1e-6  # of two distances that differ by less, neither counts as the shorter one, m

COST_OF_HIDING = 15.0  # of a label that hides all ways of one action
COST_OF_WALL = 3.0  # of hiding a wall
COST_OF_DISTANCE = 0.7  # of each of its heights that a label is away
COST_OF_TURNING = 0.5  # of standing behind instead of ahead
FORBIDDEN = 1e3  # cost of hiding another label or leaving the view
MISLEADING = 1e2  # cost of being nearer to another's end


def metres_per_pixel(bounds: Bounds) -> float:
    """How large a pixel is in a small view of these bounds, m."""
    x0, y0, x1, y1 = bounds
    return max((x1 - x0) / VIEW_WIDTH, (y1 - y0) / VIEW_HEIGHT)


def half_size(words: str, bounds: Bounds) -> FloatArray:
    """Half the width and half the height of a label in a small view of these bounds, m."""
    size = np.array([LETTER_WIDTH * len(words) + PADDING, LABEL_HEIGHT])
    return size * metres_per_pixel(bounds) / 2.0


def leader(end: FloatArray, middle: FloatArray, half: FloatArray) -> FloatArray:
    """The line from what a label names into the label, [2, 2], m.

    The viewer hangs a label from the middle of its top and always writes it equally large: in a
    larger view it takes less of the world. The line reaches what it then takes, but no farther,
    since it shines through the words.
    """
    reach = half / LARGEST_VIEW
    centre = middle + np.array([0.0, half[1] - reach[1]])
    return np.stack([end, np.clip(end, centre - reach, centre + reach)])


def label_places(
    labels: tuple[str, ...], ends: FloatArray, ways: FloatArray, walls: FloatArray, bounds: Bounds
) -> FloatArray:
    """The middle of each label: nearest to the end of what it names, and where little else is.

    Args:
        labels: their words.
        ends: [A, 2], where what they name ends, m.
        ways: [A, N, T, 2], N ways that each of the A labels names; better not hidden.
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
    halves = [half_size(words, bounds) for words in labels]
    candidates: list[FloatArray] = []
    costs: list[FloatArray] = []
    for index, (half, end) in enumerate(zip(halves, ends, strict=True)):
        along = end - ways[index, :, 0].mean(axis=0)
        turned = np.arctan2(along[1], along[0]) + angles
        middles = places_around(end, half, np.array(DISTANCES) * height, turned)
        away = np.repeat(DISTANCES, DIRECTIONS)
        turning = np.tile(1.0 - np.cos(angles), len(DISTANCES)) / 2.0
        is_hidden = np.all(np.abs(traces - middles[:, None]) <= half, axis=-1)
        hides_wall = np.all(np.abs(bricks - middles[:, None]) <= half, axis=-1).any(axis=1)
        is_outside = np.any((middles - half < low) | (middles + half > high), axis=-1)
        cost = COST_OF_DISTANCE * away + COST_OF_TURNING * turning
        cost += COST_OF_HIDING * is_hidden.mean(axis=1) * len(labels) + COST_OF_WALL * hides_wall
        cost += FORBIDDEN * is_outside + MISLEADING * is_misleading(middles, half, ends, index)
        candidates.append(middles)
        costs.append(cost)
    return choose_places(candidates, halves, costs, FORBIDDEN, ROUNDS)


def is_misleading(middles: FloatArray, half: FloatArray, ends: FloatArray, index: int) -> BoolArray:
    """Whether a label at each of N middles [N, 2] seems to name another end than its own.

    It does if its middle or its edge is nearer to another of the ends [A, 2]. Of ends in one place
    none is nearer than the other.
    """
    offsets = np.abs(middles[:, None] - ends)  # (N, A, 2)
    to_middle = np.linalg.norm(offsets, axis=-1)
    to_edge = np.linalg.norm(np.maximum(offsets - half, 0.0), axis=-1)
    away = np.stack([to_middle, to_edge])
    nearer: BoolArray = np.any(away.min(axis=-1) < away[..., index] - NEARER, axis=0)
    return nearer
