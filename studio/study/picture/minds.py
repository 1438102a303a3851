"""What learners make of people: the weights, values, reward and probabilities that they learnt."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from learners import CptParameters, Teacher, unit_vector, value, weight
from studio.arrays import FloatArray
from studio.painter.axes import Axis, LogAxis, ground, gutter, labels_below, labels_beside
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.lettering import SEMIBOLD
from studio.painter.marks import dashed_path, dot
from studio.painter.paths import draw_faint_paths
from studio.study.fits import Row, learnt_parameters, parameters_of, pooled_calibration
from studio.study.picture.growth import fits_between
from studio.study.picture.panels import named_panel
from studio.study.picture.scales import Scales
from studio.study.results import Stage
from studio.study.words import feature_names
from studio.style.palette import Colour, blend, learner_colour
from studio.style.ticks import ticks
from studio.style.words import number

_MOST_SEEDS = 60  # of more seeds, only the first ones are drawn; more would only be a smear
_FEW_SEEDS = 8  # lines of more seeds are translucent, so that they do not fill the plot
_GAP = 26  # between plots side by side, in units of the page
_REWARD_TITLES = ["Reward θ/‖θ‖", "θ/‖θ‖"]  # what the plot of rewards is called

_SHADES: dict[int, tuple[float, ...]] = {0: (), 1: (0.9,), 2: (0.35, 1.0), 3: (0.3, 0.6, 1.0)}
"""How dark curves are, from few pairs to many, by how many numbers of pairs are shown."""


def draw_shapes(canvas: Canvas, box: Box, stage: Stage, teacher: Teacher, scales: Scales) -> None:
    """Draw how probabilities are weighted and utilities valued, learnt and in truth.

    Choices tell v and the length of θ only together. What a learner makes of the teacher's utility
    x is therefore v(x ‖θ‖/‖θ*‖), with θ and v both learnt.
    """
    losses, gains, worth = box.columns((1, 1, 1), 0.7 * _GAP * canvas.unit)
    truth, fits = teacher.parameters, _shaded_fits(stage, teacher)
    colour = learner_colour(stage.results.shaped[0])
    p = np.linspace(0.0, 1.0, 101)
    for at, column, wordings in (
        (losses, "delta", ["Weight of losses", "Losses"]),
        (gains, "gamma", ["Weight of gains", "Gains"]),
    ):
        panel = named_panel(canvas, at, wordings)
        across, up = Axis(0, 1, panel.left, panel.right), Axis(0, 1, panel.bottom, panel.top)
        quarters = (0.0, 0.25, 0.5, 0.75, 1.0)
        ground(canvas, panel, [across.at(q) for q in quarters], [up.at(q) for q in quarters])
        canvas.line(
            [(panel.left, panel.bottom), (panel.right, panel.top)], canvas.theme.grid, canvas.hair
        )
        labels_below(canvas, panel, across.at, (0.0, 1.0), "p")
        curves = [(shade, weight(p, float(fit[column]))) for shade, fit in fits]
        true = weight(p, getattr(truth, column), weighting=teacher.weighting)
        _draw_shape(canvas, panel, across, up, p, curves, true, colour)
        if column == "delta":
            _draw_key(canvas, panel, stage)
    panel = named_panel(canvas, worth, ["Value of utility x", "Value of x", "Value"])
    reach = scales.reach
    across = Axis(-reach, reach, panel.left, panel.right)
    up = Axis(*scales.values, panel.bottom, panel.top)
    ground(canvas, panel)
    zero_x, zero_y = round(across.at(0.0)), round(up.at(0.0))
    axis_colour = blend(canvas.theme.faint, canvas.theme.panel, 0.5)
    canvas.fill(Box(zero_x, panel.top, zero_x + canvas.hair, panel.bottom), axis_colour)
    canvas.fill(Box(panel.left, zero_y, panel.right, zero_y + canvas.hair), axis_colour)
    labels_below(canvas, panel, across.at, (-reach, 0.0, reach), "")
    x = reach * np.sign(np.linspace(-1, 1, 121)) * np.linspace(-1, 1, 121) ** 2
    length = float(np.linalg.norm(teacher.reward)) or 1.0
    curves = [
        (shade, value(x * float(np.linalg.norm(fit["theta"]) / length), learnt_parameters(fit)))
        for shade, fit in fits
    ]
    _draw_shape(canvas, panel, across, up, x, curves, value(x, truth), colour)


def _shaded_fits(stage: Stage, teacher: Teacher) -> list[tuple[float, Row]]:
    """Fits of the learner whose shapes are shown, few pairs first, and how dark to draw them."""
    sizes, learner = stage.sharpening, stage.results.shaped[0]
    fits = [stage.results.fits_of(teacher, learner, pairs) for pairs in sizes[:-1]]
    fits += [fits_between(stage, teacher, learner)] if sizes else []
    return [
        (shade, fit)
        for shade, some in zip(_SHADES[len(sizes)], fits, strict=True)
        for fit in some[:_MOST_SEEDS]
    ]


def _draw_shape(
    canvas: Canvas,
    panel: Box,
    across: Axis,
    up: Axis,
    x: FloatArray,
    curves: Sequence[tuple[float, FloatArray]],
    truth: FloatArray,
    colour: Colour,
) -> None:
    """Draw learnt curves, the darker ones above, and the true one on top."""
    part, unit = canvas.clipped(panel), canvas.unit
    for shade in dict.fromkeys(shade for shade, _ in curves):
        lines = [
            np.stack([_straight(across, x), _straight(up, y)], axis=-1)
            for own_shade, y in curves
            if own_shade == shade
        ]
        tint = blend(colour, canvas.theme.panel, shade)
        if len(lines) > _FEW_SEEDS:
            # where many lines meet is where the learner mostly ends up
            draw_faint_paths(part, np.array(lines), tint, unit, 0.4)
            continue
        for line in lines:
            part.line(line, tint, unit)
    true = np.stack([_straight(across, x), _straight(up, truth)], axis=-1)
    dashed_path(part, true, canvas.theme.ink, 2.4 * unit)


def _draw_key(canvas: Canvas, panel: Box, stage: Stage) -> None:
    """Write which shade stands for how many pairs, below the weighting curves, if there is room."""
    unit, size = canvas.unit, canvas.type.small
    sizes, step = stage.sharpening, 1.05 * canvas.type.small
    right, bottom = panel.right - 5 * unit, panel.bottom - 0.7 * size
    widest = max((canvas.measure(str(pairs), size) for pairs in sizes), default=0.0)
    left = right - widest - 20 * unit
    # the free corner is as high as half the panel
    if len(sizes) < 2 or len(sizes) * step > 0.5 * panel.height or left < panel.centre[0]:
        return
    colour = learner_colour(stage.results.shaped[0])
    for index, (pairs, shade) in enumerate(zip(sizes, _SHADES[len(sizes)], strict=True)):
        middle = bottom - (len(sizes) - 1 - index) * step
        stroke = [(left, middle), (left + 15 * unit, middle)]
        canvas.line(stroke, blend(colour, canvas.theme.panel, shade), 2.6 * unit)
        canvas.text((left + 20 * unit, middle), str(pairs), size, canvas.theme.faint)


def _straight(axis: Axis, values: FloatArray) -> FloatArray:
    """Where values lie, px, also off the axis."""
    shares = (np.asarray(values) - axis.low) / (axis.high - axis.low)
    pixels: FloatArray = axis.start + shares * (axis.end - axis.start)
    return pixels


def draw_reward(canvas: Canvas, box: Box, stage: Stage, teacher: Teacher, scales: Scales) -> None:
    """Draw the direction of θ that was learnt from the most pairs, a dot a seed."""
    learnt = {name: fits_between(stage, teacher, name) for name in stage.results.learners}
    low, high = scales.theta
    truth = unit_vector(teacher.reward)
    units = {name: [unit_vector(fit["theta"]) for fit in fits] for name, fits in learnt.items()}
    _draw_cosines(canvas, box, units, truth)
    rewards = _RowPlot(
        _REWARD_TITLES,
        feature_names(len(teacher.reward)),
        [mark for mark in ticks(low, high, 4) if low <= mark <= high],
        Axis(low, high, 0.0, 1.0),
        neutral=0.0,
        truth=truth.tolist(),
        learnt=units,
    )
    rewards.draw(canvas, box)


def draw_risk(canvas: Canvas, box: Box, stage: Stage, teacher: Teacher, scales: Scales) -> None:
    """Draw the parameters of prospect theory learnt from the most pairs, a dot a seed."""
    low, high = scales.parameters
    parameters = _RowPlot(
        ["Parameters of prospect theory", "Risk parameters", "Parameters"],
        CptParameters.SYMBOLS,
        [mark for mark in (0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 10.0) if low <= mark <= high],
        LogAxis(low, high, 0.0, 1.0, 0.0),
        neutral=1.0,
        truth=teacher.parameters.numbers,
        learnt={
            name: [
                np.array(found.numbers)
                for found in map(parameters_of, fits_between(stage, teacher, name))
                if found
            ]
            for name in stage.results.shaped
        },
    )
    parameters.draw(canvas, box)


def _draw_cosines(
    canvas: Canvas, box: Box, learnt: Mapping[str, Sequence[FloatArray]], truth: FloatArray
) -> None:
    """Write the mean cosines of learnt and true θ/‖θ‖ beside the plot's name, if there is room."""
    size, gap = canvas.type.small, 8 * canvas.unit
    texts = [("cos", canvas.theme.faint)]
    for name, units in learnt.items():
        if units:
            cosine = number(float(np.mean([unit @ truth for unit in units])), ".3f")
            texts.append((cosine, canvas.theme.legible(learner_colour(name))))
    widths = [canvas.measure(text, size) for text, _ in texts]
    room = box.width - canvas.measure(_REWARD_TITLES[0], size, SEMIBOLD) - gap
    if len(texts) == 1 or sum(widths) + gap * len(widths) > room:
        return
    right = box.right
    for (text, colour), width in zip(reversed(texts), reversed(widths), strict=True):
        canvas.text((right, box.top), text, size, colour, anchor="right", line="top")
        right -= width + gap


@dataclass(frozen=True)
class _RowPlot:
    """Numbers under one another, each on a row of its own."""

    wordings: Sequence[str]  # what the plot is called, the longest first
    names: Sequence[str]  # what the rows are called
    marks: Sequence[float]  # values to write under the plot
    shares: Axis | LogAxis  # where values lie, from 0 (left) to 1 (right)
    neutral: float  # the value that means nothing, marked by a line
    truth: Sequence[float]  # the true number of each row
    learnt: Mapping[str, Sequence[FloatArray]]  # of each learner each seed's numbers, one a row

    def draw(self, canvas: Canvas, box: Box) -> None:
        """Draw what was learnt around the truth."""
        unit, size = canvas.unit, canvas.type.small
        left = min(gutter(canvas, self.names), 0.4 * box.width)
        panel = named_panel(canvas, box, self.wordings, left)

        def at(value: float) -> float:
            # a margin keeps dots at the ends whole
            return panel.left + 6 * unit + self.shares.at(value) * (panel.width - 12 * unit)

        ground(canvas, panel, across=[at(mark) for mark in self.marks])
        if self.shares.low < self.neutral < self.shares.high:
            neutral = round(at(self.neutral))
            canvas.fill(
                Box(neutral, panel.top, neutral + canvas.hair, panel.bottom),
                blend(canvas.theme.faint, canvas.theme.panel, 0.6),
            )
        labels_below(canvas, panel, at, self.marks, "")
        rows = panel.rows([1.0] * len(self.names))
        part = canvas.clipped(panel)
        for index, (name, true, row) in enumerate(zip(self.names, self.truth, rows, strict=True)):
            # where rows are lower than type, only every second, third ... one is named
            if index % math.ceil(1.05 * size / row.height) == 0:
                text = canvas.fitted(name, left - 6 * unit, size)
                right = panel.left - 6 * unit
                canvas.text((right, row.centre[1]), text, size, canvas.theme.ink, anchor="right")
            if index:
                canvas.fill(
                    Box(panel.left, row.top, panel.right, row.top + canvas.hair), canvas.theme.grid
                )
            lanes = row.inset(0.06 * row.height).rows([1.0] * max(len(self.learnt), 1))
            for (learner, seeds), lane in zip(self.learnt.items(), lanes, strict=False):
                found = [at(float(numbers[index])) for numbers in seeds]
                if not found:
                    continue
                colour = learner_colour(learner)
                radius = min(max(0.42 * lane.height, 2.0 * unit), 4.0 * unit)
                if len(found) > 1:
                    for x in found[:_MOST_SEEDS]:
                        part.disc(
                            (x, lane.centre[1]),
                            0.72 * radius,
                            blend(colour, canvas.theme.panel, 0.5),
                        )
                mean = at(float(np.mean([numbers[index] for numbers in seeds])))
                dot(part, mean, lane.centre[1], colour, radius / unit)
            pen = max(1, round(2 * unit))
            bar = round(at(true) - pen / 2)
            canvas.fill(Box(bar, row.top, bar + pen, row.bottom), canvas.theme.ink)


def draw_calibration(
    canvas: Canvas, box: Box, stage: Stage, teacher: Teacher, scales: Scales
) -> None:
    """Draw how much more often the teacher prefers than what was predicted."""
    wordings = [
        "Preferred − predicted, % of answers",
        "Preferred − predicted, %",
        "Prediction error, %",
        "Error, %",
    ]
    reach = scales.calibration
    marks = ticks(-reach, reach, 2)
    panel = named_panel(canvas, box, wordings, gutter(canvas, list(map(number, marks))))
    across = Axis(0, 100, panel.left, panel.right)
    # a margin keeps dots at the ends whole
    margin = 5 * canvas.unit
    up = Axis(-reach, reach, panel.bottom - margin, panel.top + margin)
    quarters = (0.0, 25.0, 50.0, 75.0, 100.0)
    ground(canvas, panel, [across.at(mark) for mark in quarters], [up.at(mark) for mark in marks])
    labels_below(canvas, panel, across.at, (0.0, 100.0), "predicted")
    labels_beside(canvas, panel, up.at, marks)
    zero = np.array([(panel.left, up.at(0.0)), (panel.right, up.at(0.0))])
    dashed_path(canvas, zero, canvas.theme.ink, 1.2 * canvas.unit)
    part = canvas.clipped(panel)
    for pairs in dict.fromkeys((*stage.sizes[:1], *stage.sizes[-1:])):
        for name in stage.results.learners:
            found = pooled_calibration(stage.results.fits_of(teacher, name, pairs))
            if not len(found.count):
                continue
            colour = learner_colour(name)
            missed = 100.0 * (found.preferred - found.predicted)
            line = np.stack([across.along(100.0 * found.predicted), up.along(missed)], axis=-1)
            if pairs < stage.sizes[-1]:
                part.line(line, blend(colour, canvas.theme.panel, 0.5), 1.2 * canvas.unit)
                continue
            part.line(line, colour, 2.2 * canvas.unit)
            for x, y in line:
                dot(part, float(x), float(y), colour, 2.4)
