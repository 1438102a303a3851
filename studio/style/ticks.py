"""Round numbers: ticks of axes, ends of ranges, widths of bins, and steps of grids.

A number is round if it is one of a few digits, usually 1, 2 and 5, times a power of ten.
"""

import math
from collections.abc import Sequence


def round_step(span: float, most: float, digits: Sequence[float] = (1, 2, 5)) -> float:
    """The smallest round step of which at most `most` are needed to reach over a span.

    Both are above 0, and `most` need not be whole. The digits that may stand before the power of
    ten ascend from 1.
    """
    power = math.floor(math.log10(span / most))
    steps = (float(f"{digit}e{power}") for digit in (*digits, 10))
    return next(step for step in steps if most * step >= span)


def round_numbers(low: float, high: float, digits: Sequence[float] = (1, 2, 5)) -> list[float]:
    """All round numbers from `low` to `high`, both above 0, ascending."""
    powers = range(math.floor(math.log10(low)), math.floor(math.log10(high)) + 1)
    numbers = [float(f"{digit}e{power}") for power in powers for digit in digits]
    return [number for number in numbers if low <= number <= high]


def ticks(low: float, high: float, most: int = 4) -> list[float]:
    """Round values from `low` to `high`, both included, at most `most` + 1 of them."""
    step = round_step(0.999 * (high - low), most, (1, 2, 2.5, 5))
    first, last = math.ceil(low / step - 1e-6), math.floor(high / step + 1e-6)
    # + 0.0 turns a −0 into a 0
    return [round(index * step, 12) + 0.0 for index in range(first, last + 1)]


def round_range(low: float, high: float) -> tuple[float, float]:
    """The smallest range with round ends around both values; never empty."""
    if high - low < 1e-9:
        low, high = low - 0.5, high + 0.5
    step = round_step(high - low, 12, (1, 2, 2.5, 5))
    return math.floor(low / step + 1e-6) * step, math.ceil(high / step - 1e-6) * step


def decades(low: float, high: float) -> list[float]:
    """The powers of ten from `low` to `high`; where they are few, 3, or 2 and 5, times them too."""
    for digits in ((1,), (1, 3), (1, 2, 5)):
        found = round_numbers(0.999 * low, 1.001 * high, digits)
        if len(found) >= 3:
            break
    return found
