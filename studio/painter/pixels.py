"""What becomes of pixels where something covers them in part or lets them shine through."""

from typing import cast

import cv2
import numpy as np
from numpy.typing import NDArray

from studio.arrays import FloatArray, PixelArray
from studio.style.palette import Colour

SHIFT = 4
"""OpenCV takes coordinates in fractions of a pixel: sixteenths, 2 to the power of 4."""

FARTHEST = 1e6
"""Coordinates that are farther away would overflow OpenCV's integers, px."""


def disc_coverage(
    x: float, y: float, radius: float, width: int, height: int
) -> NDArray[np.float32]:
    """How much of each pixel [height, width] a disc around (x, y) covers, 0 to 1."""
    across = np.arange(width, dtype=np.float32) + np.float32(0.5 - x)
    down = np.arange(height, dtype=np.float32) + np.float32(0.5 - y)
    # several times as fast as np.hypot
    beyond = np.sqrt(np.add.outer(down * down, across * across)) - np.float32(radius)
    # twice as fast as np.clip
    shares: NDArray[np.float32] = np.minimum(np.maximum(np.float32(0.5) - beyond, 0.0), 1.0)
    return shares


def tinted(pixels: PixelArray, colour: Colour, shares: NDArray[np.float32]) -> PixelArray:
    """Pixels [h, w, 3] with a colour over them, as opaque as the shares [h, w] say."""
    over = np.empty_like(pixels)
    # row by row: several times as fast as pixel by pixel
    over[:] = np.full(pixels.shape[1:], colour, np.uint8)
    return cast(PixelArray, cv2.blendLinear(over, pixels, shares, 1.0 - shares))


def fixed_point(points: FloatArray) -> NDArray[np.int32]:
    """Points [..., 2] as OpenCV takes them: sixteenths of a pixel, from the middle of a pixel."""
    near = np.clip(points - 0.5, -FARTHEST, FARTHEST)
    return cast(NDArray[np.int32], np.rint(near * 2**SHIFT).astype(np.int32))


def pen(width: float) -> int:
    """Width of the line that comes closest to a width, px, at least 1."""
    return max(1, round(width))
