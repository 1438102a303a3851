"""The film of a study: its picture, growing with the number of pairs that were learned from.

Every number of pairs has a page that stands: what was learnt from so many, on the axes of the whole
study. Nothing moves in between, where nobody was fitted.
"""

from collections.abc import Iterator, Sequence

import pyarrow as pa

from learners import Teacher
from studio.arrays import PixelArray
from studio.painter.segments import Segment
from studio.study.picture.page import SIZE, Page, draw_page, lay_out
from studio.study.picture.results import Results
from studio.style.palette import LIGHT, Theme

STANDING = 1.5
"""How long the page stands still at each number of pairs, s."""

ENDING = 3.0
"""How long the page of all pairs, which is the picture of the study, stands still, s."""


def compose_learning_film(
    table: pa.Table,
    teachers: Sequence[Teacher],
    size: tuple[int, int] = SIZE,
    frames_per_second: int = 30,
    theme: Theme = LIGHT,
) -> list[Segment]:
    """The film of a study as segments, one a number of pairs.

    Args:
        table: one row a fit, see `learners.run_study`; it may be incomplete.
        teachers: who were learned from; of more than four, the first four are shown.
        size: width and height, px; even.
        frames_per_second: whole.
        theme: of the page.

    Raises:
        InputError: if the size is not allowed.
    """
    results = Results.of(table, teachers)
    page = lay_out(results, size, theme)
    standing, ending = (round(held * frames_per_second) for held in (STANDING, ENDING))
    return [
        *(_segment(page, results.up_to(pairs), standing) for pairs in results.all_sizes[:-1]),
        _segment(page, results, ending),
    ]


def _segment(page: Page, results: Results, length: int) -> Segment:
    """The part of a film that shows these results in so many frames."""

    def frames() -> Iterator[PixelArray]:
        pixels = draw_page(page, results).pixels
        yield from (pixels for _ in range(length))

    return Segment(length, frames)
