"""The scene seen from above: ground, walls, people, robot, goal, and what to show of it."""

import math

import numpy as np

from scenes import Rollouts
from scenes.scene import PEDESTRIAN_RADIUS, ROBOT_RADIUS, Scene
from studio.arrays import FloatArray
from studio.painter.boxes import Box, Point
from studio.painter.canvas import Canvas
from studio.painter.labels import Label
from studio.painter.lettering import REGULAR
from studio.painter.marks import crosses, dashed_path, hollow_square
from studio.painter.views import View
from studio.scene.framing import beyond_edges, bounds_of_shape
from studio.scene.groups import shortest_links
from studio.scene.true_walks import true_walks
from studio.style.palette import Colour, blend
from studio.style.ticks import round_numbers, round_step


def overlap_opacity(count: int) -> float:
    """Opacity of one of `count` paths.

    Where a seventh of all paths cross, they look two thirds opaque together, so bundles look alike
    however many paths they are made of.
    """
    return float(1.0 - 0.35 ** min(7.0 / count, 1.0))


def view_of(rollouts: Rollouts, box: Box) -> View:
    """The view that shows in a box what a scene is about; see `studio.scene.framing`."""
    return View.around(bounds_of_shape(rollouts, box.width, box.height), box)


def draw_ground(canvas: Canvas, view: View) -> None:
    """Draw the floor with a grid of whole metres."""
    canvas.fill(view.box, canvas.theme.panel)
    x0, y0, x1, y1 = view.bounds
    step = max(1.0, round_step(12, view.scale))  # m; lines are at least 12 px apart
    for x in range(math.ceil(x0 / step), math.floor(x1 / step) + 1):
        left = view.to_pixels([x * step, 0.0])[0]
        canvas.fill(Box(left, view.box.top, left + canvas.hair, view.box.bottom), canvas.theme.grid)
    for y in range(math.ceil(y0 / step), math.floor(y1 / step) + 1):
        top = view.to_pixels([0.0, y * step])[1]
        canvas.fill(Box(view.box.left, top, view.box.right, top + canvas.hair), canvas.theme.grid)


def draw_walls(canvas: Canvas, view: View, scene: Scene) -> None:
    """Draw the walls."""
    for segment in scene.wall_segments:
        canvas.line(view.to_pixels(segment), canvas.theme.wall, 6 * canvas.unit)


def draw_groups(canvas: Canvas, view: View, scene: Scene, people: FloatArray) -> None:
    """Draw bars that join the people [P, 2] (m) of each group."""
    colour = blend(canvas.theme.pedestrian, canvas.theme.panel, 0.5)
    for group in scene.groups:
        members = view.to_pixels(people[list(group)])
        for link in shortest_links(members):
            canvas.line(members[link], colour, 0.7 * PEDESTRIAN_RADIUS * view.scale)


def draw_people(canvas: Canvas, view: View, people: FloatArray) -> None:
    """Draw people [P, 2] (m) as grey discs with a light rim."""
    radius = max(PEDESTRIAN_RADIUS * view.scale, 2.5 * canvas.unit)
    for centre in view.to_pixels(people):
        canvas.disc(centre, radius + max(1.0, 1.5 * canvas.unit), canvas.theme.ground)
    for centre in view.to_pixels(people):
        canvas.disc(centre, radius, canvas.theme.pedestrian)


def draw_true_walks(canvas: Canvas, view: View, rollouts: Rollouts) -> None:
    """Draw where the people of a real crowd truly walked, dashed."""
    for walk in true_walks(rollouts).swapaxes(0, 1):
        known = walk[~np.isnan(walk[:, 0])]
        if len(known) > 1:
            dashed_path(canvas, view.to_pixels(known), canvas.theme.ink, 1.2 * canvas.unit)


def draw_robot(canvas: Canvas, view: View, pose: FloatArray, colour: Colour) -> None:
    """Draw the robot at a pose (x, y in m, heading in rad): a disc with an arrowhead."""
    radius = max(ROBOT_RADIUS * view.scale, 4.0 * canvas.unit)
    centre = view.to_pixels(pose)
    canvas.disc(centre, radius + max(1.0, 2.0 * canvas.unit), canvas.theme.ground)
    canvas.disc(centre, radius, colour)
    angles = pose[2] + np.radians([0.0, 140.0, 220.0])
    corners = np.stack([np.cos(angles), -np.sin(angles)], axis=-1)
    canvas.polygon(centre + 0.66 * radius * corners, canvas.theme.ground)


def draw_contacts(canvas: Canvas, view: View, places: FloatArray, radius: float = 3.6) -> None:
    """Mark places [N, 2] (m) at which the robot first touched a person, with crosses.

    The radius is in units of the page.
    """
    reach, theme = max(radius * canvas.unit, 2.0), canvas.theme
    crosses(canvas, view.to_pixels(places), reach, theme.contact, theme.ground)


def draw_wall_contacts(canvas: Canvas, view: View, places: FloatArray, radius: float = 3.6) -> None:
    """Mark places [N, 2] (m) at which the robot first touched a wall, with squares.

    The radius is in units of the page.
    """
    reach, theme = max(0.9 * radius * canvas.unit, 2.0), canvas.theme
    rim = reach + max(1.0, canvas.unit)
    for centre in view.to_pixels(places):
        hollow_square(canvas, centre, rim, theme.ground, theme.ground)
        hollow_square(canvas, centre, reach, theme.contact, theme.ground)


def draw_goal(canvas: Canvas, view: View, goal: Point) -> Point:
    """Draw the robot's goal: a ring if it is in view, an arrowhead at the edge if it is not.

    Returns where it was drawn, px.
    """
    centre = view.to_pixels(goal)
    frame = view.box.inset(12 * canvas.unit)
    inside = np.clip(centre, (frame.left, frame.top), (frame.right, frame.bottom))
    away = centre - inside
    if np.any(away):
        angles = math.atan2(away[1], away[0]) + np.radians([0.0, 140.0, 220.0])
        corners = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
        canvas.polygon(inside + 9 * canvas.unit * corners, canvas.theme.ink)
    else:
        ink, ground = canvas.theme.ink, canvas.theme.ground
        for radius, colour in ((9, ink), (6.5, ground), (3, ink)):
            canvas.disc(centre, radius * canvas.unit, colour)
    return float(inside[0]), float(inside[1])


def goal_label(canvas: Canvas, goal: Point, direction: Point) -> Label:
    """The label of the goal that was drawn at a point (px)."""
    size, ink, reach = canvas.type.small, canvas.theme.ink, 13 * canvas.unit
    return Label("goal", size, REGULAR, ink, goal, reach, direction)


def draw_people_beyond(canvas: Canvas, view: View, scene: Scene) -> list[Label]:
    """Draw an arrow at each edge of a view beyond which people start.

    Returns the labels of the arrows, which say how many people start there.
    """
    unit, small, labels = canvas.unit, canvas.type.small, list[Label]()
    for beyond in beyond_edges(scene.starts, view.bounds):
        (right, up), away = beyond.direction, 9 * unit
        x, y = view.to_pixels(beyond.place).tolist()
        frame = view.box.inset(away)
        # the tip touches the edge, and neither corner is cut off
        x = min(max(x, frame.left), frame.right) + away * right
        y = min(max(y, frame.top), frame.bottom) - away * up
        tip, back = np.array([x, y]), np.array([-right, up])
        across = np.array([up, right])
        for size, colour in ((13, canvas.theme.panel), (10, canvas.theme.faint)):
            wings = (tip + size * unit * (back + 0.7 * side * across) for side in (-1, 1))
            canvas.polygon([tip, *wings], colour)
        middle, ink = tip + 5 * unit * back, canvas.theme.ink
        people = "person" if beyond.count == 1 else "people"
        text, direction = f"{beyond.count} more {people}", (-right, up)
        place = (float(middle[0]), float(middle[1]))
        labels.append(Label(text, small, REGULAR, ink, place, 8 * unit, direction))
    return labels


def draw_scale_bar(canvas: Canvas, view: View, right: float, baseline: float) -> float:
    """Draw a bar that shows the scale of a view, and its length in words.

    The words end at the right and stand on the baseline, px. Returns where the bar begins, px.
    """
    lengths = round_numbers(0.1, 5000.0)  # m
    room = 0.15 * view.box.width
    metres = max((length for length in lengths if length * view.scale < room), default=lengths[0])
    size, tall = canvas.type.small, 0.5 * canvas.type.small
    at, ink = (right, baseline), canvas.theme.ink
    label = canvas.text(at, f"{metres:g} m", size, ink, anchor="right", line="base")
    end, pen = label.left - 0.5 * size, max(1.0, 2 * canvas.unit)
    start = end - metres * view.scale
    canvas.fill(Box(start, baseline - pen, end, baseline), ink)
    canvas.fill(Box(start, baseline - tall, start + pen, baseline), ink)
    canvas.fill(Box(end - pen, baseline - tall, end, baseline), ink)
    return start
