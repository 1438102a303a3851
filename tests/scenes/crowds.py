"""Made-up crowds as annotations in the EWAP format."""

from collections.abc import Callable

Person = Callable[[int], tuple[float, float, float, float]]
"""x, y, vx, vy of a person at step 0, 1, …"""


def walker(x: float, y: float, vx: float, vy: float) -> Person:
    return lambda step: (x + 0.4 * step * vx, y + 0.4 * step * vy, vx, vy)


def rows(people: dict[int, Person], steps: int = 6) -> list[str]:
    """Annotations every sixth frame from frame 100."""
    return [
        f"{100 + 6 * step} {number} {x} 0 {y} {vx} 0 {vy}"
        for step in range(steps)
        for number, person in people.items()
        for x, y, vx, vy in [person(step)]
    ]


TWO = {7: walker(0.0, 0.0, 1.0, 0.0), 3: walker(0.0, 2.0, 0.0, -0.5)}
