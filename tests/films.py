"""What a film shows, for tests of films."""

from pathlib import Path

import av

from studio.arrays import PixelArray


def frames_and_times(path: Path) -> tuple[list[PixelArray], list[float]]:
    """Frames of a film, each [height, width, 3] in red, green, blue, and when they appear, s."""
    with av.open(str(path)) as film:
        frames = list(film.decode(video=0))
        times = [float(frame.pts * frame.time_base) for frame in frames]
        return [frame.to_ndarray(format="rgb24") for frame in frames], times


def frames_of(path: Path) -> list[PixelArray]:
    """Frames of a film, each [height, width, 3] in red, green, blue."""
    frames, _ = frames_and_times(path)
    return frames
