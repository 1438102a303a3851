"""Where to put labels so that they lie near their things and on nothing else."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from studio.arrays import FloatArray
from studio.painter.boxes import Box, Point
from studio.painter.canvas import Canvas
from studio.painter.lettering import SEMIBOLD
from studio.style.palette import Colour
from studio.style.places import spread_apart

_DIRECTIONS = 24
_RINGS = (
    0.0,
    0.3,
    0.6,
    1.0,
    1.5,
    2.0,
    3.0,
    4.5,
)  # distance from the thing, in heights of the label
_COST_OF_INK = 12.0  # a label wholly on ink is as bad as this many heights of distance
_COST_OF_SOLID_INK = 30.0  # and as this many more if the ink is as dark as text
_SOLID = 0.42  # of black: people and walls; what is drawn fainter can be written over
_COST_OF_COVERING = 2.0  # heights; a label that lies on a line which must be seen
_COST_OF_TURNING = 0.5  # heights; a label that is not where its thing points to
_COST_OF_CONFUSION = 15.0  # heights; a label that lies nearer to another thing than to its own


@dataclass(frozen=True)
class Label:
    """The name of a thing that lies at a point.

    Attributes:
        text: the name.
        size: of type, px.
        weight: of type, 100 to 1000.
        colour: of the letters.
        near: the point, px.
        reach: distance to keep from it, px.
        direction: where from the point the label would best be (dx, dy), px; of any length.
    """

    text: str
    size: int
    weight: int
    colour: Colour
    near: Point
    reach: float
    direction: Point


_NO_POINTS: FloatArray = np.empty((0, 2))


def draw_labels(
    canvas: Canvas,
    labels: Sequence[Label],
    area: Box,
    ground: Colour,
    seen: FloatArray = _NO_POINTS,
) -> None:
    """Write labels where there is room, with a line to things that are farther away.

    Args:
        canvas: what is drawn already.
        labels: the more important ones first; what finds no room is left out.
        area: where they may lie, px.
        ground: colour of the empty area.
        seen: [N, 2], points that are best not covered, px.
    """
    places = place(labels, canvas, area, ground, seen)
    for label, box in zip(labels, places, strict=True):
        if box is None:
            continue
        if distance(box, label.near) > label.reach + box.height:
            x, y = label.near
            end = min(max(x, box.left), box.right), min(max(y, box.top), box.bottom)
            canvas.line([label.near, end], label.colour, canvas.hair)
        canvas.text(
            box.centre,
            label.text,
            label.size,
            label.colour,
            label.weight,
            anchor="centre",
            halo=ground,
        )


def place(
    labels: Sequence[Label],
    canvas: Canvas,
    area: Box,
    ground: Colour,
    seen: FloatArray = _NO_POINTS,
) -> list[Box | None]:
    """Choose a place for each label, the first ones choosing first.

    A place costs its distance from the thing, the ink and the points that it covers; it never
    overlaps another label nor leaves the area.

    Arguments as for `draw_labels`.

    Returns:
        A box for each label, or None where there is no room.
    """
    part = canvas.clipped(area)
    away = np.abs(part.pixels.astype(np.int16) - np.array(ground, np.int16)).max(axis=-1) / 255.0
    ink, solid = _Ink(part, away), _Ink(part, (away > _SOLID).astype(np.float64))
    places: list[Box | None] = []
    for label in labels:
        width = canvas.measure(label.text, label.size, label.weight) + 0.2 * label.size
        taken = [box for box in places if box is not None]
        candidates = [
            (
                cost
                + _COST_OF_INK * ink.share(box)
                + _COST_OF_SOLID_INK * solid.share(box)
                + _COST_OF_COVERING * _covers(box, seen)
                + _COST_OF_CONFUSION * _is_nearer_to_another(box, label, labels),
                order,
                box,
            )
            for order, (cost, box) in enumerate(_candidates(label, width, 1.15 * label.size))
            if area.contains(box) and not any(box.overlaps(other) for other in taken)
        ]
        places.append(min(candidates)[2] if candidates else None)
    return places


def end_labels(
    canvas: Canvas,
    left: float,
    column: Box,
    labels: Sequence[tuple[float, Sequence[str], Colour]],
) -> None:
    """Write names beside the ends of lines, moved apart where they would touch.

    Args:
        canvas: to draw on.
        left: where the names begin, px.
        column: how high, low and far to the right names may lie.
        labels: of each line the height of its end, px, wordings, and its colour.
    """
    size = canvas.type.small
    step = 1.12 * size
    shown = sorted(labels, key=lambda label: label[0])[: max(1, int(column.height / step))]
    heights = [y for y, _, _ in shown]
    centres = spread_apart(heights, step, column.top + step / 2, column.bottom - step / 2)
    for middle, (_, wordings, colour) in zip(centres, shown, strict=True):
        text = canvas.fitted(wordings, column.right - left, size, SEMIBOLD)
        canvas.text((left, middle), text, size, canvas.theme.legible(colour), SEMIBOLD)


def distance(box: Box, point: Point) -> float:
    """Distance from a point to the nearest point of a box, px; 0 inside."""
    across = max(box.left - point[0], point[0] - box.right, 0.0)
    down = max(box.top - point[1], point[1] - box.bottom, 0.0)
    return math.hypot(across, down)


def _candidates(label: Label, width: float, height: float) -> list[tuple[float, Box]]:
    """Boxes around the thing and what they cost for lying where they lie."""
    preferred = math.atan2(label.direction[1], label.direction[0])
    found = []
    for ring in _RINGS:
        for turn in np.linspace(0.0, math.tau, _DIRECTIONS, endpoint=False).tolist():
            # the box touches an oval around the thing from outside
            away = label.reach + ring * height
            x = label.near[0] + math.cos(preferred + turn) * (away + width / 2)
            y = label.near[1] + math.sin(preferred + turn) * (away + height / 2)
            box = Box(x - width / 2, y - height / 2, x + width / 2, y + height / 2)
            found.append((ring + _COST_OF_TURNING * (1 - math.cos(turn)), box))
    return found


def _covers(box: Box, points: FloatArray) -> bool:
    x, y = points.T
    return bool(((box.left < x) & (x < box.right) & (box.top < y) & (y < box.bottom)).any())


def _is_nearer_to_another(box: Box, label: Label, labels: Sequence[Label]) -> bool:
    own = distance(box, label.near)
    return any(distance(box, other.near) < own for other in labels if other is not label)


class _Ink:
    """How much is drawn in any box, quick to ask, of a canvas whose pixels [h, w] are so dark."""

    def __init__(self, canvas: Canvas, darkness: FloatArray) -> None:
        self._sums: FloatArray = np.zeros(np.add(darkness.shape, 1))
        self._sums[1:, 1:] = darkness.cumsum(axis=0).cumsum(axis=1)
        self._left, self._top = canvas.box.left, canvas.box.top

    def share(self, box: Box) -> float:
        """Mean darkness of the box, 0 (empty) to 1."""
        bottom_most, right_most = (side - 1 for side in self._sums.shape)
        x0, x1 = np.clip(np.rint([box.left, box.right]) - self._left, 0, right_most).astype(int)
        y0, y1 = np.clip(np.rint([box.top, box.bottom]) - self._top, 0, bottom_most).astype(int)
        total = self._sums[y1, x1] - self._sums[y0, x1] - self._sums[y1, x0] + self._sums[y0, x0]
        return float(total) / max(1, int((x1 - x0) * (y1 - y0)))
