"""One action's outcomes one after the other, along a timeline of their own: the story.

Every outcome plays from its beginning to its end, as in the film, and leaves its path and its dots
behind.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import rerun as rr

from scenes import Rollouts
from studio.arrays import BoolArray, FloatArray, IntArray
from studio.comparison.comparison import CLOSING, Timetable, ended_after
from studio.comparison.picture.figure import paint_dots
from studio.comparison.recording import entities
from studio.comparison.words import dots_told_by, outcomes_told, playing_told
from studio.recorder.figures import log_figure
from studio.scene.measures import NOTHING, PERSON, contact_kinds
from studio.scene.recording.actions import MARK_REACH, class_over_time
from studio.scene.recording.moving import CROSS, SQUARE, path_corners, rounded
from studio.scene.recording.shown import WAY_STRIDE, Moments, log_looks, log_people, log_robot
from studio.style.palette import Theme, blend

POSES = 20  # of an outcome that are shown after its first; more would pass too fast to see
PATH, CONTACT = 0.8, 1.2  # half the widths of paths and of marks of contact, px


@dataclass(frozen=True)
class Marks:
    """N points [N, 2] or lines [N, corners, 2] that appear when so many outcomes have ended [N]."""

    shapes: FloatArray
    arrivals: IntArray
    told: Sequence[str]

    def log(
        self,
        stream: rr.RecordingStream,
        path: str,
        look: rr.AsComponents,
        rollouts: Rollouts,
        among: BoolArray | None = None,
    ) -> None:
        """Let them appear, or some `among` them [N]; how they look and what they tell is static."""
        order = np.argsort(self.arrivals, kind="stable")
        order = order if among is None else order[among[order]]
        if not len(order):
            return
        # a single text would not be shown
        told = [self.told[place] for place in order.tolist()] * (2 if len(order) == 1 else 1)
        counts = np.searchsorted(self.arrivals[order], ended_after(rollouts), side="right")
        rows = np.concatenate([self.shapes[order[:count]] for count in counts])
        points, lines = rr.Points2D.columns, rr.LineStrips2D.columns
        columns = points(positions=rows) if rows.ndim == 2 else lines(strips=list(rows))
        when = story_times(np.append(0.0, Timetable.of(rollouts.paths, rollouts.horizon).ends))
        stream.log(path, look, rr.AnyValues(told=told), static=True)
        stream.send_columns(path, [when], columns.partition(counts))


def log_contact_marks(
    stream: rr.RecordingStream,
    path: str,
    points: Marks,
    kinds: IntArray,
    reach: float,
    rollouts: Rollouts,
    theme: Theme,
) -> None:
    """Let contacts appear at points, which are of kinds [N]: × a person, a square a wall."""
    shapes = np.where(kinds[:, None, None] == PERSON, CROSS, SQUARE)
    marks = Marks(points.shapes[:, None] + reach * shapes, points.arrivals, points.told)
    pen = rr.Radius.ui_points(CONTACT)
    look = rr.LineStrips2D.from_fields(colors=theme.contact, radii=pen, draw_order=45.0)
    marks.log(stream, f"{path}/contacts", look, rollouts, kinds != NOTHING)


def log_story(stream: rr.RecordingStream, rollouts: Rollouts, side: int, theme: Theme) -> None:
    """Show the outcomes of one action one after the other, and the paths that they leave."""
    sample, name = rollouts.with_paths(), rollouts.names[side]
    told, path, colour = (
        outcomes_told(sample, side),
        entities.story(name),
        theme.action_colour(name),
    )
    moments, classes = moments_of(sample), class_over_time(sample, side)
    log_looks(stream, path, colour, theme)
    log_robot(stream, f"{path}/robot", moments, sample, side, classes, told)
    if sample.scene.pedestrians:
        log_people(stream, f"{path}/people", moments, sample.pedestrians[side], told)
    arrivals, robot = ended_after(rollouts)[1:], rounded(sample.robot[side, ..., :2])
    look = rr.LineStrips2D.from_fields(
        colors=blend(colour, theme.panel, 0.45), radii=rr.Radius.ui_points(PATH)
    )
    ways = Marks(robot[:, path_corners(sample, WAY_STRIDE)], arrivals, told)
    ways.log(stream, f"{path}/paths", look, rollouts)
    places = robot[np.arange(sample.count), np.maximum(sample.contact_step[side], 0)]
    kinds = contact_kinds(sample)[side]
    points = Marks(places, arrivals, told)
    log_contact_marks(stream, path, points, kinds, MARK_REACH, rollouts, theme)


def log_figure_of_dots(
    stream: rr.RecordingStream, rollouts: Rollouts, side: int, theme: Theme
) -> None:
    """Draw the axes of one side, let its icons and dots gather, and say what has come so far."""
    path, colour = entities.dots(rollouts.names[side]), theme.action_colour(rollouts.names[side])
    pixels, parts = paint_dots(rollouts, side, theme)
    log_figure(stream, path, pixels)
    for number, part in enumerate(parts):
        dots, at = part.dots, f"{path}/{number}"
        told = dots_told_by(dots.arrivals, outcomes_told(rollouts, side))
        marks = Marks(part.places, dots.arrivals, told)
        # half of it, since the figure is drawn at twice the size
        look = rr.Points2D.from_fields(colors=colour, radii=rr.Radius.ui_points(part.radius / 2))
        marks.log(stream, at, look, rollouts, dots.kinds == NOTHING)
        log_contact_marks(stream, at, marks, dots.kinds, 0.9 * part.radius, rollouts, theme)
    said, table = playing_told(rollouts, side), Timetable.of(rollouts.paths, rollouts.horizon)
    times = np.append(0.0, np.stack([table.starts, table.ends], axis=-1).ravel())
    pages = rr.TextDocument.columns(text=said, media_type=[rr.MediaType.MARKDOWN] * len(said))
    stream.send_columns(f"{path}/so_far", [story_times(times)], pages)


def moments_of(rollouts: Rollouts) -> Moments:
    """What is shown when: every outcome at some of its steps, then the end for a while."""
    last, count = rollouts.steps, rollouts.count
    table = Timetable.of(count, rollouts.horizon)
    steps = np.unique(np.rint(np.linspace(0, last, min(last, POSES) + 1)).astype(np.int64))
    times = table.starts[:, None] + table.moving[:, None] * steps / last  # (M, poses)
    when = story_times(np.concatenate([[0.0], times.ravel(), [table.over + CLOSING]]))
    which = np.repeat(np.arange(count), len(steps))
    # nobody moves before the first outcome nor after the last
    return Moments([when], np.pad(which, 1, "edge"), np.pad(np.tile(steps, count), 1, "edge"))


def story_times(seconds: FloatArray) -> rr.TimeColumn:
    """Times of the story, to the microsecond: readers stumble over finer ones."""
    return rr.TimeColumn(entities.STORY, duration=np.rint(1e6 * seconds).astype("timedelta64[us]"))
