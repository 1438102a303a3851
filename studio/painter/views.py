"""Views: maps from metres to pixels."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from studio.arrays import Bounds, FloatArray
from studio.painter.boxes import Box, Point


@dataclass(frozen=True)
class View:
    """A map from metres (y up) to pixels (y down), with the same scale in x and y."""

    box: Box  # where on the page the map lies, px
    scale: float  # px per m
    centre: Point  # what lies in the middle of the box (x, y), m

    @classmethod
    def around(cls, bounds: Bounds, box: Box) -> "View":
        """The largest view in the box that shows all of the bounds, m."""
        x0, y0, x1, y1 = bounds
        scale = min(box.width / (x1 - x0), box.height / (y1 - y0))
        return cls(box, scale, ((x0 + x1) / 2, (y0 + y1) / 2))

    @property
    def bounds(self) -> Bounds:
        """What the box shows, m."""
        x, y = self.centre
        across, up = self.box.width / self.scale / 2, self.box.height / self.scale / 2
        return x - across, y - up, x + across, y + up

    def to_pixels(self, points: ArrayLike) -> FloatArray:
        """Points in metres [..., 2] as pixels [..., 2]."""
        away = np.asarray(points, dtype=np.float64)[..., :2] - np.array(self.centre)
        pixels: FloatArray = np.array(self.box.centre) + away * np.array([self.scale, -self.scale])
        return pixels
