"""H.264 films from frames, with the same bytes on every machine.

A film is a list of segments. Each is encoded by an encoder of its own on one thread, and begins
with a key frame; two segments are encoded at a time. So the bytes depend neither on how many
cores there are nor on which segment is done first, and players can jump to every segment.
"""

import threading
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import TypeAlias, cast

import av
import cv2
from av.codec.context import Flags
from av.video.reformatter import ColorPrimaries, ColorRange, Colorspace, ColorTrc

from studio.errors import InputError, RunError
from studio.painter.canvas import PixelArray

Progress = Callable[[int, int], None]
"""Told how many frames are done, and of how many."""

VideoPacket: TypeAlias = "av.Packet[av.VideoStream]"

_WORKERS = 2
# less searching and looking ahead than the preset does: about a third less time for flat drawings,
# whose decoded colours the tests hold to the drawn ones
_QUALITY = {"preset": "veryfast", "crf": "18", "x264-params": "subme=1:b-adapt=0:rc-lookahead=5"}


@dataclass(frozen=True)
class Segment:
    """A part of a film.

    Attributes:
        length: how many frames it has.
        frames: makes its frames, one after the other, each [height, width, 3] in red, green,
            blue; a frame need last only until the next one is asked for.
    """

    length: int
    frames: Callable[[], Iterable[PixelArray]]


def check_film_size(size: tuple[int, int]) -> None:
    """Refuse what cannot be encoded.

    Raises:
        InputError: if the width or height is odd: colours are stored for blocks of 2x2 pixels.
    """
    if size[0] % 2 or size[1] % 2:
        raise InputError(
            f"size: {size[0]}x{size[1]} pixels is not allowed: a film's width and height are even"
        )


def write_mp4(
    path: Path,
    segments: Sequence[Segment],
    size: tuple[int, int],
    frames_per_second: int,
    progress: Progress | None = None,
) -> None:
    """Encode segments and join them in an MP4 file that plays while it is still loading.

    Args:
        path: of the file.
        segments: of the film, in order.
        size: width and height of every frame, px; even.
        frames_per_second: whole.
        progress: called from the encoding threads, by one at a time, after every frame.

    Raises:
        InputError: if the size is odd.
        RunError: if the file cannot be written.
    """
    check_film_size(size)
    total, done = sum(segment.length for segment in segments), 0
    lock, stopped = threading.Lock(), threading.Event()

    def encode(segment: Segment) -> list[VideoPacket]:
        nonlocal done
        encoder = _encoder(size, frames_per_second)
        packets: list[VideoPacket] = []
        try:
            for index, pixels in enumerate(segment.frames()):
                if stopped.is_set():
                    break
                packets += encoder.encode(_frame(pixels, index))
                with lock:
                    done += 1
                    if progress is not None:
                        progress(done, total)
        except BaseException:
            stopped.set()
            raise
        return [*packets, *encoder.encode(None)]

    with ThreadPoolExecutor(_WORKERS) as workers:
        futures = [workers.submit(encode, segment) for segment in segments]
        try:
            encoded = [future.result() for future in futures]
        finally:
            # after an interruption there is no use in encoding the rest
            stopped.set()
    try:
        _join(path, encoded, size, frames_per_second)
    except OSError as error:
        raise RunError(f"{path}: cannot be written: {error.strerror}") from None


def _encoder(size: tuple[int, int], frames_per_second: int) -> av.VideoCodecContext:
    encoder = av.CodecContext.create("libx264", "w")
    encoder.width, encoder.height = size
    encoder.pix_fmt = "yuv420p"
    encoder.framerate = Fraction(frames_per_second)
    encoder.time_base = Fraction(1, frames_per_second)
    encoder.thread_count = 1
    encoder.options = dict(_QUALITY)
    # MP4 keeps the parameter sets in its header, once
    encoder.flags |= Flags.global_header
    _tag(encoder)
    return encoder


def _tag(target: av.VideoCodecContext) -> None:
    """Say which colours the numbers mean: those that OpenCV's conversion makes."""
    target.colorspace = Colorspace.ITU601
    target.color_range = ColorRange.MPEG
    target.color_primaries = ColorPrimaries.BT709
    target.color_trc = ColorTrc.BT709


def _frame(pixels: PixelArray, index: int) -> av.VideoFrame:
    planes = cast(PixelArray, cv2.cvtColor(pixels, cv2.COLOR_RGB2YUV_I420))
    frame = av.VideoFrame.from_ndarray(planes, format="yuv420p")
    frame.pts = index
    return frame


def _join(
    path: Path,
    encoded: Sequence[list[VideoPacket]],
    size: tuple[int, int],
    frames_per_second: int,
) -> None:
    time_base = Fraction(1, frames_per_second)
    options = {"movflags": "+faststart"}
    with av.open(str(path), "w", format="mp4", options=options) as container:
        stream = container.add_stream("libx264", rate=frames_per_second)
        stream.width, stream.height = size
        stream.pix_fmt = "yuv420p"
        stream.codec_context.thread_count = 1
        stream.codec_context.options = dict(_QUALITY)
        _tag(stream.codec_context)
        container.start_encoding()
        first = 0
        for packets in encoded:
            for packet in packets:
                packet.stream = stream
                packet.time_base = time_base
                packet.pts = cast(int, packet.pts) + first
                packet.dts = cast(int, packet.dts) + first
                container.mux(packet)
            first += len(packets)  # a packet is a frame
