"""Where to put labels so that they lie near their things and on nothing else."""

import math
from collections.abc import Sequence
from dataclasses import astuple, dataclass

import numpy as np

from studio.arrays import BoolArray, FloatArray
from studio.painter.boxes import Box, Point
from studio.painter.canvas import Canvas
from studio.painter.lettering import SEMIBOLD
from studio.style.palette import Colour
from studio.style.places import choose_places, places_around, spread_apart

_DIRECTIONS = 24  # from a thing, in which its label may lie
_RINGS = (0.0, 0.3, 0.6, 1.0, 1.5, 2.0, 3.0, 4.5)  # distances, in heights of the label
_COST_OF_INK = 12.0  # a label wholly on ink is as bad as this many heights of distance
_COST_OF_SOLID_INK = 30.0  # and as this many more if the ink is as dark as text
_SOLID = 0.42  # of black: people and walls; what is drawn fainter can be written over
_COST_OF_COVERING = 2.0  # heights; a label that lies on a line which must be seen
_COST_OF_TURNING = 0.5  # heights; a label that is not where its thing points to
_COST_OF_CONFUSION = 15.0  # heights; a label that lies nearer to another thing than to its own


@dataclass(frozen=True)
class Label:
    """The name of a thing that lies at a point."""

    text: str
    size: int  # of type, px
    weight: int  # of type, 100 to 1000
    colour: Colour  # of the letters, and of a line to the thing
    near: Point  # where the thing lies, px
    reach: float  # distance to keep from that point, px
    direction: Point  # where from the point the label would best be (dx, dy), of any length


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
    boxes = label_boxes(labels, canvas, area, ground, seen)
    for label, box in zip(labels, boxes, strict=True):
        if box is None:
            continue
        if distance(box, label.near) > label.reach + box.height:
            x, y = label.near
            end = min(max(x, box.left), box.right), min(max(y, box.top), box.bottom)
            canvas.line([label.near, end], label.colour, canvas.hair)
        letters = label.text, label.size, label.colour, label.weight
        canvas.text(box.centre, *letters, anchor="centre", halo=ground)


def label_boxes(
    labels: Sequence[Label],
    canvas: Canvas,
    area: Box,
    ground: Colour,
    seen: FloatArray = _NO_POINTS,
) -> list[Box | None]:
    """Choose a box for each label, or None where there is no room; arguments as `draw_labels`.

    The first labels choose first. A place costs its distance from the thing, the ink and the points
    that it covers; it never overlaps another label nor leaves the area.
    """
    part = canvas.clipped(area)
    away = np.abs(part.pixels.astype(np.int16) - np.array(ground, np.int16)).max(axis=-1) / 255.0
    ink, solid = _Ink(part, away), _Ink(part, (away > _SOLID).astype(np.float64))
    middles, halves, costs = [], [], []
    for label in labels:
        places, half, cost = _candidates(canvas, label)
        boxes = np.concatenate([places - half, places + half], axis=-1)
        own = _distances(boxes, label.near)
        others = [_distances(boxes, other.near) for other in labels if other is not label]
        cost += _COST_OF_INK * ink.shares(boxes)
        cost += _COST_OF_SOLID_INK * solid.shares(boxes)
        cost += _COST_OF_COVERING * _cover(boxes, seen)
        cost += _COST_OF_CONFUSION * np.any([other < own for other in others], axis=0)
        leaves = (boxes[:, :2] < astuple(area)[:2]) | (boxes[:, 2:] > astuple(area)[2:])
        middles.append(places)
        halves.append(half)
        costs.append(np.where(leaves.any(axis=-1), math.inf, cost))
    return [
        None
        if np.isnan(middle).any()
        else Box(*(middle - half).tolist(), *(middle + half).tolist())
        for middle, half in zip(choose_places(middles, halves, costs), halves, strict=True)
    ]


def end_labels(
    canvas: Canvas, left: float, column: Box, labels: Sequence[tuple[float, Sequence[str], Colour]]
) -> None:
    """Write names beside the ends of lines, moved apart where they would touch.

    Names begin at `left` (px) and stay in the column. A label has the height of its line's end, px,
    the wordings of the name, and the line's colour.
    """
    size = canvas.type.small
    step = 1.12 * size
    shown = sorted(labels, key=lambda label: label[0])[: max(1, int(column.height / step))]
    heights = [y for y, _, _ in shown]
    centres = spread_apart(heights, step, column.top + step / 2, column.bottom - step / 2)
    for middle, (_, wordings, colour) in zip(centres, shown, strict=True):
        ink = canvas.theme.legible(colour)
        canvas.fit((left, middle), wordings, column.right - left, size, ink, SEMIBOLD)


def distance(box: Box, point: Point) -> float:
    """Distance from a point to the nearest point of a box, px; 0 inside."""
    return float(_distances(np.array([astuple(box)]), point)[0])


def _distances(boxes: FloatArray, point: Point) -> FloatArray:
    """Distance from a point to the nearest point of each box [N, 4], px, [N]."""
    beyond = np.maximum(boxes[:, :2] - point, point - boxes[:, 2:])
    away: FloatArray = np.hypot(*np.maximum(beyond, 0.0).T)
    return away


def _candidates(canvas: Canvas, label: Label) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Where a label may lie around its thing.

    Returns:
        Its middle at each place [N, 2], half its size [2], px, and what each place costs for its
        distance and its direction [N].
    """
    width = canvas.measure(label.text, label.size, label.weight) + 0.2 * label.size
    height = 1.15 * label.size
    preferred = math.atan2(label.direction[1], label.direction[0])
    turns = np.linspace(0.0, math.tau, _DIRECTIONS, endpoint=False)
    half, distances = np.array([width, height]) / 2, label.reach + np.array(_RINGS) * height
    places = places_around(np.array(label.near), half, distances, preferred + turns)
    return places, half, np.add.outer(_RINGS, _COST_OF_TURNING * (1 - np.cos(turns))).ravel()


def _cover(boxes: FloatArray, points: FloatArray) -> BoolArray:
    """Which boxes [N, 4] cover any of the points [M, 2], [N]."""
    inside = (boxes[:, None, :2] < points) & (points < boxes[:, None, 2:])
    covered: BoolArray = np.any(inside.all(axis=-1), axis=-1)
    return covered


class _Ink:
    """Sums of the darkness [h, w] of a canvas's pixels, 0 to 1, that make any box quick to ask."""

    def __init__(self, canvas: Canvas, darkness: FloatArray) -> None:
        self._sums: FloatArray = np.zeros(np.add(darkness.shape, 1))
        self._sums[1:, 1:] = darkness.cumsum(axis=0).cumsum(axis=1)
        self._corner = (canvas.box.left, canvas.box.top)

    def shares(self, boxes: FloatArray) -> FloatArray:
        """Mean darkness of each box [N, 4], 0 (empty) to 1, [N]."""
        sides = np.array(self._sums.shape[::-1]) - 1
        low, high = (
            np.clip(np.rint(corners) - self._corner, 0, sides).astype(int)
            for corners in (boxes[:, :2], boxes[:, 2:])
        )
        (x0, y0), (x1, y1) = low.T, high.T
        total = self._sums[y1, x1] - self._sums[y0, x1] - self._sums[y1, x0] + self._sums[y0, x0]
        darkness: FloatArray = total / np.maximum(1, (x1 - x0) * (y1 - y0))
        return darkness
