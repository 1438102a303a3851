"""The one rollout under each action that a recording shows in true size.

Along `sim_time` it is the first one. Along `rollout` it is each in turn, at its most telling
moment: that of the first contact, or else of the smallest gap.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import rerun as rr

from scenes import Rollouts
from scenes.scene import PEDESTRIAN_RADIUS, ROBOT_RADIUS
from studio.arrays import FloatArray, IntArray
from studio.scene.recording import entities
from studio.scene.recording.moving import (
    arrowheads,
    clear_rollouts_from,
    path_corners,
    people_told,
    rounded,
    time_columns,
    told_by_row,
    turn_column,
)
from studio.style.palette import Colour, Theme

RIM = 2.0  # width of all lines, px
WAY_STRIDE = 8  # its path is drawn through every eighth step: within 2 cm of the truth


@dataclass(frozen=True)
class Moments:
    """What is shown along some timelines: N moments, each of one rollout."""

    times: Sequence[rr.TimeColumn]  # of length N each
    which: IntArray  # [N], the rollout
    steps: IntArray  # [N], its step


def log_shown(
    stream: rr.RecordingStream,
    rollouts: Rollouts,
    index: int,
    classes: IntArray,
    gap: FloatArray,
    told: Sequence[str],
    theme: Theme,
) -> None:
    """Draw one rollout in true size: the robot with its arrowhead and path, and the people.

    Args:
        stream: the recording.
        rollouts: what was simulated.
        index: of the action.
        classes: of the robot at each step, [M, T+1].
        gap: from the robot to the nearest person at each step, [M, T+1], m.
        told: what the marks of each of the M rollouts tell.
        theme: the colours.
    """
    path, count = entities.shown(rollouts.names[index]), rollouts.paths
    along, every = np.arange(rollouts.steps + 1), np.arange(count)
    first = rollouts.contact_step[index, :count]
    # among nobody the gap is infinite at all times, so the first moment is shown
    telling = np.where(first >= 0, first, gap.argmin(axis=1))
    in_turn = Moments([turn_column(rollouts)], every, telling)
    log_looks(stream, path, theme.action_colour(rollouts.names[index]), theme)
    for moments in (Moments(time_columns(rollouts), 0 * along, along), in_turn):
        log_robot(stream, f"{path}/robot", moments, rollouts, index, classes, told)
        if rollouts.scene.pedestrians:
            log_people(stream, f"{path}/people", moments, rollouts.pedestrians[index], told)
    if count < rollouts.count:
        clear_rollouts_from(stream, path, count)


def log_robot(
    stream: rr.RecordingStream,
    path: str,
    moments: Moments,
    rollouts: Rollouts,
    index: int,
    classes: IntArray,
    told: Sequence[str],
) -> None:
    """Show the robot at each moment with an arrowhead, and its whole path."""
    which, robot = moments.which, rollouts.robot[index]
    poses = robot[which, moments.steps]
    rims = rr.Ellipses2D.columns(
        # without these at each moment there would be a rim where there is no robot
        half_sizes=[(ROBOT_RADIUS, ROBOT_RADIUS)] * len(which),
        centers=rounded(poses[:, :2]),
        class_ids=classes[which, moments.steps],
    )
    ways = rounded(robot[:, path_corners(rollouts, WAY_STRIDE), :2])[which]
    drawn = [line for pair in zip(rounded(arrowheads(poses)), ways, strict=True) for line in pair]
    lines = rr.LineStrips2D.columns(strips=drawn).partition([2] * len(which))
    answers = told_by_row([[told[place]] for place in which])
    stream.send_columns(path, moments.times, [*rims, *lines, *answers])


def log_people(
    stream: rr.RecordingStream, path: str, moments: Moments, people: FloatArray, told: Sequence[str]
) -> None:
    """Show the people [M, T+1, P, 2] at each moment."""
    places = rounded(people[moments.which, moments.steps])  # (N, P, 2)
    count, person_count, _ = places.shape
    rims = rr.Ellipses2D.columns(
        half_sizes=[(PEDESTRIAN_RADIUS, PEDESTRIAN_RADIUS)] * (count * person_count),
        centers=places.reshape(-1, 2),
    )
    answers = told_by_row([people_told([told[place]], person_count) for place in moments.which])
    rows = [*rims.partition([person_count] * count), *answers]
    stream.send_columns(path, moments.times, rows)


def log_looks(stream: rr.RecordingStream, path: str, colour: Colour, theme: Theme) -> None:
    """Say how the rollout looks that is drawn in true size; the rim of the robot has its class."""
    pen = rr.Radius.ui_points(RIM / 2)
    robot = rr.Ellipses2D.from_fields(line_radii=pen, draw_order=41.0)
    lines = rr.LineStrips2D.from_fields(colors=colour, radii=pen, draw_order=40.0)
    people = rr.Ellipses2D.from_fields(colors=theme.pedestrian, line_radii=pen, draw_order=21.0)
    stream.log(f"{path}/robot", robot, lines, static=True)
    stream.log(f"{path}/people", people, static=True)
