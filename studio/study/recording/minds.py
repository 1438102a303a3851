"""The minds in a recording of a study: what learners take a teacher to be like, beside the truth.

Values are compared as functions of u = θ·φ / ‖θ‖, the utility in units of θ's length: a learner's
‖θ‖ alone says nothing, since choices tell its product with the value function.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
import rerun as rr

from learners import (
    FEATURES,
    PARAMETER_COLUMNS,
    CptParameters,
    Spread,
    Teacher,
    unit_vector,
    value,
    weight,
)
from studio.arrays import Bounds, FloatArray
from studio.recorder.axes import LIFT, Axes, Scale, draw_key, linear
from studio.recorder.drawing import Drawing
from studio.study.fits import Row, learnt_parameters
from studio.study.recording import entities
from studio.study.recording.over_pairs import changing_figure, learner_entries
from studio.study.results import StudyResults
from studio.study.words import teacher_called
from studio.style.palette import LIGHT, Colour, blend, learner_colour
from studio.style.ticks import doublings, round_ticks

# where w(p) is drawn: denser towards 0 and 1, where it is steep
_PROBABILITIES: FloatArray = (1.0 - np.cos(np.linspace(0.0, np.pi, 61))) / 2.0

# where v is drawn, in units of ‖θ‖: denser at 0, where the kink is
_UTILITIES: FloatArray = np.sign(np.linspace(-1.0, 1.0, 81)) * np.linspace(-1.0, 1.0, 81) ** 2

# the figure of parameters
_ROW = 0.095  # height of a row, in units of the page
_KEY_COLUMNS = 2  # how many learners its key names beside one another
_LEAST_PARAMETER, _LARGEST_PARAMETER = 0.25, 4.0  # the scale reaches at least from one to the other


@dataclass(frozen=True)
class MindFigure:
    """What a figure of learnt functions shows."""

    path: str  # its entity
    axes: Axes  # what it is drawn on
    x: FloatArray  # [X], where functions are drawn
    truth: FloatArray  # [X], the teacher's function there
    learnt: Callable[[Row], FloatArray]  # gives the function that a fit learnt there, [X]


def log_minds(stream: rr.RecordingStream, results: StudyResults, teacher: Teacher) -> None:
    """Draw w(p) of gains and of losses, v, and the parameters, over the number of pairs."""
    log_mind(stream, results, teacher, weight_figure(teacher, entities.GAIN_WEIGHTS, "gamma"))
    log_mind(stream, results, teacher, weight_figure(teacher, entities.LOSS_WEIGHTS, "delta"))
    log_mind(stream, results, teacher, value_figure(teacher))
    log_parameters(stream, results, teacher)


def weight_figure(teacher: Teacher, name: str, curvature: str) -> MindFigure:
    """How much a probability counts: of a gain by the curvature `gamma`, of a loss by `delta`."""

    def learnt(fit: Row) -> FloatArray:
        weights: FloatArray = weight(_PROBABILITIES, getattr(learnt_parameters(fit), curvature))
        return weights

    scale = linear((0.0, 0.5, 1.0))
    true_curvature = getattr(teacher.parameters, curvature)
    truth = weight(_PROBABILITIES, true_curvature, weighting=teacher.weighting)
    path = entities.figure(teacher.name, name)
    return MindFigure(path, Axes(scale, scale), _PROBABILITIES, truth, learnt)


def value_figure(teacher: Teacher) -> MindFigure:
    """How good a gain feels and how bad a loss."""

    def learnt(fit: Row) -> FloatArray:
        return values_along(fit["theta"], fit["reference"], learnt_parameters(fit))

    truth = values_along(teacher.reward, teacher.reference, teacher.parameters)
    up = linear(round_ticks(1.25 * truth.min(), 1.25 * truth.max()))
    axes = Axes(linear((-1.0, -0.5, 0.0, 0.5, 1.0)), up)
    path = entities.figure(teacher.name, entities.VALUES)
    return MindFigure(path, axes, _UTILITIES, truth, learnt)


def values_along(theta: Sequence[float], reference: float, people: CptParameters) -> FloatArray:
    """Values v at `_UTILITIES`, [X]."""
    length = float(np.sqrt(np.sum(np.square(theta))))
    values: FloatArray = value(length * _UTILITIES - reference, people)
    return values


def log_mind(
    stream: rr.RecordingStream, results: StudyResults, teacher: Teacher, mind: MindFigure
) -> None:
    """Draw a figure of functions: every seed faintly, their mean boldly, the truth in dashes."""
    drawing = Drawing(lift=LIFT)
    mind.axes.draw(drawing)
    key = [(teacher_called(teacher), None), *learner_entries(results.learners)]
    draw_key(drawing, key, 0.06, mind.axes.height - 0.06)
    drawing.log(stream, mind.path)

    truth = Drawing()
    truth.dashes(visible(mind.axes, mind.x, mind.truth), LIGHT.ink, 2.5)
    truth.log(stream, entities.truth(mind.path), draw_order=22.0)

    for pairs, changing in changing_figure(stream, results, mind.path):
        found = {
            learner: np.stack([mind.learnt(fit) for fit in fits])
            for learner in results.learners
            if (fits := results.fits_of(teacher, learner, pairs))
        }
        for learner, functions in found.items():
            pale = blend(learner_colour(learner), LIGHT.panel, 0.35)
            for function in np.unique(functions, axis=0):
                changing.line(visible(mind.axes, mind.x, function), pale, 1.2)
        for learner, functions in found.items():
            mean = visible(mind.axes, mind.x, functions.mean(axis=0))
            changing.line(mean, learner_colour(learner), 4.5)


def visible(axes: Axes, x: FloatArray, y: FloatArray) -> FloatArray:
    """The part of a growing function that lies on the page, [N, 2]."""
    low, high = axes.y.ticks[0], axes.y.ticks[-1]
    inside = (y >= low) & (y <= high)
    if inside.all() or not inside.any():
        return axes.points(x, y)
    # to the edge of the page, not only to the last place within
    first, last = np.flatnonzero(inside)[[0, -1]]
    part = slice(max(first - 1, 0), last + 2)
    ends = np.clip(y[part], low, high)
    return axes.points(np.interp(ends, y[part], x[part]), ends)


def log_parameters(stream: rr.RecordingStream, results: StudyResults, teacher: Teacher) -> None:
    """Draw θ/‖θ‖ and the five parameters: a row each, with intervals, beside the truth."""
    path = entities.figure(teacher.name, entities.PARAMETERS)
    direction, parameters = parameter_scales(results)
    names, heights = (*FEATURES, *CptParameters.SYMBOLS), row_heights()
    scales = [direction] * len(FEATURES) + [parameters] * len(CptParameters.SYMBOLS)
    drawing = Drawing(lift=LIFT)
    for scale, block in ((direction, heights[:5]), (parameters, heights[5:])):
        top, foot = block[0] + _ROW / 2, block[-1] - _ROW / 2
        for tick, words in zip(scale.ticks, scale.words, strict=True):
            across = float(scale(tick))
            colour = LIGHT.faint if words in ("0", "1") else LIGHT.grid
            drawing.line([(across, foot), (across, top)], colour, 1.0)
            drawing.text((across, foot - 0.05), words)
    for words, y in zip(names, heights, strict=True):
        drawing.text((-0.2, y), words)
    for place, entry in enumerate(learner_entries(results.learners)):
        row, column = divmod(place, _KEY_COLUMNS)
        draw_key(drawing, [entry], 0.55 * column, heights[0] + _ROW * (row + 1))
    drawing.log(stream, path)

    truth = Drawing()
    numbers = [*unit_vector(teacher.reward), *teacher.parameters.numbers]
    for scale, y, number in zip(scales, heights, numbers, strict=True):
        across = float(scale(number))
        truth.line([(across, y - 0.4 * _ROW), (across, y + 0.4 * _ROW)], LIGHT.ink, 2.5)
    truth.log(stream, entities.truth(path), draw_order=22.0)

    for pairs, changing in changing_figure(stream, results, path):
        for place, learner in enumerate(results.learners):
            aside = 0.6 * _ROW * ((place + 0.5) / len(results.learners) - 0.5)
            spreads = spreads_of_numbers(results, teacher, learner, pairs)
            for scale, y, spread in zip(scales, heights, spreads, strict=True):
                if spread is not None:
                    draw_spread(changing, scale, y - aside, spread, learner_colour(learner))


def spreads_of_numbers(
    results: StudyResults, teacher: Teacher, learner: str, pairs: int
) -> list[Spread | None]:
    """What the seeds say of each number of θ/‖θ‖, then of each parameter; None where nothing."""
    columns = ("theta_unit", *PARAMETER_COLUMNS)
    theta, *parameters = (results.spread(each, teacher, learner, pairs) for each in columns)
    direction = [theta and _number_of(theta, place) for place in range(len(FEATURES))]
    return [*direction, *parameters]


def draw_spread(drawing: Drawing, scale: Scale, y: float, spread: Spread, colour: Colour) -> None:
    """Draw a mean as a dot, its interval as a thick and ± one std as a thin line."""
    for ends, pixels in (
        ((spread.mean - spread.std, spread.mean + spread.std), 1.6),
        ((spread.low, spread.high), 5.0),
    ):
        left, right = (float(end) for end in scale(np.array(ends)))
        drawing.line([(left, y), (right, y)], blend(colour, LIGHT.panel, 0.6), pixels)
    drawing.dot((float(scale(spread.mean)), y), colour, 10.0)


def parameter_scales(results: StudyResults) -> tuple[Scale, Scale]:
    """The scales of θ/‖θ‖ and of the parameters, the same for all teachers."""
    truths = [number for teacher in results.teachers for number in teacher.parameters.numbers]
    ticks = doublings(min(_LEAST_PARAMETER, *truths), max(_LARGEST_PARAMETER, 2.0 * max(truths)))
    parameters = Scale(tuple(ticks), tuple(f"{tick:.3g}" for tick in ticks), True)
    return linear((-1.0, -0.5, 0.0, 0.5, 1.0)), parameters


def row_heights() -> list[float]:
    """Where the rows of the figure of parameters lie, the lowest at 0."""
    below = [_ROW * place for place in reversed(range(5))]
    return [*(below[0] + _ROW * place + 0.14 for place in (5, 4, 3, 2, 1)), *below]


def parameter_bounds(results: StudyResults) -> Bounds:
    """What a view of the figure of parameters must show."""
    rows_of_key = -(-len(results.learners) // _KEY_COLUMNS)
    return -0.36, -0.16, 1.06, row_heights()[0] + _ROW * rows_of_key + 0.06


def _number_of(spread: Spread, place: int) -> Spread:
    """The spread of one number of a list."""
    return spread.of(place)
