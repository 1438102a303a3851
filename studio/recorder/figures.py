"""Figures that Rerun has no view for, as the painter draws them: images in a recording.

A figure is drawn at twice the size at which a view usually shows it, so that it stays crisp. What
lies on it, such as dots that answer when hovered, is given in its pixels: x to the right, y down.
"""

import struct
import zlib

import numpy as np
import pyarrow as pa
import rerun as rr
import rerun.blueprint as rrb
from numpy.typing import NDArray

from studio.arrays import Bounds, PixelArray
from studio.style.palette import LIGHT

_MOST_COLOURS = 256  # of an image with a palette
_IMAGE_ORDER = -100.0  # what lies on a figure is drawn later
_PNG_SIGNATURE = b"\x89PNG\r\n\x1a\n"
_WITH_PALETTE = 3  # colour type of the format
_FASTEST_GOOD = 6  # level of compression: higher ones take longer and save next to nothing


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


def palette_png(pixels: PixelArray) -> bytes:
    """Pixels [height, width, 3] as a PNG file with a palette, a third as large as one without.

    Where there are more than 256 colours, the rarer ones become those of the commonest 256 that are
    nearest, which nobody sees: a drawn figure has many colours only where edges are smooth.

    The format: "Portable Network Graphics (PNG) Specification", W3C, second edition, 2003.
    """
    height, width = pixels.shape[:2]
    # hashed, which takes a tenth of the time of sorting
    known = pa.array(_as_numbers(pixels)).dictionary_encode()
    numbers, places = np.asarray(known.dictionary), np.asarray(known.indices)
    colours = np.stack([numbers >> 16, numbers >> 8 & 255, numbers & 255], axis=-1).astype(float)
    palette = colours[np.argsort(-np.bincount(places), kind="stable")[:_MOST_COLOURS]]
    # squares of distances, but for what is the same for the whole palette; (colours, palette)
    away = np.square(palette).sum(axis=-1) - 2.0 * colours @ palette.T
    rows = np.zeros((height, width + 1), np.uint8)  # each begins with a 0: it is not filtered
    rows[:, 1:] = away.argmin(axis=1).astype(np.uint8)[places].reshape(height, width)
    header = struct.pack(">IIBBBBB", width, height, 8, _WITH_PALETTE, 0, 0, 0)
    chunks = (
        (b"IHDR", header),
        (b"PLTE", palette.astype(np.uint8).tobytes()),
        (b"IDAT", zlib.compress(rows.tobytes(), _FASTEST_GOOD)),
        (b"IEND", b""),
    )
    return _PNG_SIGNATURE + b"".join(_chunk(kind, data) for kind, data in chunks)


def _as_numbers(pixels: PixelArray) -> NDArray[np.uint32]:
    """Each colour as one number, [height * width]."""
    numbers = np.zeros(pixels.shape[:2], np.uint32)
    for channel in range(3):
        numbers <<= 8
        numbers |= pixels[..., channel]
    return numbers.ravel()


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
