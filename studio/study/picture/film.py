"""The film of a study, one finding at a time: how regret fell, then what was learned.

Both pages grow with the number of pairs that were learned from, on the axes of the whole study, and
move smoothly from one number to the next. Nobody was fitted in between, so what is drawn there is
interpolated, and a note says so. The film ends with the picture of the study.
"""

from collections.abc import Callable, Iterator
from itertools import pairwise

import numpy as np

from studio.arrays import PixelArray
from studio.painter.canvas import Canvas
from studio.painter.segments import Segment
from studio.study.picture.finding import SIZE, compose_finding, draw_finding, lay_out_finding
from studio.study.picture.page import draw_stage, lay_out_study
from studio.study.results import Stage, StudyResults
from studio.style.palette import LIGHT, Theme

_INTERPOLATED = "Between two numbers of pairs the curves are interpolated."

# how long something takes, s
_MOVING = 0.7  # the way from one number of pairs to the next
_RESTING = 0.8  # a number of pairs stands still
_LOOKING = 3.0  # a whole page stands still
_CLOSING = 6.0  # the picture of the study stands still at the end


def compose_study_film(
    results: StudyResults,
    size: tuple[int, int] = SIZE,
    frames_per_second: int = 30,
    theme: Theme = LIGHT,
) -> list[Segment]:
    """The film of a study as segments; it has even sides (px).

    Raises:
        InputError: if the size is not allowed.
    """
    finding = lay_out_finding(results, size, theme, _INTERPOLATED)
    minds = lay_out_study(results, size, theme, _INTERPOLATED)
    shown = finding.results

    def frames(seconds: float) -> int:
        return max(1, round(seconds * frames_per_second))

    def grown(draw: Callable[[Stage], Canvas]) -> list[Segment]:
        parts = []
        for stage, following in pairwise(shown.stages):
            ways = np.geomspace(stage.reached, following.reached, frames(_MOVING), endpoint=False)
            parts.append(_still(draw, stage, frames(_RESTING)))
            parts.append(_moving(draw, [Stage(shown, float(pairs)) for pairs in ways[1:]]))
        return [*parts, _still(draw, shown.stages[-1], frames(_LOOKING))]

    return [
        *grown(lambda stage: draw_finding(finding, stage)),
        *grown(lambda stage: draw_stage(minds, stage)),
        _still(lambda _: compose_finding(results, size, theme), shown.stages[-1], frames(_CLOSING)),
    ]


def _still(draw: Callable[[Stage], Canvas], stage: Stage, length: int) -> Segment:
    """The part of a film that shows a stage for this number of frames."""

    def frames() -> Iterator[PixelArray]:
        pixels = draw(stage).pixels
        yield from (pixels for _ in range(length))

    return Segment(length, frames)


def _moving(draw: Callable[[Stage], Canvas], stages: list[Stage]) -> Segment:
    """The part of a film that shows each stage for a frame."""

    def frames() -> Iterator[PixelArray]:
        yield from (draw(stage).pixels for stage in stages)

    return Segment(len(stages), frames)
