"""The minds in a recording: how the teachers weigh probabilities and value gains and losses.

Each panel of curves is drawn in units of its own and stretched onto a page, on which it is 1 wide
and 1 high; the panels stand side by side.
"""

from dataclasses import dataclass

import numpy as np
import rerun as rr

from learners import decision_weights, value, weight
from studio.arrays import Bounds, FloatArray
from studio.recorder.axes import line_colour
from studio.recorder.drawing import Drawing
from studio.scene.judgements import Judgement
from studio.scene.recording import entities
from studio.style.ticks import round_ticks
from studio.style.words import number

CURVES_PITCH = 1.4  # from the left of a panel to that of the next, on the page
OUTCOMES_WEIGHED = 50  # how many equally likely outcomes the decision weights are drawn for
LARGEST_UTILITY = 0.5  # the value curves reach from minus this utility to plus this utility

CURVES_BOUNDS: Bounds = (-0.2, -0.21, (len(entities.CURVES) - 1) * CURVES_PITCH + 1.08, 1.18)
"""What a view of all panels must show."""


@dataclass(frozen=True)
class Panel:
    """The curves of a panel, one a teacher, and its axes."""

    title: str  # what the curves are
    across: str  # what is counted across
    x: tuple[float, ...]  # ticks across, ascending, from one end of the panel to the other
    y: tuple[float, ...]  # ticks upwards, ascending, from the bottom of the panel to its top
    places: FloatArray  # [N], where across the curves are known
    curves: list[FloatArray]  # [N] each


def log_curves(stream: rr.RecordingStream, judgements: tuple[Judgement, ...]) -> None:
    """Draw how the teachers weigh and value: four panels of curves, a curve a teacher."""
    panels = (
        weights_panel("w(p) of gains", [each.parameters.gamma for each in judgements]),
        weights_panel("w(p) of losses", [each.parameters.delta for each in judgements]),
        decision_weights_panel(judgements),
        values_panel(judgements),
    )
    for place, (figure, panel) in enumerate(zip(entities.CURVES, panels, strict=True)):
        log_panel(stream, figure, panel, judgements, place)


def weights_panel(title: str, curvatures: list[float]) -> Panel:
    """The curves w(p) of these curvatures: how much a probability counts."""
    # denser towards 0 and 1, where the curves are steep
    p = (1.0 - np.cos(np.linspace(0.0, np.pi, 101))) / 2.0
    ticks = (0.0, 0.5, 1.0)
    return Panel(title, "p", ticks, ticks, p, [weight(p, curvature) for curvature in curvatures])


def decision_weights_panel(judgements: tuple[Judgement, ...]) -> Panel:
    """How much each of fifty equally likely outcomes counts, from the worst to the best.

    The worse half are losses, the better half are gains. A weight of 1 is that of the probability.
    """
    count = OUTCOMES_WEIGHED
    places = np.arange(0.5, count)
    utilities = places - count / 2.0
    curves = [count * decision_weights(utilities, each.parameters) for each in judgements]
    ticks = round_ticks(0.0, float(np.max(curves)))
    ranks = (0.0, count / 2.0, float(count))
    return Panel(f"decision weight × {count}", "rank", ranks, ticks, places, curves)


def values_panel(judgements: tuple[Judgement, ...]) -> Panel:
    """The curves v(x): how good a gain feels and how bad a loss."""
    x = LARGEST_UTILITY * np.linspace(-1.0, 1.0, 101) ** 3  # denser at 0, where the kink is
    curves = [value(x, each.parameters) for each in judgements]
    ticks = round_ticks(float(np.min(curves)), float(np.max(curves)))
    return Panel("v(x)", "x", (-LARGEST_UTILITY, 0.0, LARGEST_UTILITY), ticks, x, curves)


def log_panel(
    stream: rr.RecordingStream,
    figure: str,
    panel: Panel,
    judgements: tuple[Judgement, ...],
    place: int,
) -> None:
    """Draw one curve a teacher, and the axes; in the first panel also a key in the upper left.

    The figure is in its own units; a transform stretches it onto its place beside the others.
    """
    left, right, bottom, top = panel.x[0], panel.x[-1], panel.y[0], panel.y[-1]
    width, height = right - left, top - bottom
    across, up = 1.0 / width, 1.0 / height
    stream.log(
        figure,
        rr.Transform3D(
            translation=[place * CURVES_PITCH - left * across, -bottom * up, 0.0],
            scale=[across, up, 1.0],
        ),
        static=True,
    )
    drawing = Drawing(lift=0.045 * height)
    below, beside = bottom - 0.12 * height, left - 0.1 * width
    drawing.text((left + width / 2, top + 0.1 * height), panel.title)
    drawing.text((left + 0.75 * width, below), panel.across)
    for tick in panel.x:
        drawing.line([(tick, bottom), (tick, top)], line_colour(tick))
        drawing.text((tick, below), number(tick))
    for tick in panel.y:
        drawing.line([(left, tick), (right, tick)], line_colour(tick))
        drawing.text((beside, tick), number(tick))
    # the lowest curve last: it would vanish in the peaks of the others
    for row in sorted(range(len(judgements)), key=lambda row: -panel.curves[row].max()):
        colour = judgements[row].colour
        drawing.line(np.stack([panel.places, panel.curves[row]], axis=-1), colour, 4.0)
        if place == 0:
            y = top - (0.09 + 0.12 * row) * height
            drawing.line([(left + 0.04 * width, y), (left + 0.13 * width, y)], colour, 4.0)
            drawing.text((left + 0.29 * width, y), judgements[row].label)
    drawing.log(stream, figure)
