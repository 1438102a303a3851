"""The page that lets a person compare two actions: the question, two sides, and what they share.

The film (`studio.comparison.picture.film`) fills the page outcome by outcome; the picture is the
page when all have been shown, and the film's last frame.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from scenes import Rollouts
from studio.comparison.comparison import QUESTION, SIDES, Comparison
from studio.comparison.dots import DotMeasure, DotScale, dot_measures
from studio.comparison.picture.dots import DotPlot, IconArray, draw_dot_axis, has_dots
from studio.comparison.picture.scene import OutcomeScene
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.labels import label_boxes
from studio.painter.lettering import SEMIBOLD
from studio.painter.paths import draw_faint_paths
from studio.painter.views import View
from studio.scene.picture.scenery import (
    draw_goal,
    draw_ground,
    draw_people,
    draw_scale_bar,
    draw_walls,
    goal_label,
    view_of,
)
from studio.scene.picture.titles import draw_heading_in_line, joined
from studio.style.palette import LIGHT, Theme
from studio.style.words import action_label, contacts_told, counted

SIZE = (1600, 900)
"""Width and height of the picture unless one asks for others, px."""

# lengths in units of the page
_GAP = 48  # between the sides
_DOTS = 150  # height of the room for dots
_PITCH, _DOT_PITCH = 22, 15  # the largest distance from one icon to the next, and of dots


def compose_comparison_picture(
    comparison: Comparison, size: tuple[int, int] = SIZE, theme: Theme = LIGHT
) -> Canvas:
    """Draw the picture of a comparison: all outcomes of two actions, side by side.

    Raises:
        InputError: if the size is not allowed.
    """
    page = lay_out_comparison(comparison, size, theme)
    show = Show(page)
    show.keep(comparison.rollouts.count)
    show.write(legends(page))
    show.draw_at_rest()
    return show.canvas


# The page


@dataclass(frozen=True)
class Plot:
    """The dots of a measure on both sides, and the room (px) that each side has for them."""

    measure: DotMeasure
    scale: DotScale
    rooms: tuple[Box, ...]


@dataclass(frozen=True)
class ComparisonPage:
    """What all frames share; views, icons and counts have an entry a side."""

    comparison: Comparison
    canvas: Canvas  # with everything drawn that never changes
    views: tuple[View, ...]  # of the scene
    legend: Box  # the line below the scenes
    icons: tuple[IconArray, ...]
    counts: tuple[Box, ...]  # where the number of contacts is told
    plots: tuple[Plot, ...]  # one a measure


def lay_out_comparison(
    comparison: Comparison, size: tuple[int, int], theme: Theme = LIGHT
) -> ComparisonPage:
    """Draw what all frames share; raises what `compose_comparison_picture` raises."""
    rollouts = comparison.rollouts
    canvas = Canvas(*size, theme.of(comparison.actions))
    kind, unit, page = canvas.type, canvas.unit, canvas.page
    top = _draw_title(canvas, rollouts) + 14 * unit
    columns = Box(page.left, top, page.right, page.bottom).columns([1.0, 1.0], _GAP * unit)
    head, line = 1.9 * kind.heading, 1.7 * kind.small
    icon_height = max(2 * _PITCH * unit, 1.5 * kind.heading)
    dots_bottom = page.bottom - 2.4 * kind.small - 5 * unit
    dots_top = dots_bottom - _DOTS * unit
    icons_bottom = dots_top - 16 * unit
    icons_top = icons_bottom - icon_height
    scene_bottom = icons_top - line - 10 * unit

    count = rollouts.count
    views, icons, counts = [], [], []
    room = canvas.measure(contacts_told(count, count, count), kind.heading, SEMIBOLD) + 16 * unit
    for side, column in enumerate(columns):
        _draw_head(canvas, Box(column.left, top, column.right, top + head), rollouts, side)
        views.append(view_of(rollouts, Box(column.left, top + head, column.right, scene_bottom)))
        _draw_scenery(canvas, views[side], rollouts)
        band = Box(column.left, icons_top, column.right - room, icons_bottom)
        icons.append(IconArray.fit(band, count, _PITCH * unit))
        left = icons[side].box.right + 12 * unit
        counts.append(Box(left, icons_top, column.right, icons_bottom))
    legend = Box(page.left, scene_bottom, columns[0].right, scene_bottom + line)
    draw_scale_bar(canvas, views[1], page.right, scene_bottom + 1.25 * kind.small)
    dots = tuple(Box(column.left, dots_top, column.right, dots_bottom) for column in columns)
    plots = _draw_plots(canvas, dots, rollouts)
    return ComparisonPage(
        comparison, canvas, tuple(views), legend, tuple(icons), tuple(counts), plots
    )


def _draw_title(canvas: Canvas, rollouts: Rollouts) -> float:
    """Ask the question, and say what is seen, along the top of the page; returns where it ends."""
    outcomes = f"{counted(rollouts.count, 'outcome')} of each, the next {rollouts.horizon:g} s"
    luck = "same people and same luck on both sides"
    told = joined((rollouts.scene.name, outcomes, luck), (outcomes, luck), (outcomes,))
    size = canvas.type.title
    return draw_heading_in_line(canvas, [QUESTION], told, size, 0.1 * size).bottom


def _draw_head(canvas: Canvas, box: Box, rollouts: Rollouts, side: int) -> None:
    """Name a side and its action."""
    kind, theme, name = canvas.type, canvas.theme, rollouts.names[side]
    colour = theme.action_colour(name)
    tall = 1.5 * kind.heading
    badge = Box(box.left, box.top, box.left + tall, box.top + tall)
    canvas.rounded(badge, 0.2 * tall, colour)
    paper = theme.ink_on(colour)
    canvas.text(badge.centre, SIDES[side], kind.heading, paper, SEMIBOLD, anchor="centre")
    left = badge.right + 0.5 * kind.heading
    at, room, ink = (left, badge.centre[1]), box.right - left, theme.legible(colour)
    canvas.fit(at, action_label(name), room, kind.heading, ink, SEMIBOLD)


def _draw_scenery(canvas: Canvas, view: View, rollouts: Rollouts) -> None:
    """Draw what does not move in a scene, but for the goal itself, which lies above people."""
    inside = canvas.clipped(view.box)
    draw_ground(inside, view)
    draw_walls(inside, view, rollouts.scene)
    # where little of what comes will lie, on either side
    busy, paths = inside.copy(), view.to_pixels(np.concatenate(rollouts.robot))
    draw_faint_paths(busy, paths, canvas.theme.ink, 2 * canvas.unit, 0.5)
    draw_people(busy, view, rollouts.scene.starts)
    goal = draw_goal(busy, view, rollouts.scene.robot.goal)
    label = goal_label(canvas, goal, (1.0, 0.0))
    [box] = label_boxes([label], busy, view.box.inset(4 * canvas.unit), canvas.theme.panel)
    if box is not None:
        inside.text(box.centre, label.text, label.size, label.colour, anchor="centre")


def _draw_plots(canvas: Canvas, sides: tuple[Box, ...], rollouts: Rollouts) -> tuple[Plot, ...]:
    """Draw the axes of the measures, side by side on each side."""
    shown, plots = dot_measures(rollouts), []
    rooms = [side.columns([1.0] * len(shown), _GAP * canvas.unit) for side in sides]
    room = rooms[0][0]
    scales = DotScale.fit_all(shown, room.width, room.height, _DOT_PITCH * canvas.unit)
    for measure, scale, both in zip(shown, scales, zip(*rooms, strict=True), strict=True):
        for room in both:
            draw_dot_axis(canvas, room, measure)
        plots.append(Plot(measure, scale, both))
    return tuple(plots)


def legends(page: ComparisonPage) -> list[str]:
    """What the marks in the picture mean, the longest wording first."""
    rollouts = page.comparison.rollouts
    people = "grey: people and their paths" if rollouts.scene.pedestrians else ""
    told_apart = all(has_dots(plot.scale) for plot in page.plots)
    dots = "a dot: one outcome" if told_apart else ""
    red = "red: contact" if rollouts.touched.any() else ""
    thin = "Thin: the robot's paths"
    return joined((thin, people, dots, red), (thin, dots, red), ("Thin: paths", red))


# What changes


class Show:
    """A page on which outcomes appear; its canvas looks as the page does now."""

    def __init__(self, page: ComparisonPage) -> None:
        self.canvas, self._page = page.canvas.copy(), page
        rollouts, theme = page.comparison.rollouts, page.canvas.theme
        self._contact = rollouts.touched  # (2, K)
        self._colours = [theme.action_colour(name) for name in rollouts.names]
        self._scenes = [
            OutcomeScene(self.canvas.clipped(view.box), view, rollouts, side)
            for side, view in enumerate(page.views)
        ]
        self._plots = [
            [DotPlot(plot.rooms[side], plot.scale, side, contact) for plot in page.plots]
            for side, contact in enumerate(self._contact)
        ]
        self._counts = ["", ""]

    def keep(self, count: int) -> None:
        """Count the first `count` outcomes and leave their paths behind."""
        canvas, total = self.canvas, self._contact.shape[1]
        for side, colour in enumerate(self._colours):
            self._scenes[side].keep(count)
            touched = int(self._contact[side, :count].sum())
            self._page.icons[side].draw(canvas, touched, count - touched, colour)
            for plot in self._plots[side]:
                plot.draw(canvas, count, colour)
            self._counts[side] = contacts_told(touched, count, total)

    def write(self, legends: Sequence[str]) -> None:
        """Write how many outcomes had contact, and a legend, the longest wording first."""
        canvas, page, kind = self.canvas, self._page, self.canvas.type
        canvas.texts[:] = page.canvas.texts
        for box, told in zip(page.counts, self._counts, strict=True):
            canvas.restore(page.canvas, box)
            ink = canvas.theme.faint if told.startswith("0 ") else canvas.theme.contact
            canvas.text((box.left, box.centre[1]), told, kind.heading, ink, SEMIBOLD)
        canvas.restore(page.canvas, page.legend)
        at, room = (page.legend.left, page.legend.top + 1.25 * kind.small), page.legend.width
        canvas.fit(at, legends, room, kind.small, canvas.theme.faint, line="base")

    def draw_at_rest(self) -> None:
        """Draw both scenes with everybody where the scene has them at the start."""
        for scene in self._scenes:
            scene.draw_at_rest()

    def draw_outcome(self, outcome: int, step: float) -> None:
        """Draw both scenes with one outcome at a step."""
        for scene in self._scenes:
            scene.draw_outcome(outcome, step)
