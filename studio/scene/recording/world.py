"""The world in a recording: walls, robots and people, seen from above."""

from typing import cast

import numpy as np
import rerun as rr
from numpy.typing import NDArray

from scenes import Rollouts
from scenes.scene import PEDESTRIAN_RADIUS, ROBOT_RADIUS
from studio.arrays import Bounds, FloatArray
from studio.recorder.drawing import Drawing, y_upwards
from studio.scene.groups import shortest_links
from studio.scene.recording import entities
from studio.scene.recording.label_places import (
    LABEL_HEIGHT,
    half_size,
    label_places,
    leader,
    metres_per_pixel,
)
from studio.style.palette import Theme, blend
from studio.style.words import short

RESOLUTION = 1.0 / 128.0
"""Positions are rounded to this, about 8 mm: they are at most 4 mm off.

Being a power of two it leaves the last bytes of each number empty and makes many numbers equal,
so that they pack into 0.6 of their size; rounded to 1 cm they would pack into 0.8.
"""

HEADING_RESOLUTION = 1.0 / 64.0
"""Headings are rounded to this, about 0.9°, rad."""

CONTACT_CLASS = 0
"""Class of a robot that has touched something; under the action with index a it is a + 1 before."""

DOT_RADIUS = 0.05
"""Radius of the dot that stands for the robot in every future but the first, m."""

PERSON_DOT_RADIUS = 0.045
"""Radius of the dot that stands for a person in every future but the first, m."""

ARROWHEAD = ROBOT_RADIUS * np.array([(-0.35, 0.5), (0.6, 0.0), (-0.35, -0.5)])
"""The arrowhead on the robot that is drawn in full, when it faces along x, [3, 2], m."""

ARROWHEAD_THICKNESS = 0.07
"""Of the strokes of the arrowhead, m."""

BAR_THICKNESS = 0.7 * PEDESTRIAN_RADIUS
"""Of the bars that join the people of a group, m."""

WALL_THICKNESS = 0.12
"""Of the drawn walls, m; the simulated ones are lines."""

PATH_STRIDE = 4
"""A path is drawn through every fourth step: its corners stay within a centimetre of the truth."""

MOST_PATHS_BESIDE_LABELS = 10
"""Names of actions are placed beside so many of the paths of each action; others lie as these."""

LABEL_ORDER = 1000.0
"""Of dots and lines of the labels: above the robots of all actions."""

TimeColumns = tuple[rr.TimeColumn, ...]


def log_scene(stream: rr.RecordingStream, rollouts: Rollouts, bounds: Bounds, theme: Theme) -> None:
    """Draw what does not move: metres, walls, the robot's task and names of actions."""
    # without names, which the viewer would write beside every robot where there are few
    colours = [theme.contact, *(theme.action_colour(name) for name in rollouts.names)]
    classes = [rr.AnnotationInfo(number, color=colour) for number, colour in enumerate(colours)]
    stream.log(
        entities.WORLD,
        y_upwards(),
        rr.AnnotationContext(classes),
        static=True,
    )
    stream.log(
        entities.GRID,
        rr.LineStrips2D(
            list(grid_lines(bounds)),
            colors=theme.grid,
            radii=rr.Radius.ui_points(0.5),
            draw_order=-10.0,
        ),
        static=True,
    )
    stream.log(
        entities.WALLS,
        rr.LineStrips2D(
            list(rollouts.scene.wall_segments), colors=theme.wall, radii=WALL_THICKNESS / 2.0
        ),
        static=True,
    )
    log_task(stream, rollouts, theme)
    log_labels(stream, rollouts, bounds, theme)


def log_task(stream: rr.RecordingStream, rollouts: Rollouts, theme: Theme) -> None:
    """Draw the robot's start as a ring with a nose, and its goal as a target."""
    robot = rollouts.scene.robot
    start, goal = np.array(robot.start), np.array(robot.goal)
    ahead = np.array([np.cos(robot.start_heading), np.sin(robot.start_heading)])
    drawing = Drawing()
    drawing.line(circle(start, ROBOT_RADIUS), theme.ink)
    drawing.line([start + ROBOT_RADIUS * ahead, start + 1.6 * ROBOT_RADIUS * ahead], theme.ink, 3.0)
    drawing.stroke(circle(goal, 0.85 * ROBOT_RADIUS), theme.ink, 0.3 * ROBOT_RADIUS)
    drawing.stroke(circle(goal, 0.15 * ROBOT_RADIUS), theme.ink, 0.3 * ROBOT_RADIUS)
    drawing.log(stream, entities.TASK, draw_order=22.0)


def log_labels(
    stream: rr.RecordingStream, rollouts: Rollouts, bounds: Bounds, theme: Theme
) -> None:
    """Write each action's name near where its paths end."""
    labels = tuple(short(name) for name in rollouts.names)
    some = rollouts.robot[:, :MOST_PATHS_BESIDE_LABELS, ::PATH_STRIDE, :2]
    drawing = Drawing(lift=metres_per_pixel(bounds) * LABEL_HEIGHT / 2.0)
    ends = rollouts.robot[:, :, -1, :2].mean(axis=1)
    places = label_places(labels, ends, some, rollouts.scene.wall_segments, bounds)
    for action, words, end, place in zip(rollouts.actions, labels, ends, places, strict=True):
        # dark, since it lies on paths of every colour; the dot at its end says whose it is
        drawing.line(leader(end, place, half_size(words, bounds)), theme.ink, 1.2)
        drawing.dot(end.tolist(), theme.ink, 9.0)
        drawing.dot(end.tolist(), theme.action_colour(action.name), 6.0)
        drawing.text(place.tolist(), words)
    drawing.log(stream, entities.LABELS, draw_order=LABEL_ORDER)


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
    path = entities.robots(rollouts.names[index])
    robot = rounded(rollouts.robot[index, ..., :2]).swapaxes(0, 1)  # (T+1, K, 2)
    heading = rounded(rollouts.robot[index, ..., 2], HEADING_RESOLUTION).swapaxes(0, 1)  # (T+1, K)
    times, count = heading.shape
    in_full = np.arange(count) == 0  # one future with bodies, the others as dots
    order = 30.0 + index  # a robot hides the arrowheads of those that it lies on
    stream.log(
        path,
        rr.Points2D.from_fields(
            radii=np.where(in_full, ROBOT_RADIUS, DOT_RADIUS), draw_order=order
        ),
        rr.LineStrips2D.from_fields(
            colors=theme.panel, radii=ARROWHEAD_THICKNESS / 2.0, draw_order=order + 0.5
        ),
        static=True,
    )
    touched = has_touched(rollouts.contact_step[index], times)
    stream.send_columns(
        path,
        time_columns(rollouts),
        [
            *rr.Points2D.columns(
                positions=robot.reshape(-1, 2),
                class_ids=np.where(touched, CONTACT_CLASS, index + 1).ravel(),
            ).partition([count] * times),
            *rr.AnyValues.columns(heading=heading.astype(np.float32).ravel()).partition(
                [count] * times
            ),
            *rr.LineStrips2D.columns(strips=strips(rounded(arrowheads(rollouts.robot[index, 0])))),
        ],
    )


def log_pedestrians(
    stream: rr.RecordingStream, rollouts: Rollouts, index: int, theme: Theme
) -> None:
    """Show the K times P people under one action: those of the first rollout with bodies.

    Bars join the people of a group there.
    """
    path = entities.pedestrians(rollouts.names[index])
    people = rounded(rollouts.pedestrians[index]).swapaxes(0, 1)  # (T+1, K, P, 2)
    times, count, person_count, _ = people.shape
    in_full = np.repeat(np.arange(count) == 0, person_count)
    faint = blend(theme.pedestrian, theme.panel, 0.5)
    look: list[rr.AsComponents] = [
        rr.Points2D.from_fields(
            radii=np.where(in_full, PEDESTRIAN_RADIUS, PERSON_DOT_RADIUS),
            colors=np.where(in_full[:, None], theme.pedestrian, faint),
            draw_order=10.0,  # below paths and contacts
        )
    ]
    moving = [
        *rr.Points2D.columns(positions=people.reshape(-1, 2)).partition(
            [count * person_count] * times
        )
    ]
    if rollouts.scene.groups:
        bars = group_bars(people[:, 0], rollouts.scene.groups)  # (T+1, bars, 2, 2)
        look.append(bar_style(theme))
        moving += rr.LineStrips2D.columns(strips=strips(bars.reshape(-1, 2, 2))).partition(
            [bars.shape[1]] * times
        )
    stream.log(path, *look, static=True)
    stream.send_columns(path, time_columns(rollouts), moving)


def log_paths(stream: rr.RecordingStream, rollouts: Rollouts, index: int, theme: Theme) -> None:
    """Draw the paths of the K robots, with a red cross where one first touched something.

    The path of the robot that is drawn in full lies over the others once more, bold.
    """
    robot = rounded(rollouts.robot[index, ..., :2])
    last = robot.shape[1] - 1
    corners = np.unique([*range(0, last, PATH_STRIDE), last])
    contact_step = rollouts.contact_step[index]
    ever = np.flatnonzero(contact_step >= 0)
    marks = crosses(robot[ever, contact_step[ever]], 0.05)
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


def rounded(values: FloatArray, resolution: float = RESOLUTION) -> FloatArray:
    """The nearest multiples of the resolution."""
    near: FloatArray = np.round(values / resolution) * resolution
    return near


def arrowheads(poses: FloatArray) -> FloatArray:
    """Where the corners of the arrowhead are on a robot at poses [N, 3], [N, 3, 2], m."""
    x, y, heading = poses.T[..., None]  # (N, 1) each
    ahead, left = ARROWHEAD.T
    corners: FloatArray = np.stack(
        [
            x + ahead * np.cos(heading) - left * np.sin(heading),
            y + ahead * np.sin(heading) + left * np.cos(heading),
        ],
        axis=-1,
    )
    return corners


def bar_style(theme: Theme) -> rr.LineStrips2D:
    """How the bars between people look; they lie below them."""
    faint = blend(theme.pedestrian, theme.panel, 0.5)
    return rr.LineStrips2D.from_fields(colors=faint, radii=BAR_THICKNESS / 2.0, draw_order=5.0)


def group_bars(people: FloatArray, groups: tuple[tuple[int, ...], ...]) -> FloatArray:
    """Ends of the bars that join the people [N, P, 2] of each group, [N, bars, 2, 2], m."""
    every = np.arange(len(people))[:, None, None]
    bars = [people[:, group][every, shortest_links(people[:, group])] for group in groups]
    return np.concatenate(bars, axis=1)


def strips(corners: FloatArray) -> list[FloatArray]:
    """Lines [N, M, 2] of M corners each as Rerun's types want them, which takes an array too."""
    return cast("list[FloatArray]", corners)  # as an array they are not converted one by one


def time_columns(rollouts: Rollouts) -> TimeColumns:
    """The two timelines that everything moves along."""
    steps = np.arange(rollouts.robot.shape[2])
    return (
        rr.TimeColumn("sim_time", duration=steps * rollouts.dt),
        rr.TimeColumn("step", sequence=steps),
    )


def has_touched(contact_step: NDArray[np.int64], times: int) -> NDArray[np.bool_]:
    """Whether each of K robots has touched something by each of `times` steps, [times, K]."""
    touched: NDArray[np.bool_] = (contact_step >= 0) & (np.arange(times)[:, None] >= contact_step)
    return touched


def grid_lines(bounds: Bounds) -> FloatArray:
    """Lines at whole metres, or at whole tens where there would be more than 60.

    Returns:
        [N, 2, 2], m.
    """
    x0, y0, x1, y1 = bounds
    size = max(x1 - x0, y1 - y0)
    step = 1.0 if size <= 60.0 else 10.0
    # views show more than the bounds where their shape is another
    across = step * np.arange(np.floor((x0 - size) / step), np.ceil((x1 + size) / step) + 1)
    up = step * np.arange(np.floor((y0 - size) / step), np.ceil((y1 + size) / step) + 1)
    vertical = [[(x, up[0]), (x, up[-1])] for x in across]
    horizontal = [[(across[0], y), (across[-1], y)] for y in up]
    return np.array(vertical + horizontal)


def circle(centre: FloatArray, radius: float) -> FloatArray:
    """A closed ring, [49, 2], m."""
    angles = np.linspace(0.0, 2.0 * np.pi, 49)
    ring: FloatArray = centre + radius * np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    return ring


def crosses(centres: FloatArray, reach: float) -> FloatArray:
    """Two strokes a cross, [2N, 2, 2], m."""
    strokes = reach * np.array([[(-1.0, -1.0), (1.0, 1.0)], [(-1.0, 1.0), (1.0, -1.0)]])
    lines: FloatArray = (centres[:, None, None] + strokes).reshape(-1, 2, 2)
    return lines
