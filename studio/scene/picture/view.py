"""The picture's view of the scene: every path of every action, named where it ends."""

import math
from collections.abc import Sequence

import numpy as np

from scenes import Rollouts
from scenes.scene import ROBOT_RADIUS
from studio.arrays import FloatArray
from studio.painter.boxes import Box, Point
from studio.painter.canvas import Canvas
from studio.painter.labels import Label, draw_labels
from studio.painter.lettering import REGULAR, SEMIBOLD
from studio.painter.paths import draw_faint_paths
from studio.painter.views import View
from studio.scene.judgements import Judgement
from studio.scene.measures import first_contacts
from studio.scene.picture.scenery import (
    draw_contacts,
    draw_goal,
    draw_ground,
    draw_groups,
    draw_people,
    draw_people_beyond,
    draw_robot,
    draw_scale_bar,
    draw_walls,
    goal_label,
    overlap_opacity,
    view_of,
)
from studio.scene.picture.titles import joined
from studio.style.palette import blend
from studio.style.words import action_label

_MOST_LABELS = 12  # with more actions than this, only the teachers' picks are named


def draw_scene(
    canvas: Canvas, box: Box, rollouts: Rollouts, judgements: Sequence[Judgement]
) -> None:
    """Draw the scene and a caption below it.

    Where there are too many actions to name them all, those are named that a teacher would pick.
    """
    scene, theme, unit, small = rollouts.scene, canvas.theme, canvas.unit, canvas.type.small
    panel = Box(box.left, box.top, box.right, box.bottom - 1.5 * small)
    view, inside = view_of(rollouts, panel), canvas.clipped(panel)
    opacity, pen = overlap_opacity(rollouts.count), 2 * unit
    colours = [theme.action_colour(name) for name in rollouts.names]
    draw_ground(inside, view)
    grey = blend(theme.pedestrian, theme.panel, 0.8)
    people = rollouts.without_robot.swapaxes(1, 2).reshape(-1, rollouts.steps + 1, 2)
    draw_faint_paths(inside, view.to_pixels(people), grey, pen, 0.6 * opacity)
    for paths, colour in zip(rollouts.robot, colours, strict=True):
        draw_faint_paths(inside, view.to_pixels(paths), colour, pen, opacity)
    draw_walls(inside, view, scene)
    draw_groups(inside, view, scene, scene.starts)
    draw_people(inside, view, scene.starts)
    for index in range(len(rollouts.actions)):
        draw_contacts(inside, view, first_contacts(rollouts, index))
    medians = np.median(view.to_pixels(rollouts.robot), axis=1)  # (A, T+1, 2)
    for median, colour in zip(medians, colours, strict=True):
        inside.line(median, theme.panel, 6 * unit)
        inside.line(median, colour, 3 * unit)
    for median, colour in zip(medians, colours, strict=True):
        inside.disc(median[-1], 7 * unit, theme.ground)
        inside.disc(median[-1], 5 * unit, colour)
    goal = draw_goal(inside, view, scene.robot.goal)
    start = np.array([*scene.robot.start, scene.robot.start_heading])
    draw_robot(inside, view, start, theme.ink)
    picks = {judgement.best for judgement in judgements}
    named = set(range(len(medians))) if len(medians) <= _MOST_LABELS else picks
    labels = _scene_labels(inside, view, rollouts, medians, goal, named)
    labels += draw_people_beyond(inside, view, scene)
    standing = view.to_pixels([*scene.starts, scene.robot.start])
    seen = np.concatenate([medians.reshape(-1, 2), standing])
    draw_labels(inside, labels, panel.inset(4 * unit), theme.panel, seen)
    baseline = box.bottom - 0.3 * small
    end = draw_scale_bar(canvas, view, box.right, baseline) - small
    at, room = (box.left, baseline), end - box.left
    canvas.fit(at, _captions(rollouts), room, small, theme.faint, line="base")


def _scene_labels(
    canvas: Canvas,
    view: View,
    rollouts: Rollouts,
    medians: FloatArray,
    goal: Point,
    named: set[int],
) -> list[Label]:
    """Names of the robot, its goal and the named actions, the actions at their medians' ends."""
    theme, unit, body = canvas.theme, canvas.unit, canvas.type.body
    heading = rollouts.scene.robot.start_heading
    x, y = view.to_pixels(rollouts.scene.robot.start).tolist()
    behind = -math.cos(heading), math.sin(heading)
    reach = 1.2 * ROBOT_RADIUS * view.scale + 3 * unit
    labels = [
        Label("robot", canvas.type.small, REGULAR, theme.ink, (x, y), reach, behind),
        goal_label(canvas, goal, (goal[0] - x, goal[1] - y)),
    ]
    for index in sorted(named):
        path, name = medians[index], rollouts.names[index]
        words = canvas.abbreviated(action_label(name), view.box.width / 5, body, SEMIBOLD)
        ink = theme.legible(theme.action_colour(name))
        x, y = path[-1].tolist()
        dx, dy = path[-1] - path[-min(6, len(path))]
        # below where the robot hardly moves
        direction = (dx, dy) if math.hypot(dx, dy) > 2 * unit else (0.0, 1.0)
        labels.append(Label(words, body, SEMIBOLD, ink, (x, y), 9 * unit, direction))
    return labels


def _captions(rollouts: Rollouts) -> list[str]:
    """What the marks in the scene mean, the longest wording first."""
    people = "grey: people" if rollouts.scene.pedestrians else ""
    paths = people and f"{people} and their paths without the robot"
    groups = "joined: groups" if rollouts.scene.groups else ""
    red = "red: contact" if rollouts.touched.any() else ""
    first = red and "red: first contact"
    every, brief = "Thin: every rollout · bold: median", "Thin: rollouts · bold: median"
    return joined(
        (every, paths, groups, first),
        (every, people, groups, first),
        (brief, people, groups, red),
        (brief, people, red),
        ("Bold: median", people, red),
    )
