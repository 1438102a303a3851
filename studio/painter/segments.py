"""Films as they are drawn, part by part, before a file is made of them."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass

from studio.arrays import PixelArray
from studio.errors import InputError

Progress = Callable[[int, int], None]
"""Told how many frames are done, and of how many."""

SMALLEST_SIDE = 64
"""Of a frame, px."""


@dataclass(frozen=True)
class Segment:
    """A part of a film.

    Attributes:
        length: how many frames it has.
        frames: makes its frames, one after the other, each [height, width, 3] in red, green,
            blue; a frame need last only until the next one is asked for. It may be called again.
    """

    length: int
    frames: Callable[[], Iterable[PixelArray]]


def check_sides(size: tuple[int, int], largest: int) -> None:
    """Refuse frames that are too small, or larger than a kind of file allows.

    Raises:
        InputError: if the width or height is below `SMALLEST_SIDE` or above `largest`, px.
    """
    if not all(SMALLEST_SIDE <= side <= largest for side in size):
        raise InputError(
            f"size: {size[0]}x{size[1]} pixels is not allowed: at least "
            f"{SMALLEST_SIDE}x{SMALLEST_SIDE} and at most {largest}x{largest}"
        )


def check_rate(frames_per_second: int, most: int) -> None:
    """Refuse more or fewer frames per second than films can have.

    Raises:
        InputError: if they are not a whole number of at least 1 and at most `most`.
    """
    if frames_per_second not in range(1, most + 1):
        raise InputError(
            f"frames_per_second: {frames_per_second} is not allowed: a whole number, 1 to {most}"
        )
