"""The picture's table of outcomes: a row an action, with contacts and distributions of features."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from learners import REWARD
from scenes import FEATURES, Rollouts
from studio.arrays import FloatArray, IntArray
from studio.painter.axes import Axis, axis_with_ticks
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.lettering import REGULAR, SEMIBOLD
from studio.painter.marks import Histogram, cross, draw_histogram, hollow_square
from studio.scene.certainty import wilson
from studio.scene.measures import Measure, contact_kinds, measures
from studio.scene.picture.rows import ActionRows, draw_head, head_height
from studio.scene.picture.titles import joined
from studio.style.ticks import round_range, ticks
from studio.style.words import listed, share_told, signed

_LONGEST = "Clearance, m"  # of the titles of features
_BINS = 24  # of a histogram
_LOWEST, _HIGHEST = 16.0, 96.0  # rows, in units of the page


def draw_outcomes(canvas: Canvas, box: Box, rollouts: Rollouts) -> None:
    """Draw the table in a box of a page."""
    unit, small = canvas.unit, canvas.type.small
    lowest = max(_LOWEST * unit, 1.05 * small)
    heights = lowest, max(_HIGHEST * unit, lowest)
    rows = ActionRows.fit(box, rollouts.names, head_height(canvas), 3.3 * small, heights)
    touched = {"person": rollouts.person_step >= 0}
    if rollouts.wall_touched.any():
        touched["wall"] = rollouts.wall_touched
    gap = 10 * unit
    name = Box(box.left, box.top, box.left + rows.name_width(canvas), box.bottom)
    # one column of contacts may be a bit wider than those of features
    widths = [1.0 if len(touched) > 1 else 1.1] * len(touched) + [1.0] * len(FEATURES)
    columns = Box(name.right + gap, box.top, box.right, box.bottom).columns(widths, gap)
    shown, kinds = measures(rollouts), contact_kinds(rollouts)
    size = _head_size(canvas, columns[-1].width)
    rows.draw_lines(canvas)
    rows.draw_names(canvas, name)
    draw_head(canvas, name, ["Action"], [""], canvas.theme.ink, size)
    counts, of = [who.sum(axis=1) for who in touched.values()], rollouts.count
    words = _ContactWords.fit(canvas, rows, columns[0].width, counts, of)
    for place, (column, thing) in enumerate(zip(columns, touched, strict=False)):
        below = [f"a {thing}{words.below}"]
        draw_head(canvas, column, ["Touched"], below, canvas.theme.ink, size)
        told = list(zip(words.counts[place], words.shares[place], strict=True))
        _draw_contacts(canvas, column, rows, counts[place], of, thing, told)
    features = columns[len(touched) :]
    most = [
        _draw_measure(canvas, column, rows, measure, worth, kinds, size)
        for measure, worth, column in zip(shown, REWARD, features, strict=True)
    ]
    at = (box.left, rows.floor + 2.0 * small)
    canvas.fit(at, _notes(rollouts, most), box.width, small, canvas.theme.faint, line="top")


def _head_size(canvas: Canvas, width: float) -> int:
    """The largest size of type in which the title of every feature fits a width (px), px."""
    kind = canvas.type
    sizes = (size for size in (kind.heading, kind.body) if _fits(canvas, size, width))
    return next(sizes, kind.small)


def _fits(canvas: Canvas, size: int, width: float) -> bool:
    """Whether the titles of all features fit a width, px, in a size of type, px."""
    return canvas.measure(_LONGEST, size, SEMIBOLD) <= width


def _notes(rollouts: Rollouts, most: Sequence[int]) -> list[str]:
    """What the table's marks mean, and how many rollouts the highest bars have, longest first."""
    people, walls = (rollouts.person_step >= 0).any(), rollouts.wall_touched.any()
    red = "red: a person was touched" if people else ""
    striped = "striped: a wall" if walls else ""
    never = "" if walls or not rollouts.scene.walls else "no wall was touched"
    brackets, dot = "brackets: 95 % intervals", "dot: mean"
    scale = f"as high as a row: {listed([str(each) for each in most])} rollouts"
    return joined(
        (f"Histograms: {scale}", dot, red, striped, brackets, never),
        (f"Histograms: {scale}", dot, red, striped, never),
        (f"Histograms: {scale}", dot, red, striped),
        (scale.capitalize(), dot, red and "red: contact"),
        (dot.capitalize(), red and "red: contact"),
    )


@dataclass(frozen=True)
class _ContactWords:
    """In how many rollouts several kinds of things were touched, in words that fit their columns.

    Where there is room, they are counts and shares in percent; else shares alone.
    """

    below: str  # what is told, to follow the name of a thing
    counts: list[list[str]]  # of each kind, an action each; empty where there is no room for them
    shares: list[list[str]]  # of each kind, an action each: the share and its interval

    @classmethod
    def fit(
        cls, canvas: Canvas, rows: ActionRows, width: float, touched: list[IntArray], count: int
    ) -> "_ContactWords":
        """Words that fit columns of a width, px."""
        small, size = canvas.type.small, rows.type_size(canvas)
        numbers = [[str(number) for number in own.tolist()] for own in touched]
        shares = [[_share_told(number, count) for number in own.tolist()] for own in touched]
        widest = max(canvas.measure(text, small) for own in shares for text in own)
        widest += max(canvas.measure(text, size, SEMIBOLD) for own in numbers for text in own)
        if widest + 6 * canvas.unit <= width:
            return cls(_suffix(canvas, width, [f", of {count}", ""]), numbers, shares)
        nothing = [[""] * len(own) for own in numbers]
        shares = [[text.replace(" %", "") for text in own] for own in shares]
        if any(canvas.measure(text, small) > width for own in shares for text in own):
            shares = [[text.split(" ", 1)[1] for text in own] for own in shares]
        return cls(_suffix(canvas, width, [f", % of {count}", ", %"]), nothing, shares)


def _suffix(canvas: Canvas, width: float, wordings: Sequence[str]) -> str:
    """The first wording with which the longest name of a thing fits a width, px, or the last."""
    small = canvas.type.small
    fitting = (text for text in wordings if canvas.measure(f"a person{text}", small) <= width)
    return next(fitting, wordings[-1])


def _share_told(touched: int, count: int) -> str:
    share = wilson(touched, count)
    return share_told(share.value, share.low, share.high)


def _draw_contacts(
    canvas: Canvas,
    column: Box,
    rows: ActionRows,
    touched: IntArray,
    count: int,
    thing: str,
    told: Sequence[tuple[str, str]],
) -> None:
    """Draw in how many rollouts a kind of thing was touched, with the interval of the share.

    Below the words lies the share, on an axis from 0 to 100 %, where rows have room for it.
    """
    unit, theme, small = canvas.unit, canvas.theme, canvas.type.small
    axis = Axis(0.0, 100.0, column.left, column.right)
    cells = zip(rows.cells(column), touched.tolist(), told, strict=False)
    has_lanes = rows.row >= 1.25 * small + 7 * unit
    for cell, number, (counted, text) in cells:
        share, lane = wilson(number, count), cell.bottom - 4.5 * unit
        middle = (cell.top + lane) / 2 - unit if has_lanes else cell.centre[1]
        ink, weight = (theme.contact, SEMIBOLD) if number else (theme.faint, REGULAR)
        canvas.text((cell.left, middle), counted, rows.type_size(canvas), ink, weight)
        room = column.width - canvas.measure(counted, rows.type_size(canvas), weight)
        ink = ink if number and not counted else theme.faint
        canvas.fit((cell.right, middle), [text, ""], room, small, ink, anchor="right")
        if has_lanes:
            ends = axis.at(100.0 * share.low), axis.at(100.0 * share.high)
            pen, line = max(1.0, 2 * unit), theme.contact if number else theme.faint
            canvas.fill(Box(cell.left, lane, cell.right, lane + canvas.hair), theme.grid)
            canvas.fill(Box(ends[0], lane - pen / 2, ends[1], lane + pen / 2), line)
            if number:
                _contact_mark(canvas, thing, (axis.at(100.0 * share.value), lane))
    if has_lanes:
        axis_with_ticks(canvas, axis, rows.floor, [0.0, 50.0, 100.0])


def _contact_mark(canvas: Canvas, thing: str, at: tuple[float, float]) -> None:
    radius, colour = max(3.6 * canvas.unit, 2.0), canvas.theme.contact
    if thing == "person":
        cross(canvas, at, radius, colour)
    else:
        hollow_square(canvas, at, 0.85 * radius, colour, canvas.theme.ground)


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


def _draw_measure(
    canvas: Canvas,
    column: Box,
    rows: ActionRows,
    measure: Measure,
    worth: float,
    kinds: IntArray,
    size: int,
) -> int:
    """Draw how a feature is distributed under every action; how many rollouts a row stands for."""
    edges, marks = _bins(measure)
    histograms = [
        Histogram.of(values, edges, kind)
        for values, kind in zip(measure.values, kinds, strict=True)
    ]
    most = max(histogram.highest for histogram in histograms)
    title, below = measure.title.capitalize(), [f"reward {signed(worth)}", signed(worth)]
    # a unit that has no room in the title of every feature stands below all titles
    if not _fits(canvas, size, column.width):
        title, unit = measure.feature.capitalize(), f"{measure.unit} · " if measure.unit else ""
        below = [f"{unit}{signed(worth)}"]
    draw_head(canvas, column, [title], below, canvas.theme.ink, size)
    axis = Axis(float(edges[0]), float(edges[-1]), column.left, column.right)
    for index, row, colour in rows.coloured(canvas, column):
        plot = Box(row.left, row.top + 0.1 * row.height, row.right, row.bottom - 1)
        draw_histogram(canvas, plot, axis, histograms[index], most, colour)
    axis_with_ticks(canvas, axis, rows.floor, marks)
    return most
