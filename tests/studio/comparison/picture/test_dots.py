import cv2
import numpy as np
import pytest

from studio.comparison.dots import Dots, DotScale, dot_measures
from studio.comparison.picture.dots import DotPlot, IconArray
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.scene.measures import NOTHING, PERSON, WALL
from studio.style.palette import LIGHT
from tests.canvases import a_canvas, holds, red_pixels
from tests.studio.comparison.made_up import a_comparison

BLUE = (0, 0, 200)


@pytest.mark.parametrize("count", [1, 7, 50, 200])
def test_icons_fill_up_from_both_ends_and_have_room(count):
    room = Box(10.0, 10.0, 510.0, 50.0)
    array = IconArray.fit(room, count, 22.0)
    assert holds(room.inset(-1e-6), array.box)
    for people, walls, others in (
        (0, 0, 0),
        (count // 3, 0, count // 2),
        (count // 4, count // 4, count - 2 * (count // 4)),
    ):
        canvas = Canvas(640, 360, LIGHT)
        array.draw(canvas, people, walls, others, BLUE)
        middles, squares = [], 0
        for across, down in array.grid.places():
            x, y = int(array.box.left + across), int(array.box.top + down)
            middles.append(canvas.pixels[y, x])
            reach = int(0.5 * array.grid.pitch)
            around = canvas.pixels[y - reach : y + reach + 1, x - reach : x + reach + 1]
            is_red = bool((middles[-1] == LIGHT.contact).all())
            squares += not is_red and red_pixels(around) > 0.4 * reach**2
        red = [bool((middle == LIGHT.contact).all()) for middle in middles]
        waiting = [bool((middle == LIGHT.grid).all()) for middle in middles]
        # a cross has a red middle, a square has none
        assert red == [index < people for index in range(count)]
        assert squares == walls
        assert waiting == [people + walls <= index < count - others for index in range(count)]


@pytest.mark.parametrize("width", [200.0, 500.0])
def test_each_of_many_contacts_can_be_counted(width):
    array, canvas = IconArray.fit(Box(10.0, 10.0, 10.0 + width, 50.0), 50, 22.0), a_canvas()
    array.draw(canvas, 30, 20, 0, BLUE)
    reds = (canvas.pixels == LIGHT.contact).all(axis=-1).astype(np.uint8)
    assert cv2.connectedComponents(reds)[0] - 1 == 50


def test_very_many_icons_become_a_bar_that_fills_from_both_ends():
    array = IconArray.fit(Box(0.0, 0.0, 300.0, 12.0), 5000, 22.0)
    canvas = Canvas(640, 360, LIGHT)
    array.draw(canvas, 1000, 0, 2000, BLUE)
    middle = int(array.box.centre[1])
    width, row = array.box.width, canvas.pixels[middle]
    assert (row == LIGHT.contact).all(axis=-1).sum() == pytest.approx(0.2 * width, abs=2)
    assert (row == LIGHT.grid).all(axis=-1).sum() == pytest.approx(0.4 * width, abs=2)


def test_dots_pile_up_as_outcomes_end_with_those_that_touched_somebody_lowest():
    kinds = np.array([[NOTHING, PERSON, NOTHING, WALL], [NOTHING] * 4])
    comparison = a_comparison(rollouts=4)
    progress = dot_measures(comparison.rollouts)[0]
    dots = Dots.of(np.full(4, 0.5 * (progress.low + progress.high)), kinds[0])
    measure = type(progress)(progress.names, (dots, dots), progress.low, progress.high)
    room = Box(20.0, 20.0, 320.0, 120.0)
    scale = DotScale.fit(measure, room.width, room.height, 20.0)
    canvas, plot = Canvas(640, 360, LIGHT), DotPlot(room, scale, 0, dots)
    drawn = []
    for count in range(5):
        plot.draw(canvas, count, BLUE)
        reds = (canvas.pixels == LIGHT.contact).all(axis=-1)
        blues = (canvas.pixels == BLUE).all(axis=-1)
        drawn.append((int(reds.sum()), int(blues.sum())))
    one_dot = drawn[1][1]
    assert drawn[0] == (0, 0)
    assert [round(blue / one_dot) for _, blue in drawn] == [0, 1, 1, 2, 2]
    assert drawn[1][0] == 0 < drawn[2][0] == drawn[3][0] < drawn[4][0]
    # the last one to come lies below those that were there before it, without contact
    assert np.flatnonzero(reds.any(axis=1)).min() > np.flatnonzero(blues.any(axis=1)).min()
    assert np.flatnonzero(reds.any(axis=1)).max() > np.flatnonzero(blues.any(axis=1)).max()
