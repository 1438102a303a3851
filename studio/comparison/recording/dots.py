"""One action's outcomes as dots that gather along the story: contacts, progress, gaps.

They lie on a page whose unit is its width; both sides have the same axes.
"""

from collections import defaultdict

import numpy as np
import rerun as rr

from scenes import Rollouts
from studio.arrays import BoolArray, Bounds, FloatArray
from studio.comparison.comparison import OPENING, seconds_each
from studio.comparison.dots import DOT_RADIUS, DotScale, IconGrid, dot_measures
from studio.comparison.recording import entities
from studio.comparison.recording.story import ends, story_times
from studio.recorder.drawing import Drawing
from studio.scene.recording.moving import log_over_time
from studio.style.palette import Theme, blend
from studio.style.ticks import ticks
from studio.style.words import contacts_told, number

BOUNDS: Bounds = (-0.02, -0.12, 1.02, 0.34)
"""What a view of the page must show."""

# lengths on the page
ICONS_TOP, ICONS_WIDTH, ICONS_HEIGHT = 0.32, 0.72, 0.06  # of the room for the array of icons
DOTS_HEIGHT = 0.21  # of the dot plots
PLOT_GAP = 0.08  # between two dot plots
ICON_PITCH, DOT_PITCH = 0.03, 0.02  # from one icon or dot to the next at most
COUNT_WIDTH = 0.22  # of the words right of the icons, about
PLAYING_HEIGHT, COUNT_HEIGHT = 0.33, 0.29  # where these say what plays, and count contacts


def log_dots(stream: rr.RecordingStream, rollouts: Rollouts, side: int, theme: Theme) -> None:
    """Draw the axes of one side, and let its dots gather."""
    path = entities.dots(rollouts.names[side])
    colour = theme.action_colour(rollouts.names[side])
    contact = rollouts.touched[side]
    grid = IconGrid.fit(ICONS_WIDTH, ICONS_HEIGHT, len(contact), ICON_PITCH)
    icons = np.array([0.0, ICONS_TOP]) + grid.places() * (1.0, -1.0)
    radius = DOT_RADIUS * grid.pitch
    stream.log(f"{path}/waiting", rr.Points2D(icons, colors=theme.grid, radii=radius), static=True)
    # contacts from the left, the others from the right
    ranks = np.where(contact, contact.cumsum() - 1, len(contact) - (~contact).cumsum())
    pale = blend(colour, theme.panel, 0.5)
    shades = np.where(contact[:, None], theme.contact, pale)
    places, colours, radii = [icons[ranks]], [shades], [radius]
    lowest = []

    axes, shown = Drawing(lift=0.02), dot_measures(rollouts)
    width = (1.0 - PLOT_GAP * (len(shown) - 1)) / len(shown)
    scales = DotScale.fit_all(shown, width, DOTS_HEIGHT, DOT_PITCH)
    for column, (measure, scale) in enumerate(zip(shown, scales, strict=True)):
        left = column * (width + PLOT_GAP)
        for start, end in measure.lines():
            ends_of_line = [(left + start * width, 0.0), (left + end * width, 0.0)]
            axes.line(ends_of_line, theme.faint, 1.0)
        for tick in ticks(measure.low, measure.high, 5):
            axes.text((left + measure.at(tick) * width, -0.035), number(tick))
        axes.text((left + width / 2, -0.085), measure.names[0])
        highest, covering = piled_up(scale, side, contact)
        places.append(np.array([left, 0.0]) + highest)
        lowest.append(np.array([left, 0.0]) + covering)
        # red at once where there is nothing to cover
        alone = contact & (highest == covering).all(axis=-1)
        colours.append(np.where(alone[:, None], theme.contact, colour))
        radii.append(DOT_RADIUS * scale.pitch)
    axes.log(stream, path)
    count, when = len(contact), [story_times(ends(len(contact)))]
    dots = rr.Points2D.columns(
        positions=np.stack(places, axis=1).reshape(-1, 2),
        colors=np.stack(colours, axis=1).reshape(-1, 3).astype(np.uint8),
        radii=np.tile(radii, count),
    ).partition([len(places)] * count)
    look = rr.Points2D.from_fields(draw_order=40.0)
    log_over_time(stream, f"{path}/outcomes", when, [look], dots)
    covers = np.stack(lowest, axis=1)[contact].reshape(-1, 2)
    red = rr.Points2D.columns(positions=covers).partition(np.where(contact, len(lowest), 0))
    look = rr.Points2D.from_fields(colors=theme.contact, radii=radii[-1], draw_order=50.0)
    log_over_time(stream, f"{path}/contacts", when, [look], red)
    log_count(stream, f"{path}/count", contact, grid.width, theme)


def log_count(
    stream: rr.RecordingStream, path: str, contact: BoolArray, left: float, theme: Theme
) -> None:
    """Say right of the icons which outcome plays, and count those so far with contact."""
    count, middle = len(contact), left + COUNT_WIDTH / 2
    when, labels = [], []
    counted = contacts_told(0, 0, count)
    touched = contact.cumsum().tolist()
    for outcome, end in enumerate(ends(count).tolist()):
        playing = f"Outcome {outcome + 1} of {count}"
        when += [OPENING + outcome * seconds_each(count), end]
        labels.append([playing, counted])
        counted = contacts_told(touched[outcome], outcome + 1, count)
        labels.append([playing, counted])
    when.append(OPENING + count * seconds_each(count))
    labels.append(["", counted])
    look = rr.LineStrips2D.from_fields(radii=0.0, colors=theme.ink, show_labels=True)
    places = [[(middle, height)] * 2 for height in (PLAYING_HEIGHT, COUNT_HEIGHT)]
    words = rr.LineStrips2D.columns(
        strips=places * len(labels), labels=[words for both in labels for words in both]
    ).partition([2] * len(labels))
    log_over_time(stream, path, [story_times(np.array(when))], [look], words)


def piled_up(scale: DotScale, side: int, contact: BoolArray) -> tuple[FloatArray, FloatArray]:
    """Where dots appear when outcomes come one by one, so that contacts always lie below.

    A dot that is there stays there. So every outcome puts a dot on top of its stack, and an outcome
    with contact also covers the lowest dot that is not red yet: the dot on top stands in for it.

    Returns:
        The tops, [K, 2], and the lowest places that are not red, [K, 2].
    """
    landed: defaultdict[int, int] = defaultdict(int)
    red: defaultdict[int, int] = defaultdict(int)
    tops, lowest = [], []
    for index, touched in zip(scale.bins[side].tolist(), contact.tolist(), strict=True):
        tops.append(scale.middle(index, landed[index]))
        lowest.append(scale.middle(index, red[index]))
        landed[index] += 1
        red[index] += touched
    return np.array(tops), np.array(lowest)
