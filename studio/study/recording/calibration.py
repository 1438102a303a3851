"""Calibration in a recording of a study: are people as decided as a learner predicts?"""

import numpy as np
import rerun as rr

from learners import Teacher
from studio.recorder.plots import log_bars
from studio.study.fits import calibration_with_intervals
from studio.study.recording import entities
from studio.study.results import StudyResults
from studio.style.palette import LIGHT, blend, learner_colour

_TICK = 0.012  # width of the bar that marks a prediction


def log_calibration(stream: rr.RecordingStream, results: StudyResults, teacher: Teacher) -> None:
    """Add bars of how probable the teacher's choices are, over how probable they were predicted.

    They are full up to the lower end of the 95 % interval over seeds, pale up to its upper end; the
    dark one in their middle reaches to the prediction.
    """
    for learner in results.learners:
        path, colour = entities.calibration(teacher.name, learner), learner_colour(learner)
        for pairs in results.sizes:
            fits = [
                fit for fit in results.fits_of(teacher, learner, pairs) if fit["calibration_count"]
            ]
            if not fits:
                continue
            stream.set_time(entities.TIMELINE, sequence=pairs)
            predicted, preferred, low, high = calibration_with_intervals(fits)
            edges = np.linspace(0.0, 1.0, len(predicted) + 1)
            pale = blend(colour, LIGHT.ground, 0.35)
            log_bars(stream, f"{path}/1_high", edges, high, pale, static=False)
            log_bars(stream, f"{path}/2_low", edges, low, colour, static=False)
            middles = (edges[1:] + edges[:-1] - _TICK) / 2
            marks = rr.BarChart(
                predicted, color=LIGHT.ink, abscissa=middles, widths=np.full(len(middles), _TICK)
            )
            stream.log(f"{path}/3_predicted", marks)
            told = rr.AnyValues(predicted=predicted, preferred=preferred, low=low, high=high)
            stream.log(f"{path}/1_high", told)
    stream.reset_time()
