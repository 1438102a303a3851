"""One action's outcomes one after the other, along a timeline of their own: the story.

Every outcome plays from its beginning to its end, as in the film, and leaves its path and its dots
behind.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

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
    """N points [N, 2] or lines [N, corners, 2] of outcomes that touched things of these kinds [N].

    They appear when so many outcomes have ended, [N], and tell what these were.
    """

    shapes: FloatArray
    kinds: IntArray
    arrivals: IntArray
    told: Sequence[str]


@dataclass(frozen=True)
class Story:
    """The outcomes of the action on one side, as a recording shows them along the story."""

    stream: rr.RecordingStream
    rollouts: Rollouts
    side: int
    theme: Theme

    def log_world(self) -> None:
        """Show the outcomes one after the other, and the paths that they leave."""
        sample, side, name = self.rollouts.with_paths(), self.side, self.rollouts.names[self.side]
        told, path, moments = outcomes_told(sample, side), entities.story(name), moments_of(sample)
        colour, classes = self.theme.action_colour(name), class_over_time(sample, side)
        log_looks(self.stream, path, colour, self.theme)
        log_robot(self.stream, f"{path}/robot", moments, sample, side, classes, told)
        if sample.scene.pedestrians:
            log_people(self.stream, f"{path}/people", moments, sample.pedestrians[side], told)
        arrivals, robot = ended_after(self.rollouts)[1:], rounded(sample.robot[side, ..., :2])
        faint, pen = blend(colour, self.theme.panel, 0.45), rr.Radius.ui_points(PATH)
        kinds, corners = contact_kinds(sample)[side], path_corners(sample, WAY_STRIDE)
        look = rr.LineStrips2D.from_fields(colors=faint, radii=pen)
        self._gather(f"{path}/paths", look, Marks(robot[:, corners], kinds, arrivals, told))
        places = robot[np.arange(sample.count), np.maximum(sample.contact_step[side], 0)]
        self._gather_contacts(path, Marks(places, kinds, arrivals, told), MARK_REACH)

    def log_dots(self) -> None:
        """Draw the axes, let icons and dots gather, and say what has come so far."""
        rollouts, side, name = self.rollouts, self.side, self.rollouts.names[self.side]
        path, told = entities.dots(name), outcomes_told(rollouts, side)
        pixels, parts = paint_dots(rollouts, side, self.theme)
        log_figure(self.stream, path, pixels)
        for part in parts:
            dots, at = part.dots, f"{path}/{part.name}"
            words = dots_told_by(dots.arrivals, told)
            marks = Marks(part.places, dots.kinds, dots.arrivals, words)
            # half of it, since the figure is drawn at twice the size
            pen, colour = rr.Radius.ui_points(part.radius / 2), self.theme.action_colour(name)
            look = rr.Points2D.from_fields(colors=colour, radii=pen)
            self._gather(at, look, marks, dots.kinds == NOTHING)
            self._gather_contacts(at, marks, 0.9 * part.radius)
        said, table = playing_told(rollouts, side), Timetable.of(rollouts.paths, rollouts.horizon)
        times = np.append(0.0, np.stack([table.starts, table.ends], axis=-1).ravel())
        pages = rr.TextDocument.columns(text=said, media_type=[rr.MediaType.MARKDOWN] * len(said))
        self.stream.send_columns(f"{path}/so_far", [story_times(times)], pages)

    def _gather_contacts(self, path: str, points: Marks, reach: float) -> None:
        """Let an × appear at points where a person was touched, a square where a wall alone was."""
        shapes = np.where(points.kinds[:, None, None] == PERSON, CROSS, SQUARE)
        marks = replace(points, shapes=points.shapes[:, None] + reach * shapes)
        red, pen = self.theme.contact, rr.Radius.ui_points(CONTACT)
        look = rr.LineStrips2D.from_fields(colors=red, radii=pen, draw_order=45.0)
        self._gather(f"{path}/contacts", look, marks, points.kinds != NOTHING)

    def _gather(
        self, path: str, look: rr.AsComponents, marks: Marks, among: BoolArray | None = None
    ) -> None:
        """Let marks appear, or some `among` them [N]; how they look, what they tell is static."""
        rollouts, order = self.rollouts, np.argsort(marks.arrivals, kind="stable")
        order = order if among is None else order[among[order]]
        if not len(order):
            return
        # a single text would not be shown
        told = [marks.told[place] for place in order.tolist()] * (2 if len(order) == 1 else 1)
        counts = np.searchsorted(marks.arrivals[order], ended_after(rollouts), side="right")
        rows = np.concatenate([marks.shapes[order[:count]] for count in counts])
        points, lines = rr.Points2D.columns, rr.LineStrips2D.columns
        columns = points(positions=rows) if rows.ndim == 2 else lines(strips=list(rows))
        when = story_times(np.append(0.0, Timetable.of(rollouts.paths, rollouts.horizon).ends))
        self.stream.log(path, look, rr.AnyValues(told=told), static=True)
        self.stream.send_columns(path, [when], columns.partition(counts))


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
