"""The types of arrays, and of bounds, that the studio works with."""

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]
BoolArray = NDArray[np.bool_]
PixelArray = NDArray[np.uint8]

Bounds = tuple[float, float, float, float]
"""What a view shows: x0, y0, x1, y1, with y counting upwards."""
