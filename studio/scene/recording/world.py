"""What does not move in the world of a recording: walls, the task, how long a metre is."""

import numpy as np
import rerun as rr

from scenes import Rollouts
from scenes.scene import ROBOT_RADIUS
from studio.arrays import Bounds
from studio.recorder.views import y_upwards
from studio.scene.recording import entities
from studio.scene.recording.moving import people_told, rounded, strips
from studio.style.palette import Theme, blend
from studio.style.ticks import round_step

WALL_THICKNESS = 0.12  # of the drawn walls, m; the simulated ones are lines
SCALE_SHARE = 0.12  # of a view's width that the scale bar takes at least
SCALE_INSET = 0.03  # of a view's width between the scale bar and the edges


def log_world(stream: rr.RecordingStream, rollouts: Rollouts, bounds: Bounds, theme: Theme) -> None:
    """Draw what does not move, and say what colour a class of robots has."""
    # without names, which the viewer would write beside every robot where there are few
    colours = [theme.contact, *(theme.action_colour(name) for name in rollouts.names)]
    classes = [rr.AnnotationInfo(number, color=colour) for number, colour in enumerate(colours)]
    stream.log(entities.WORLD, y_upwards(), rr.AnnotationContext(classes), static=True)
    walls = rr.LineStrips2D(
        list(rollouts.scene.wall_segments), colors=theme.wall, radii=WALL_THICKNESS / 2.0
    )
    stream.log(entities.WALLS, walls, static=True)
    log_task(stream, rollouts, theme)
    log_scale(stream, bounds, theme)
    if rollouts.scene.pedestrians:
        log_without_robot(stream, rollouts, theme)


def log_task(stream: rr.RecordingStream, rollouts: Rollouts, theme: Theme) -> None:
    """Draw the robot's start as a ring, and its goal as a target."""
    robot = rollouts.scene.robot
    centres = [robot.start, robot.goal, robot.goal]
    radii = ROBOT_RADIUS * np.array([1.0, 1.0, 0.4])
    rings = rr.Ellipses2D(
        centers=centres,
        half_sizes=np.stack([radii, radii], axis=-1),
        colors=theme.ink,
        line_radii=rr.Radius.ui_points(1.0),
        draw_order=22.0,
    )
    told = rr.AnyValues(told=["the robot's start", "its goal", "its goal"])
    stream.log(entities.TASK, rings, told, static=True)


def log_scale(stream: rr.RecordingStream, bounds: Bounds, theme: Theme) -> None:
    """Draw a bar of a round number of metres into the lower left corner of a view."""
    x0, y0, x1, _ = bounds
    left, bottom = x0 + SCALE_INSET * (x1 - x0), y0 + SCALE_INSET * (x1 - x0)
    bar = [(left, bottom), (left + scale_length(bounds), bottom)]
    line = rr.LineStrips2D([bar], colors=theme.ink, radii=rr.Radius.ui_points(1.5))
    # a single text would not be shown
    told = rr.AnyValues(told=[f"{scale_length(bounds):g} m"] * 2)
    stream.log(entities.SCALE, line, told, static=True)


def scale_length(bounds: Bounds) -> float:
    """How long the bar is in a view with these bounds, m."""
    return round_step(SCALE_SHARE * (bounds[2] - bounds[0]), 1.0)


def log_without_robot(stream: rr.RecordingStream, rollouts: Rollouts, theme: Theme) -> None:
    """Keep the M times P walks of the people had the robot not been there, one line a walk."""
    walks = rounded(rollouts.without_robot).swapaxes(1, 2)  # (M, P, T+1, 2)
    count, people = walks.shape[:2]
    lines = rr.LineStrips2D(
        strips(walks.reshape(-1, *walks.shape[2:])),
        colors=blend(theme.pedestrian, theme.panel, 0.25),
        radii=rr.Radius.ui_points(0.5),
        draw_order=-5.0,
    )
    told = people_told([f"rollout {place} without the robot" for place in range(count)], people)
    stream.log(entities.WITHOUT_ROBOT, lines, rr.AnyValues(told=told), static=True)
