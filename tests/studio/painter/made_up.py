"""Films for tests."""

import cv2
import numpy as np

from studio.painter.segments import Segment

SIZE = (160, 96)
WHITE, BLUE, RED, GREY = (250, 250, 250), (0, 114, 178), (213, 43, 30), (120, 124, 130)


def page(step, size=SIZE):
    """Flat colours with a disc that moves, and a strip of many greys."""
    pixels = np.full((size[1], size[0], 3), WHITE, np.uint8)
    pixels[: size[1] // 4] = BLUE
    pixels[size[1] // 2 : size[1] // 2 + 8] = np.linspace(0, 255, size[0])[None, :, None]
    pixels[-size[1] // 4 :, : size[0] // 2] = GREY
    cv2.circle(pixels, (20 + 4 * step, 3 * size[1] // 4), 8, RED, cv2.FILLED, cv2.LINE_AA)
    return pixels


def moving(steps, size=SIZE):
    return Segment(len(steps), lambda: (page(step, size) for step in steps))


def film(size=SIZE):
    """Two parts that move and one that stands still."""
    return [moving(range(12), size), moving(range(12, 24), size), moving([24] * 10, size)]


def drawn(segments):
    return [pixels.copy() for segment in segments for pixels in segment.frames()]
