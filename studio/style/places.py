"""Where things that are written find room beside one another, in any unit of length."""

import math
from collections.abc import Sequence

import numpy as np

from studio.arrays import FloatArray


def spread_apart(heights: Sequence[float], step: float, low: float, high: float) -> list[float]:
    """Ascending heights moved so far apart that neighbours are at least a step apart.

    All stay between `low` and `high`, between which there is room for as many steps as heights.
    """
    spread = list(heights)
    last = len(spread) - 1
    for _ in range(30):
        for index in range(last):
            push = max(spread[index] + step - spread[index + 1], 0.0) / 2
            spread[index] -= push
            spread[index + 1] += push
    # what is left to do is exact, and keeps to the limits
    for index in range(last + 1):
        spread[index] = max(spread[index], spread[index - 1] + step if index else low)
    for index in range(last, -1, -1):
        spread[index] = min(spread[index], spread[index + 1] - step if index < last else high)
    return spread


def places_around(
    point: FloatArray, half: FloatArray, distances: FloatArray, angles: FloatArray
) -> FloatArray:
    """Places for a box all around a point, where it touches ovals around the point from outside.

    Args:
        point: [2].
        half: half the width and half the height of the box, [2].
        distances: how far ovals are from the point, beyond the size of the box, [R].
        angles: in which directions from the point places lie, [D], rad.

    Returns:
        The middle of the box at each place, oval by oval, [R * D, 2].
    """
    ahead = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    return (point + ahead * (half + distances[:, None, None])).reshape(-1, 2)


def choose_places(
    middles: Sequence[FloatArray],
    halves: Sequence[FloatArray],
    costs: Sequence[FloatArray],
    cost_of_overlap: float = math.inf,
    rounds: int = 1,
) -> FloatArray:
    """Choose a place for each of several boxes, one box after the other, always the cheapest one.

    Args:
        middles: of each box at the places that it may take, [N, 2] each.
        halves: half the width and half the height of each box, [2] each.
        costs: of the places, [N] each; a place that is not allowed costs infinitely much.
        cost_of_overlap: with any other box where it lies by now.
        rounds: how often each box chooses; from the second time on it knows where all others are.

    Returns:
        The middle of each box [A, 2]; not a number (NaN) where no place is allowed.
    """
    chosen: FloatArray = np.full((len(middles), 2), np.nan)
    for index in [*range(len(middles))] * rounds:
        chosen[index] = np.nan
        total = costs[index].copy()
        for half, middle in zip(halves, chosen, strict=True):
            # what is not a number is not near anything
            is_near = (np.abs(middles[index] - middle) < halves[index] + half).all(axis=-1)
            total[is_near] += cost_of_overlap
        best = total.argmin()
        if total[best] < math.inf:
            chosen[index] = middles[index][best]
    return chosen
