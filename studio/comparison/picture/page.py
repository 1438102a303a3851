"""The page that lets a person compare two actions: the question, two sides, and what they share.

The film (`studio.comparison.picture.film`) fills the page outcome by outcome; the picture is the
page when all have been shown, and the film's last frame.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from scenes import Rollouts
from studio.comparison.comparison import QUESTION, SIDES, Comparison, ended_after
from studio.comparison.dots import DotMeasure, DotScale, dot_measures
from studio.comparison.picture.dots import DotPlot, IconArray, draw_dot_axis
from studio.comparison.picture.scene import OutcomeScene
from studio.comparison.words import contacts_in_detail, crowd_told, dots_told, marks_told
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.labels import label_boxes
from studio.painter.lettering import SEMIBOLD
from studio.painter.paths import draw_faint_paths
from studio.painter.quantile_dots import MOST_DOTS
from studio.painter.views import View
from studio.scene.measures import PERSON, WALL, contact_kinds
from studio.scene.picture.scenery import (
    draw_goal,
    draw_ground,
    draw_people,
    draw_people_beyond,
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

MOST_PLAYED = 300
"""Outcomes that move in the film, and leave their paths; recordings of today have fewer paths."""

# lengths in units of the page
_GAP, _PLOT_GAP = 48, 28  # between the sides, and between the dot plots of a side
_DOTS = 140  # height of the room for dots
_PITCH, _DOT_PITCH = 22, 13  # the largest distance from one icon to the next, and of dots


def compose_comparison_picture(
    comparison: Comparison, size: tuple[int, int] = SIZE, theme: Theme = LIGHT
) -> Canvas:
    """Draw the picture of a comparison: all outcomes of two actions, side by side.

    Raises:
        InputError: if the size is not allowed.
    """
    page = lay_out_comparison(comparison, size, theme)
    show = Show(page)
    show.keep(page.sample.paths)
    show.write(legends(page))
    show.draw_at_rest()
    return show.canvas


# The page

Legends = tuple[Sequence[str], Sequence[str]]
"""What is written below the left and the right scene, the longest wordings first."""


@dataclass(frozen=True)
class Plot:
    """The dots of a measure on both sides, and the room (px) that each side has for them."""

    measure: DotMeasure
    scale: DotScale
    rooms: tuple[Box, ...]


@dataclass(frozen=True)
class ComparisonPage:
    """What all frames share; views, notes, icons and counts have an entry a side."""

    rollouts: Rollouts  # under the names that are shown, all K of them
    sample: Rollouts  # those M of them whose paths are shown, as if there were no others
    canvas: Canvas  # with everything drawn that never changes
    views: tuple[View, ...]  # of the scene
    notes: tuple[Box, ...]  # above the scenes, where it is told if some outcome is a special one
    legends: tuple[Box, ...]  # the lines below the scenes
    icons: tuple[IconArray, ...]
    counts: tuple[Box, ...]  # where the number of contacts is told
    plots: tuple[Plot, ...]  # one a measure


def lay_out_comparison(
    comparison: Comparison, size: tuple[int, int], theme: Theme = LIGHT
) -> ComparisonPage:
    """Draw what all frames share; raises what `compose_comparison_picture` raises."""
    rollouts = comparison.shown.keep_paths(MOST_PLAYED)
    canvas = Canvas(*size, comparison.coloured(theme))
    kind, unit, page = canvas.type, canvas.unit, canvas.page
    # as high as the title that is written once the view is known
    title = canvas.text_box((page.left, page.top), "", kind.title, line="top")
    top = title.bottom + 14 * unit
    columns = Box(page.left, top, page.right, page.bottom).columns([1.0, 1.0], _GAP * unit)
    head, line = 1.9 * kind.heading, 1.7 * kind.small
    icon_height = max(2 * _PITCH * unit, 1.2 * kind.heading + 1.3 * kind.small)
    dots_bottom = page.bottom - 2.4 * kind.small - 6 * unit
    dots_top = dots_bottom - _DOTS * unit
    icons_bottom = dots_top - 16 * unit
    icons_top = icons_bottom - icon_height
    scene_bottom = icons_top - line - 10 * unit

    count = rollouts.count
    views, notes, icons, counts = [], [], [], []
    widest = canvas.measure(contacts_told(count, count, count), kind.heading, SEMIBOLD)
    room = max(widest, 0.36 * columns[0].width) + 16 * unit
    for side, column in enumerate(columns):
        named = _draw_head(
            canvas, Box(column.left, top, column.right, top + head), comparison, side
        )
        notes.append(Box(named + 2 * kind.heading, top, column.right, top + head))
        views.append(view_of(rollouts, Box(column.left, top + head, column.right, scene_bottom)))
        _draw_scenery(canvas, views[side], rollouts)
        band = Box(column.left, icons_top, column.right - room, icons_bottom)
        icons.append(IconArray.fit(band, count, _PITCH * unit))
        left = icons[side].box.right + 12 * unit
        counts.append(Box(left, icons_top, column.right, icons_bottom))
    _draw_title(canvas, rollouts, views[0])
    bar = draw_scale_bar(canvas, views[1], page.right, scene_bottom + 1.25 * kind.small)
    legends = tuple(
        Box(column.left, scene_bottom, right, scene_bottom + line)
        for column, right in zip(columns, (columns[0].right, bar - kind.small), strict=True)
    )
    dots = tuple(Box(column.left, dots_top, column.right, dots_bottom) for column in columns)
    plots, sample = _draw_plots(canvas, dots, rollouts), rollouts.with_paths()
    places = tuple(views), tuple(notes), legends, tuple(icons), tuple(counts)
    return ComparisonPage(rollouts, sample, canvas, *places, plots)


def _draw_title(canvas: Canvas, rollouts: Rollouts, view: View) -> None:
    """Ask the question, and say what is seen, along the top of the page."""
    outcomes = f"{counted(rollouts.count, 'outcome')} of each, the next {rollouts.horizon:g} s"
    people = crowd_told(rollouts.scene, view.bounds)
    luck = "same people and same luck on both sides"
    told = joined(
        (rollouts.scene.name, outcomes, people, luck),
        (outcomes, people, luck),
        (outcomes, people),
        (people,) if people else (outcomes,),
    )
    size = canvas.type.title
    draw_heading_in_line(canvas, [QUESTION], told, size, 0.1 * size)


def _draw_head(canvas: Canvas, box: Box, comparison: Comparison, side: int) -> float:
    """Name a side, and its action unless that is not to be told; returns where it ends, px."""
    kind, theme, name = canvas.type, canvas.theme, comparison.shown.names[side]
    colour = theme.action_colour(name)
    tall = 1.5 * kind.heading
    badge = Box(box.left, box.top, box.left + tall, box.top + tall)
    canvas.rounded(badge, 0.2 * tall, colour)
    paper = theme.ink_on(colour)
    canvas.text(badge.centre, SIDES[side], kind.heading, paper, SEMIBOLD, anchor="centre")
    if not comparison.named:
        return badge.right
    left = badge.right + 0.5 * kind.heading
    at, room, ink = (left, badge.centre[1]), 0.5 * box.width, theme.legible(colour)
    words = canvas.abbreviated(action_label(name), room, kind.heading, SEMIBOLD)
    return canvas.text(at, words, kind.heading, ink, SEMIBOLD).right


def _draw_scenery(canvas: Canvas, view: View, rollouts: Rollouts) -> None:
    """Draw what does not move in a scene, but for the goal itself, which lies above people."""
    inside = canvas.clipped(view.box)
    draw_ground(inside, view)
    draw_walls(inside, view, rollouts.scene)
    beyond = draw_people_beyond(inside, view, rollouts.scene)
    # where little of what comes will lie, on either side
    busy, paths = inside.copy(), view.to_pixels(np.concatenate(rollouts.robot))
    draw_faint_paths(busy, paths, canvas.theme.ink, 2 * canvas.unit, 0.5)
    draw_people(busy, view, rollouts.scene.starts)
    goal = draw_goal(busy, view, rollouts.scene.robot.goal)
    labels = [goal_label(canvas, goal, (1.0, 0.0)), *beyond]
    area, ground = view.box.inset(4 * canvas.unit), canvas.theme.panel
    for label, box in zip(labels, label_boxes(labels, busy, area, ground), strict=True):
        if box is not None:
            letters = label.text, label.size, label.colour, label.weight
            inside.text(box.centre, *letters, anchor="centre", halo=ground)


def _draw_plots(canvas: Canvas, sides: tuple[Box, ...], rollouts: Rollouts) -> tuple[Plot, ...]:
    """Draw the axes of the measures, side by side on each side."""
    shown, plots = dot_measures(rollouts), []
    rooms = [side.columns([1.0] * len(shown), _PLOT_GAP * canvas.unit) for side in sides]
    room = rooms[0][0]
    scales = DotScale.fit_all(shown, room.width, room.height, _DOT_PITCH * canvas.unit)
    for measure, scale, both in zip(shown, scales, zip(*rooms, strict=True), strict=True):
        for room in both:
            draw_dot_axis(canvas, room, measure)
        plots.append(Plot(measure, scale, both))
    return tuple(plots)


def legends(page: ComparisonPage) -> Legends:
    """What the marks in the picture mean, the longest wording first."""
    rollouts, sample = page.rollouts, page.sample.count
    people = "grey: people and their paths" if rollouts.scene.pedestrians else ""
    thin = "thin: the robot's paths"
    if sample < rollouts.count:
        thin += f", a sample of {sample}"
    dots, touched = dots_told(rollouts.count, MOST_DOTS), marks_told(rollouts)
    return joined((thin, people), (thin,)), joined((dots, touched), (touched or dots,))


# What changes


class Show:
    """A page on which outcomes appear; its canvas looks as the page does now."""

    def __init__(self, page: ComparisonPage) -> None:
        self.canvas, self._page = page.canvas.copy(), page
        theme = page.canvas.theme
        self._kinds = contact_kinds(page.rollouts)  # (2, K)
        self._colours = [theme.action_colour(name) for name in page.rollouts.names]
        self._scenes = [
            OutcomeScene(self.canvas.clipped(view.box), view, page.sample, side)
            for side, view in enumerate(page.views)
        ]
        self._plots = [
            [
                DotPlot(plot.rooms[side], plot.scale, side, plot.measure.dots[side])
                for plot in page.plots
            ]
            for side in range(len(SIDES))
        ]
        self._counts: list[tuple[str, Sequence[str]]] = [("", ())] * len(SIDES)

    def keep(self, paths: int) -> None:
        """Leave the first `paths` of the sample behind, and count what has come to its end."""
        canvas, page = self.canvas, self._page
        ended, total = int(ended_after(page.rollouts)[paths]), page.rollouts.count
        for side, colour in enumerate(self._colours):
            self._scenes[side].keep(paths)
            kinds = self._kinds[side, :ended]
            people, walls = int((kinds == PERSON).sum()), int((kinds == WALL).sum())
            page.icons[side].draw(canvas, people, walls, ended - people - walls, colour)
            for plot in self._plots[side]:
                plot.draw(canvas, ended, colour)
            detail = contacts_in_detail(people, walls, total) if ended == total else ()
            self._counts[side] = contacts_told(people + walls, ended, total), detail

    def write(self, legends: Legends, notes: Sequence[str] = ("", "")) -> None:
        """Write how many outcomes had contact, the legends, and a note on each side."""
        canvas, page, kind = self.canvas, self._page, self.canvas.type
        canvas.texts[:] = page.canvas.texts
        faint, ink = canvas.theme.faint, canvas.theme.ink
        for box, (told, detail) in zip(page.counts, self._counts, strict=True):
            canvas.restore(page.canvas, box)
            shade = faint if told.startswith("0 ") else canvas.theme.legible(canvas.theme.contact)
            middle = box.centre[1] - (0.65 * kind.small if detail else 0.0)
            canvas.text((box.left, middle), told, kind.heading, shade, SEMIBOLD)
            if detail:
                at = (box.left, middle + 0.6 * kind.heading + 0.65 * kind.small)
                canvas.fit(at, detail, box.width, kind.small, faint)
        for box, note in zip(page.notes, notes, strict=True):
            canvas.restore(page.canvas, box)
            at = (box.right, box.top + 0.75 * kind.heading)
            canvas.fit(at, note, box.width, kind.heading, ink, SEMIBOLD, anchor="right")
        for box, wordings in zip(page.legends, legends, strict=True):
            canvas.restore(page.canvas, box)
            at = (box.left, box.top + 1.25 * kind.small)
            canvas.fit(at, wordings, box.width, kind.small, faint, line="base")

    def draw_at_rest(self) -> None:
        """Draw both scenes with everybody where the scene has them at the start."""
        for scene in self._scenes:
            scene.draw_at_rest()

    def fade(self) -> None:
        """Let the paths that were left behind step back, for one outcome to be seen before them."""
        for scene in self._scenes:
            scene.fade()

    def draw_outcomes(self, outcomes: Sequence[int], step: float) -> None:
        """Draw both scenes, each with one outcome of its own at a step."""
        for scene, outcome in zip(self._scenes, outcomes, strict=True):
            scene.draw_outcome(outcome, step)
