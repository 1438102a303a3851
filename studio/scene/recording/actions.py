"""The world under each action in a recording: K robots and the people among whom each drives.

The robot and the people of the first rollout are drawn in true size, those of the others as dots.
"""

import numpy as np
import rerun as rr

from scenes import Rollouts
from scenes.scene import PEDESTRIAN_RADIUS, ROBOT_RADIUS
from studio.scene.measures import first_contacts, touched_by
from studio.scene.recording import entities
from studio.scene.recording.moving import (
    CONTACT_CLASS,
    arrowheads,
    crosses,
    log_over_time,
    log_people,
    path_corners,
    rounded,
    strips,
    time_columns,
)
from studio.style.palette import Theme, blend

HEADING_RESOLUTION = 1.0 / 64.0  # headings are rounded to this, about 0.9°, rad
ROBOT_DOT_RADIUS, PERSON_DOT_RADIUS = 0.05, 0.045  # in every rollout but the first, m
ARROWHEAD_THICKNESS = 0.07  # of its strokes, m


def log_action(stream: rr.RecordingStream, rollouts: Rollouts, index: int, theme: Theme) -> None:
    """Show the K robots and their pedestrians under one action, over time."""
    log_robots(stream, rollouts, index, theme)
    if rollouts.scene.pedestrians:
        log_pedestrians(stream, rollouts, index, theme)
    log_paths(stream, rollouts, index, theme)


def log_robots(stream: rr.RecordingStream, rollouts: Rollouts, index: int, theme: Theme) -> None:
    """Show the K robots under one action: the first with a body that shows where it faces.

    The arrowhead is a component of the robots, because an entity of its own would cost twice as
    much.
    """
    robot = rounded(rollouts.robot[index, ..., :2]).swapaxes(0, 1)  # (T+1, K, 2)
    heading = rounded(rollouts.robot[index, ..., 2], HEADING_RESOLUTION).swapaxes(0, 1)  # (T+1, K)
    times, count = heading.shape
    in_full = np.arange(count) == 0  # one rollout with bodies, the others as dots
    radii = np.where(in_full, ROBOT_RADIUS, ROBOT_DOT_RADIUS)
    order = 30.0 + index  # a robot hides the arrowheads of those that it lies on
    look = [
        rr.Points2D.from_fields(radii=radii, draw_order=order),
        rr.LineStrips2D.from_fields(
            colors=theme.panel, radii=ARROWHEAD_THICKNESS / 2.0, draw_order=order + 0.5
        ),
    ]
    touched = touched_by(rollouts.contact_step[index], np.arange(times)[:, None])
    classes = np.where(touched, CONTACT_CLASS, index + 1).ravel()
    points = rr.Points2D.columns(positions=robot.reshape(-1, 2), class_ids=classes)
    headings = rr.AnyValues.columns(heading=heading.astype(np.float32).ravel())
    arrows = rr.LineStrips2D.columns(strips=strips(rounded(arrowheads(rollouts.robot[index, 0]))))
    rows = [count] * times
    columns = [*points.partition(rows), *headings.partition(rows), *arrows]
    path = entities.robots(rollouts.names[index])
    log_over_time(stream, path, time_columns(rollouts), look, columns)


def log_pedestrians(
    stream: rr.RecordingStream, rollouts: Rollouts, index: int, theme: Theme
) -> None:
    """Show the K times P people under one action, with bars that join the groups of the first P."""
    people = rollouts.pedestrians[index].swapaxes(0, 1)  # (T+1, K, P, 2)
    times, count, person_count, _ = people.shape
    in_full = np.repeat(np.arange(count) == 0, person_count)
    faint = blend(theme.pedestrian, theme.panel, 0.5)
    look = rr.Points2D.from_fields(
        radii=np.where(in_full, PEDESTRIAN_RADIUS, PERSON_DOT_RADIUS),
        colors=np.where(in_full[:, None], theme.pedestrian, faint),
        draw_order=10.0,  # below paths and contacts
    )
    path, when = entities.pedestrians(rollouts.names[index]), time_columns(rollouts)
    places, groups = people.reshape(times, -1, 2), rollouts.scene.groups
    log_people(stream, path, when, places, groups, look, theme)


def log_paths(stream: rr.RecordingStream, rollouts: Rollouts, index: int, theme: Theme) -> None:
    """Draw the paths of the K robots, with a red cross where one first touched something.

    The path of the robot that is drawn in full lies over the others once more, bold.
    """
    robot, corners = rounded(rollouts.robot[index, ..., :2]), path_corners(rollouts)
    marks = crosses(rounded(first_contacts(rollouts, index)[:, :2]), 0.05)
    colour = theme.action_colour(rollouts.names[index])
    faint = blend(colour, theme.panel, 0.45)
    stream.log(
        entities.paths(rollouts.names[index]),
        rr.LineStrips2D(
            [*robot[:, corners], robot[0, corners], *marks],
            colors=[faint] * len(robot) + [colour] + [theme.contact] * len(marks),
            radii=rr.Radius.ui_points([0.7] * len(robot) + [1.5] + [0.7] * len(marks)),
        ),
        static=True,
    )


def log_without_robot(stream: rr.RecordingStream, rollouts: Rollouts, theme: Theme) -> None:
    """Keep the K times P walks of the people had the robot not been there, one line a walk."""
    walks = rounded(rollouts.without_robot).swapaxes(1, 2)  # (K, P, T+1, 2)
    stream.log(
        entities.WITHOUT_ROBOT,
        rr.LineStrips2D(
            list(walks.reshape(-1, *walks.shape[2:])),
            colors=blend(theme.pedestrian, theme.panel, 0.25),
            radii=rr.Radius.ui_points(0.5),
            draw_order=-5.0,
        ),
        static=True,
    )
