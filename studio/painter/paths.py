"""Translucent paths that grow darker where they overlap."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import cast

import cv2
import numpy as np
from numpy.typing import NDArray

from studio.arrays import FloatArray, IntArray, PixelArray
from studio.painter.canvas import Canvas
from studio.painter.pixels import SHIFT, fixed_point, pen, tinted
from studio.style.palette import Colour

Part = tuple[slice, slice]
"""Rows and columns of a canvas."""

# how far beyond the pen a path is counted, towards lower and towards higher coordinates, px
_SOFT_FRINGE = (1.0, 3.0)  # all that OpenCV draws
_STILL_FRINGE = (1.0, 2.0 + 1.0 / 32.0)  # what still pictures have always shown


@dataclass(frozen=True)
class Trace:
    """What a path that comes piece by piece covers so far."""

    left: int  # first column of the canvas that the whole path can touch
    top: int  # first row that it can touch
    mask: PixelArray  # [h, w], how much of the pixels from there on is covered, in 255ths


class FaintPaths:
    """Paths of one colour that are counted pixel by pixel, so that more can be added at any time.

    Where n paths cross, their joint opacity is 1 − (1 − opacity)^n, whatever their order; a path
    that crosses itself counts once.

    Args:
        canvas: that they are for.
        colour: of all paths.
        width: of the pen, px.
        opacity: of one path, 0 to 1 (not included).
        fringe: how far beyond the pen paths are counted, before and after their points, px. Less
            than OpenCV's soft edges cuts off a hundredth of a path here and there.
    """

    def __init__(
        self,
        canvas: Canvas,
        colour: Colour,
        width: float,
        opacity: float,
        fringe: tuple[float, float] = _SOFT_FRINGE,
    ) -> None:
        self._fringe = fringe
        self._corner = np.array([canvas.box.left, canvas.box.top])
        self._colour, self._pen = colour, pen(width)
        self._strength = np.float32(math.log1p(-opacity) / 255.0)
        self._counts = np.zeros(canvas.pixels.shape[:2], np.float32)  # in 255ths of a path

    def traces(self, paths: FloatArray) -> list[Trace]:
        """Empty traces of whole paths [K, N, 2], px, which are to come piece by piece."""
        return [_empty_trace(box) for box in self._touched(paths).tolist()]

    def add(self, paths: FloatArray, traces: Sequence[Trace] | None = None) -> Part:
        """Add whole paths [K, N, 2], px, or the next piece of each path that has a trace.

        Returns:
            The part of the canvas that looks different now.
        """
        fixed, touched = fixed_point(paths - self._corner), self._touched(paths)
        boxes = touched.tolist()
        begun = traces or map(_empty_trace, boxes)
        for line, box, trace in zip(fixed, boxes, begun, strict=True):
            self._count(line, box, trace)
        left, top = touched[:, :2].min(axis=0, initial=self._counts.size)
        right, bottom = touched[:, 2:].max(axis=0, initial=0)
        return slice(top, bottom), slice(left, right)

    def over(self, pixels: PixelArray, part: Part = (slice(None), slice(None))) -> PixelArray:
        """A part of the canvas as it looks with all paths so far over these pixels [H, W, 3]."""
        counts = self._counts[part]
        if not counts.size:
            return pixels[part]
        return tinted(pixels[part], self._colour, 1.0 - np.exp(counts * self._strength))

    def _count(self, line: NDArray[np.int32], box: list[int], trace: Trace) -> None:
        """Count what a line covers of a box that its trace does not cover already."""
        x, y, (height, width) = trace.left, trace.top, trace.mask.shape
        # by rounding errors, a piece may reach over the whole
        left, top = max(box[0], x), max(box[1], y)
        right, bottom = min(box[2], x + width), min(box[3], y + height)
        if left < right and top < bottom:
            counts = self._counts[top:bottom, left:right]
            covered = trace.mask[top - y : bottom - y, left - x : right - x]
            before, local = covered.copy(), line - (np.array([left, top]) << SHIFT)
            cv2.polylines(covered, [local], False, 255, self._pen, cv2.LINE_AA, SHIFT)
            cv2.accumulate(cv2.subtract(covered, before), counts)

    def _touched(self, paths: FloatArray) -> IntArray:
        """What paths [K, N, 2], px, touch of the canvas: left, top, right, bottom, [K, 4]."""
        local, (before, after) = paths - self._corner - 0.5, self._fringe
        low = np.floor(local.min(axis=1) - self._pen - before)
        high = np.floor(local.max(axis=1) + self._pen + after)
        limits = np.array(self._counts.shape[::-1])
        ends = np.clip(np.concatenate([low, high], axis=-1), 0, np.tile(limits, 2))
        return cast(IntArray, ends.astype(np.int64))


def draw_faint_paths(
    canvas: Canvas, paths: FloatArray, colour: Colour, width: float, opacity: float
) -> None:
    """Draw paths [K, N, 2], px; colour, width and opacity are those of `FaintPaths`."""
    faint = FaintPaths(canvas, colour, width, opacity, _STILL_FRINGE)
    part = faint.add(paths)
    canvas.pixels[part] = faint.over(canvas.pixels, part)


def _empty_trace(box: list[int]) -> Trace:
    left, top, right, bottom = box
    return Trace(left, top, np.zeros((bottom - top, right - left), np.uint8))
