"""The film of a study: its picture, growing with the number of pairs that were learned from.

Every stage of the study has a page that stands still: what was learnt by then, on the axes of the
whole study. Nothing moves between two stages, because nobody was fitted there.
"""

from collections.abc import Iterator

from studio.arrays import PixelArray
from studio.painter.segments import Segment
from studio.study.picture.page import SIZE, StudyPage, draw_stage, lay_out_study
from studio.study.results import Stage, StudyResults
from studio.style.palette import LIGHT, Theme

_STAGE_LENGTH = 1.5  # how long the page of a stage stands still, s
_LAST_STAGE_LENGTH = 3.0  # the same of the last stage, whose page is the picture of the study, s


def compose_study_film(
    results: StudyResults,
    size: tuple[int, int] = SIZE,
    frames_per_second: int = 30,
    theme: Theme = LIGHT,
) -> list[Segment]:
    """The film of a study as segments, one for each number of pairs; it has even sides (px).

    Raises:
        InputError: if the size is not allowed.
    """
    page = lay_out_study(results, size, theme)
    *stages, last = page.results.stages
    length, last_length = (
        round(seconds * frames_per_second) for seconds in (_STAGE_LENGTH, _LAST_STAGE_LENGTH)
    )
    return [*(_segment(page, stage, length) for stage in stages), _segment(page, last, last_length)]


def _segment(page: StudyPage, stage: Stage, length: int) -> Segment:
    """The part of a film that shows a stage for this number of frames."""

    def frames() -> Iterator[PixelArray]:
        pixels = draw_stage(page, stage).pixels
        yield from (pixels for _ in range(length))

    return Segment(length, frames)
