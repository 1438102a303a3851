"""The column beside the scene in motion: what an action has led to so far."""

import numpy as np
from numpy.typing import NDArray

from scenes import Rollouts
from scenes.scene import PEDESTRIAN_RADIUS, ROBOT_RADIUS
from studio.arrays import FloatArray
from studio.painter.axes import Axis, draw_ticks
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.lettering import SEMIBOLD
from studio.painter.marks import draw_histogram, draw_icons
from studio.scene.picture.crowd import between
from studio.style.palette import Colour, blend
from studio.style.ticks import round_range, ticks
from studio.style.words import action_label, number

_BINS = 24


class Side:
    """The column beside the scene: what this action has led to so far."""

    def __init__(self, canvas: Canvas, box: Box, rollouts: Rollouts, index: int) -> None:
        self._canvas, self._colour = (
            canvas,
            canvas.theme.action_colour(rollouts.names[index]),
        )
        self._contact_step = rollouts.contact_step[index]
        self._last = rollouts.steps
        kind, unit, action = canvas.type, canvas.unit, rollouts.actions[index]
        name = canvas.fitted(action_label(action.name), box.width, kind.title, SEMIBOLD)
        title = canvas.text(
            (box.left, box.top),
            name,
            kind.title,
            canvas.theme.legible(self._colour),
            SEMIBOLD,
            line="top",
        )
        driven, turned = (number(given, ".3g") for given in (action.speed, action.turn_rate))
        command = [
            f"{driven} m/s, turning {turned} rad/s",
            f"{driven} m/s, {turned} rad/s",
        ]
        below = canvas.text(
            (box.left, title.bottom + 4 * unit),
            canvas.fitted(command, box.width, kind.body),
            kind.body,
            canvas.theme.faint,
            line="top",
        )
        rest = Box(box.left, below.bottom + 18 * unit, box.right, box.bottom)
        contact, gap, progress = rest.rows((1.25, 1, 1), 16 * unit)
        self._count = Box(contact.left, contact.top, contact.right, contact.top + 1.6 * kind.title)
        icons_top = self._count.bottom + 0.2 * kind.title
        self._icons = Box(contact.left, icons_top, contact.right, contact.bottom)
        self._plots = (
            _Running(canvas, gap, "Smallest gap to a person so far, m", *_gaps(rollouts, index)),
            _Running(canvas, progress, "Progress so far, m", *_progress(rollouts, index)),
        )
        self._touched = -1

    def draw(self, still: Canvas, step: float) -> None:
        """Draw what has happened up to a step."""
        canvas, kind, count = self._canvas, self._canvas.type, len(self._contact_step)
        contact = (self._contact_step >= 0) & (self._contact_step <= step)
        touched, so_far = int(contact.sum()), " so far" if step < self._last else ""
        canvas.restore(still, self._count.inset(-0.15 * kind.title))
        canvas.text(
            (self._count.left, self._count.top),
            canvas.fitted(
                [f"{touched} of {count} contact{so_far}", f"{touched} of {count}{so_far}"],
                self._count.width,
                kind.title,
                SEMIBOLD,
            ),
            kind.title,
            canvas.theme.contact if touched else canvas.theme.faint,
            SEMIBOLD,
            line="top",
        )
        if touched != self._touched:
            canvas.restore(still, self._icons)
            faint = blend(self._colour, canvas.theme.ground, 0.45)
            draw_icons(canvas, self._icons, touched, count, faint)
            self._touched = touched
        for plot in self._plots:
            plot.draw(canvas, still, step, self._colour, contact)


def _gaps(rollouts: Rollouts, index: int) -> tuple[FloatArray, float, float]:
    """Smallest gap up to each step, within 0 to 2 m [K, T+1], and the ends of its axis."""
    farthest = 2.0
    away = rollouts.pedestrians[index] - rollouts.robot[index, :, :, None, :2]
    gaps = np.linalg.norm(away, axis=-1) - (ROBOT_RADIUS + PEDESTRIAN_RADIUS)
    smallest = np.clip(gaps.min(axis=-1, initial=farthest), 0.0, farthest)
    return np.minimum.accumulate(smallest, axis=-1), 0.0, farthest


def _progress(rollouts: Rollouts, index: int) -> tuple[FloatArray, float, float]:
    """Progress up to each step [K, T+1], and the ends of its axis, the same for all actions."""
    to_goal = np.linalg.norm(rollouts.robot[..., :2] - rollouts.scene.robot.goal, axis=-1)
    progress = to_goal[..., :1] - to_goal
    return progress[index], *round_range(float(progress.min()), float(progress.max()))


class _Running:
    """A histogram that moves."""

    def __init__(
        self,
        canvas: Canvas,
        box: Box,
        title: str,
        values: FloatArray,
        low: float,
        high: float,
    ) -> None:
        kind, unit = canvas.type, canvas.unit
        canvas.text(
            (box.left, box.top),
            canvas.fitted(
                [title, title.replace(" to a person", "")], box.width, kind.body, SEMIBOLD
            ),
            kind.body,
            canvas.theme.ink,
            SEMIBOLD,
            line="top",
        )
        floor = box.bottom - 1.8 * kind.small
        self._axis = Axis(low, high, box.left, box.right)
        self._plot = Box(box.left, box.top + 1.4 * kind.body, box.right, floor)
        self._values, self._edges = values, np.linspace(low, high, _BINS + 1)
        canvas.fill(Box(box.left, floor, box.right, floor + canvas.hair), canvas.theme.grid)
        draw_ticks(canvas, self._axis, floor + 8 * unit, ticks(low, high, 4))

    def draw(
        self,
        canvas: Canvas,
        still: Canvas,
        step: float,
        colour: Colour,
        contact: NDArray[np.bool_],
    ) -> None:
        """Draw the distribution at a step."""
        canvas.restore(still, self._plot.inset(-5 * canvas.unit))
        values = between(self._values, step)
        draw_histogram(canvas, self._plot, self._axis, values, self._edges, colour, contact)
