"""The column beside the scene in motion: what an action has led to so far."""

import numpy as np

from scenes import Rollouts
from studio.arrays import BoolArray, FloatArray
from studio.painter.axes import Axis, draw_ticks
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.lettering import SEMIBOLD
from studio.painter.marks import draw_histogram, draw_icons
from studio.scene.measures import gap_over_time, progress_over_time, touched_by
from studio.scene.picture.crowd import between
from studio.scene.picture.titles import contacts_counted
from studio.style.palette import Colour, blend
from studio.style.ticks import round_range, ticks
from studio.style.words import action_label, number

_BINS = 24  # of a histogram
_WIDEST_GAP = 2.0  # m; wider gaps count as this


class OutcomesSoFar:
    """The column beside the scene: what the rollouts of one action have led to so far."""

    def __init__(self, canvas: Canvas, box: Box, rollouts: Rollouts, index: int) -> None:
        self._canvas = canvas
        self._colour = canvas.theme.action_colour(rollouts.names[index])
        self._contact_step = rollouts.contact_step[index]
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
        contact, gap, progress = rest.rows((1.25, 1, 1), 16 * unit)
        self._count = Box(contact.left, contact.top, contact.right, contact.top + 1.6 * kind.title)
        icons_top = self._count.bottom + 0.2 * kind.title
        self._icons = Box(contact.left, icons_top, contact.right, contact.bottom)
        smallest = np.clip(gap_over_time(rollouts)[index], 0.0, _WIDEST_GAP)
        smallest = np.minimum.accumulate(smallest, axis=-1)
        gained = progress_over_time(rollouts)
        # the same axis for all actions
        ends = round_range(float(gained.min()), float(gained.max()))
        gap_titles = ["Smallest gap to a person so far, m", "Smallest gap so far, m"]
        self._plots = (
            _MovingHistogram(canvas, gap, gap_titles, smallest, (0.0, _WIDEST_GAP)),
            _MovingHistogram(canvas, progress, ["Progress so far, m"], gained[index], ends),
        )
        self._touched = -1

    def draw(self, still: Canvas, step: float) -> None:
        """Draw what has happened up to a step."""
        canvas, theme, box = self._canvas, self._canvas.theme, self._count
        size, count = canvas.type.title, len(self._contact_step)
        contact = touched_by(self._contact_step, step)
        touched, so_far = int(contact.sum()), " so far" if step < self._last else ""
        canvas.restore(still, box.inset(-0.15 * size))
        at, told = (box.left, box.top), contacts_counted(touched, count, so_far)
        ink = theme.contact if touched else theme.faint
        canvas.fit(at, told, box.width, size, ink, SEMIBOLD, line="top")
        if touched != self._touched:
            canvas.restore(still, self._icons)
            faint = blend(self._colour, theme.ground, 0.45)
            draw_icons(canvas, self._icons, touched, count, faint)
            self._touched = touched
        for plot in self._plots:
            plot.draw(canvas, still, step, self._colour, contact)


class _MovingHistogram:
    """How values [K, T+1] are distributed at one step after the other, on an axis that stays."""

    def __init__(
        self,
        canvas: Canvas,
        box: Box,
        titles: list[str],
        values: FloatArray,
        ends: tuple[float, float],
    ) -> None:
        kind, unit, at = canvas.type, canvas.unit, (box.left, box.top)
        canvas.fit(at, titles, box.width, kind.body, canvas.theme.ink, SEMIBOLD, line="top")
        floor = box.bottom - 1.8 * kind.small
        self._axis = Axis(*ends, box.left, box.right)
        self._plot = Box(box.left, box.top + 1.4 * kind.body, box.right, floor)
        self._values, self._edges = values, np.linspace(*ends, _BINS + 1)
        canvas.fill(Box(box.left, floor, box.right, floor + canvas.hair), canvas.theme.grid)
        draw_ticks(canvas, self._axis, floor + 8 * unit, ticks(*ends, 4))

    def draw(
        self, canvas: Canvas, still: Canvas, step: float, colour: Colour, contact: BoolArray
    ) -> None:
        """Draw the distribution at a step; contact [K] are the rollouts in contact by then."""
        canvas.restore(still, self._plot.inset(-5 * canvas.unit))
        values = between(self._values, step)
        draw_histogram(canvas, self._plot, self._axis, values, self._edges, colour, contact)
