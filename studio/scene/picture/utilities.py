"""The figure that a scene is about: how good the outcomes of every action are, and to whom.

A row an action, on one axis: a dot for each rollout at the utility of its outcome, and below the
dots a mark for each teacher at the utility that, for sure, would be worth as much to the teacher as
the action: the certainty equivalent of its value V. At the right stands V itself.
"""

import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from scenes import Rollouts
from studio.arrays import FloatArray, IntArray
from studio.painter.axes import Axis, axis_with_ticks
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.lettering import REGULAR, SEMIBOLD
from studio.painter.marks import cross, hollow_square
from studio.painter.pens import pen_mark
from studio.painter.quantile_dots import DotStacks, QuantileDots
from studio.scene.judgements import Judgement, utilities
from studio.scene.measures import PERSON, WALL, contact_kinds
from studio.scene.picture.rows import ActionRows, draw_head, head_height
from studio.scene.picture.titles import joined
from studio.scene.words import bias_told
from studio.style.palette import Colour
from studio.style.ticks import round_range, ticks
from studio.style.words import rounded_number

_DOTS = 0.62  # share of a row's height that dots stand in, the rest is for the teachers' marks
_SMALLEST_PITCH = 4.4  # from dot to dot, in units of the page
_LEAST_PLOT = 0.2  # share of the figure's width that the dots have at least
_LOWEST, _HIGHEST = 20.0, 130.0  # rows, in units of the page


@dataclass(frozen=True)
class DrawnUtilities:
    """What of the figure lies where on the page, px."""

    bottom: float  # where the figure ends: the end of its box, or above it
    dots: list[FloatArray]  # of every action that is shown: middles of the dots, [N, 2]
    rollouts: list[IntArray]  # and which rollout each dot is, [N]; -1 if it stands for several


def draw_utilities(
    canvas: Canvas, box: Box, rollouts: Rollouts, judgements: Sequence[Judgement]
) -> DrawnUtilities:
    """Draw the figure in a box of a page; there may be any number of teachers, also none."""
    small, unit, faint = canvas.type.small, canvas.unit, canvas.theme.faint
    bias = bias_told(judgements, rollouts.names, rollouts.count) if judgements else ""
    footer, lowest = (3.1 + 1.3 * bool(bias)) * small, max(_LOWEST * unit, 1.05 * small)
    heights = lowest, max(_HIGHEST * unit, lowest)
    rows = ActionRows.fit(box, rollouts.names, head_height(canvas), footer, heights)
    gap, name_width = 14 * unit, rows.name_width(canvas)
    room = (1.0 - _LEAST_PLOT) * box.width - name_width - gap
    width = min(_value_width(canvas, rows, judgements), room / max(len(judgements), 1) - gap)
    plot_width = box.width - name_width - gap - len(judgements) * (width + gap)
    names, plot, *values = box.columns((name_width, plot_width, *[width] * len(judgements)), gap)
    rows.draw_lines(canvas)
    rows.draw_names(canvas, names)
    heading, size = Box(box.left, box.top, plot.right, box.bottom), canvas.type.heading
    draw_head(canvas, heading, _TITLES, _legends(rollouts), canvas.theme.ink, size)
    places, dots = _draw_plot(canvas, plot, rows, rollouts, judgements)
    for judgement, column in zip(judgements, values, strict=True):
        _draw_values(canvas, column, rows, judgement)
    at = (box.left, rows.floor + 1.9 * small)
    placed = canvas.fit(at, _notes(judgements), box.width, small, faint, line="top")
    at, brief = (box.left, placed.bottom + 0.2 * small), bias.partition(", held")[0]
    canvas.fit(at, [bias, brief], box.width, small, faint, line="top")
    return DrawnUtilities(rows.box.bottom, places, [each.sources for each in dots])


def _has_two_lines(canvas: Canvas, rows: ActionRows) -> bool:
    """Whether a row has room for two lines of text."""
    return rows.row >= 1.15 * (canvas.type.small + canvas.type.body)


def _told(judgement: Judgement, index: int) -> tuple[str, str, str]:
    """The value V of an action, its interval, and its interval in brief."""
    numbers = [float(each[index]) for each in (judgement.values, judgement.low, judgement.high)]
    value, low, high = (rounded_number(each, 3, ".3f") for each in numbers)
    ends = (re.sub("^(−?)0", r"\1", rounded_number(each, 2, ".2f")) for each in numbers[1:])
    return value, f"[{low}, {high}]", "[{}, {}]".format(*ends)


def _lines(canvas: Canvas, told: Sequence[tuple[str, str, str]], room: float) -> list[str]:
    """Values with their intervals in brief, each on one line; without spaces if room is scarce."""
    lines = [f"{value} {brief}" for value, _, brief in told]
    if all(canvas.measure(line, canvas.type.small) <= room for line in lines):
        return lines
    return [line.replace(", ", ",") for line in lines]


def _value_width(canvas: Canvas, rows: ActionRows, judgements: Sequence[Judgement]) -> float:
    """Width of a column that the values V and their intervals fit into, px."""
    small, heading = canvas.type.small, canvas.type.heading
    widths = [0.0]
    for judgement in judgements:
        widths.append(canvas.measure(f"V {judgement.label}", heading, SEMIBOLD) + 1.2 * heading)
        for index in range(rows.shown):
            value, interval, brief = _told(judgement, index)
            told = interval if _has_two_lines(canvas, rows) else f"{value} {brief}"
            widths.append(canvas.measure(told, small) + 14 * canvas.unit)
    return max(widths)


_TITLES = [
    "Utility of what may happen, and its worth to each teacher",
    "Utility of what may happen",
]


def _legends(rollouts: Rollouts) -> list[str]:
    """What the dots stand for, the longest wording first."""
    kinds, count = contact_kinds(rollouts), rollouts.count
    dots = len(QuantileDots.of(np.zeros(count), np.zeros(count, np.int64)).values)
    told = "a dot: one rollout" if dots == count else f"{dots} dots stand for {count} rollouts"
    touched = [kind for kind in (PERSON, WALL) if (kinds == kind).any()]
    long = {PERSON: "×: touches a person", WALL: "□: touches a wall"}
    short = {PERSON: "× a person", WALL: "□ a wall"}
    return joined(
        (told, *(long[kind] for kind in touched)),
        (told, *(short[kind] for kind in touched)),
        (told,),
    )


def _notes(judgements: Sequence[Judgement]) -> list[str]:
    """What the marks and numbers of the teachers are, the longest wording first."""
    if not judgements:
        return [""]
    mark = "Marks below the dots"
    what = "the sure utility that is worth as much to a teacher as the action"
    return [
        f"{mark}: {what} · brackets: what other rollouts give in 95 % of draws",
        f"{mark}: {what} · brackets: 95 % of other rollouts' draws",
        f"{mark}: certainty equivalents of V · brackets: 95 % of draws of other rollouts",
        "Marks: certainty equivalents of V · brackets: 95 % of draws",
        "Marks: certainty equivalents",
    ]


def _axis(
    dots: Sequence[QuantileDots], judgements: Sequence[Judgement], plot: Box
) -> tuple[Axis, list[float]]:
    """The axis that holds all dots and marks, and its ticks."""
    ends = [end for each in judgements for end in each.certainty_equivalent_interval]
    shown = np.concatenate([*(each.values for each in dots), *ends, [0.0]])
    low, high = round_range(float(shown.min()), float(shown.max()))
    return Axis(low, high, plot.left, plot.right), ticks(low, high, 6)


def _draw_plot(
    canvas: Canvas, plot: Box, rows: ActionRows, rollouts: Rollouts, judgements: Sequence[Judgement]
) -> tuple[list[FloatArray], list[QuantileDots]]:
    """Draw the dots and the teachers' marks of every action; where the dots lie, and the dots."""
    theme, unit = canvas.theme, canvas.unit
    kinds, worths = contact_kinds(rollouts), utilities(rollouts)
    dots = [
        QuantileDots.of(own, kind)
        for own, kind in zip(worths[: rows.shown], kinds[: rows.shown], strict=True)
    ]
    axis, marks = _axis(dots, judgements, plot)
    zero = round(axis.at(0.0))
    canvas.fill(Box(zero, rows.cells(plot)[0].top, zero + canvas.hair, rows.floor), theme.grid)
    room = _DOTS * rows.row - 3 * unit
    stacks = DotStacks.fit(dots, axis, room, max(_SMALLEST_PITCH * unit, 2.0))
    places = []
    for index, cell, colour in rows.coloured(canvas, plot):
        floor = cell.top + _DOTS * cell.height
        canvas.fill(Box(plot.left, floor, plot.right, floor + canvas.hair), theme.grid)
        places.append(stacks.middles(dots[index]) * (1.0, -1.0) + (0.0, floor))
        _draw_dots(canvas, places[-1], dots[index].kinds, 0.44 * stacks.pitch, colour)
        strip = Box(plot.left, floor + canvas.hair, plot.right, cell.bottom)
        _draw_certainty_equivalents(canvas, axis, strip, judgements, index)
    axis_with_ticks(canvas, axis, rows.floor, marks)
    return places, dots


def _draw_dots(
    canvas: Canvas, places: FloatArray, kinds: IntArray, radius: float, colour: Colour
) -> None:
    """Draw dots at places [N, 2], px: discs, crosses for people and squares for walls touched."""
    theme = canvas.theme
    for place, kind in zip(places, kinds.tolist(), strict=True):
        if kind == PERSON:
            cross(canvas, place, 1.1 * radius, theme.contact)
        elif kind == WALL:
            hollow_square(canvas, place, 0.95 * radius, theme.contact, theme.ground)
        else:
            canvas.disc(place, radius, colour)


def _draw_certainty_equivalents(
    canvas: Canvas, axis: Axis, strip: Box, judgements: Sequence[Judgement], index: int
) -> None:
    """Draw a mark with its interval for each teacher, one below the other."""
    lanes = strip.rows([1.0] * len(judgements)) if judgements else ()
    for judgement, lane in zip(judgements, lanes, strict=True):
        low, high = judgement.certainty_equivalent_interval
        middle, colour = lane.centre[1], judgement.colour
        pen = max(1.0, 2 * canvas.unit)
        ends = axis.at(float(low[index])), axis.at(float(high[index]))
        canvas.fill(Box(ends[0], middle - pen / 2, ends[1], middle + pen / 2), colour)
        at = (axis.at(float(judgement.certainty_equivalents[index])), middle)
        radius = min(4.2 * canvas.unit, 0.6 * lane.height)
        pen_mark(canvas, at, judgement.pen, radius, canvas.theme.ground)


def _draw_values(canvas: Canvas, column: Box, rows: ActionRows, judgement: Judgement) -> None:
    """Write V of every action with its interval; what the teacher picks is filled or outlined."""
    unit, theme, colour = canvas.unit, canvas.theme, judgement.colour
    small, body = canvas.type.small, canvas.type.body
    pick = "filled: pick" if judgement.is_sure else "outlined: open"
    inset = 22 * unit
    mark = (column.left + 8 * unit, column.top + 0.55 * canvas.type.heading)
    pen_mark(canvas, mark, judgement.pen, 5.5 * unit, theme.ground)
    head = Box(column.left + inset, column.top, column.right, column.bottom)
    ink = theme.legible(colour)
    titles = [f"V {judgement.label}", judgement.label]
    draw_head(canvas, head, titles, [pick, pick.split()[-1]], ink, canvas.type.heading)
    room = column.width - 6 * unit
    lines = _lines(canvas, [_told(judgement, index) for index in range(rows.shown)], room)
    for index, cell in enumerate(rows.cells(column)):
        middle, is_candidate = cell.centre[1], index in judgement.candidates
        pill = cell.inset(2 * unit)
        ink, quiet = theme.ink, theme.faint
        if is_candidate:
            canvas.rounded(pill, 6 * unit, colour)
            if judgement.is_sure:
                ink = quiet = theme.ink_on(colour)
            else:
                canvas.rounded(pill.inset(max(1.0, 2 * unit)), 5 * unit, theme.ground)
        value, interval, brief = _told(judgement, index)
        weight = SEMIBOLD if is_candidate else REGULAR
        if _has_two_lines(canvas, rows):
            at = (cell.centre[0], middle - 0.54 * small)
            canvas.fit(at, value, room, body, ink, weight, anchor="centre")
            at = (cell.centre[0], middle + 0.54 * body)
            canvas.fit(at, [interval, brief], room, small, quiet, anchor="centre")
        else:
            canvas.fit(cell.centre, [lines[index], value], room, small, ink, anchor="centre")
