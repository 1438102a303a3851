"""A scene before anything happens in it: who stands where, and which way everybody goes."""

import math

import numpy as np

from scenes.scene import Pedestrian, Scene
from studio.arrays import FloatArray
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.views import View
from studio.scene.framing import MARGIN
from studio.scene.picture.scenery import (
    draw_goal,
    draw_ground,
    draw_groups,
    draw_people,
    draw_robot,
    draw_scale_bar,
    draw_walls,
)
from studio.scene.picture.titles import draw_heading
from studio.style.palette import LIGHT, Theme
from studio.style.words import counted

PLAN_SIZE = (960, 540)
"""Width and height, px."""


def compose_plan(scene: Scene, size: tuple[int, int] = PLAN_SIZE, theme: Theme = LIGHT) -> Canvas:
    """Draw a scene at time 0, all of it.

    A line shows where a person gets in a second, at the speed that the person begins with.
    """
    canvas = Canvas(*size, theme)
    page, small = canvas.page, canvas.type.small
    kind, inside = scene_told(scene)
    heading = draw_heading(canvas, page, [kind, scene.name], [inside], page.width)
    panel = Box(page.left, heading.bottom + small, page.right, page.bottom - 1.8 * small)
    x0, y0, x1, y1 = scene.bounds
    around = (x0 - MARGIN, y0 - MARGIN, x1 + MARGIN, y1 + MARGIN)
    view, floor = View.around(around, panel), canvas.clipped(panel)
    draw_ground(floor, view)
    draw_walls(floor, view, scene)
    draw_groups(floor, view, scene, scene.starts)
    for person in scene.pedestrians:
        ahead = np.array([person.start, np.array(person.start) + velocity_of(person)])
        floor.line(view.to_pixels(ahead), theme.pedestrian, 3 * canvas.unit)
    draw_people(floor, view, scene.starts)
    draw_goal(floor, view, scene.robot.goal)
    robot = np.array([*scene.robot.start, scene.robot.start_heading])
    draw_robot(floor, view, robot, theme.ink)
    caption = "black: the robot and its goal · grey: people, and where they get in 1 s"
    canvas.text((page.left, page.bottom), caption, small, theme.faint, line="base")
    draw_scale_bar(canvas, view, page.right, page.bottom)
    return canvas


def scene_told(scene: Scene) -> tuple[str, str]:
    """What a scene is, and what is in it."""
    words = dict.fromkeys([scene.name, scene.family, scene.pattern])
    told = [word.replace("_", " ") for word in words if word != "custom"]
    if scene.number:
        told.append(f"number {scene.number}")
    crowd = counted(len(scene.pedestrians), "pedestrian")
    groups = f" ({counted(len(scene.groups), 'group')})" if scene.groups else ""
    walls = counted(len(scene.walls), "wall") if scene.walls else "no walls"
    return " · ".join(told), f"{crowd}{groups}, {walls}"


def velocity_of(person: Pedestrian) -> FloatArray:
    """The velocity at which a person begins, [2], m/s."""
    if person.velocity is not None:
        return np.array(person.velocity)
    way = np.subtract(person.goal, person.start)
    return person.desired_speed * way / max(math.hypot(*way), 1e-9)
