"""Films as they are drawn, part by part, before a file is made of them."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass

from studio.arrays import PixelArray
from studio.errors import InputError

SMALLEST_FRAME = (64, 64)
"""Width and height of the smallest frame that a film can have, px."""


@dataclass(frozen=True)
class Segment:
    """A part of a film.

    Its frames are made one after the other, each [height, width, 3] in red, green, blue. A frame
    need last only until the next one is asked for. All may be asked for again.
    """

    length: int  # frames
    frames: Callable[[], Iterable[PixelArray]]


def check_rate(frames_per_second: int, most: int) -> None:
    """Refuse more or fewer frames per second than films can have.

    Raises:
        InputError: if they are not a whole number of at least 1 and at most `most`.
    """
    if frames_per_second not in range(1, most + 1):
        raise InputError(
            f"frames_per_second: {frames_per_second} is not allowed: a whole number, 1 to {most}"
        )
