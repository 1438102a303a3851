"""What does not move in the world of a recording: ground, walls, the task, names of the actions."""

import numpy as np
import rerun as rr

from scenes import Rollouts
from scenes.scene import ROBOT_RADIUS
from studio.arrays import Bounds, FloatArray
from studio.recorder.drawing import Drawing, y_upwards
from studio.scene.recording import entities
from studio.scene.recording.label_places import (
    LABEL_HEIGHT,
    half_size,
    label_places,
    leader,
    metres_per_pixel,
)
from studio.scene.recording.moving import PATH_STRIDE
from studio.style.palette import Theme
from studio.style.words import short_label

WALL_THICKNESS = 0.12  # of the drawn walls, m; the simulated ones are lines
MOST_PATHS_BESIDE_LABELS = 10  # of each action; further ones lie near these
LABEL_ORDER = 1000.0  # the dots and lines of the labels lie above the robots of all actions


def log_world(stream: rr.RecordingStream, rollouts: Rollouts, bounds: Bounds, theme: Theme) -> None:
    """Draw what does not move: metres, walls, the robot's task and names of actions."""
    # without names, which the viewer would write beside every robot where there are few
    colours = [theme.contact, *(theme.action_colour(name) for name in rollouts.names)]
    classes = [rr.AnnotationInfo(number, color=colour) for number, colour in enumerate(colours)]
    stream.log(entities.WORLD, y_upwards(), rr.AnnotationContext(classes), static=True)
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
    labels = tuple(short_label(name) for name in rollouts.names)
    some = rollouts.robot[:, :MOST_PATHS_BESIDE_LABELS, ::PATH_STRIDE, :2]
    drawing = Drawing(lift=metres_per_pixel(bounds) * LABEL_HEIGHT / 2.0)
    ends = rollouts.robot[:, :, -1, :2].mean(axis=1)
    places = label_places(labels, ends, some, rollouts.scene.wall_segments, bounds)
    for name, words, end, place in zip(rollouts.names, labels, ends, places, strict=True):
        # dark, since it lies on paths of every colour; the dot at its end says whose it is
        drawing.line(leader(end, place, half_size(words, bounds)), theme.ink, 1.2)
        drawing.dot(end.tolist(), theme.ink, 9.0)
        drawing.dot(end.tolist(), theme.action_colour(name), 6.0)
        drawing.text(place.tolist(), words)
    drawing.log(stream, entities.LABELS, draw_order=LABEL_ORDER)


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
