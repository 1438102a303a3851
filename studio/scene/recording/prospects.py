"""The prospects in a recording: what every outcome is worth, and how much it counts to whom.

The figure lies on a page whose unit is the width of a panel; there is a panel an action.
"""

import numpy as np
import rerun as rr

from learners import decision_weights
from scenes import Rollouts
from studio.arrays import Bounds, FloatArray
from studio.recorder.axes import Scale, line_colour, linear
from studio.recorder.drawing import PAGE_RESOLUTION, Drawing
from studio.scene.judgements import Judgement, utilities
from studio.scene.recording import entities
from studio.scene.recording.moving import rounded
from studio.style.palette import Theme
from studio.style.ticks import round_ticks
from studio.style.words import number, short_label

# lengths on the page
PROSPECTS_PITCH = 1.3  # from the left of a panel to that of the next
WEIGHT_HEIGHT = 0.85  # of the lower part of a panel
UTILITY_BOTTOM, UTILITY_HEIGHT = 1.15, 1.4  # of its upper part
UTILITY_TOP = UTILITY_BOTTOM + UTILITY_HEIGHT
TITLE_BOTTOM = UTILITY_TOP + 0.27
MARK_LEFT, MARK_WIDTH = 1.04, 0.05  # of the first of the marks at the right of a panel
TICKS_MIDDLE, WORDS_MIDDLE = -0.28, -0.42  # of the numbers at the left, and of what they are

LONGEST_TITLE = 14  # characters; with a longer one, titles stand on two levels and do not touch


def log_prospects(
    stream: rr.RecordingStream, rollouts: Rollouts, judgements: tuple[Judgement, ...], theme: Theme
) -> None:
    """Draw a panel an action: its outcomes from the worst to the best, and what each counts.

    Above, a dot is the utility of an outcome; marks at the right of the panel are the certainty
    equivalents of the prospect. Below, a line a teacher is the decision weight of each outcome in
    multiples of its probability 1/K.
    """
    ranked = np.sort(utilities(rollouts), axis=-1)  # (A, K), worst first
    names, count = rollouts.names, rollouts.count
    weights = [decision_weights(ranked, each.parameters) * count for each in judgements]
    worths = [each.certainty_equivalents for each in judgements]
    everything = np.concatenate([ranked.ravel(), *worths])
    utility_scale = linear(round_ticks(float(everything.min()), float(everything.max())))
    weight_scale = linear(round_ticks(0.0, float(max(1.0, np.max(weights)))))
    drawing = Drawing(lift=0.09, resolution=PAGE_RESOLUTION)
    draw_levels(drawing, len(names), utility_scale, UTILITY_BOTTOM, UTILITY_HEIGHT)
    draw_levels(drawing, len(names), weight_scale, 0.0, WEIGHT_HEIGHT)
    raised, colours = second_level(names), [each.colour for each in judgements]
    for index, name in enumerate(names):
        left = index * PROSPECTS_PITCH
        drawing.text((left + 0.5, TITLE_BOTTOM + raised * (index % 2)), short_label(name))
        # the lowest line last: it would vanish in the peaks of the others
        for column in sorted(range(len(judgements)), key=lambda column: -weights[column].max()):
            heights = WEIGHT_HEIGHT * weight_scale(weights[column][index])
            drawing.line(stairs(left, heights), colours[column], 2.0)
        for column, worth in enumerate(worths):
            mark = left + MARK_LEFT + column * MARK_WIDTH
            level = UTILITY_BOTTOM + UTILITY_HEIGHT * float(utility_scale(worth[index]))
            drawing.line([(mark, level), (mark + 0.8 * MARK_WIDTH, level)], colours[column], 5.0)
    draw_words(drawing, judgements, TITLE_BOTTOM + raised, len(names) * PROSPECTS_PITCH)
    drawing.log(stream, entities.PROSPECTS)
    x = PROSPECTS_PITCH * np.arange(len(names))[:, None] + (np.arange(count) + 0.5) / count
    y = UTILITY_BOTTOM + UTILITY_HEIGHT * utility_scale(ranked)
    stream.log(
        entities.RANKED_OUTCOMES,
        rr.Points2D(
            rounded(np.stack([x, y], axis=-1), PAGE_RESOLUTION).reshape(-1, 2),
            colors=np.repeat([theme.action_colour(name) for name in names], count, axis=0),
            radii=rr.Radius.ui_points(2.0),
        ),
        static=True,
    )


def draw_levels(drawing: Drawing, actions: int, scale: Scale, bottom: float, height: float) -> None:
    """Draw a line at each tick of a scale through all panels; write 0 and the ends at the left."""
    for tick in scale.ticks:
        y = bottom + height * float(scale(tick))
        if tick in (0.0, scale.ticks[0], scale.ticks[-1]):
            drawing.text((TICKS_MIDDLE, y), number(tick))
        for left in PROSPECTS_PITCH * np.arange(actions):
            drawing.line([(left, y), (left + 1.0, y)], line_colour(tick), 1.0)


def stairs(left: float, heights: FloatArray) -> FloatArray:
    """A line of one level step for each of K heights, side by side in a panel, [2K, 2]."""
    edges = left + np.linspace(0.0, 1.0, len(heights) + 1)
    return np.stack([np.repeat(edges, 2)[1:-1], np.repeat(heights, 2)], axis=-1)


def draw_words(
    drawing: Drawing, judgements: tuple[Judgement, ...], top: float, right: float
) -> None:
    """Say what the levels are, how outcomes are ordered, and whose lines and marks are whose.

    The highest titles are at the top; right of the panels the colours of the teachers stand.
    """
    drawing.text((WORDS_MIDDLE, top), "utility")
    # the viewer hangs words from their first line
    drawing.text((WORDS_MIDDLE, WEIGHT_HEIGHT / 2.0 + 0.08), "weight ÷\nprobability")
    drawing.text((0.5, -0.24), "worst → best")
    for row, judgement in enumerate(judgements):
        y = UTILITY_TOP - 0.32 * row
        drawing.line([(right, y), (right + 0.15, y)], judgement.colour, 4.0)
        drawing.text((right + 0.52, y), judgement.label)


def second_level(names: tuple[str, ...]) -> float:
    """How much higher every other title is."""
    return 0.3 if max(len(short_label(name)) for name in names) > LONGEST_TITLE else 0.0


def prospects_bounds(names: tuple[str, ...]) -> Bounds:
    """What a view of the figure of prospects of these actions must show."""
    return (
        WORDS_MIDDLE - 0.46,
        -0.4,
        len(names) * PROSPECTS_PITCH + 0.95,
        TITLE_BOTTOM + second_level(names) + 0.15,
    )
