"""What recordings are made into: still pictures and films, painted from the recording alone."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import pyarrow.compute as pc

from studio.comparison.picture import page as comparison
from studio.comparison.picture.film import compose_comparison_film
from studio.comparison.picture.page import compose_comparison_picture
from studio.comparison.recording.read import ComparisonRecording
from studio.errors import InputError
from studio.kinds import Recording
from studio.painter.canvas import Canvas
from studio.painter.encode import Progress, Segment, check_codec, check_rate, write_gif, write_mp4
from studio.scene.picture import page as picture
from studio.scene.picture.film import compose_film
from studio.scene.picture.page import compose_picture
from studio.scene.recording.read import SceneRecording
from studio.scene.selection import only
from studio.study.picture import page as study
from studio.study.picture.film import compose_study_film
from studio.study.picture.page import compose_study_picture
from studio.study.recording.read import StudyRecording
from studio.style.palette import THEMES, Theme

Size = tuple[int, int]

FILM_WIDTH, GIF_WIDTH = 1280, 960
"""How wide films are unless one asks for a size; they are shaped like the still picture, px."""

FORMATS = (".png", ".mp4", ".gif")
"""Endings of the files that a recording can be painted into."""


@dataclass(frozen=True)
class Look:
    """How pictures and films look.

    Attributes:
        size: width and height, px; left out, that which suits what is painted.
        frames_per_second: of films.
        theme: `light` or `dark`.
        codec: of MP4 films, `h264` or `av1`.

    Raises:
        InputError: if there is no such theme or codec, or films cannot have so many frames.
    """

    size: Size | None = None
    frames_per_second: int = 30
    theme: str = "light"
    codec: str = "h264"

    def __post_init__(self) -> None:
        if self.theme not in THEMES:
            raise InputError(f"--theme: {self.theme!r} is not known: {', '.join(THEMES)}")
        check_codec(self.codec)
        check_rate(self.frames_per_second)


@dataclass(frozen=True)
class Excerpt:
    """Which part of a recording is shown.

    Attributes:
        actions: names of some actions of a scene; all of them if left out.
        start: where it begins on the recording's own timeline: the film of a scene in s of
            simulated time, that of a comparison in outcomes, a study in pairs; with the first if
            left out.
        end: where it ends, likewise; with the last if left out.
    """

    actions: tuple[str, ...] = ()
    start: float | None = None
    end: float | None = None


def write_picture(
    path: Path,
    recording: Recording,
    look: Look = Look(),  # frozen
    excerpt: Excerpt = Excerpt(),  # frozen
    progress: Progress | None = None,
) -> None:
    """Paint a recording into a file: a picture (`.png`) or a film (`.mp4`, `.gif`).

    The same arguments give the same bytes.

    Args:
        path: of the file, written exactly there; its ending says what it becomes.
        recording: what to paint.
        look: how it looks.
        excerpt: which part of it.
        progress: told after every frame of a film how many of how many are done; called from other
            threads, by one at a time.

    Raises:
        InputError: if the ending or the size is not allowed, or there is no such part.
        OSError: if the file cannot be written.
    """
    rate = look.frames_per_second
    if path.suffix == ".png":
        compose_still(recording, look, excerpt).save(path)
    elif path.suffix == ".mp4":
        size = look.size or film_size(recording, FILM_WIDTH)
        segments = compose_moving(recording, size, look, excerpt)
        write_mp4(path, segments, size, rate, look.codec, progress)
    elif path.suffix == ".gif":
        size = look.size or film_size(recording, GIF_WIDTH)
        write_gif(path, compose_moving(recording, size, look, excerpt), size, rate, progress)
    else:
        raise InputError(f"{path}: is not allowed: a name that ends in {', '.join(FORMATS)}")


def check_files(paths: Sequence[Path], recording: Recording, excerpt: Excerpt) -> None:
    """Make sure that files can become what is wanted, before any work is done.

    Raises:
        InputError: if an ending is not allowed, one file is named twice, or none of the files would
            show the excerpt.
    """
    for path in paths:
        if path.suffix not in FORMATS:
            raise InputError(f"{path}: is not allowed: a name that ends in {', '.join(FORMATS)}")
    resolved = [path.resolve() for path in paths]
    for path in paths:
        if resolved.count(path.resolve()) > 1:
            raise InputError(f"{path}: is named twice: each file once")
    timed = excerpt.start is not None or excerpt.end is not None
    is_still = all(path.suffix == ".png" for path in paths)
    if timed and is_still and not isinstance(recording, StudyRecording):
        raise InputError("--from, --to: go with a film, a picture shows all of the time")


def still_size(recording: Recording) -> Size:
    """Size of the still picture of a recording unless one asks for another, px."""
    match recording:
        case SceneRecording():
            return picture.SIZE
        case ComparisonRecording():
            return comparison.SIZE
        case StudyRecording():
            return study.SIZE


def film_size(recording: Recording, width: int) -> Size:
    """Size of a film so many px wide that is shaped like the still picture, px, even."""
    still_width, still_height = still_size(recording)
    return width, 2 * round(width * still_height / still_width / 2)


def compose_still(recording: Recording, look: Look, excerpt: Excerpt) -> Canvas:
    """Draw the still picture of a recording.

    Raises:
        InputError: if the size is not allowed, or there is no such part of the recording.
    """
    size, theme = look.size or still_size(recording), _theme(recording, look)
    match recording:
        case SceneRecording():
            shown = _with_actions(recording, excerpt.actions)
            return compose_picture(shown.rollouts, shown.judgements, size, theme)
        case ComparisonRecording():
            _refuse_actions(excerpt, "a comparison")
            return compose_comparison_picture(recording.comparison, size, theme)
        case StudyRecording():
            shown_study = _between(recording, excerpt)
            return compose_study_picture(shown_study.table, shown_study.teachers, size, theme)


def compose_moving(recording: Recording, size: Size, look: Look, excerpt: Excerpt) -> list[Segment]:
    """The film of a recording as segments.

    Raises:
        InputError: if the size is not allowed, or there is no such part of the recording.
    """
    rate, theme = look.frames_per_second, _theme(recording, look)
    match recording:
        case SceneRecording():
            shown = _with_actions(recording, excerpt.actions)
            rollouts = shown.rollouts
            span = _span(excerpt, 0.0, rollouts.horizon)
            return compose_film(rollouts, shown.judgements, size, rate, theme, span)
        case ComparisonRecording():
            _refuse_actions(excerpt, "a comparison")
            span = _span(excerpt, 1, recording.comparison.rollouts.count)
            return compose_comparison_film(recording.comparison, size, rate, theme, span)
        case StudyRecording():
            shown_study = _between(recording, excerpt)
            return compose_study_film(shown_study.table, shown_study.teachers, size, rate, theme)


def _theme(recording: Recording, look: Look) -> Theme:
    """The theme, in which actions have the colours that they have among all of the scene's."""
    theme = THEMES[look.theme]
    match recording:
        case SceneRecording():
            return theme.of(recording.rollouts.names)
        case ComparisonRecording() | StudyRecording():
            return theme


def _with_actions(recording: SceneRecording, names: tuple[str, ...]) -> SceneRecording:
    """The recording as if these were all of its actions."""
    if not names:
        return recording
    known = recording.rollouts.names
    rollouts = only(recording.rollouts, names)
    places = [known.index(name) for name in names]
    judgements = tuple(
        replace(
            judgement, values=judgement.values[places], best=int(judgement.values[places].argmax())
        )
        for judgement in recording.judgements
    )
    return SceneRecording(rollouts, judgements)


def _between(recording: StudyRecording, excerpt: Excerpt) -> StudyRecording:
    """The recording as if the study had been of these numbers of pairs."""
    _refuse_actions(excerpt, "a study")
    pairs = recording.table["pairs"]
    if not len(pairs):
        return recording
    low, high = _span(excerpt, pc.min(pairs).as_py(), pc.max(pairs).as_py())
    wanted = pc.and_(pc.greater_equal(pairs, low), pc.less_equal(pairs, high))
    table = recording.table.filter(wanted)
    if not table.num_rows:
        sizes = ", ".join(map(str, sorted(set(pairs.to_pylist()))))
        raise InputError(
            f"--from, --to: {low:g} to {high:g} pairs are not allowed: some of {sizes}"
        )
    return StudyRecording(table, recording.teachers)


def _span(excerpt: Excerpt, first: float, last: float) -> tuple[float, float]:
    """From where to where the excerpt goes, of what goes from the first to the last."""
    start = first if excerpt.start is None else excerpt.start
    return start, last if excerpt.end is None else excerpt.end


def _refuse_actions(excerpt: Excerpt, of_what: str) -> None:
    if excerpt.actions:
        raise InputError(f"--actions: goes with the recording of a scene, not of {of_what}")
