"""One action's outcomes one after the other, along a timeline of their own: the story.

Nobody moves during the opening; then every outcome plays from its beginning to its end in the same
short time and leaves its path behind; in the end everybody is back where they started.
"""

from typing import TypeVar

import numpy as np
import rerun as rr
from numpy.typing import NDArray

from scenes import Rollouts
from scenes.scene import PEDESTRIAN_RADIUS, ROBOT_RADIUS
from studio.arrays import FloatArray, IntArray
from studio.comparison.comparison import CLOSING, MOVING, OPENING, seconds_each
from studio.comparison.recording import entities
from studio.scene.measures import touched_by
from studio.scene.recording.moving import (
    CONTACT_CLASS,
    arrowheads,
    crosses,
    log_over_time,
    log_people,
    path_corners,
    rounded,
)
from studio.style.palette import Theme, blend

Number = TypeVar("Number", bound=np.generic)

POSES = 20  # of an outcome that are shown after its first; more would pass too fast to see


def log_story(stream: rr.RecordingStream, rollouts: Rollouts, side: int, theme: Theme) -> None:
    """Show the outcomes of one action one after the other."""
    log_moving_robot(stream, rollouts, side, theme)
    if rollouts.scene.pedestrians:
        log_moving_people(stream, rollouts, side, theme)
    log_gathering_paths(stream, rollouts, side, theme)


def log_moving_robot(
    stream: rr.RecordingStream, rollouts: Rollouts, side: int, theme: Theme
) -> None:
    """Show the robot with an arrowhead, and the way that it has come in this outcome."""
    name, robot = rollouts.names[side], rollouts.scene.robot
    path, steps, when = entities.story(name), shown_steps(rollouts), [moments(rollouts)]
    rest = np.array([*robot.start, robot.start_heading])
    poses = with_rest(rollouts.robot[side][:, steps].reshape(-1, 3), rest)
    touched = touched_by(rollouts.contact_step[side][:, None], steps)  # (K, poses)
    classes = np.where(with_rest(touched.ravel(), np.array(False)), CONTACT_CLASS, side + 1)
    points = rr.Points2D.columns(positions=rounded(poses[:, :2]), class_ids=classes)
    look = rr.Points2D.from_fields(radii=ROBOT_RADIUS, draw_order=30.0)
    log_over_time(stream, f"{path}/robot", when, [look], points)
    line = rr.LineStrips2D.from_fields(
        colors=theme.panel, radii=0.11 * ROBOT_RADIUS, draw_order=40.0
    )
    arrows = rr.LineStrips2D.columns(strips=list(arrowheads(poses)))
    log_over_time(stream, f"{path}/heading", when, [line], arrows)
    ways = [way[steps[: last + 1]] for way in rollouts.robot[side] for last in range(len(steps))]
    nowhere = rest[None]
    # a line takes two points
    strips = [
        rounded(way[:, :2] if len(way) > 1 else way[:, :2].repeat(2, axis=0))
        for way in (nowhere, *ways, nowhere, nowhere)
    ]
    colour, pen = theme.action_colour(name), rr.Radius.ui_points(1.6)
    line = rr.LineStrips2D.from_fields(colors=colour, radii=pen, draw_order=25.0)
    log_over_time(stream, f"{path}/way", when, [line], rr.LineStrips2D.columns(strips=strips))


def log_moving_people(
    stream: rr.RecordingStream, rollouts: Rollouts, side: int, theme: Theme
) -> None:
    """Show the people, and bars that join those of a group."""
    people = rollouts.pedestrians[side][:, shown_steps(rollouts)]  # (K, poses, P, 2)
    places = with_rest(people.reshape(-1, *people.shape[2:]), rollouts.scene.starts)
    grey, radius = theme.pedestrian, PEDESTRIAN_RADIUS
    look = rr.Points2D.from_fields(radii=radius, colors=grey, draw_order=10.0)
    path, when = f"{entities.story(rollouts.names[side])}/pedestrians", [moments(rollouts)]
    log_people(stream, path, when, places, rollouts.scene.groups, look, theme)


def log_gathering_paths(
    stream: rr.RecordingStream, rollouts: Rollouts, side: int, theme: Theme
) -> None:
    """Leave the path of each outcome behind when it ends, with a red cross if there was contact."""
    name, corners = rollouts.names[side], path_corners(rollouts)
    robot, touched = rounded(rollouts.robot[side, ..., :2]), rollouts.touched[side]
    faint = blend(theme.action_colour(name), theme.panel, 0.45)
    strips, colours, lengths = [], [], []
    for way, step, contact in zip(robot, rollouts.contact_step[side], touched, strict=True):
        marks = crosses(way[step][None], 0.06) if contact else ()
        strips += [way[corners], *marks]
        colours += [faint, *[theme.contact] * len(marks)]
        lengths.append(1 + len(marks))
    look = rr.LineStrips2D.from_fields(radii=rr.Radius.ui_points(0.8))
    lines = rr.LineStrips2D.columns(strips=strips, colors=colours).partition(lengths)
    when = [story_times(ends(len(robot)))]
    log_over_time(stream, f"{entities.story(name)}/paths", when, [look], lines)


def shown_steps(rollouts: Rollouts) -> IntArray:
    """The steps of an outcome that are shown: all, or evenly spaced ones where there are many."""
    last = rollouts.steps
    return np.unique(np.rint(np.linspace(0, last, min(last, POSES) + 1)).astype(np.int64))


def moments(rollouts: Rollouts) -> rr.TimeColumn:
    """When anybody moves: at the start, at each shown step of each outcome, and twice at the end.

    The second time nothing happens any more; it keeps the end in view for a while.
    """
    count, last = rollouts.count, rollouts.steps
    each = seconds_each(count)
    shares = MOVING * shown_steps(rollouts) / last
    playing = OPENING + each * (np.arange(count)[:, None] + shares)
    over = OPENING + each * count
    times = np.concatenate([[0.0], playing.ravel(), [over, over + CLOSING]])
    return story_times(times)


def ends(count: int) -> FloatArray:
    """When each of K outcomes comes to its end, [K], s of the story."""
    places = np.arange(count, dtype=np.float64)
    times: FloatArray = OPENING + seconds_each(count) * (places + MOVING)
    return times


def story_times(seconds: FloatArray) -> rr.TimeColumn:
    """Times of the story, to the microsecond: readers stumble over finer ones."""
    return rr.TimeColumn(entities.STORY, duration=np.rint(1e6 * seconds).astype("timedelta64[us]"))


def with_rest(rows: NDArray[Number], rest: NDArray[Number]) -> NDArray[Number]:
    """A row for each of the `moments`: one of rest, those of all shown steps, and two of rest."""
    return np.concatenate([rest[None], rows, rest[None], rest[None]])
