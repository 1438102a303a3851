"""The minds in a recording: how the teachers weigh probabilities and value gains and losses.

Each panel of curves is drawn in units of its own and stretched onto a page, on which it is 1 wide
and 1 high; the panels stand side by side.
"""

from dataclasses import dataclass

import numpy as np
import rerun as rr

from learners import decision_weights, value, weight
from studio.arrays import Bounds, FloatArray
from studio.recorder.drawing import Drawing
from studio.scene.judgements import Judgement
from studio.scene.recording import entities
from studio.style.palette import LIGHT
from studio.style.ticks import round_ticks
from studio.style.words import number

CURVES_PITCH, PANELS = 1.4, 4
"""How far the left of a panel is from that of the next, and how many panels there are."""

OUTCOMES_WEIGHED = 50
"""How many equally likely outcomes the decision weights are drawn for."""

LARGEST_UTILITY = 0.5
"""The value curves are drawn from minus this utility to plus this utility."""


@dataclass(frozen=True)
class Panel:
    """Where a panel lies, and its axes.

    Attributes:
        place: number of the panel, counted from the left.
        title: what the curves are.
        across: what is counted across, in words.
        x: ticks across, ascending, from one end of the panel to the other.
        y: ticks upwards, ascending, from the bottom of the panel to its top.
    """

    place: int
    title: str
    across: str
    x: tuple[float, ...]
    y: tuple[float, ...]

    @property
    def width(self) -> float:
        """How much the axis across spans, in its own unit."""
        return self.x[-1] - self.x[0]

    @property
    def height(self) -> float:
        """How much the axis upwards spans, in its own unit."""
        return self.y[-1] - self.y[0]


def log_curves(stream: rr.RecordingStream, judgements: tuple[Judgement, ...]) -> None:
    """Draw how the teachers weigh and value: four panels of curves, a curve a teacher."""
    log_weighting(stream, judgements)
    log_decision_weights(stream, judgements)
    log_values(stream, judgements)


def log_weighting(stream: rr.RecordingStream, judgements: tuple[Judgement, ...]) -> None:
    """Draw w(p) of gains and of losses: how much a probability counts."""
    # denser towards 0 and 1, where the curves are steep
    p = (1.0 - np.cos(np.linspace(0.0, np.pi, 101))) / 2.0
    gains = [weight(p, each.parameters.gamma) for each in judgements]
    losses = [weight(p, each.parameters.delta) for each in judgements]
    ticks = (0.0, 0.5, 1.0)
    of_gains = Panel(0, "w(p) of gains", "p", ticks, ticks)
    of_losses = Panel(1, "w(p) of losses", "p", ticks, ticks)
    log_panel(stream, entities.GAIN_WEIGHTS, of_gains, judgements, p, gains, has_key=True)
    log_panel(stream, entities.LOSS_WEIGHTS, of_losses, judgements, p, losses)


def log_decision_weights(stream: rr.RecordingStream, judgements: tuple[Judgement, ...]) -> None:
    """Draw how much each of fifty equally likely outcomes counts, from the worst to the best.

    The worse half are losses, the better half are gains. A weight of 1 is that of the probability.
    """
    places = np.arange(0.5, OUTCOMES_WEIGHED)
    utilities = places - OUTCOMES_WEIGHED / 2.0
    curves = [
        OUTCOMES_WEIGHED * decision_weights(utilities, each.parameters) for each in judgements
    ]
    panel = Panel(
        2,
        "decision weight × 50",
        "rank",
        (0.0, OUTCOMES_WEIGHED / 2.0, float(OUTCOMES_WEIGHED)),
        round_ticks(0.0, float(np.max(curves))),
    )
    log_panel(stream, entities.DECISION_WEIGHTS, panel, judgements, places, curves)


def log_values(stream: rr.RecordingStream, judgements: tuple[Judgement, ...]) -> None:
    """Draw v(x): how good a gain feels and how bad a loss."""
    x = LARGEST_UTILITY * np.linspace(-1.0, 1.0, 101) ** 3  # denser at 0, where the kink is
    curves = [value(x, judgement.parameters) for judgement in judgements]
    ticks = round_ticks(float(np.min(curves)), float(np.max(curves)))
    panel = Panel(3, "v(x)", "x", (-LARGEST_UTILITY, 0.0, LARGEST_UTILITY), ticks)
    log_panel(stream, entities.VALUES, panel, judgements, x, curves)


def log_panel(
    stream: rr.RecordingStream,
    figure: str,
    panel: Panel,
    judgements: tuple[Judgement, ...],
    x: FloatArray,
    curves: list[FloatArray],
    *,
    has_key: bool = False,
) -> None:
    """Draw one curve a teacher, and the axes; a key in the upper left, if that is free.

    The figure is in its own units; a transform stretches it onto its place beside the others.
    """
    across, up = 1.0 / panel.width, 1.0 / panel.height
    left, right, bottom, top = panel.x[0], panel.x[-1], panel.y[0], panel.y[-1]
    stream.log(
        figure,
        rr.Transform3D(
            translation=[panel.place * CURVES_PITCH - left * across, -bottom * up, 0.0],
            scale=[across, up, 1.0],
        ),
        static=True,
    )
    drawing = Drawing(lift=0.045 * panel.height)
    drawing.text((left + panel.width / 2, top + 0.1 * panel.height), panel.title)
    drawing.text((left + 0.75 * panel.width, bottom - 0.12 * panel.height), panel.across)
    for tick in panel.x:
        drawing.line([(tick, bottom), (tick, top)], LIGHT.faint if tick == 0.0 else LIGHT.grid)
        drawing.text((tick, bottom - 0.12 * panel.height), number(tick))
    for tick in panel.y:
        drawing.line([(left, tick), (right, tick)], LIGHT.faint if tick == 0.0 else LIGHT.grid)
        drawing.text((left - 0.1 * panel.width, tick), number(tick))
    # the lowest curve last: it would vanish in the peaks of the others
    for row in sorted(range(len(judgements)), key=lambda row: -curves[row].max()):
        colour = judgements[row].colour
        drawing.line(np.stack([x, curves[row]], axis=-1), colour, 4.0)
        if has_key:
            y = top - (0.09 + 0.12 * row) * panel.height
            drawing.line(
                [(left + 0.04 * panel.width, y), (left + 0.13 * panel.width, y)], colour, 4.0
            )
            drawing.text((left + 0.29 * panel.width, y), judgements[row].label)
    drawing.log(stream, figure)


def curves_bounds() -> Bounds:
    """What a view of the four panels must show."""
    return -0.2, -0.21, (PANELS - 1) * CURVES_PITCH + 1.08, 1.18
