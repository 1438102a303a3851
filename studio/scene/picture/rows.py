"""Tables with a row an action: where the rows lie, and the names that they begin with."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.lettering import SEMIBOLD
from studio.style.palette import Colour
from studio.style.words import action_label


@dataclass(frozen=True)
class ActionRows:
    """Where the rows of a table lie: a header, a row an action, and a footer."""

    box: Box  # the whole table
    names: tuple[str, ...]  # of all actions
    header: float  # height, px
    row: float  # height, px
    shown: int  # how many actions there is room for

    @classmethod
    def fit(
        cls,
        box: Box,
        names: tuple[str, ...],
        header: float,
        footer: float,
        rows: tuple[float, float],
    ) -> "ActionRows":
        """Fit rows between the lowest and the highest height (px) into a box, from its top on."""
        lowest, highest = rows
        room = box.height - header - footer
        row = min(max(room / len(names), lowest), highest)
        shown = min(len(names), max(int(room / row + 1e-9), 1))
        lines = shown
        if shown < len(names):
            shown -= 1  # the last line says how many are left out
        bottom = box.top + header + lines * row + footer
        return cls(Box(box.left, box.top, box.right, bottom), names, header, row, shown)

    @property
    def floor(self) -> float:
        """Where the last row ends, px."""
        lines = self.shown + (self.shown < len(self.names))
        return self.box.top + self.header + lines * self.row

    def cells(self, column: Box) -> list[Box]:
        """The cells of one column, an action each."""
        top = self.box.top + self.header
        return [
            Box(column.left, top + index * self.row, column.right, top + (index + 1) * self.row)
            for index in range(self.shown)
        ]

    def coloured(self, canvas: Canvas, column: Box) -> Iterator[tuple[int, Box, Colour]]:
        """The cells of one column with the index and the colour of their actions."""
        for index, cell in enumerate(self.cells(column)):
            yield index, cell, canvas.theme.action_colour(self.names[index])

    def draw_lines(self, canvas: Canvas) -> None:
        """Draw the lines above the rows, and say how many actions there is no room for."""
        for row in self.cells(self.box):
            canvas.fill(Box(row.left, row.top, row.right, row.top + canvas.hair), canvas.theme.grid)
        left_out = len(self.names) - self.shown
        if left_out:
            told = f"and {left_out} more actions"
            wordings = [f"{told} that there is no room for", told]
            at, faint = (self.box.left, self.floor - self.row / 2), canvas.theme.faint
            canvas.fit(at, wordings, self.box.width, canvas.type.small, faint)

    def type_size(self, canvas: Canvas) -> int:
        """Size of type in rows, which is small where they are low, px."""
        return canvas.type.body if self.row >= 1.15 * canvas.type.body else canvas.type.small

    def name_width(self, canvas: Canvas) -> float:
        """Width of the column of names: of the longest name, but not much of the table, px."""
        size, names = self.type_size(canvas), map(action_label, self.names)
        widest = max(canvas.measure(name, size, SEMIBOLD) for name in names)
        return min(widest + 21 * canvas.unit, 0.17 * self.box.width)

    def draw_names(self, canvas: Canvas, column: Box) -> None:
        """Name the actions, each beside a disc in its colour."""
        unit, size = canvas.unit, self.type_size(canvas)
        for index, cell, colour in self.coloured(canvas, column):
            middle, left = cell.centre[1], cell.left + 20 * unit
            canvas.disc((cell.left + 6 * unit, middle), 6 * unit, colour)
            name = action_label(self.names[index])
            text = canvas.abbreviated(name, cell.right - left, size, SEMIBOLD)
            canvas.text((left, middle), text, size, canvas.theme.legible(colour), SEMIBOLD)


def draw_head(
    canvas: Canvas,
    column: Box,
    titles: Sequence[str],
    below: Sequence[str],
    colour: Colour,
    size: int,
) -> None:
    """Write the title of a column in a size (px) at its top, and a smaller line below it."""
    kind, width, at = canvas.type, column.width, (column.left, column.top)
    canvas.fit(at, titles, width, size, colour, SEMIBOLD, line="top")
    at = (column.left, column.top + kind.heading + 1)
    canvas.fit(at, below, width, kind.small, canvas.theme.faint, line="top")


def head_height(canvas: Canvas) -> float:
    """Height of a title with a line below it, px."""
    return 1.35 * canvas.type.heading + 1.35 * canvas.type.small
