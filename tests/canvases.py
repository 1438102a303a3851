"""Canvases and what they show, for tests of pictures and films."""

from itertools import combinations

from studio.arrays import PixelArray
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.style.palette import LIGHT


def a_canvas(width: int = 640, height: int = 360) -> Canvas:
    """An empty canvas in the light theme."""
    return Canvas(width, height, LIGHT)


def texts(canvas: Canvas) -> list[str]:
    """The texts on a canvas, in the order in which they were set."""
    return [placed.text for placed in canvas.texts]


def holds(outer: Box, inner: Box) -> bool:
    """Whether a box lies wholly inside another one."""
    is_across = outer.left <= inner.left and inner.right <= outer.right
    return is_across and outer.top <= inner.top and inner.bottom <= outer.bottom


def check_texts(canvas: Canvas) -> None:
    """Every text stays on the page and off the others."""
    for placed in canvas.texts:
        assert holds(canvas.box, placed.box), placed
    for first, second in combinations(canvas.texts, 2):
        assert not first.box.overlaps(second.box), (first, second)


def red_pixels(pixels: PixelArray) -> int:
    """How many pixels have the colour of contact in the light theme."""
    return int((pixels == LIGHT.contact).all(axis=-1).sum())
