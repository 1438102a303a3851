"""The world in a recording: walls, robots and people, seen from above."""

import numpy as np
import rerun as rr
from numpy.typing import NDArray

from scenes import Rollouts
from scenes.scene import PEDESTRIAN_RADIUS, ROBOT_RADIUS
from studio.framing import Bounds
from studio.judgements import FloatArray
from studio.naming import short
from studio.palette import Theme, blend
from studio.recorder import entities
from studio.recorder.drawing import Drawing

RESOLUTION = 1.0 / 128.0
"""Positions are rounded to this, about 8 mm: they are at most 4 mm off.

Being a power of two it leaves the last bytes of each number empty and makes many numbers equal,
so that they pack into 0.6 of their size; rounded to 1 cm they would pack into 0.8.
"""

HEADING_RESOLUTION = 1.0 / 64.0
"""Headings are rounded to this, about 0.9°, rad."""

CONTACT_CLASS = 0
"""Class of a robot that has touched something; under the action with index a it is a + 1 before."""

DOT_RADIUS = 0.07
"""Radius of the dot that stands for the robot in every future but the first, m."""

PERSON_DOT_RADIUS = 0.045
"""Radius of the dot that stands for a person in every future but the first, m."""

WALL_THICKNESS = 0.12
"""Of the drawn walls, m; the simulated ones are lines."""

PATH_STRIDE = 4
"""A path is drawn through every fourth step: its corners stay within a centimetre of the truth."""

TimeColumns = tuple[rr.TimeColumn, ...]


def log_scene(stream: rr.RecordingStream, rollouts: Rollouts, bounds: Bounds, theme: Theme) -> None:
    """Draw what does not move: metres, walls, the robot's task and names of actions."""
    # without names, which the viewer would write beside every robot where there are few
    colours = [theme.contact, *(theme.action_colour(action.name) for action in rollouts.actions)]
    classes = [rr.AnnotationInfo(number, color=colour) for number, colour in enumerate(colours)]
    stream.log(
        entities.WORLD,
        # screens count y downwards, the world counts it upwards
        rr.Transform3D(scale=[1.0, -1.0, 1.0]),
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
    log_labels(stream, rollouts)


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


def log_labels(stream: rr.RecordingStream, rollouts: Rollouts) -> None:
    """Write each action's name where its paths end."""
    drawing = Drawing()
    for index, action in enumerate(rollouts.actions):
        path = rollouts.robot[index, ..., :2].mean(axis=0)  # (T+1, 2)
        ahead = path[-1] - path[0]
        drawing.text(path[-1] + 0.4 * ahead / max(np.hypot(*ahead), 1e-6), short(action.name))
    drawing.log(stream, entities.LABELS)


def log_action(stream: rr.RecordingStream, rollouts: Rollouts, index: int, theme: Theme) -> None:
    """Show the K robots and their pedestrians under one action, over time."""
    name = rollouts.actions[index].name
    robot = rounded(rollouts.robot[index, ..., :2]).swapaxes(0, 1)  # (T+1, K, 2)
    heading = rounded(rollouts.robot[index, ..., 2], HEADING_RESOLUTION).swapaxes(0, 1)  # (T+1, K)
    people = rounded(rollouts.pedestrians[index]).swapaxes(0, 1)  # (T+1, K, P, 2)
    times, count, person_count, _ = people.shape
    when = time_columns(rollouts)
    in_full = np.arange(count) == 0  # one future with bodies, the others as dots
    stream.log(
        entities.robots(name),
        rr.Points2D.from_fields(radii=np.where(in_full, ROBOT_RADIUS, DOT_RADIUS)),
        static=True,
    )
    touched = has_touched(rollouts.contact_step[index], times)
    stream.send_columns(
        entities.robots(name),
        when,
        [
            *rr.Points2D.columns(
                positions=robot.reshape(-1, 2),
                class_ids=np.where(touched, CONTACT_CLASS, index + 1).ravel(),
            ).partition([count] * times),
            *rr.AnyValues.columns(heading=heading.astype(np.float32).ravel()).partition(
                [count] * times
            ),
        ],
    )
    if person_count:
        in_full = np.repeat(in_full, person_count)
        faint = blend(theme.pedestrian, theme.panel, 0.5)
        stream.log(
            entities.pedestrians(name),
            rr.Points2D.from_fields(
                radii=np.where(in_full, PEDESTRIAN_RADIUS, PERSON_DOT_RADIUS),
                colors=np.where(in_full[:, None], theme.pedestrian, faint),
                draw_order=10.0,  # below paths and contacts
            ),
            static=True,
        )
        stream.send_columns(
            entities.pedestrians(name),
            when,
            rr.Points2D.columns(positions=people.reshape(-1, 2)).partition(
                [count * person_count] * times
            ),
        )
    log_paths(stream, rollouts, index, theme)


def log_paths(stream: rr.RecordingStream, rollouts: Rollouts, index: int, theme: Theme) -> None:
    """Draw the paths of the K robots, with a red cross where one first touched something."""
    robot = rounded(rollouts.robot[index, ..., :2])
    last = robot.shape[1] - 1
    corners = np.unique([*range(0, last, PATH_STRIDE), last])
    contact_step = rollouts.contact_step[index]
    ever = np.flatnonzero(contact_step >= 0)
    marks = crosses(robot[ever, contact_step[ever]], 0.05)
    faint = blend(theme.action_colour(rollouts.actions[index].name), theme.panel, 0.45)
    stream.log(
        entities.paths(rollouts.actions[index].name),
        rr.LineStrips2D(
            [*robot[:, corners], *marks],
            colors=[faint] * len(robot) + [theme.contact] * len(marks),
            radii=rr.Radius.ui_points(0.7),
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
