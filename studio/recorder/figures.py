"""Figures that Rerun has no view for, as the painter draws them: images in a recording.

A figure is drawn at twice the size at which a view usually shows it, so that it stays crisp. What
lies on it, such as dots that answer when hovered, is given in its pixels: x to the right, y down.
"""

import rerun as rr
import rerun.blueprint as rrb

from studio.arrays import Bounds, PixelArray
from studio.style.palette import LIGHT
from studio.style.png import palette_png

_IMAGE_ORDER = -100.0  # what lies on a figure is drawn later


def log_figure(
    stream: rr.RecordingStream, path: str, pixels: PixelArray, *, static: bool = True
) -> None:
    """Add a figure [height, width, 3] to a recording.

    A figure that is not static is shown from the stream's time on, until there is another one.
    """
    image = rr.EncodedImage(
        contents=palette_png(pixels), media_type="image/png", draw_order=_IMAGE_ORDER
    )
    stream.log(path, image, static=static)


def painted_view(path: str, title: str, window: Bounds | None = None) -> rrb.View:
    """A view of a figure, or of a part of it (px, y down), and of all that lies below its path."""
    bounds = None
    if window:
        x0, y0, x1, y1 = window
        bounds = rrb.VisualBounds2D(x_range=[x0, x1], y_range=[y0, y1])
    return rrb.Spatial2DView(
        origin=f"/{path}", name=title, background=LIGHT.ground, visual_bounds=bounds
    )
