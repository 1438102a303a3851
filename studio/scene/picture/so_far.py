"""The column beside the scene in motion: what an action has led to so far."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from scenes import Rollouts
from studio.arrays import FloatArray, IntArray
from studio.painter.axes import Axis, axis_with_ticks
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.lettering import SEMIBOLD
from studio.painter.marks import Histogram, draw_histogram, draw_icons
from studio.scene.certainty import wilson
from studio.scene.measures import (
    NOTHING,
    PERSON,
    WALL,
    gap_over_time,
    progress_over_time,
    touched_by,
)
from studio.scene.picture.crowd import between
from studio.style.palette import Colour, blend
from studio.style.ticks import round_range, ticks
from studio.style.words import action_label, number, share_told

_BINS = 24  # of a histogram
_WIDEST_GAP = 2.0  # m; wider gaps count as this


@dataclass(frozen=True)
class Course:
    """How a measure develops in every rollout, and the one scale on which all actions show it."""

    titles: tuple[str, ...]  # what is measured, with its unit, the longest wording first
    values: FloatArray  # [A, K, T+1]
    edges: FloatArray  # [B + 1], ends of the bins
    most: int  # how many rollouts the highest bar of a histogram stands for

    @classmethod
    def of(cls, titles: tuple[str, ...], values: FloatArray, ends: tuple[float, float]) -> "Course":
        """On a scale of counts that holds the end of every action."""
        edges = np.linspace(*ends, _BINS + 1)
        kinds = np.zeros(values.shape[1], np.int64)
        return cls(
            titles,
            values,
            edges,
            max(Histogram.of(own[:, -1], edges, kinds).highest for own in values),
        )


def courses(rollouts: Rollouts) -> tuple[Course, Course]:
    """The two measures that develop beside the scene in motion: smallest gap, and progress."""
    gap = np.clip(gap_over_time(rollouts), 0.0, _WIDEST_GAP)
    smallest = np.minimum.accumulate(gap, axis=-1)
    gained = progress_over_time(rollouts)
    ends = round_range(float(gained.min()), float(gained.max()))
    gap_titles = ("Smallest gap to a person so far, m", "Smallest gap so far, m")
    return (
        Course.of(gap_titles, smallest, (0.0, _WIDEST_GAP)),
        Course.of(("Progress so far, m",), gained, ends),
    )


class OutcomesSoFar:
    """The column beside the scene: what the rollouts of one action have led to so far."""

    def __init__(
        self, canvas: Canvas, box: Box, rollouts: Rollouts, index: int, shown: Sequence[Course]
    ) -> None:
        """Take all rollouts; those whose paths are kept are counted while they move."""
        self._canvas, count = canvas, rollouts.paths
        self._colour = canvas.theme.action_colour(rollouts.names[index])
        every = {"person": rollouts.person_step[index], "wall": rollouts.wall_step[index]}
        self._steps = {thing: steps[:count] for thing, steps in every.items()}
        self._ends = {thing: _end_told(thing, steps, count) for thing, steps in every.items()}
        self._last = rollouts.steps
        kind, unit, action = canvas.type, canvas.unit, rollouts.actions[index]
        at, name = (box.left, box.top), action_label(action.name)
        ink = canvas.theme.legible(self._colour)
        title = canvas.fit(at, name, box.width, kind.title, ink, SEMIBOLD, line="top")
        driven, turned = (number(given, ".3g") for given in (action.speed, action.turn_rate))
        command = [f"{driven} m/s, turning {turned} rad/s", f"{driven} m/s, {turned} rad/s"]
        at, faint = (box.left, title.bottom + 4 * unit), canvas.theme.faint
        below = canvas.fit(at, command, box.width, kind.body, faint, line="top")
        rest = Box(box.left, below.bottom + 18 * unit, box.right, box.bottom)
        contact, *plots = rest.rows((1.25, *[1.0] * len(shown)), 16 * unit)
        height = 1.25 * kind.title + 1.3 * kind.body
        counts = Box(contact.left, contact.top, contact.right, contact.top + height)
        self._counts = counts
        self._icons = Box(
            contact.left, counts.bottom + 0.4 * kind.body, contact.right, contact.bottom
        )
        things = list(self._steps) if rollouts.wall_touched.any() else ["person"]
        self._cells = dict(zip(things, counts.columns([1.0] * len(things), 12 * unit), strict=True))
        self._plots = [
            _MovingHistogram(canvas, plot, course, index)
            for plot, course in zip(plots, shown, strict=True)
        ]
        self._drawn = (-1, -1)

    def draw(self, still: Canvas, step: float) -> None:
        """Draw what has happened up to a step."""
        canvas, count = self._canvas, len(self._steps["person"])
        people, walls = (touched_by(steps, step) for steps in self._steps.values())
        touched = {"person": int(people.sum()), "wall": int(walls.sum())}
        canvas.restore(still, self._counts.inset(-0.15 * canvas.type.title))
        for thing, cell in self._cells.items():
            self._draw_count(cell, thing, touched[thing], count, step >= self._last)
        drawn = touched["person"], int((walls & ~people).sum())
        if drawn != self._drawn:
            canvas.restore(still, self._icons.inset(-2 * canvas.unit))
            faint = blend(self._colour, canvas.theme.ground, 0.45)
            draw_icons(canvas, self._icons, *drawn, count, faint)
            self._drawn = drawn
        kinds = np.where(people, PERSON, np.where(walls, WALL, NOTHING))
        for plot in self._plots:
            plot.draw(canvas, still, step, self._colour, kinds)

    def _draw_count(self, cell: Box, thing: str, touched: int, count: int, ended: bool) -> None:
        """Write in how many rollouts a thing was touched; in the end, how sure the share is."""
        canvas, theme, kind = self._canvas, self._canvas.theme, self._canvas.type
        ink = theme.contact if touched else theme.faint
        counts, at = [f"{touched} of {count}", f"{touched}"], (cell.left, cell.top)
        placed = canvas.fit(at, counts, cell.width, kind.title, ink, SEMIBOLD, line="top")
        told = [f"touch a {thing} so far", f"a {thing} so far", f"a {thing}"]
        if ended:
            told = self._ends[thing]
        at = (cell.left, placed.bottom)
        canvas.fit(at, told, cell.width, kind.body, theme.ink, line="top")


def _end_told(thing: str, steps: IntArray, shown: int) -> list[str]:
    """In what share of all rollouts a thing was touched in the end, the longest wording first.

    The steps [K] are those of all rollouts, of which a sample may be shown.
    """
    share = wilson(int((steps >= 0).sum()), len(steps))
    told = share_told(share.value, share.low, share.high)
    every = f" of all {len(steps)}" if shown < len(steps) else ""
    return [f"a {thing}: {told}{every}", f"a {thing}: {told}", told]


class _MovingHistogram:
    """How a measure is distributed at one step after the other, on scales that stay."""

    def __init__(self, canvas: Canvas, box: Box, course: Course, index: int) -> None:
        kind, unit, at = canvas.type, canvas.unit, (box.left, box.top)
        scale = f"{course.most}"
        room = box.width - canvas.measure(f"↕ {scale}", kind.small) - 8 * unit
        canvas.fit(at, course.titles, room, kind.body, canvas.theme.ink, SEMIBOLD, line="top")
        floor = box.bottom - 2.1 * kind.small
        self._axis = Axis(float(course.edges[0]), float(course.edges[-1]), box.left, box.right)
        self._plot = Box(box.left, box.top + 1.4 * kind.body, box.right, floor)
        self._values, self._edges, self._most = course.values[index], course.edges, course.most
        marks = ticks(self._axis.low, self._axis.high, 4)
        axis_with_ticks(canvas, self._axis, floor, marks)
        # how many rollouts a bar as high as the plot stands for
        top, faint = self._plot.top, canvas.theme.faint
        canvas.fill(Box(box.right - 8 * unit, top, box.right, top + canvas.hair), faint)
        at = (box.right, box.top)
        canvas.text(at, scale, kind.small, faint, anchor="right", line="top")

    def draw(
        self, canvas: Canvas, still: Canvas, step: float, colour: Colour, kinds: IntArray
    ) -> None:
        """Draw the distribution at a step; kinds [K] are what rollouts have touched by then."""
        canvas.restore(still, self._plot.inset(-5 * canvas.unit))
        histogram = Histogram.of(between(self._values, step), self._edges, kinds)
        draw_histogram(canvas, self._plot, self._axis, histogram, self._most, colour)
