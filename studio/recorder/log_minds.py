"""The minds in a recording: how the teachers weigh probabilities and value gains and losses."""

from dataclasses import dataclass
from typing import Any

import numpy as np
import rerun as rr

from learners import value, weight
from studio.judgements import FloatArray, Judgement
from studio.naming import number, teacher_name
from studio.palette import LIGHT, teacher_colour
from studio.recorder import entities
from studio.recorder.drawing import Drawing

LARGEST_UTILITY = 0.5
"""The value curves are drawn from minus to plus this, in units of utility."""


@dataclass(frozen=True)
class Axes:
    """The axes of a figure that is drawn in its own units.

    Attributes:
        x: ticks across, from the lowest value to the highest.
        y: ticks upwards, from the lowest value to the highest.
    """

    x: tuple[float, ...]
    y: tuple[float, ...]

    @property
    def width(self) -> float:
        """From the lowest value across to the highest."""
        return self.x[-1] - self.x[0]

    @property
    def height(self) -> float:
        """From the lowest value upwards to the highest."""
        return self.y[-1] - self.y[0]


def log_judgements(stream: rr.RecordingStream, judgements: tuple[Judgement, ...]) -> None:
    """Keep the value of every action to every teacher."""
    values: dict[str, Any] = {judgement.teacher: judgement.values for judgement in judgements}
    stream.log(entities.JUDGEMENTS, rr.AnyValues(**values), static=True)


def log_weighting(stream: rr.RecordingStream, judgements: tuple[Judgement, ...]) -> None:
    """Draw w(p) of gains and of losses: how much a probability counts."""
    axes = Axes((0.0, 0.5, 1.0), (0.0, 0.5, 1.0))
    # denser towards 0 and 1, where the curves are steep
    probability = (1.0 - np.cos(np.linspace(0.0, np.pi, 101))) / 2.0
    gains = [weight(probability, each.parameters.gamma).numpy() for each in judgements]
    losses = [weight(probability, each.parameters.delta).numpy() for each in judgements]
    log_curves(stream, entities.GAIN_WEIGHTS, axes, judgements, probability, gains)
    log_curves(stream, entities.LOSS_WEIGHTS, axes, judgements, probability, losses)


def log_values(stream: rr.RecordingStream, judgements: tuple[Judgement, ...]) -> None:
    """Draw v(x): how good a gain feels and how bad a loss."""
    x = LARGEST_UTILITY * np.linspace(-1.0, 1.0, 101) ** 3  # denser at 0, where the kink is
    curves = [value(x, judgement.parameters).numpy() for judgement in judgements]
    lowest, highest = np.min(curves), np.max(curves)
    halves = np.arange(np.floor(2.0 * lowest), np.ceil(2.0 * highest) + 1) / 2.0
    axes = Axes((-LARGEST_UTILITY, 0.0, LARGEST_UTILITY), tuple(halves.tolist()))
    log_curves(stream, entities.VALUES, axes, judgements, x, curves)


def log_curves(
    stream: rr.RecordingStream,
    figure: str,
    axes: Axes,
    judgements: tuple[Judgement, ...],
    x: FloatArray,
    curves: list[FloatArray],
) -> None:
    """Draw one curve a teacher, with axes and a key in the upper left, where no curve runs.

    The figure is in its own units; a transform stretches it onto a page of width and height 1.
    """
    across, up = 1.0 / axes.width, 1.0 / axes.height
    stream.log(
        figure,
        rr.Transform3D(
            translation=[-axes.x[0] * across, -axes.y[0] * up, 0.0], scale=[across, up, 1.0]
        ),
        static=True,
    )
    left, bottom, top = axes.x[0], axes.y[0], axes.y[-1]
    drawing = Drawing(lift=0.035 * axes.height)
    for tick in axes.x:
        drawing.line([(tick, bottom), (tick, top)], LIGHT.faint if tick == 0.0 else LIGHT.grid)
        drawing.text((tick, bottom - 0.06 * axes.height), number(tick))
    for tick in axes.y:
        drawing.line([(left, tick), (axes.x[-1], tick)], LIGHT.faint if tick == 0.0 else LIGHT.grid)
        drawing.text((left - 0.07 * axes.width, tick), number(tick))
    for row, (judgement, curve) in enumerate(zip(judgements, curves, strict=True)):
        colour = teacher_colour(judgement.teacher)
        drawing.line(np.stack([x, curve], axis=-1), colour, 4.0)
        y = top - (0.08 + 0.09 * row) * axes.height
        drawing.line([(left + 0.05 * axes.width, y), (left + 0.13 * axes.width, y)], colour, 4.0)
        drawing.text((left + 0.22 * axes.width, y), teacher_name(judgement.teacher))
    drawing.log(stream, figure)
