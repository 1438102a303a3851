"""The picture's table of actions: one row each, with contacts, distributions and values."""

from collections.abc import Sequence
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
from studio.style.palette import Colour, blend, contrast, teacher_colour
from studio.style.ticks import round_range, ticks
from studio.style.words import action_label, rounded_number, signed, teacher_name

_BINS = 24
_NOTES = ["dot: mean · red: rollouts with contact", "dot: mean · red: with contact"]


@dataclass(frozen=True)
class _Measure:
    """One feature as a column of the table shows it.

    Attributes:
        title: name of the feature.
        unit: of the values; empty if they have none.
        values: [A, K].
        low: left end of the axis.
        high: right end of the axis.
        edges: edges of the histogram's bins.
        ticks: values to write under the axis.
        worth: the reward for one unit of the scaled feature.
    """

    title: str
    unit: str
    values: FloatArray
    low: float
    high: float
    edges: FloatArray
    ticks: list[float]
    worth: float


def _measures(rollouts: Rollouts) -> list[_Measure]:
    physical = {
        "clearance": ("m", rollouts.clearance_m),
        "deviation": ("m", rollouts.deviation_m),
        "progress": ("m", rollouts.progress_m),
    }
    measures = []
    for index, (feature, worth) in enumerate(zip(FEATURES, REWARD, strict=True)):
        unit, values = physical.get(feature, ("", rollouts.features[..., index]))
        if feature == "collisions":
            most = max(2, round(float(values.max())))
            # bars as slim as a third of a bin, around the whole numbers
            edges = np.arange(-0.5, most + 0.51, 1 / 3)
            marks = [mark for mark in ticks(0.0, most, 4) if mark.is_integer()]
        else:
            low, high = float(values.min()), float(values.max())
            if feature in ("clearance", "deviation"):
                low, high = 0.0, max(high, 0.1)
            elif feature == "smoothness":
                low, high = min(low, 0.9), 1.0
            low, high = round_range(low, high)
            edges = np.linspace(low, high, _BINS + 1)
            marks = ticks(low, high, 3)
        measures.append(
            _Measure(feature, unit, values, float(edges[0]), float(edges[-1]), edges, marks, worth)
        )
    return measures


@dataclass(frozen=True)
class ActionTable:
    """Where the table of actions lies.

    Attributes:
        box: the whole of it.
        header: height of its header, px.
        row: height of a row, px.
        footer: height of the line of ticks under the rows, px.
        shown: how many actions there is room for.
    """

    box: Box
    header: float
    row: float
    footer: float
    shown: int

    @classmethod
    def fit(cls, canvas: Canvas, space: Box, rollouts: Rollouts) -> "ActionTable":
        """Lay the table out at the bottom of the space, above which the scene needs room too."""
        kind, unit, count = canvas.type, canvas.unit, len(rollouts.actions)
        header, footer = 1.35 * kind.heading + 1.35 * kind.small, 1.7 * kind.small
        most = 0.52 * space.height - header - footer
        lowest, highest = 1.3 * kind.body, 32 * unit
        row = min(max(most / count, lowest), highest)
        shown = min(count, int(most / row + 1e-9))
        # the last line then says how many are left out
        shown = shown if shown == count else shown - 1
        lines = shown if shown == count else shown + 1
        top = space.bottom - header - lines * row - footer
        return cls(Box(space.left, top, space.right, space.bottom), header, row, footer, shown)

    def draw(self, canvas: Canvas, rollouts: Rollouts, judgements: Sequence[Judgement]) -> None:
        """Draw header, rows and ticks."""
        widths = (154, 162, *[140] * len(FEATURES), *[94] * len(judgements))
        columns = self.box.columns(widths, 24 * canvas.unit)
        name, contact, cells = columns[0], columns[1], columns[2:]
        measures = _measures(rollouts)
        self._draw_lines(canvas, len(rollouts.actions), contact.right - name.left)
        note = canvas.fitted(_NOTES, contact.right - name.left, canvas.type.small)
        at = (name.left, self.box.bottom - self.footer + 8 * canvas.unit)
        canvas.text(at, note, canvas.type.small, canvas.theme.faint, line="top")
        self._draw_names(canvas, name, rollouts)
        self._draw_contacts(canvas, contact, rollouts)
        for measure, column in zip(measures, cells, strict=False):
            self._draw_measure(canvas, column, measure, rollouts)
        self._draw_whose_value(canvas, cells[len(measures) - 1].right, judgements)
        for judgement, column in zip(judgements, cells[len(measures) :], strict=True):
            self._draw_judgement(canvas, column, judgement)

    def _draw_whose_value(
        self, canvas: Canvas, left: float, judgements: Sequence[Judgement]
    ) -> None:
        """Write below the values what they are."""
        by_mean = [teacher_name(j.teacher) for j in judgements if j.parameters == PROFILES["eu"]]
        rest = "others" if by_mean else "V"
        theirs = [f"{rest}: {prospect}" for prospect in ("cumulative prospect theory", "CPT")]
        if len(by_mean) == len(judgements):
            theirs = []
        own = [f"{name}: expected utility" for name in by_mean]
        texts = [" · ".join([*own, *part]) for part in ([t] for t in theirs)] or [" · ".join(own)]
        size, right = canvas.type.small, self.box.right
        text = canvas.fitted([*texts, ""], right - left, size)
        at = (right, self.box.bottom - self.footer + 8 * canvas.unit)
        canvas.text(at, text, size, canvas.theme.faint, anchor="right", line="top")

    def _rows(self, column: Box) -> list[Box]:
        """The cells of one column."""
        top = column.top + self.header
        return [
            Box(column.left, top + index * self.row, column.right, top + (index + 1) * self.row)
            for index in range(self.shown)
        ]

    def _draw_lines(self, canvas: Canvas, count: int, room: float) -> None:
        for row in self._rows(self.box):
            canvas.fill(Box(row.left, row.top, row.right, row.top + canvas.hair), canvas.theme.grid)
        if self.shown < count:
            top = self.box.top + self.header + self.shown * self.row
            small, left_out = canvas.type.small, f"and {count - self.shown} more actions"
            text = canvas.fitted([f"{left_out} that there is no room for", left_out], room, small)
            canvas.text((self.box.left, top + self.row / 2), text, small, canvas.theme.faint)

    def _head(self, canvas: Canvas, column: Box, title: str, below: str, colour: Colour) -> None:
        kind = canvas.type
        text = canvas.fitted(title, column.width, kind.heading, SEMIBOLD)
        box = canvas.text(
            (column.left, column.top), text, kind.heading, colour, SEMIBOLD, line="top"
        )
        canvas.text(
            (column.left, box.bottom + 1),
            canvas.fitted(below, column.width, kind.small),
            kind.small,
            canvas.theme.faint,
            line="top",
        )

    def _draw_names(self, canvas: Canvas, column: Box, rollouts: Rollouts) -> None:
        unit, size = canvas.unit, canvas.type.body
        self._head(canvas, column, "Action", "", canvas.theme.ink)
        for index, row in enumerate(self._rows(column)):
            middle = row.centre[1]
            name = rollouts.names[index]
            colour = canvas.theme.action_colour(name)
            canvas.disc((row.left + 6 * unit, middle), 6 * unit, colour)
            left = row.left + 20 * unit
            text = canvas.abbreviated(action_label(name), row.right - left, size, SEMIBOLD)
            canvas.text((left, middle), text, size, canvas.theme.legible(colour), SEMIBOLD)

    def _draw_contacts(self, canvas: Canvas, column: Box, rollouts: Rollouts) -> None:
        unit, size, count = canvas.unit, canvas.type.body, rollouts.contact_step.shape[1]
        room = canvas.measure(f"{count} of {count}", size, SEMIBOLD)
        height = min(0.84 * self.row, 32 * unit)
        icons = [
            Box(
                row.left,
                row.centre[1] - height / 2,
                row.right - room - 8 * unit,
                row.centre[1] + height / 2,
            )
            for row in self._rows(column)
        ]
        below = "one dot a rollout" if icon_pitch(icons[0], count) else "share of rollouts"
        self._head(canvas, column, "Contact", below, canvas.theme.ink)
        for index, box in enumerate(icons):
            touched = int(rollouts.touched[index].sum())
            colour = canvas.theme.action_colour(rollouts.names[index])
            faint = blend(colour, canvas.theme.ground, 0.45)
            drawn = draw_icons(canvas, box, touched, count, faint)
            canvas.text(
                (drawn.right + 8 * unit, box.centre[1]),
                f"{touched} of {count}",
                size,
                canvas.theme.contact if touched else canvas.theme.faint,
                SEMIBOLD if touched else REGULAR,
            )

    def _draw_measure(
        self, canvas: Canvas, column: Box, measure: _Measure, rollouts: Rollouts
    ) -> None:
        unit = canvas.unit
        title = measure.title.capitalize() + (f", {measure.unit}" if measure.unit else "")
        self._head(canvas, column, title, f"reward {signed(measure.worth)}", canvas.theme.ink)
        axis = Axis(measure.low, measure.high, column.left, column.right)
        rows = self._rows(column)
        for index, row in enumerate(rows):
            plot = Box(row.left, row.top + 0.14 * row.height, row.right, row.bottom - 1)
            values = measure.values[index]
            touched = rollouts.touched[index]
            colour = canvas.theme.action_colour(rollouts.names[index])
            draw_histogram(canvas, plot, axis, values, measure.edges, colour, touched)
        draw_ticks(canvas, axis, rows[-1].bottom + 8 * unit, measure.ticks)

    def _draw_judgement(self, canvas: Canvas, column: Box, judgement: Judgement) -> None:
        unit, size = canvas.unit, canvas.type.body
        colour = teacher_colour(judgement.teacher)
        title, ink = f"V {teacher_name(judgement.teacher)}", canvas.theme.legible(colour)
        self._head(canvas, column, title, "filled: pick", ink)
        width = canvas.measure("−0.000", size, SEMIBOLD) + 12 * unit
        for index, row in enumerate(self._rows(column)):
            given, middle = float(judgement.values[index]), row.centre[1]
            text, right = rounded_number(given, 3, ".3f"), row.left + width - 6 * unit
            if index == judgement.best:
                half = min(0.75 * size, row.height / 2 - canvas.hair)
                pill = Box(row.left, middle - half, row.left + width, middle + half)
                canvas.rounded(pill, 5 * unit, colour)
                paper = max(
                    canvas.theme.ground, canvas.theme.ink, key=lambda ink: contrast(ink, colour)
                )
                canvas.text((right, middle), text, size, paper, SEMIBOLD, anchor="right")
            else:
                canvas.text((right, middle), text, size, canvas.theme.ink, anchor="right")
