"""The film of a comparison: every outcome of two actions in turn, side by side, then the picture.

The k-th outcome plays on both sides at once: the same people with the same luck.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from studio.arrays import FloatArray, PixelArray
from studio.comparison.comparison import CLOSING, MOVING, OPENING, Comparison, seconds_each
from studio.comparison.picture.page import (
    ComparisonPage,
    Show,
    compose_comparison_picture,
    lay_out_comparison,
)
from studio.errors import InputError
from studio.painter.canvas import Canvas
from studio.painter.segments import Segment
from studio.scene.picture.titles import joined
from studio.style.palette import LIGHT, Theme
from studio.style.words import counted

_MOST_PLAYED = 300  # outcomes that move; the paths of further ones appear together with theirs
_SEGMENTS = 6  # that the outcomes are cut into; each costs a key frame and draws what came before


def compose_comparison_film(
    comparison: Comparison,
    size: tuple[int, int],
    frames_per_second: int,
    theme: Theme = LIGHT,
    span: tuple[float, float] | None = None,
) -> list[Segment]:
    """The film as segments: both scenes at rest, the outcomes in parts, and the closing picture.

    Width and height (px) are even. The span is from which outcome to which the film plays, the
    first being 1; without one it plays all. A film that does not begin with the first outcome does
    not show the scenes at rest, and one that does not run to the last has no closing picture.

    Raises:
        InputError: if the size is not allowed, or there are no such outcomes.
    """
    page = lay_out_comparison(comparison, size, theme)
    count = comparison.rollouts.count
    pace = Pace.of(count, frames_per_second)
    first, last = span or (1, count)
    turns = [turn for turn in range(pace.turns) if first <= pace.shown(turn) + 1 <= last]
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

    before = [Segment(opening, at_rest)] if first == 1 else []
    after = [Segment(ending, closing)] if last == count else []
    parts = [part.tolist() for part in np.array_split(turns, min(_SEGMENTS, len(turns)))]
    playing = [Segment(len(part) * pace.frames, partial(frames, part)) for part in parts]
    return [*before, *playing, *after]


@dataclass(frozen=True)
class Pace:
    """How outcomes follow one another."""

    count: int  # of outcomes
    turns: int  # how many of the outcomes move, one after the other
    frames: int  # how many frames each of these has
    moving: int  # in how many of its frames an outcome moves; in the rest it stands at its end
    frames_per_second: int  # of the film

    @classmethod
    def of(cls, count: int, frames_per_second: int) -> "Pace":
        """The pace at which `count` outcomes are shown."""
        turns = min(count, _MOST_PLAYED)
        frames = max(1, round(seconds_each(turns) * frames_per_second))
        return cls(count, turns, frames, max(1, round(MOVING * frames)), frames_per_second)

    def shown(self, turns: int) -> int:
        """How many outcomes have been shown after a number of turns."""
        return turns * self.count // self.turns

    def times_real(self, horizon: float) -> float:
        """How many times faster than real time an outcome moves."""
        return horizon * self.frames_per_second / self.moving


def scenes_at_rest(page: ComparisonPage) -> Canvas:
    """Draw both scenes before anything happens."""
    show, count = Show(page), page.comparison.rollouts.count
    show.keep(0)
    show.write([f"{counted(count, 'outcome')} of each action, one at a time", ""])
    show.draw_at_rest()
    return show.canvas


def play_outcomes(page: ComparisonPage, pace: Pace, turns: Sequence[int]) -> Iterator[Canvas]:
    """Draw the frames of some turns that follow one another.

    Yields:
        One and the same canvas, drawn anew for each frame.
    """
    show, rollouts = Show(page), page.comparison.rollouts
    show.keep(pace.shown(turns[0]))
    last = rollouts.steps
    moving: FloatArray = np.linspace(0.0, last, pace.moving + 1)[1:-1]
    speed = f"{float(f'{pace.times_real(rollouts.horizon):.2g}'):g}× real time"
    red = "red: contact" if rollouts.touched.any() else ""
    for turn in turns:
        outcome = pace.shown(turn)
        told = f"Outcome {outcome + 1} of {pace.count}"
        legends = joined((told, speed, red), (told, speed), (told,))
        show.write(legends)
        for step in moving.tolist():
            show.draw_outcome(outcome, step)
            yield show.canvas
        show.keep(pace.shown(turn + 1))
        show.write(legends)
        show.draw_outcome(outcome, last)
        for _ in range(pace.frames - len(moving)):
            yield show.canvas
