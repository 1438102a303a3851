"""Films as MP4 files, with the same bytes on every machine.

Each segment is encoded by an encoder of its own on one thread, and begins with a key frame; two
segments are encoded at a time. So the bytes depend neither on how many cores there are nor on which
segment is done first, and players can jump to every segment.
"""

import os
import threading
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import TypeAlias, cast

import av
import cv2
import numpy as np
from av.codec.codec import UnknownCodecError
from av.codec.context import Flags
from av.video.reformatter import ColorPrimaries, ColorRange, Colorspace, ColorTrc

from studio.errors import InputError
from studio.painter.boxes import check_size
from studio.painter.segments import SMALLEST_FRAME, Segment, check_rate
from studio.progress import Progress

VideoPacket: TypeAlias = "av.Packet[av.VideoStream]"

MOST_FILM_FRAMES = 60
"""Most frames per second of an MP4."""

_LARGEST_SIDE = 4096  # of a frame, px: common players show no larger ones
_WORKERS = 2

# the AV1 encoder would describe itself at length on the standard error
os.environ.setdefault("SVT_LOG", "1")


@dataclass(frozen=True)
class _Codec:
    """A way to encode an MP4 film."""

    encoder: str  # FFmpeg's name of it
    options: dict[str, str]


# These options turn off almost all of x264's searching, by which flat drawings hardly gain: films
# take two thirds of the time of the preset as it is. They also turn off its macroblock tree, with
# which the same frames now and then gave other bytes when two encoders ran at a time. Faster
# presets of either codec leave more remains of earlier frames behind. The tests hold the decoded
# colours of both to the drawn ones.
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
    _check_film_size(size)
    check_rate(frames_per_second, MOST_FILM_FRAMES)
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


def _check_film_size(size: tuple[int, int]) -> None:
    # colours are stored for blocks of 2x2 pixels
    if size[0] % 2 or size[1] % 2:
        raise InputError(
            f"size: {size[0]}x{size[1]} pixels is not allowed: a film's width and height are even"
        )
    check_size(size, SMALLEST_FRAME, _LARGEST_SIDE)


def _is_present(encoder: str) -> bool:
    try:
        av.Codec(encoder, "w")
    except UnknownCodecError:
        return False
    return True


@dataclass(frozen=True)
class _Form:
    """What all encoders of one film have in common."""

    codec: _Codec
    size: tuple[int, int]
    frames_per_second: int

    def encoder(self) -> av.VideoCodecContext:
        """A new encoder."""
        encoder = cast(av.VideoCodecContext, av.CodecContext.create(self.codec.encoder, "w"))
        encoder.framerate = Fraction(self.frames_per_second)
        encoder.time_base = 1 / encoder.framerate
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
        # Frames are decoded some time before they are shown. Encoders of short segments ask for
        # less of it, but times must go up through all segments, so all take the longest.
        lead, first = 0, 0
        for packets in encoded:
            for place, packet in enumerate(packets):
                lead = max(lead, place - cast(int, packet.pts))
        for packets in encoded:
            for place, packet in enumerate(packets):
                packet.stream = stream
                packet.time_base = Fraction(1, form.frames_per_second)
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
