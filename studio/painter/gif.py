"""Films as animated GIF files, with the same bytes on every machine.

A GIF is made in two rounds: the first finds the palette that suits all frames best, the second
encodes.
"""

import io
from collections.abc import Iterator, Sequence
from contextlib import suppress
from itertools import chain
from pathlib import Path
from typing import cast

import av
import numpy as np
from av.filter import Graph

from studio.arrays import PixelArray
from studio.painter.boxes import check_size
from studio.painter.segments import SMALLEST_FRAME, Segment, check_rate
from studio.progress import Progress

_LARGEST_SIDE = 1920  # of a frame, px
_MOST_FRAMES = 50  # a second: browsers slow GIFs down that ask for more


def write_gif(
    path: Path,
    segments: Sequence[Segment],
    size: tuple[int, int],
    frames_per_second: int,
    progress: Progress | None = None,
) -> None:
    """Write segments as an animated GIF that starts over for ever.

    All frames share the palette of 256 colours that suits them best, without dithering. A frame
    that looks like the one before it is left out, and the one before it stands longer.

    Args:
        path: of the file.
        segments: of the film, in order; their frames are drawn twice.
        size: width and height of every frame, px; 64 to 1920, odd ones too.
        frames_per_second: whole, 1 to 50.
        progress: called after every frame of both rounds.

    Raises:
        InputError: if the size or the number of frames is not allowed.
        OSError: if the file cannot be written.
    """
    check_size(size, SMALLEST_FRAME, _LARGEST_SIDE)
    check_rate(frames_per_second, _MOST_FRAMES)
    length = sum(segment.length for segment in segments)

    def told(before: int) -> Iterator[tuple[int, PixelArray]]:
        """All frames with their numbers, without those that look like the one before."""
        shown = np.empty((0, 0, 3), np.uint8)
        frames = chain.from_iterable(segment.frames() for segment in segments)
        for index, pixels in enumerate(frames):
            if not np.array_equal(pixels, shown):
                shown = pixels.copy()
                yield index, shown
            if progress is not None:
                progress(before + index + 1, 2 * length)

    palette, last = _palette(told(0), size)
    held = round(100 * (length - last) / frames_per_second)
    animation = _animation(told(length), palette, held, size, frames_per_second)
    path.write_bytes(animation)


def _palette(
    frames: Iterator[tuple[int, PixelArray]], size: tuple[int, int]
) -> tuple[av.VideoFrame, int]:
    """The best palette for numbered frames, and the number of the last one."""
    graph = _graph("palettegen", "reserve_transparent=0", 1, [(*size, "rgb24")])
    last = 0
    for last, pixels in frames:
        graph.push(_numbered(pixels, last))
    graph.push(None)
    return cast(av.VideoFrame, graph.pull()), last


def _animation(
    frames: Iterator[tuple[int, PixelArray]],
    palette: av.VideoFrame,
    held: int,
    size: tuple[int, int],
    frames_per_second: int,
) -> bytes:
    """A GIF file of numbered frames, the last of them held for `held` hundredths of a second."""
    inputs = [(*size, "rgb24"), (16, 16, "bgra")]
    graph = _graph("paletteuse", "dither=none", frames_per_second, inputs)
    graph.push(palette, 1)
    graph.push(None, 1)
    file = io.BytesIO()
    options = {"loop": "0", "final_delay": str(held)}
    with av.open(file, "w", format="gif", options=options) as container:
        stream = container.add_stream("gif", rate=frames_per_second)
        stream.width, stream.height = size
        stream.pix_fmt = "pal8"

        def add(numbered: av.VideoFrame | None) -> None:
            graph.push(numbered, 0)
            with suppress(BlockingIOError, EOFError):
                while True:
                    container.mux(stream.encode(cast(av.VideoFrame, graph.pull())))

        for number, pixels in frames:
            add(_numbered(pixels, number))
        add(None)
        container.mux(stream.encode(None))
    return file.getvalue()


def _numbered(pixels: PixelArray, number: int) -> av.VideoFrame:
    frame = av.VideoFrame.from_numpy_buffer(pixels, format="rgb24")
    frame.pts = number
    return frame


def _graph(
    name: str, options: str, frames_per_second: int, inputs: Sequence[tuple[int, int, str]]
) -> Graph:
    """A filter with inputs of these widths, heights and pixel formats, ready for use."""
    graph = Graph()
    filtering, sink = graph.add(name, options), graph.add("buffersink")
    for index, (width, height, pixel_format) in enumerate(inputs):
        form = f"width={width}:height={height}:pix_fmt={pixel_format}"
        buffer = graph.add("buffer", f"{form}:time_base=1/{frames_per_second}")
        buffer.link_to(filtering, 0, index)
    filtering.link_to(sink)
    graph.configure()
    return graph
