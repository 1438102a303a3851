"""What every recording can do, and how one is painted into files.

A kind of recording is a folder with a file `kind.py` (see `studio.kinds`), in which a class keeps
to the protocol `Recording`. What is painted comes from the recording alone, nothing is simulated
again.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

from studio.errors import InputError
from studio.style.palette import THEMES, Theme

if TYPE_CHECKING:
    import pandas as pd
    import pyarrow as pa

    from studio.painter.canvas import Canvas
    from studio.painter.segments import Segment
    from studio.progress import Progress

Size = tuple[int, int]
"""Width and height of a picture, px."""

_WIDTHS = {".mp4": 1280, ".gif": 960}  # of films of which no size is asked for, px
_ENDINGS = (".png", *_WIDTHS)  # of the files that a recording can be painted into


@dataclass(frozen=True)
class Look:
    """How pictures and films look.

    Raises:
        InputError: if there is no such theme or codec, or films cannot have this frame rate.
    """

    size: Size | None = None  # if left out, the one that suits what is painted
    frames_per_second: int = 30  # of films
    theme: str = "light"  # or `dark`
    codec: str = "h264"  # of MP4 films, or `av1`

    def __post_init__(self) -> None:
        from studio.painter.mp4 import MOST_FILM_FRAMES, check_codec
        from studio.painter.segments import check_rate

        if self.theme not in THEMES:
            raise InputError(f"--theme: {self.theme!r} is not known: {', '.join(THEMES)}")
        check_codec(self.codec)
        check_rate(self.frames_per_second, MOST_FILM_FRAMES)

    @property
    def colours(self) -> Theme:
        """The colours of the theme."""
        return THEMES[self.theme]


@dataclass(frozen=True)
class Excerpt:
    """Which part of a recording is shown: all of it but for what is told.

    A recording has a timeline of its own, in the unit that its kind counts in.
    """

    actions: tuple[str, ...] = ()  # names of some actions of a scene
    start: float | None = None  # where it begins on the timeline
    end: float | None = None  # where it ends there
    page: int = 1  # of the still picture, for a recording whose picture has several

    def span(self, first: float, last: float) -> tuple[float, float]:
        """From where to where the excerpt goes on a timeline from `first` to `last`."""
        start = first if self.start is None else self.start
        return start, last if self.end is None else self.end

    def refuse_actions(self, of_what: str) -> None:
        """Raise an InputError if some actions are asked for, since this recording has no choice."""
        if self.actions:
            raise InputError(f"--actions: goes with the recording of a scene, not of {of_what}")


class Recording(Protocol):
    """What the studio asks of a recording, whatever its kind, and what a person can ask of it.

    A kind's own class derives from this one. Painting raises `InputError` if a size is not allowed
    or the recording has no such excerpt.
    """

    @property
    def size(self) -> Size:
        """Size of the still picture unless one asks for another, px."""

    @property
    def still_is_cut(self) -> bool:
        """Whether the still picture, too, shows only what lies between the excerpt's ends."""

    @property
    def pages(self) -> int:
        """How many pages the still picture has."""
        return 1

    def still(self, look: Look, excerpt: Excerpt) -> Canvas:
        """Draw the still picture."""

    def moving(self, size: Size, look: Look, excerpt: Excerpt) -> list[Segment]:
        """The film in segments, of this size (px) whatever the look says."""

    def to_arrow(self) -> pa.Table:
        """The numbers that the recording is about, as a table."""

    def to_pandas(self) -> pd.DataFrame:
        """The table of `to_arrow` as a data frame.

        Raises:
            InputError: if pandas is not installed.
        """
        if find_spec("pandas") is None:
            install = "pip install 'prospect-studio[pandas]'"
            raise InputError(f"to_pandas: pandas is not installed: {install}")
        return self.to_arrow().to_pandas()


def write_picture(
    path: Path,
    recording: Recording,
    look: Look | None = None,
    excerpt: Excerpt | None = None,
    progress: Progress | None = None,
) -> None:
    """Paint a recording into a file: a picture (`.png`) or a film (`.mp4`, `.gif`).

    The same arguments give the same bytes.

    Args:
        path: of the file, written exactly there; its ending says what it becomes.
        recording: what to paint.
        look: how it looks.
        excerpt: which part of it; all of it if left out.
        progress: told after every frame of a film how many of how many are done; called from other
            threads, by one at a time.

    Raises:
        InputError: if the ending or the size is not allowed, or there is no such part.
        OSError: if the file cannot be written.
    """
    from studio.painter.gif import write_gif
    from studio.painter.mp4 import write_mp4

    look, excerpt = look or Look(), excerpt or Excerpt()
    rate = look.frames_per_second
    _check_ending(path)
    if path.suffix == ".png":
        recording.still(look, excerpt).save(path)
        return
    size = look.size or _film_size(recording.size, _WIDTHS[path.suffix])
    segments = recording.moving(size, look, excerpt)
    if path.suffix == ".mp4":
        write_mp4(path, segments, size, rate, look.codec, progress)
    else:
        write_gif(path, segments, size, rate, progress)


def check_files(paths: Sequence[Path], recording: Recording, excerpt: Excerpt) -> None:
    """Make sure that files can become what is wanted, before any work is done.

    Raises:
        InputError: if an ending is not allowed, one file is named twice, or none of the files would
            show the excerpt.
    """
    for path in paths:
        _check_ending(path)
    resolved = [path.resolve() for path in paths]
    for path in paths:
        if resolved.count(path.resolve()) > 1:
            raise InputError(f"{path}: is named twice: each file once")
    if not 1 <= excerpt.page <= recording.pages:
        pages = "1" if recording.pages == 1 else f"1 to {recording.pages}"
        raise InputError(f"--page: {excerpt.page} is not there: {pages}")
    if excerpt.page > 1 and not any(path.suffix == ".png" for path in paths):
        raise InputError("--page: goes with a picture, a film shows all pages")
    is_timed = excerpt.start is not None or excerpt.end is not None
    is_still = all(path.suffix == ".png" for path in paths)
    if is_timed and is_still and not recording.still_is_cut:
        raise InputError("--from, --to: go with a film, a picture shows all of the time")


def _film_size(still: Size, width: int) -> Size:
    """Size of a film of this width that is shaped like the still picture, px, both even."""
    return width, 2 * round(width * still[1] / still[0] / 2)


def _check_ending(path: Path) -> None:
    if path.suffix not in _ENDINGS:
        raise InputError(f"{path}: is not allowed: a name that ends in {', '.join(_ENDINGS)}")
