"""Where things that are written find room beside one another, in any unit of length."""

from collections.abc import Sequence


def spread_apart(heights: Sequence[float], step: float, low: float, high: float) -> list[float]:
    """Heights moved so far apart that neighbours are a step away from one another.

    Args:
        heights: ascending.
        step: least distance; as many steps as there are heights fit between `low` and `high`.
        low: least height allowed.
        high: largest height allowed.
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
