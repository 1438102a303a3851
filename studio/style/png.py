"""Pixels as PNG files with a palette."""

import struct
import zlib

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from studio.arrays import PixelArray

_MOST_COLOURS = 256  # of an image with a palette
_PNG_SIGNATURE = b"\x89PNG\r\n\x1a\n"
_WITH_PALETTE = 3  # colour type of the format
_FASTEST_GOOD = 6  # level of compression: higher ones take longer and save next to nothing


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
