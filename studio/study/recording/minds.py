"""The minds in a recording of a study: what learners take a teacher to be like, beside the truth.

Values are compared as functions of u = θ·φ / ‖θ‖, the utility in units of θ's length: a learner's
‖θ‖ alone says nothing, since choices tell its product with the value function.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import rerun as rr

from learners import FEATURES, CptParameters, Curve, Teacher, unit_vector, value, weight
from studio.arrays import Bounds, FloatArray
from studio.recorder.axes import LIFT, Axes, Scale, draw_key, linear
from studio.recorder.drawing import Drawing
from studio.study.recording import entities
from studio.study.results import (
    CPT_COLUMNS,
    Results,
    learnt_parameters,
    length,
    true_parameters,
)
from studio.style.palette import LIGHT, Colour, blend, learner_colour
from studio.style.ticks import doublings, round_ticks
from studio.style.words import learner_name, teacher_name

GAIN_WEIGHTS, LOSS_WEIGHTS, VALUES = "weights_of_gains", "weights_of_losses", "values"
PARAMETERS = "parameters"
"""Names of the figures, as parts of entity paths."""

PROBABILITIES: FloatArray = (1.0 - np.cos(np.linspace(0.0, np.pi, 61))) / 2.0
"""Where w(p) is drawn: denser towards 0 and 1, where it is steep."""

UTILITIES: FloatArray = np.sign(np.linspace(-1.0, 1.0, 81)) * np.linspace(-1.0, 1.0, 81) ** 2
"""Where v is drawn, in units of ‖θ‖: denser at 0, where the kink is."""

SYMBOLS = dict(zip(CPT_COLUMNS, "αηλγδ", strict=True))

ROW = 0.095
"""Height of a row in the figure of parameters, in units of the page."""

KEY_COLUMNS = 2
"""How many learners the key of that figure names beside one another."""

LEAST_PARAMETER, LARGEST_PARAMETER = 0.25, 4.0
"""The scale of parameters reaches at least from the one to the other."""


@dataclass(frozen=True)
class MindFigure:
    """What a figure of learnt functions shows.

    Attributes:
        path: its entity.
        axes: what it is drawn on.
        x: where functions are drawn.
        truth: the teacher's function there.
        learnt: by number of pairs and learner, the functions of all seeds, [S, X].
    """

    path: str
    axes: Axes
    x: FloatArray
    truth: FloatArray
    learnt: dict[tuple[int, str], FloatArray]


def log_minds(stream: rr.RecordingStream, results: Results, teacher: Teacher) -> None:
    """Draw w(p) of gains and of losses, v, and the parameters, over the number of pairs."""
    for mind in (*weight_figures(results, teacher), value_figure(results, teacher)):
        log_mind(stream, results, teacher, mind)
    log_parameters(stream, results, teacher)


def weight_figures(results: Results, teacher: Teacher) -> tuple[MindFigure, MindFigure]:
    """How much a probability counts, of gains and of losses."""
    scale = linear((0.0, 0.5, 1.0))
    gains: dict[tuple[int, str], FloatArray] = {}
    losses: dict[tuple[int, str], FloatArray] = {}
    for pairs in results.sizes:
        for learner in results.learners:
            people = learnt_parameters(results.runs(teacher, learner, pairs))
            gains[pairs, learner] = _stacked([weight(PROBABILITIES, each.gamma) for each in people])
            losses[pairs, learner] = _stacked(
                [weight(PROBABILITIES, each.delta) for each in people]
            )
    true_gains, true_losses = (
        weight(PROBABILITIES, curvature, weighting=teacher.weighting)
        for curvature in (teacher.parameters.gamma, teacher.parameters.delta)
    )
    paths = [entities.figure(teacher.name, name) for name in (GAIN_WEIGHTS, LOSS_WEIGHTS)]
    axes = Axes(scale, scale)
    return (
        MindFigure(paths[0], axes, PROBABILITIES, true_gains, gains),
        MindFigure(paths[1], axes, PROBABILITIES, true_losses, losses),
    )


def value_figure(results: Results, teacher: Teacher) -> MindFigure:
    """How good a gain feels and how bad a loss."""
    truth = values_along(teacher.reward, teacher.reference, teacher.parameters)
    learnt = {}
    for pairs in results.sizes:
        for learner in results.learners:
            runs = results.runs(teacher, learner, pairs)
            learnt[pairs, learner] = _stacked(
                [
                    values_along(theta, reference, people)
                    for theta, reference, people in zip(
                        runs["theta"], runs["reference"], learnt_parameters(runs), strict=True
                    )
                ]
            )
    low, high = 1.25 * truth.min(), 1.25 * truth.max()
    axes = Axes(linear((-1.0, -0.5, 0.0, 0.5, 1.0)), linear(round_ticks(low, high)))
    return MindFigure(entities.figure(teacher.name, VALUES), axes, UTILITIES, truth, learnt)


def values_along(theta: Sequence[float], reference: float, people: CptParameters) -> FloatArray:
    """Values v at utilities in units of ‖θ‖, [X]."""
    values: FloatArray = value(length(theta) * UTILITIES - reference, people)
    return values


def log_mind(
    stream: rr.RecordingStream, results: Results, teacher: Teacher, mind: MindFigure
) -> None:
    """Draw a figure of functions: every seed faintly, their mean boldly, the truth in dashes."""
    drawing = Drawing(lift=LIFT)
    mind.axes.draw(drawing)
    draw_key(drawing, _key(results, teacher), 0.06, mind.axes.height - 0.06)
    drawing.log(stream, mind.path)

    truth = Drawing()
    truth.dashes(visible(mind.axes, mind.x, mind.truth), LIGHT.ink, 2.5)
    truth.log(stream, entities.truth(mind.path), draw_order=22.0)

    for pairs in results.sizes:
        stream.set_time(entities.TIMELINE, sequence=pairs)
        moving = Drawing()
        found = {
            learner: mind.learnt[pairs, learner]
            for learner in results.learners
            if len(mind.learnt[pairs, learner])
        }
        for learner, functions in found.items():
            pale = blend(learner_colour(learner), LIGHT.panel, 0.35)
            for function in np.unique(functions, axis=0):
                moving.line(visible(mind.axes, mind.x, function), pale, 1.2)
        for learner, functions in found.items():
            mean = visible(mind.axes, mind.x, functions.mean(axis=0))
            moving.line(mean, learner_colour(learner), 4.5)
        moving.log(stream, entities.moving(mind.path), draw_order=21.0, static=False)
    stream.reset_time()


def visible(axes: Axes, x: FloatArray, y: FloatArray) -> FloatArray:
    """The part of a growing function that lies on the page, [N, 2]."""
    low, high = axes.y.ticks[0], axes.y.ticks[-1]
    inside = (y >= low) & (y <= high)
    if inside.all() or not inside.any():
        return axes.place(x, y)
    # to the edge of the page, not only to the last place within
    first, last = np.flatnonzero(inside)[[0, -1]]
    part = slice(max(first - 1, 0), last + 2)
    ends = np.clip(y[part], low, high)
    return axes.place(np.interp(ends, y[part], x[part]), ends)


def log_parameters(stream: rr.RecordingStream, results: Results, teacher: Teacher) -> None:
    """Draw θ/‖θ‖ and the five parameters: a row each, with intervals, beside the truth."""
    path = entities.figure(teacher.name, PARAMETERS)
    direction, parameters = parameter_scales(results)
    rows = [(feature, direction) for feature in FEATURES]
    rows += [(SYMBOLS[column], parameters) for column in CPT_COLUMNS]
    heights = row_heights()
    drawing = Drawing(lift=LIFT)
    for scale, block in ((direction, heights[:5]), (parameters, heights[5:])):
        top, foot = block[0] + ROW / 2, block[-1] - ROW / 2
        for tick, words in zip(scale.ticks, scale.words, strict=True):
            across = float(scale(tick))
            colour = LIGHT.faint if words in ("0", "1") else LIGHT.grid
            drawing.line([(across, foot), (across, top)], colour, 1.0)
            drawing.text((across, foot - 0.05), words)
    for (words, _), y in zip(rows, heights, strict=True):
        drawing.text((-0.2, y), words)
    for place, learner in enumerate(results.learners):
        row, column = divmod(place, KEY_COLUMNS)
        entry = (learner_name(learner), learner_colour(learner))
        draw_key(drawing, [entry], 0.55 * column, heights[0] + ROW * (row + 1))
    drawing.log(stream, path)

    truth = Drawing()
    numbers = [*unit_vector(teacher.reward), *true_parameters(teacher)]
    for (_, scale), y, number in zip(rows, heights, numbers, strict=True):
        across = float(scale(number))
        truth.line([(across, y - 0.4 * ROW), (across, y + 0.4 * ROW)], LIGHT.ink, 2.5)
    truth.log(stream, entities.truth(path), draw_order=22.0)

    for pairs in results.sizes:
        stream.set_time(entities.TIMELINE, sequence=pairs)
        moving = Drawing()
        for place, learner in enumerate(results.learners):
            aside = 0.6 * ROW * ((place + 0.5) / len(results.learners) - 0.5)
            curves = [results.curve(column, teacher, learner) for column in CPT_COLUMNS]
            spreads = [*_spreads_of_theta(results, teacher, learner, pairs)]
            spreads += [_spread(curve, pairs) for curve in curves]
            for (_, scale), y, spread in zip(rows, heights, spreads, strict=True):
                if spread is not None:
                    draw_spread(moving, scale, y - aside, spread, learner_colour(learner))
        moving.log(stream, entities.moving(path), draw_order=21.0, static=False)
    stream.reset_time()


@dataclass(frozen=True)
class Spread:
    """A mean over seeds, its 95 % interval, and the standard deviation."""

    mean: float
    std: float
    low: float
    high: float


def draw_spread(drawing: Drawing, scale: Scale, y: float, spread: Spread, colour: Colour) -> None:
    """Draw a mean as a dot, its interval as a thick and ± one std as a thin line."""
    for ends, pixels in (
        ((spread.mean - spread.std, spread.mean + spread.std), 1.6),
        ((spread.low, spread.high), 5.0),
    ):
        left, right = (float(end) for end in scale(np.array(ends)))
        drawing.line([(left, y), (right, y)], blend(colour, LIGHT.panel, 0.6), pixels)
    drawing.dot((float(scale(spread.mean)), y), colour, 10.0)


def parameter_scales(results: Results) -> tuple[Scale, Scale]:
    """The scales of θ/‖θ‖ and of the parameters, the same for all teachers."""
    truths = [number for teacher in results.teachers for number in true_parameters(teacher)]
    ticks = doublings(min(LEAST_PARAMETER, *truths), max(LARGEST_PARAMETER, 2.0 * max(truths)))
    parameters = Scale(tuple(ticks), tuple(f"{tick:.3g}" for tick in ticks), True)
    return linear((-1.0, -0.5, 0.0, 0.5, 1.0)), parameters


def row_heights() -> list[float]:
    """Where the rows of the figure of parameters lie, the lowest at 0."""
    below = [ROW * place for place in reversed(range(5))]
    return [*(below[0] + ROW * place + 0.14 for place in (5, 4, 3, 2, 1)), *below]


def parameter_bounds(results: Results) -> Bounds:
    """What a view of the figure of parameters must show."""
    rows_of_key = -(-len(results.learners) // KEY_COLUMNS)
    return -0.36, -0.16, 1.06, row_heights()[0] + ROW * rows_of_key + 0.06


def _spread(curve: Curve | None, pairs: int, place: int | None = None) -> Spread | None:
    if curve is None or pairs not in curve.pairs:
        return None
    at = int(np.flatnonzero(curve.pairs == pairs)[0])
    sides = [curve.mean[at], curve.std[at], curve.low[at], curve.high[at]]
    return Spread(*(float(side if place is None else side[place]) for side in sides))


def _spreads_of_theta(
    results: Results, teacher: Teacher, learner: str, pairs: int
) -> list[Spread | None]:
    curve = results.curve("theta_unit", teacher, learner)
    return [_spread(curve, pairs, place) for place in range(len(FEATURES))]


def _key(results: Results, teacher: Teacher) -> list[tuple[str, Colour | None]]:
    learnt = [(learner_name(learner), learner_colour(learner)) for learner in results.learners]
    return [(f"{teacher_name(teacher.name)} teacher", None), *learnt]


def _stacked(functions: list[FloatArray]) -> FloatArray:
    return np.stack(functions) if functions else np.empty((0, 0))
