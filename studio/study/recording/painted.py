"""What Rerun has no view for: learnt functions beside the teacher's, and what marks mean."""

from dataclasses import replace

import rerun as rr

from learners import Teacher
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.pens import pen_mark
from studio.recorder.figures import log_figure
from studio.study.picture.minds import draw_shapes
from studio.study.picture.scales import Scales
from studio.study.recording import entities
from studio.study.results import StudyResults
from studio.study.words import learner_called
from studio.style.palette import LIGHT, blend, learner_pen

_PAGE = (2000, 1125)  # of which figures are a corner, and which their type suits, px
_SHAPES_SIZE = (1200, 470)  # width and height of the figure of learnt functions, px

_KEY_WIDTH, _KEY_LINE = 600, 36  # of the key, px, and from line to line
_MEANINGS = (
    "bold: mean over seeds, and its 95 % interval",
    "thin, dark: interquartile mean",
    "pale dots: seeds · black: the teacher",
)


def log_shapes(
    stream: rr.RecordingStream, results: StudyResults, teacher: Teacher, scales: Scales
) -> None:
    """Add how the teacher weighs probabilities and values utilities, and how that is learnt."""
    width, height = _SHAPES_SIZE
    for stage in results.stages:
        canvas = Canvas(*_PAGE, LIGHT)
        draw_shapes(canvas, Box(24, 20, width - 24, height - 8), stage, teacher, scales)
        stream.set_time(entities.TIMELINE, sequence=int(stage.reached))
        path = entities.shapes(teacher.name)
        log_figure(stream, path, canvas.pixels[:height, :width], static=False)
    stream.reset_time()


def log_key(stream: rr.RecordingStream, results: StudyResults) -> None:
    """Add what the colours and marks of all plots mean."""
    width, height = _KEY_WIDTH, _KEY_LINE * (len(results.learners) + len(_MEANINGS)) + 16
    canvas = Canvas(*_PAGE, LIGHT)
    size, middle = canvas.type.small, 8 + _KEY_LINE / 2
    for learner in results.learners:
        pen = learner_pen(learner)
        pale = blend(pen.colour, LIGHT.ground, 0.25)
        canvas.fill(Box(16, middle - 13, 96, middle + 13), pale)
        canvas.line([(16, middle), (96, middle)], pen.colour, 5.0)
        solid = replace(pen, filled=True)  # as Rerun draws all markers
        pen_mark(canvas, (56, middle), solid, 8.0, pale)
        said = canvas.abbreviated(learner_called(learner), width - 130, size)
        canvas.text((114, middle), said, size, LIGHT.ink)
        middle += _KEY_LINE
    for words in _MEANINGS:
        canvas.text((16, middle), words, size, LIGHT.faint)
        middle += _KEY_LINE
    log_figure(stream, entities.KEY, canvas.pixels[:height, :width])
