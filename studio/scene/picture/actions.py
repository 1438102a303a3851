"""The picture's table of actions: one row each, with contacts, distributions and values."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from learners import PROFILES, REWARD
from scenes import FEATURES, Rollouts
from studio.arrays import FloatArray
from studio.painter.axes import Axis, draw_ticks
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.lettering import REGULAR, SEMIBOLD
from studio.painter.marks import draw_histogram, draw_icons, icon_pitch
from studio.scene.judgements import Judgement
from studio.scene.measures import Measure, measures
from studio.scene.picture.titles import joined
from studio.style.palette import Colour, blend
from studio.style.ticks import round_range, ticks
from studio.style.words import action_label, rounded_number, signed

_BINS = 24  # of a histogram
_NOTES = ["dot: mean · red: rollouts with contact", "dot: mean · red: with contact"]
_BY_CPT = ("cumulative prospect theory", "CPT")


def _bins(measure: Measure) -> tuple[FloatArray, list[float]]:
    """Edges of the bins of a histogram, from end to end of its axis, and the ticks below."""
    values = measure.values
    if measure.is_counted:
        most = max(2, round(float(values.max())))
        # bars as slim as a third of a bin, around the whole numbers
        edges = np.arange(-0.5, most + 0.51, 1 / 3)
        return edges, [mark for mark in ticks(0.0, most, 4) if mark.is_integer()]
    low, high = float(values.min()), float(values.max())
    if measure.feature in ("clearance", "deviation"):
        low, high = 0.0, max(high, 0.1)
    elif measure.feature == "smoothness":
        low, high = min(low, 0.9), 1.0
    low, high = round_range(low, high)
    return np.linspace(low, high, _BINS + 1), ticks(low, high, 3)


@dataclass(frozen=True)
class ActionTable:
    """Where the table of actions lies."""

    box: Box  # the whole table
    header: float  # height, px
    row: float  # height, px
    footer: float  # height of the line of ticks under the rows, px
    shown: int  # how many actions there is room for

    @classmethod
    def fit(cls, canvas: Canvas, space: Box, rollouts: Rollouts) -> "ActionTable":
        """Lay the table out at the bottom of the space, above which the scene needs room too."""
        kind, unit, count = canvas.type, canvas.unit, len(rollouts.actions)
        header, footer = 1.35 * kind.heading + 1.35 * kind.small, 1.7 * kind.small
        most = 0.52 * space.height - header - footer
        lowest, highest = 1.3 * kind.body, 32 * unit
        row = min(max(most / count, lowest), highest)
        shown = min(count, int(most / row + 1e-9))
        top = space.bottom - header - shown * row - footer
        if shown < count:
            shown -= 1  # the last line says how many are left out
        return cls(Box(space.left, top, space.right, space.bottom), header, row, footer, shown)

    def draw(self, canvas: Canvas, rollouts: Rollouts, judgements: Sequence[Judgement]) -> None:
        """Draw header, rows and ticks."""
        widths = (154, 162, *[140] * len(FEATURES), *[94] * len(judgements))
        name, contact, *cells = self.box.columns(widths, 24 * canvas.unit)
        room = contact.right - name.left
        self._draw_lines(canvas, len(rollouts.actions), room)
        self._note(canvas, name.left, _NOTES, room, "left")
        self._draw_names(canvas, name, rollouts)
        self._draw_contacts(canvas, contact, rollouts)
        for measure, worth, column in zip(measures(rollouts), REWARD, cells, strict=False):
            self._draw_measure(canvas, column, measure, worth, rollouts)
        room = self.box.right - cells[len(FEATURES) - 1].right
        self._note(canvas, self.box.right, _whose_values(judgements), room, "right")
        for judgement, column in zip(judgements, cells[len(FEATURES) :], strict=True):
            self._draw_judgement(canvas, column, judgement)

    def _note(
        self, canvas: Canvas, at: float, wordings: list[str], room: float, anchor: str
    ) -> None:
        """Write a note below the table, from its left or its right end on."""
        top = self.box.bottom - self.footer + 8 * canvas.unit
        size, faint = canvas.type.small, canvas.theme.faint
        canvas.fit((at, top), wordings, room, size, faint, anchor=anchor, line="top")

    def _rows(self, column: Box) -> list[Box]:
        """The cells of one column."""
        top = column.top + self.header
        return [
            Box(column.left, top + index * self.row, column.right, top + (index + 1) * self.row)
            for index in range(self.shown)
        ]

    def _coloured_rows(
        self, canvas: Canvas, column: Box, rollouts: Rollouts
    ) -> Iterator[tuple[int, Box, Colour]]:
        """The cells of one column with the index and the colour of their actions."""
        for index, row in enumerate(self._rows(column)):
            yield index, row, canvas.theme.action_colour(rollouts.names[index])

    def _draw_lines(self, canvas: Canvas, count: int, room: float) -> None:
        for row in self._rows(self.box):
            canvas.fill(Box(row.left, row.top, row.right, row.top + canvas.hair), canvas.theme.grid)
        if self.shown < count:
            top = self.box.top + self.header + self.shown * self.row
            left_out = f"and {count - self.shown} more actions"
            wordings = [f"{left_out} that there is no room for", left_out]
            at, faint = (self.box.left, top + self.row / 2), canvas.theme.faint
            canvas.fit(at, wordings, room, canvas.type.small, faint)

    def _head(self, canvas: Canvas, column: Box, title: str, below: str, colour: Colour) -> None:
        kind, width, at = canvas.type, column.width, (column.left, column.top)
        box = canvas.fit(at, title, width, kind.heading, colour, SEMIBOLD, line="top")
        at = (column.left, box.bottom + 1)
        canvas.fit(at, below, width, kind.small, canvas.theme.faint, line="top")

    def _draw_names(self, canvas: Canvas, column: Box, rollouts: Rollouts) -> None:
        unit, size = canvas.unit, canvas.type.body
        self._head(canvas, column, "Action", "", canvas.theme.ink)
        for index, row, colour in self._coloured_rows(canvas, column, rollouts):
            middle, name = row.centre[1], rollouts.names[index]
            canvas.disc((row.left + 6 * unit, middle), 6 * unit, colour)
            left = row.left + 20 * unit
            text = canvas.abbreviated(action_label(name), row.right - left, size, SEMIBOLD)
            canvas.text((left, middle), text, size, canvas.theme.legible(colour), SEMIBOLD)

    def _draw_contacts(self, canvas: Canvas, column: Box, rollouts: Rollouts) -> None:
        unit, size, theme, count = canvas.unit, canvas.type.body, canvas.theme, rollouts.count
        room = canvas.measure(f"{count} of {count}", size, SEMIBOLD) + 8 * unit
        half = min(0.84 * self.row, 32 * unit) / 2
        icons = Box(column.left, 0.0, column.right - room, 2 * half)
        below = "one dot a rollout" if icon_pitch(icons, count) else "share of rollouts"
        self._head(canvas, column, "Contact", below, theme.ink)
        for index, row, colour in self._coloured_rows(canvas, column, rollouts):
            touched, middle = int(rollouts.touched[index].sum()), row.centre[1]
            box = Box(icons.left, middle - half, icons.right, middle + half)
            drawn = draw_icons(canvas, box, touched, count, blend(colour, theme.ground, 0.45))
            at, told = (drawn.right + 8 * unit, middle), f"{touched} of {count}"
            ink, weight = (theme.contact, SEMIBOLD) if touched else (theme.faint, REGULAR)
            canvas.text(at, told, size, ink, weight)

    def _draw_measure(
        self, canvas: Canvas, column: Box, measure: Measure, worth: float, rollouts: Rollouts
    ) -> None:
        title, below = measure.title.capitalize(), f"reward {signed(worth)}"
        self._head(canvas, column, title, below, canvas.theme.ink)
        edges, marks = _bins(measure)
        axis = Axis(float(edges[0]), float(edges[-1]), column.left, column.right)
        for index, row, colour in self._coloured_rows(canvas, column, rollouts):
            plot = Box(row.left, row.top + 0.14 * row.height, row.right, row.bottom - 1)
            values, touched = measure.values[index], rollouts.touched[index]
            draw_histogram(canvas, plot, axis, values, edges, colour, touched)
        draw_ticks(canvas, axis, self._rows(column)[-1].bottom + 8 * canvas.unit, marks)

    def _draw_judgement(self, canvas: Canvas, column: Box, judgement: Judgement) -> None:
        unit, size, theme, colour = canvas.unit, canvas.type.body, canvas.theme, judgement.colour
        title = f"V {judgement.label}"
        self._head(canvas, column, title, "filled: pick", theme.legible(colour))
        width = canvas.measure("−0.000", size, SEMIBOLD) + 12 * unit
        for index, row in enumerate(self._rows(column)):
            given, middle = float(judgement.values[index]), row.centre[1]
            text, right = rounded_number(given, 3, ".3f"), row.left + width - 6 * unit
            ink, weight = theme.ink, REGULAR
            if index == judgement.best:
                half = min(0.75 * size, row.height / 2 - canvas.hair)
                pill = Box(row.left, middle - half, row.left + width, middle + half)
                canvas.rounded(pill, 5 * unit, colour)
                ink = theme.ink_on(colour)
                weight = SEMIBOLD
            canvas.text((right, middle), text, size, ink, weight, anchor="right")


def _whose_values(judgements: Sequence[Judgement]) -> list[str]:
    """What the values of the teachers are, the longest wording first."""
    eu = PROFILES["eu"]
    own = [f"{each.label}: expected utility" for each in judgements if each.parameters == eu]
    if len(own) == len(judgements):
        return [*joined(own), ""]
    rest = "others" if own else "V"
    return [*joined(*([*own, f"{rest}: {theory}"] for theory in _BY_CPT)), ""]
