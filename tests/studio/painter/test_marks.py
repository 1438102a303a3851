import cv2
import numpy as np
import pytest

from studio.arrays import BoolArray
from studio.painter.axes import Axis
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.marks import Histogram, draw_histogram, draw_icons
from studio.style.palette import LIGHT
from tests.canvases import a_canvas

BLUE = (0, 0, 200)


def test_values_off_an_axis_lie_at_its_end():
    axis = Axis(0.0, 2.0, 100.0, 200.0)
    assert [axis.at(value) for value in (-1.0, 0.0, 1.0, 5.0)] == [100.0, 100.0, 150.0, 200.0]


def reds(canvas: Canvas) -> BoolArray:
    red: BoolArray = (canvas.pixels == LIGHT.contact).all(axis=-1)
    return red


def blobs(mask: BoolArray) -> int:
    """How many pieces hang together."""
    return int(cv2.connectedComponents(mask.astype(np.uint8))[0]) - 1


def test_an_icon_array_has_an_icon_a_rollout_and_contacts_in_red_and_in_shapes_of_their_own():
    canvas = a_canvas()
    draw_icons(canvas, Box(0.0, 0.0, 300.0, 150.0), 7, 5, 50, BLUE)
    assert blobs(reds(canvas)) == 12
    assert blobs((canvas.pixels == BLUE).all(axis=-1)) == 38
    # the middle of a cross is red, that of a square is not
    assert (canvas.pixels[15, 15] == LIGHT.contact).all()
    assert not (canvas.pixels[15 + 30 * 3, 15 + 30] == LIGHT.contact).all()


def test_icons_too_small_to_tell_apart_become_a_bar_that_fills_with_red():
    canvas = a_canvas()
    draw_icons(canvas, Box(0.0, 0.0, 300.0, 12.0), 250, 0, 1000, BLUE)
    assert np.flatnonzero(reds(canvas)[6]).tolist() == list(range(75))
    draw_icons(canvas, Box(0.0, 20.0, 300.0, 32.0), 250, 500, 1000, BLUE)
    filled = reds(canvas)[20:32].any(axis=0)
    assert np.flatnonzero(filled).tolist() == list(range(225))
    assert reds(canvas)[20:32, 10].sum() > reds(canvas)[20:32, 150].sum() > 0


def test_a_histogram_counts_values_by_what_was_touched() -> None:
    values = np.array([-9.0, 0.1, 0.4, 0.6, 1.0, 7.0])
    kinds = np.array([0, 1, 2, 2, 2, 2])
    histogram = Histogram.of(values, np.array([0.0, 0.5, 1.0]), kinds)
    assert histogram.counts.tolist() == [[1, 0], [1, 0], [1, 3]]
    assert histogram.highest == 3
    assert histogram.mean == pytest.approx(np.mean([0.0, 0.1, 0.4, 0.6, 1.0, 1.0]))


def height(most: int, values: list[float]) -> int:
    """How high the bar of equal values is, px, in a box 100 high."""
    canvas = a_canvas(1600, 900)
    histogram = Histogram.of(np.array(values), np.array([0.0, 1.0, 2.0]), np.full(len(values), 2))
    axis = Axis(0.0, 2.0, 0.0, 200.0)
    draw_histogram(canvas, Box(0.0, 0.0, 200.0, 100.0), axis, histogram, most, BLUE)
    return int((canvas.pixels[:, 20] == BLUE).all(axis=-1).sum())


def test_bars_are_as_high_as_they_count_on_a_scale_that_may_be_given() -> None:
    assert height(4, [0.5] * 2) == 50
    assert height(4, [0.5] * 4) == 100
    assert height(1000, [0.5]) == 2  # a sliver
    assert 90 < height(4, [0.5] * 8) < 100  # broken below its top
