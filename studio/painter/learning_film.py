"""The film of a study: its picture, growing with the number of pairs that were learned from.

At every number of pairs the page shows what was learnt from so many; axes are those of the whole
study from the first frame on. On the way to the next number only the curves move, straight from
one mean to the next: what learners think changes when they have learned, and not before.
"""

from collections.abc import Iterator, Sequence

import numpy as np
import pyarrow as pa

from learners import Teacher
from studio.painter.canvas import Canvas, PixelArray
from studio.painter.encode import Segment, check_film_size
from studio.painter.learning import SIZE, Page, draw_page, draw_progress, lay_out
from studio.painter.learning_results import Results
from studio.palette import LIGHT, Theme

STANDING = 1.2
"""How long the page stands still at each number of pairs, s."""

MOVING = 0.5
"""How long curves take to the next number of pairs, s."""

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
    check_film_size(size)
    results = Results.of(table, teachers)
    page = lay_out(results, size, theme)
    ending = round(ENDING * frames_per_second)
    if not results.all_sizes:
        return [_segment(page, [(results, ending)])]
    segments = []
    for index, pairs in enumerate(results.all_sizes):
        moving = round(MOVING * frames_per_second) if index else 0
        before = results.all_sizes[max(index - 1, 0)]
        # evenly along the logarithmic axis; the last of these is the next number of pairs itself
        passed = np.geomspace(before, pairs, moving + 1)[1:-1]
        last = index == len(results.all_sizes) - 1
        standing = ending if last else round(STANDING * frames_per_second)
        stages = [(results.up_to(float(reached)), 1) for reached in passed]
        segments.append(_segment(page, [*stages, (results.up_to(pairs), standing)]))
    return segments


def _segment(page: Page, stages: Sequence[tuple[Results, int]]) -> Segment:
    """The part of a film that shows each of these results in so many frames."""

    def frames() -> Iterator[PixelArray]:
        drawn = play(page, [results for results, _ in stages])
        for canvas, (_, held) in zip(drawn, stages, strict=True):
            yield from (canvas.pixels for _ in range(held))

    return Segment(sum(held for _, held in stages), frames)


def play(page: Page, stages: Sequence[Results]) -> Iterator[Canvas]:
    """Draw the page once for each of the results, which go ever farther.

    Yields:
        A canvas that lasts only until the next one is asked for.
    """
    canvas, sizes = page.canvas, None
    for results in stages:
        if results.sizes != sizes:
            canvas, sizes = draw_page(page, results), results.sizes
        else:
            # nothing was learned meanwhile
            for column in page.columns:
                draw_progress(canvas, column, results, page.scales)
        yield canvas
