"""What changes in a recording of a study with the number of pairs: its pages and its figures."""

from collections.abc import Callable, Iterable, Iterator
from typing import Any

import rerun as rr

from learners import Spread
from studio.recorder.axes import LIFT
from studio.recorder.drawing import Drawing
from studio.recorder.pages import log_page
from studio.study.recording import entities
from studio.study.results import StudyResults
from studio.style.palette import Colour, learner_colour
from studio.style.words import learner_name


def each_size(stream: rr.RecordingStream, results: StudyResults) -> Iterator[int]:
    """Each number of pairs in turn, with the stream's time set to it; without a time afterwards."""
    for pairs in results.sizes:
        stream.set_time(entities.TIMELINE, sequence=pairs)
        yield pairs
    stream.reset_time()


def changing_figure(
    stream: rr.RecordingStream, results: StudyResults, path: str
) -> Iterator[tuple[int, Drawing]]:
    """Each number of pairs, and a drawing that joins the figure at this path when it is drawn."""
    for pairs in each_size(stream, results):
        drawing = Drawing(lift=LIFT)
        yield pairs, drawing
        drawing.log(stream, entities.moving(path), draw_order=21.0, static=False)


def log_changing_page(
    stream: rr.RecordingStream, results: StudyResults, path: str, page: Callable[[int], str]
) -> None:
    """Add a page of Markdown, written anew for each number of pairs."""
    for pairs in each_size(stream, results):
        log_page(stream, path, page(pairs), static=False)


def learner_entries(learners: Iterable[str]) -> list[tuple[str, Colour | None]]:
    """What a figure's key says of learners: their names and colours."""
    return [(learner_name(learner), learner_colour(learner)) for learner in learners]


def sides(spread: Spread) -> tuple[Any, Any, Any, Any]:
    """Mean, standard deviation and the interval's ends, in the order that recordings keep."""
    return spread.mean, spread.std, spread.low, spread.high
