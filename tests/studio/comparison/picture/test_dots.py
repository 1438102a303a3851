import pytest

from studio.comparison.picture.dots import IconArray
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.style.palette import LIGHT
from tests.canvases import holds


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
        array.draw(canvas, people, walls, others, (0, 0, 200))
        middles = [
            canvas.pixels[int(array.box.top + down), int(array.box.left + across)]
            for across, down in array.grid.places()
        ]
        crossed = [bool((middle == LIGHT.contact).all()) for middle in middles]
        hollow = [bool((middle == LIGHT.ground).all()) for middle in middles]
        waiting = [bool((middle == LIGHT.grid).all()) for middle in middles]
        touched = people + walls
        assert crossed == [index < people for index in range(count)]
        assert hollow == [people <= index < touched for index in range(count)]
        assert waiting == [touched <= index < count - others for index in range(count)]


def test_a_bar_stands_for_icons_that_could_not_be_told_apart():
    canvas, room = Canvas(640, 360, LIGHT), Box(10.0, 10.0, 210.0, 30.0)
    IconArray.fit(room, 5000, 22.0).draw(canvas, 2500, 0, 2500, (0, 0, 200))
    row = canvas.pixels[20]
    assert (row == LIGHT.contact).all(axis=-1).sum() == pytest.approx(100, abs=2)
    assert (row[:110] == LIGHT.contact).all(axis=-1).sum() >= 98
