"""Points and boxes on a page, px, x to the right and y down, and how boxes are cut."""

from collections.abc import Sequence
from dataclasses import dataclass

from studio.errors import InputError

Point = tuple[float, float]


@dataclass(frozen=True)
class Box:
    """A rectangle on the page, px."""

    left: float
    top: float
    right: float
    bottom: float

    @property
    def width(self) -> float:
        """From left to right, px."""
        return self.right - self.left

    @property
    def height(self) -> float:
        """From top to bottom, px."""
        return self.bottom - self.top

    @property
    def centre(self) -> Point:
        """The point in the middle."""
        return (self.left + self.right) / 2, (self.top + self.bottom) / 2

    def inset(self, by: float) -> "Box":
        """The box with every side moved in, or out if `by` is negative, px."""
        return Box(self.left + by, self.top + by, self.right - by, self.bottom - by)

    def overlaps(self, other: "Box") -> bool:
        """Whether the two share more than an edge."""
        return (
            self.left < other.right
            and other.left < self.right
            and self.top < other.bottom
            and other.top < self.bottom
        )

    def columns(self, widths: Sequence[float], gap: float = 0.0) -> "tuple[Box, ...]":
        """Cut into columns whose widths stand in these proportions, with gaps between (px)."""
        edges = _cuts(self.left, self.width, widths, gap)
        return tuple(Box(start, self.top, end, self.bottom) for start, end in edges)

    def rows(self, heights: Sequence[float], gap: float = 0.0) -> "tuple[Box, ...]":
        """Cut into rows whose heights stand in these proportions, with gaps between (px)."""
        edges = _cuts(self.top, self.height, heights, gap)
        return tuple(Box(self.left, start, self.right, end) for start, end in edges)


def _cuts(
    start: float, length: float, shares: Sequence[float], gap: float
) -> list[tuple[float, float]]:
    unit = (length - gap * (len(shares) - 1)) / sum(shares)
    cuts = []
    for share in shares:
        cuts.append((start, start + share * unit))
        start += share * unit + gap
    return cuts


def check_size(size: tuple[int, int], smallest: tuple[int, int], largest: int) -> None:
    """Refuse pages and frames whose width or height (px) is too small or too large.

    Raises:
        InputError: if a side is shorter than in the smallest size, or longer than `largest`.
    """
    (width, height), (least_width, least_height) = size, smallest
    if not (least_width <= width <= largest and least_height <= height <= largest):
        raise InputError(
            f"size: {width}x{height} pixels is not allowed: at least "
            f"{least_width}x{least_height} and at most {largest}x{largest}"
        )
