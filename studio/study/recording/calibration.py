"""Calibration in a recording of a study: are people as decided as a learner predicts?"""

from typing import Any

import numpy as np
import rerun as rr

from learners import Teacher
from studio.arrays import FloatArray
from studio.recorder.axes import LIFT, Axes, draw_key, linear
from studio.recorder.drawing import Drawing
from studio.study.recording import entities
from studio.study.results import Results, Runs
from studio.style.palette import LIGHT, blend, learner_colour
from studio.style.words import learner_name

CALIBRATION = "calibration"
"""Name of the figure, as a part of entity paths."""

LARGEST_DOT = 26.0
"""Diameter of the dot of all predictions together, in pixels."""


def calibration_axes() -> Axes:
    """Predicted probability across, the teacher's upwards."""
    scale = linear((0.0, 0.25, 0.5, 0.75, 1.0))
    return Axes(scale, scale)


def log_calibration(stream: rr.RecordingStream, results: Results, teacher: Teacher) -> None:
    """Draw how probable the teacher's choices are against how probable they were predicted to be.

    Every seed faintly; all seeds together boldly, a dot's area being the share of predictions.
    """
    path, axes = entities.figure(teacher.name, CALIBRATION), calibration_axes()
    drawing = Drawing(lift=LIFT)
    axes.draw(drawing)
    drawing.dashes(np.array([(0.0, 0.0), (1.0, 1.0)]), LIGHT.ink, 2.0)
    entries = [(learner_name(learner), learner_colour(learner)) for learner in results.learners]
    draw_key(drawing, [("as predicted", None), *entries], 0.06, 0.94)
    drawing.log(stream, path)
    for pairs in results.sizes:
        stream.set_time(entities.TIMELINE, sequence=pairs)
        moving = Drawing()
        found = {learner: results.runs(teacher, learner, pairs) for learner in results.learners}
        for learner, runs in found.items():
            pale = blend(learner_colour(learner), LIGHT.panel, 0.35)
            for place in range(len(runs["seed"])):
                one = {name: rows[place : place + 1] for name, rows in runs.items()}
                predicted, preferred, _ = pooled_calibration(one)
                moving.line(axes.place(predicted, preferred), pale, 1.2)
        for learner, runs in found.items():
            predicted, preferred, share = pooled_calibration(runs)
            spots = axes.place(predicted, preferred)
            moving.line(spots, learner_colour(learner), 3.5)
            for spot, weight in zip(spots, share, strict=True):
                size = max(6.0, LARGEST_DOT * float(np.sqrt(weight)))
                moving.dot(spot, learner_colour(learner), size)
        moving.log(stream, entities.moving(path), draw_order=21.0, static=False)
    stream.reset_time()


def pooled_calibration(runs: Runs) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Calibration over several fits, of the n bins that are not empty.

    Returns:
        Mean prediction, mean probability of the teacher's, and share of predictions, [n] each.
    """
    if not runs["seed"]:
        return np.empty(0), np.empty(0), np.empty(0)
    count = _numbers(runs["calibration_count"])  # (S, bins)
    total = count.sum(axis=0)
    some = total > 0.0
    predicted, preferred = (
        np.nansum(count * _numbers(runs[f"calibration_{what}"]), axis=0)[some] / total[some]
        for what in ("predicted", "preferred")
    )
    return predicted, preferred, total[some] / total.sum()


def _numbers(rows: list[list[Any]]) -> FloatArray:
    return np.array(rows, dtype=np.float64)
