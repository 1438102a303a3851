"""Calibration in a recording of a study: are people as decided as a learner predicts?"""

import numpy as np
import rerun as rr

from learners import Teacher
from studio.recorder.axes import LIFT, Axes, draw_key, linear
from studio.recorder.drawing import Drawing
from studio.study.fits import pooled_calibration
from studio.study.recording import entities
from studio.study.recording.over_pairs import changing_figure, learner_entries
from studio.study.results import StudyResults
from studio.style.palette import LIGHT, blend, learner_colour

_LARGEST_DOT = 26.0  # diameter of the dot of all predictions together, in pixels


def log_calibration(stream: rr.RecordingStream, results: StudyResults, teacher: Teacher) -> None:
    """Draw how probable the teacher's choices are against how probable they were predicted to be.

    Every seed faintly; all seeds together boldly, a dot's area being the share of predictions.
    """
    path = entities.figure(teacher.name, entities.CALIBRATION)
    probabilities = linear((0.0, 0.25, 0.5, 0.75, 1.0))
    axes = Axes(probabilities, probabilities)
    drawing = Drawing(lift=LIFT)
    axes.draw(drawing)
    drawing.dashes(np.array([(0.0, 0.0), (1.0, 1.0)]), LIGHT.ink, 2.0)
    draw_key(drawing, [("as predicted", None), *learner_entries(results.learners)], 0.06, 0.94)
    drawing.log(stream, path)
    for pairs, changing in changing_figure(stream, results, path):
        found = {name: results.fits_of(teacher, name, pairs) for name in results.learners}
        for learner, fits in found.items():
            pale = blend(learner_colour(learner), LIGHT.panel, 0.35)
            for one in (pooled_calibration([fit]) for fit in fits):
                changing.line(axes.points(one.predicted, one.preferred), pale, 1.2)
        for learner, fits in found.items():
            pooled = pooled_calibration(fits)
            spots = axes.points(pooled.predicted, pooled.preferred)
            changing.line(spots, learner_colour(learner), 3.5)
            for spot, share in zip(spots, pooled.count / pooled.count.sum(), strict=True):
                size = max(6.0, _LARGEST_DOT * float(np.sqrt(share)))
                changing.dot(spot, learner_colour(learner), size)
