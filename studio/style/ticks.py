"""Round numbers for axes."""

import math


def ticks(low: float, high: float, most: int = 4) -> list[float]:
    """Round values from `low` to `high`, both included, at most `most` + 1 of them."""
    rough = (high - low) / most
    power = 10.0 ** math.floor(math.log10(rough))
    step = next(digit * power for digit in (1, 2, 2.5, 5, 10) if digit * power >= rough * 0.999)
    first, last = math.ceil(low / step - 1e-6), math.floor(high / step + 1e-6)
    # + 0.0 turns a −0 into a 0
    return [round(index * step, 12) + 0.0 for index in range(first, last + 1)]


def round_range(low: float, high: float) -> tuple[float, float]:
    """The smallest range with round ends around both values; never empty."""
    if high - low < 1e-9:
        low, high = low - 0.5, high + 0.5
    power = 10.0 ** math.floor(math.log10(high - low))
    steps = (power / 10, power / 5, power / 4, power / 2, power)
    step = next(step for step in steps if high - low <= 12 * step)
    return math.floor(low / step + 1e-6) * step, math.ceil(high / step - 1e-6) * step
