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
from studio.scene.measures import poses_at
from studio.scene.picture.scenery import (
    draw_contacts,
    draw_goal,
    draw_ground,
    draw_groups,
    draw_people,
    draw_people_beyond,
    draw_robot,
    draw_scale_bar,
    draw_true_walks,
    draw_wall_contacts,
    draw_walls,
    goal_label,
    overlap_opacity,
    view_of,
)
from studio.scene.picture.titles import joined
from studio.scene.true_walks import true_walks_told
from studio.style.palette import blend
from studio.style.words import action_label

_MOST_WALKS = 4000  # of people, in all rollouts together; more would take a second
_MOST_LABELS = 12  # with more actions than this, only the teachers' picks are named


def draw_scene(
    canvas: Canvas, box: Box, rollouts: Rollouts, judgements: Sequence[Judgement]
) -> View:
    """Draw the scene and a caption below it; returns the view of the scene.

    Where there are too many actions to name them all, those are named that a teacher might pick.
    """
    scene, theme, unit, small = rollouts.scene, canvas.theme, canvas.unit, canvas.type.small
    panel = Box(box.left, box.top, box.right, box.bottom - caption_height(canvas, rollouts))
    view, inside = view_of(rollouts, panel), canvas.clipped(panel)
    opacity, pen = overlap_opacity(rollouts.paths), 2 * unit
    colours = [theme.action_colour(name) for name in rollouts.names]
    draw_ground(inside, view)
    _draw_walks(inside, view, rollouts, pen)
    for paths, colour in zip(rollouts.robot, colours, strict=True):
        draw_faint_paths(inside, view.to_pixels(paths), colour, pen, opacity)
    draw_true_walks(inside, view, rollouts)
    draw_walls(inside, view, scene)
    draw_groups(inside, view, scene, scene.starts)
    draw_people(inside, view, scene.starts)
    means = view.to_pixels(rollouts.robot).mean(axis=1)  # (A, T+1, 2)
    for mean, colour in zip(means, colours, strict=True):
        inside.line(mean, theme.panel, 6 * unit)
        inside.line(mean, colour, 3 * unit)
    for index in range(len(rollouts.actions)):
        people, walls = rollouts.person_step[index], rollouts.wall_step[index]
        draw_wall_contacts(inside, view, poses_at(rollouts, index, walls))
        draw_contacts(inside, view, poses_at(rollouts, index, people))
    for mean, colour in zip(means, colours, strict=True):
        inside.disc(mean[-1], 7 * unit, theme.ground)
        inside.disc(mean[-1], 5 * unit, colour)
    goal = draw_goal(inside, view, scene.robot.goal)
    start = np.array([*scene.robot.start, scene.robot.start_heading])
    draw_robot(inside, view, start, theme.ink)
    picks = {index for judgement in judgements for index in judgement.candidates}
    named = set(range(len(means))) if len(means) <= _MOST_LABELS else picks
    labels = _scene_labels(inside, view, rollouts, means, goal, named)
    labels += draw_people_beyond(inside, view, scene)
    standing = view.to_pixels([*scene.starts, scene.robot.start])
    seen = np.concatenate([means.reshape(-1, 2), standing])
    draw_labels(inside, labels, panel.inset(4 * unit), theme.panel, seen)
    baseline = panel.bottom + 1.2 * small
    room = draw_scale_bar(canvas, view, box.right, baseline) - small - box.left
    for wordings in _captions(rollouts):
        canvas.fit((box.left, baseline), wordings, room, small, theme.faint, line="base")
        baseline, room = baseline + 1.3 * small, box.width
    return view


def _draw_walks(canvas: Canvas, view: View, rollouts: Rollouts, pen: float) -> None:
    """Draw where people walk beside the robot, under every action."""
    grey, count = blend(canvas.theme.pedestrian, canvas.theme.panel, 0.8), _walks_shown(rollouts)
    opacity = 0.6 * overlap_opacity(count * len(rollouts.actions))
    walks = rollouts.pedestrians[:, :count].swapaxes(2, 3).reshape(-1, rollouts.steps + 1, 2)
    draw_faint_paths(canvas, view.to_pixels(walks), grey, pen, opacity)


def _walks_shown(rollouts: Rollouts) -> int:
    """In how many rollouts of each action the walks of a crowd are shown."""
    walks = len(rollouts.actions) * max(len(rollouts.scene.pedestrians), 1)
    return min(rollouts.paths, max(_MOST_WALKS // walks, 10))


def _scene_labels(
    canvas: Canvas, view: View, rollouts: Rollouts, means: FloatArray, goal: Point, named: set[int]
) -> list[Label]:
    """Names of the robot, its goal and the named actions, the actions at their means' ends."""
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
        path, name = means[index], rollouts.names[index]
        words = canvas.abbreviated(action_label(name), view.box.width / 4, body, SEMIBOLD)
        ink = theme.legible(theme.action_colour(name))
        x, y = path[-1].tolist()
        dx, dy = path[-1] - path[-min(6, len(path))]
        # below where the robot hardly moves
        direction = (dx, dy) if math.hypot(dx, dy) > 2 * unit else (0.0, 1.0)
        labels.append(Label(words, body, SEMIBOLD, ink, (x, y), 9 * unit, direction))
    return labels


def caption_height(canvas: Canvas, rollouts: Rollouts) -> float:
    """Height of the lines below the scene, px."""
    return (0.2 + 1.3 * len(_captions(rollouts))) * canvas.type.small


def _captions(rollouts: Rollouts) -> list[list[str]]:
    """What the marks in the scene mean: for each line its wordings, the longest first."""
    count, kept = rollouts.count, rollouts.paths
    sample = f"a sample, {kept} of {count} rollouts"
    thin = "Thin: every rollout" if kept == count else f"Thin: {sample}"
    paths = [f"{thin} · bold: mean", thin]
    people = "Grey: people" if rollouts.scene.pedestrians else ""
    walks = people and f"{people} and their walks beside the robot"
    if walks and _walks_shown(rollouts) < kept:
        walks += f" in {_walks_shown(rollouts)} rollouts"
    groups = "joined: groups" if rollouts.scene.groups else ""
    touched = [
        told
        for told, who in (("× a person", rollouts.person_step), ("□ a wall", rollouts.wall_step))
        if (who >= 0).any()
    ]
    contact = f"touched: {', '.join(touched)}" if touched else ""
    brief = people and f"{people} and their walks"
    others = joined(
        (walks, groups, contact),
        (walks, contact),
        (brief, groups, contact),
        (brief, contact),
        (people, contact),
    )
    dashed = [f"Dashed: {told}" for told in true_walks_told(rollouts)]
    return [lines for lines in (paths, others, dashed) if any(lines)]
