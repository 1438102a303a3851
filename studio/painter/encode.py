"""Films from frames: MP4 and GIF files, with the same bytes on every machine.

A film is a list of segments. For MP4, each is encoded by an encoder of its own on one thread, and
begins with a key frame; two segments are encoded at a time. So the bytes depend neither on how many
cores there are nor on which segment is done first, and players can jump to every segment. A GIF is
made in two rounds: the first finds the palette that suits all frames best, the second encodes.
"""

import io
import os
import threading
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import TypeAlias, cast

import av
import cv2
import numpy as np
from av.codec.codec import UnknownCodecError
from av.codec.context import Flags
from av.filter import Graph
from av.video.reformatter import ColorPrimaries, ColorRange, Colorspace, ColorTrc

from studio.arrays import PixelArray
from studio.errors import InputError

Progress = Callable[[int, int], None]
"""Told how many frames are done, and of how many."""

VideoPacket: TypeAlias = "av.Packet[av.VideoStream]"

SMALLEST_SIDE = 64
LARGEST_FILM_SIDE = 4096
LARGEST_GIF_SIDE = 1920
"""Of frames, px."""

MOST_FILM_FRAMES = 60
MOST_GIF_FRAMES = 50
"""A second; browsers slow GIFs down that ask for more."""

_WORKERS = 2

# the AV1 encoder would describe itself at length on the standard error
os.environ.setdefault("SVT_LOG", "1")


@dataclass(frozen=True)
class Segment:
    """A part of a film.

    Attributes:
        length: how many frames it has.
        frames: makes its frames, one after the other, each [height, width, 3] in red, green,
            blue; a frame need last only until the next one is asked for. It may be called again.
    """

    length: int
    frames: Callable[[], Iterable[PixelArray]]


@dataclass(frozen=True)
class _Codec:
    """A way to encode an MP4 film: FFmpeg's encoder and its options."""

    encoder: str
    options: dict[str, str]


# h264: almost without searching, by which flat drawings hardly gain: two thirds of the time of the
# preset as it is. Nor with x264's macroblock tree, with which the same frames now and then gave
# other bytes when two encoders ran at a time. Faster presets of either codec leave more remains of
# earlier frames behind. The tests hold the decoded colours of both to the drawn ones.
_FOR_DRAWINGS = (
    "subme=0:me=dia:partitions=i4x4,i8x8:weightp=0:scenecut=0:b-adapt=0:mbtree=0:rc-lookahead=0"
)
_CODECS = {
    "h264": _Codec("libx264", {"preset": "veryfast", "crf": "20", "x264-params": _FOR_DRAWINGS}),
    "av1": _Codec("libsvtav1", {"preset": "9", "crf": "30", "svtav1-params": "lp=1"}),
}


def check_codec(codec: str) -> None:
    """Refuse a codec that films cannot be encoded with here.

    Raises:
        InputError: if there is no such codec, or PyAV was built without it.
    """
    present = [name for name, known in _CODECS.items() if _is_present(known.encoder)]
    if codec not in present:
        lacking = "is not part of this PyAV" if codec in _CODECS else "is not known"
        raise InputError(f"codec: {codec!r} {lacking}: {', '.join(present) or 'there is none'}")


def check_film_size(size: tuple[int, int]) -> None:
    """Refuse what cannot be encoded as MP4.

    Raises:
        InputError: if the width or height is odd, for colours are stored for blocks of 2x2 pixels,
            or too small or too large for common players.
    """
    if size[0] % 2 or size[1] % 2:
        raise InputError(
            f"size: {size[0]}x{size[1]} pixels is not allowed: a film's width and height are even"
        )
    _check_sides(size, LARGEST_FILM_SIDE)


def write_mp4(
    path: Path,
    segments: Sequence[Segment],
    size: tuple[int, int],
    frames_per_second: int,
    codec: str = "h264",
    progress: Progress | None = None,
) -> None:
    """Encode segments and join them in an MP4 file that plays while it is still loading.

    Args:
        path: of the file.
        segments: of the film, in order.
        size: width and height of every frame, px; even, 64 to 4096.
        frames_per_second: whole, 1 to 60.
        codec: `h264` plays everywhere; `av1` is free of patents, and takes twice the time.
        progress: called from the encoding threads, by one at a time, after every frame.

    Raises:
        InputError: if the size, the number of frames or the codec is not allowed.
        OSError: if the file cannot be written.
    """
    check_film_size(size)
    check_rate(frames_per_second)
    check_codec(codec)
    form = _Form(_CODECS[codec], size, frames_per_second)
    total, done = sum(segment.length for segment in segments), 0
    lock, stopped = threading.Lock(), threading.Event()

    def encode(segment: Segment) -> list[VideoPacket]:
        nonlocal done
        encoder = form.encoder()
        planes = np.empty((size[1] * 3 // 2, size[0]), np.uint8)
        packets: list[VideoPacket] = []
        try:
            for index, pixels in enumerate(segment.frames()):
                if stopped.is_set():
                    break
                cv2.cvtColor(pixels, cv2.COLOR_RGB2YUV_I420, dst=planes)
                # from_numpy_buffer would misplace colours unless the height is a multiple of 4
                frame = av.VideoFrame.from_ndarray(planes, format="yuv420p")
                frame.pts = index
                packets += encoder.encode(frame)
                with lock:
                    done += 1
                    if progress is not None:
                        progress(done, total)
        except BaseException:
            stopped.set()
            raise
        return [*packets, *encoder.encode(None)]

    with _one_thread_each(), ThreadPoolExecutor(_WORKERS) as workers:
        futures = [workers.submit(encode, segment) for segment in segments]
        try:
            encoded = [future.result() for future in futures]
        finally:
            # after an interruption there is no use in encoding the rest
            stopped.set()
    _join(path, encoded, form)


def write_gif(
    path: Path,
    segments: Sequence[Segment],
    size: tuple[int, int],
    frames_per_second: int,
    progress: Progress | None = None,
) -> None:
    """Write segments as an animated GIF that starts over for ever.

    All frames share the palette of 256 colours that suits them best, without dithering. A frame
    that looks like the one before only makes that one stand longer, the last one too.

    Args:
        path: of the file.
        segments: of the film, in order; their frames are made twice.
        size: width and height of every frame, px; 64 to 1920, odd ones too.
        frames_per_second: whole, 1 to 50.
        progress: called after every frame of both rounds.

    Raises:
        InputError: if the size or the number of frames is not allowed.
        OSError: if the file cannot be written.
    """
    _check_sides(size, LARGEST_GIF_SIDE)
    check_rate(frames_per_second, MOST_GIF_FRAMES)
    length = sum(segment.length for segment in segments)

    def told(before: int) -> Iterator[tuple[int, PixelArray]]:
        """All frames with their numbers, without those that look like the one before."""
        shown = np.empty((0, 0, 3), np.uint8)
        index = 0
        for segment in segments:
            for pixels in segment.frames():
                if not np.array_equal(pixels, shown):
                    shown = pixels.copy()
                    yield index, shown
                index += 1
                if progress is not None:
                    progress(before + index, 2 * length)

    palette, last = _palette(told(0), size)
    held = round(100 * (length - last) / frames_per_second)
    animation = _animation(told(length), palette, held, size, frames_per_second)
    path.write_bytes(animation)


# What is allowed


def _is_present(encoder: str) -> bool:
    try:
        av.Codec(encoder, "w")
    except UnknownCodecError:
        return False
    return True


def _check_sides(size: tuple[int, int], largest: int) -> None:
    if not all(SMALLEST_SIDE <= side <= largest for side in size):
        raise InputError(
            f"size: {size[0]}x{size[1]} pixels is not allowed: at least "
            f"{SMALLEST_SIDE}x{SMALLEST_SIDE} and at most {largest}x{largest}"
        )


def check_rate(frames_per_second: int, most: int = MOST_FILM_FRAMES) -> None:
    """Refuse more or fewer frames per second than films can have.

    Raises:
        InputError: if they are not a whole number of at least 1 and at most `most`.
    """
    if frames_per_second not in range(1, most + 1):
        raise InputError(
            f"frames_per_second: {frames_per_second} is not allowed: a whole number, 1 to {most}"
        )


# MP4


@dataclass(frozen=True)
class _Form:
    """What all encoders of one film have in common."""

    codec: _Codec
    size: tuple[int, int]
    frames_per_second: int

    @property
    def time_base(self) -> Fraction:
        """Duration of a frame, s."""
        return Fraction(1, self.frames_per_second)

    def encoder(self) -> av.VideoCodecContext:
        """A new encoder."""
        encoder = cast(av.VideoCodecContext, av.CodecContext.create(self.codec.encoder, "w"))
        encoder.framerate = Fraction(self.frames_per_second)
        encoder.time_base = self.time_base
        # MP4 keeps the parameter sets in its header, once
        encoder.flags |= Flags.global_header
        self.set_up(encoder)
        return encoder

    def set_up(self, encoder: av.VideoCodecContext) -> None:
        """Say what the frames are, and which colours their numbers mean: those of OpenCV."""
        encoder.width, encoder.height = self.size
        encoder.pix_fmt = "yuv420p"
        encoder.thread_count = 1
        encoder.options = dict(self.codec.options)
        encoder.colorspace = Colorspace.ITU601
        encoder.color_range = ColorRange.MPEG
        encoder.color_primaries = ColorPrimaries.BT709
        encoder.color_trc = ColorTrc.BT709


def _join(path: Path, encoded: Sequence[list[VideoPacket]], form: _Form) -> None:
    """Write the packets of all segments into an MP4 file."""
    with av.open(str(path), "w", format="mp4", options={"movflags": "+faststart"}) as container:
        stream = cast(
            av.VideoStream, container.add_stream(form.codec.encoder, rate=form.frames_per_second)
        )
        form.set_up(stream.codec_context)
        container.start_encoding()
        # frames are decoded before they are shown, by as much as the segment needs that needs most:
        # encoders of short segments tell less, and the times of all must go up
        lead = max(
            (
                place - cast(int, packet.pts)
                for packets in encoded
                for place, packet in enumerate(packets)
            ),
            default=0,
        )
        first = 0
        for packets in encoded:
            for place, packet in enumerate(packets):
                packet.stream = stream
                packet.time_base = form.time_base
                packet.pts = cast(int, packet.pts) + first
                packet.dts = first + place - lead
                container.mux(packet)
            first += len(packets)  # a packet is a frame


@contextmanager
def _one_thread_each() -> Iterator[None]:
    """Keep OpenCV from starting threads, which would take the cores from the two workers."""
    before = cv2.getNumThreads()
    cv2.setNumThreads(1)
    try:
        yield
    finally:
        cv2.setNumThreads(before)


# GIF


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
    """A GIF file of numbered frames, the last of them held for so many hundredths of a second."""
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
