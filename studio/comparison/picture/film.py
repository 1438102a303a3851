"""The film of a comparison: outcomes of two actions in turn, side by side, then what they show.

The k-th outcome plays on both sides at once: the same people with the same luck. The first few play
slowly, the others fast, and leave their paths behind. Then the worst and the typical outcome of
each side play once more, and the picture stands still.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from studio.arrays import IntArray, PixelArray
from studio.comparison.comparison import CLOSING, OPENING, Comparison, Timetable
from studio.comparison.picture.page import (
    ComparisonPage,
    Show,
    compose_comparison_picture,
    lay_out_comparison,
)
from studio.comparison.telling import TellingOutcome, telling_outcomes
from studio.comparison.words import marks_told
from studio.errors import InputError
from studio.painter.canvas import Canvas
from studio.painter.segments import Segment
from studio.scene.picture.titles import joined
from studio.style.palette import LIGHT, Theme
from studio.style.words import counted

_SEGMENTS = 8  # that the outcomes are cut into; each costs a key frame and draws what came before
_STANDING = 1.0  # how long the end of an outcome that plays once more stands still, s


def compose_comparison_film(
    comparison: Comparison,
    size: tuple[int, int],
    frames_per_second: int,
    theme: Theme = LIGHT,
    span: tuple[float, float] | None = None,
) -> list[Segment]:
    """The film as segments: both scenes at rest, the outcomes in parts, replays, and the picture.

    Width and height (px) are even. The span is from which outcome to which the film plays, the
    first being 1; without one it plays all whose paths are kept. A film that does not begin with
    the first outcome does not show the scenes at rest, and one that does not run to the last has
    neither replays nor a closing picture.

    Raises:
        InputError: if the size is not allowed, or there are no such outcomes.
    """
    page = lay_out_comparison(comparison, size, theme)
    count = page.sample.count
    pace = Pace.of(count, page.rollouts.horizon, frames_per_second)
    first, last = span or (1, count)
    turns = [turn for turn in range(count) if first <= turn + 1 <= last]
    if not 1 <= first <= last <= count or not turns:
        raise InputError(
            f"--from, --to: outcomes {first:g} to {last:g} are not allowed: within 1 to {count}"
        )
    opening, ending = round(OPENING * frames_per_second), round(CLOSING * frames_per_second)

    def at_rest() -> Iterator[PixelArray]:
        pixels = scenes_at_rest(page).pixels
        return (pixels for _ in range(opening))

    def closing() -> Iterator[PixelArray]:
        pixels = compose_comparison_picture(comparison, size, theme).pixels
        return (pixels for _ in range(ending))

    def frames(part: Sequence[int]) -> Iterator[PixelArray]:
        return (canvas.pixels for canvas in play_outcomes(page, pace, part))

    def replayed(telling: TellingOutcome) -> Iterator[PixelArray]:
        return (canvas.pixels for canvas in replay(page, pace, telling))

    before = [Segment(opening, at_rest)] if first == 1 else []
    playing = [
        Segment(int(pace.frames[part].sum()), partial(frames, part)) for part in pace.parts(turns)
    ]
    if last < count:
        return [*before, *playing]
    once_more = [
        Segment(pace.frames_of_replay, partial(replayed, telling))
        for telling in telling_outcomes(page.rollouts)
    ]
    return [*before, *playing, *once_more, Segment(ending, closing)]


@dataclass(frozen=True)
class Pace:
    """How outcomes follow one another in the frames of a film."""

    frames: IntArray  # [M], how many frames each of them has
    moving: IntArray  # [M], in how many of its frames it moves; in the rest it stands at its end
    frames_per_second: int

    @classmethod
    def of(cls, count: int, horizon: float, frames_per_second: int) -> "Pace":
        """The pace at which `count` outcomes of a horizon (s) are shown."""
        table = Timetable.of(count, horizon)
        moving, frames = (
            np.maximum(np.rint(times * frames_per_second), 1).astype(np.int64)
            for times in (table.moving, table.lengths)
        )
        return cls(frames, np.minimum(moving, frames), frames_per_second)

    @property
    def frames_of_replay(self) -> int:
        """How many frames an outcome has that plays once more: it is as slow as the first."""
        return int(self.moving[0]) + round(_STANDING * self.frames_per_second)

    def parts(self, turns: Sequence[int]) -> list[list[int]]:
        """Turns that follow one another cut into parts of about as many frames each."""
        so_far = np.cumsum(self.frames[list(turns)])
        wanted = so_far[-1] * np.arange(1, _SEGMENTS) / _SEGMENTS
        cuts = np.unique(np.searchsorted(so_far, wanted))
        return [part.tolist() for part in np.split(np.array(turns), cuts) if len(part)]

    def told(self, turn: int, horizon: float) -> str:
        """How many times faster than real time an outcome moves."""
        times_real = horizon * self.frames_per_second / int(self.moving[turn])
        return f"{float(f'{times_real:.2g}'):g}× real time"


def scenes_at_rest(page: ComparisonPage) -> Canvas:
    """Draw both scenes before anything happens."""
    show = Show(page)
    show.keep(0)
    told = f"{counted(page.sample.count, 'outcome')} of each action, one at a time"
    show.write(([told, ""], _marks(page)))
    show.draw_at_rest()
    return show.canvas


def play_outcomes(page: ComparisonPage, pace: Pace, turns: Sequence[int]) -> Iterator[Canvas]:
    """Draw the frames of some turns that follow one another.

    Yields:
        One and the same canvas, drawn anew for each frame.
    """
    show, rollouts = Show(page), page.sample
    show.keep(turns[0])
    for outcome in turns:
        told = f"Outcome {outcome + 1} of {rollouts.count}"
        playing = joined((told, pace.told(outcome, rollouts.horizon)), (told,)), _marks(page)
        show.write(playing)
        moving = _steps(rollouts.steps, int(pace.moving[outcome]))
        for step in moving:
            show.draw_outcomes((outcome, outcome), step)
            yield show.canvas
        show.keep(outcome + 1)
        show.write(playing)
        show.draw_outcomes((outcome, outcome), rollouts.steps)
        for _ in range(int(pace.frames[outcome]) - len(moving)):
            yield show.canvas


def replay(page: ComparisonPage, pace: Pace, telling: TellingOutcome) -> Iterator[Canvas]:
    """Draw the frames of an outcome of each side that plays once more, when all have been shown.

    Yields:
        One and the same canvas, drawn anew for each frame.
    """
    show, rollouts = Show(page), page.sample
    show.keep(rollouts.count)
    show.fade()
    shown = " shown" if rollouts.count < page.rollouts.count else ""
    notes = [
        f"{telling.name} outcome: no. {place + 1} of {rollouts.count}{shown}"
        for place in telling.places
    ]
    told = f"Once more: the {telling.name} outcome of each side"
    show.write((joined((told, pace.told(0, rollouts.horizon)), (told,)), _marks(page)), notes)
    moving = _steps(rollouts.steps, int(pace.moving[0]))
    for step in moving:
        show.draw_outcomes(telling.places, step)
        yield show.canvas
    show.draw_outcomes(telling.places, rollouts.steps)
    for _ in range(pace.frames_of_replay - len(moving)):
        yield show.canvas


def _steps(last: int, frames: int) -> list[float]:
    """The steps that are shown in as many frames, but for the last one."""
    steps: list[float] = np.linspace(0.0, last, frames + 1)[1:-1].tolist()
    return steps


def _marks(page: ComparisonPage) -> list[str]:
    """What marks of contact mean, and that only some of the outcomes play if so."""
    count, played = page.rollouts.count, page.sample.count
    sample = f"playing: a sample of {played} of {count}" if played < count else ""
    touched = marks_told(page.rollouts)
    return joined((touched, sample), (sample or touched,))
