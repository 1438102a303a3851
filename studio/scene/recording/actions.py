"""The world under each action in a recording: robots and the people among whom each drives.

All rollouts whose paths are kept are there as dots that move along `sim_time`.
"""

from collections.abc import Sequence

import numpy as np
import pyarrow as pa
import rerun as rr

from scenes import Rollouts
from studio.arrays import FloatArray, IntArray
from studio.scene.measures import touched_by
from studio.scene.recording import entities
from studio.scene.recording.moving import (
    CONTACT_CLASS,
    CROSS,
    HEADING_RESOLUTION,
    SQUARE,
    group_bars,
    log_over_time,
    path_corners,
    people_told,
    rounded,
    strips,
    time_columns,
)
from studio.scene.recording.shown import log_shown
from studio.scene.words import rollouts_told
from studio.style.palette import Theme, blend

ROBOT_DOT, PERSON_DOT, BAR = 2.2, 1.3, 1.0  # radii of dots, half the width of bars, px
MARK_REACH = 0.06  # from the middle of a mark of contact to its sides, m


def log_action(
    stream: rr.RecordingStream, rollouts: Rollouts, index: int, gap: FloatArray, theme: Theme
) -> None:
    """Show the M rollouts under one action whose paths are kept.

    The gap [M, T+1] is that to the nearest person, m.
    """
    told = rollouts_told(rollouts, index)
    classes = class_over_time(rollouts, index)
    log_robots(stream, rollouts, index, classes, told)
    log_paths(stream, rollouts, index, told, theme)
    log_contacts(stream, rollouts, index, theme)
    if rollouts.scene.pedestrians:
        log_pedestrians(stream, rollouts, index, told, theme)
    log_shown(stream, rollouts, index, classes, gap, told, theme)


def class_over_time(rollouts: Rollouts, index: int) -> IntArray:
    """Class of each robot under one action, which says its colour, at each step, [M, T+1]."""
    first = rollouts.contact_step[index, : rollouts.paths, None]
    touched = touched_by(first, np.arange(rollouts.steps + 1))
    return np.where(touched, CONTACT_CLASS, index + 1)


def log_robots(
    stream: rr.RecordingStream,
    rollouts: Rollouts,
    index: int,
    classes: IntArray,
    told: Sequence[str],
) -> None:
    """Show all robots under one action as dots."""
    robot = rounded(rollouts.robot[index, ..., :2]).swapaxes(0, 1)  # (T+1, M, 2)
    heading = rounded(rollouts.robot[index, ..., 2], HEADING_RESOLUTION).T  # (T+1, M)
    points = rr.Points2D.columns(positions=robot.reshape(-1, 2), class_ids=classes.T.ravel())
    # one value a step, a list: of many values the viewer would show no other one
    lists = pa.FixedSizeListArray.from_arrays(heading.astype(np.float32).ravel(), rollouts.paths)
    headings = rr.AnyValues.columns(heading=lists)
    dots = rr.Points2D.from_fields(radii=rr.Radius.ui_points(ROBOT_DOT), draw_order=30.0)
    look: list[rr.AsComponents] = [dots, rr.AnyValues(told=told)]
    columns = [*points.partition([rollouts.paths] * len(heading)), *headings]
    path = entities.robots(rollouts.names[index])
    log_over_time(stream, path, time_columns(rollouts), look, columns)


def log_pedestrians(
    stream: rr.RecordingStream, rollouts: Rollouts, index: int, told: Sequence[str], theme: Theme
) -> None:
    """Show the people of all rollouts under one action as dots.

    Bars join the people of each group in the first rollout.
    """
    people = rounded(rollouts.pedestrians[index]).swapaxes(0, 1)  # (T+1, M, P, 2)
    times, count, person_count, _ = people.shape
    faint = blend(theme.pedestrian, theme.panel, 0.5)
    radius = rr.Radius.ui_points(PERSON_DOT)
    dots = rr.Points2D.from_fields(radii=radius, colors=faint, draw_order=10.0)
    look: list[rr.AsComponents] = [dots, rr.AnyValues(told=people_told(told, person_count))]
    points = rr.Points2D.columns(positions=people.reshape(-1, 2))
    columns = [*points.partition([count * person_count] * times)]
    if rollouts.scene.groups:
        bars = group_bars(people[:, 0], rollouts.scene.groups)  # (T+1, bars, 2, 2)
        lines = rr.LineStrips2D.columns(strips=strips(bars.reshape(-1, 2, 2)))
        columns += lines.partition([bars.shape[1]] * times)
        pen = rr.Radius.ui_points(BAR)
        look.append(rr.LineStrips2D.from_fields(colors=faint, radii=pen, draw_order=9.0))
    path = entities.pedestrians(rollouts.names[index])
    log_over_time(stream, path, time_columns(rollouts), look, columns)


def log_paths(
    stream: rr.RecordingStream, rollouts: Rollouts, index: int, told: Sequence[str], theme: Theme
) -> None:
    """Draw the paths of all robots under one action."""
    lines = rr.LineStrips2D(
        strips(rounded(rollouts.robot[index][:, path_corners(rollouts), :2])),
        colors=blend(theme.action_colour(rollouts.names[index]), theme.panel, 0.45),
        radii=rr.Radius.ui_points(0.7),
    )
    path = entities.paths(rollouts.names[index])
    stream.log(path, lines, rr.AnyValues(told=told), static=True)


def log_contacts(stream: rr.RecordingStream, rollouts: Rollouts, index: int, theme: Theme) -> None:
    """Mark where robots first touch a person, with an ×, and where a wall, with a square."""
    marks, told = [], []
    for steps, shape, thing in (
        (rollouts.person_step, CROSS, "person"),
        (rollouts.wall_step, SQUARE, "wall"),
    ):
        for place, step in enumerate(steps[index, : rollouts.paths].tolist()):
            if step >= 0:
                at = rounded(rollouts.robot[index, place, step, :2])
                marks.append(at + MARK_REACH * shape)
                told.append(
                    f"rollout {place} first touches a {thing} at {step * rollouts.dt:.1f} s"
                )
    if marks:
        lines = rr.LineStrips2D(
            marks, colors=theme.contact, radii=rr.Radius.ui_points(0.9), draw_order=25.0
        )
        answers = rr.AnyValues(told=told * 2 if len(told) == 1 else told)
        stream.log(entities.contacts(rollouts.names[index]), lines, answers, static=True)
