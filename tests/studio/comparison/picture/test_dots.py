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
    for touched, others in ((0, 0), (count // 3, count // 2), (count // 2, count - count // 2)):
        canvas = Canvas(640, 360, LIGHT)
        array.draw(canvas, touched, others, (0, 0, 200))
        middles = [
            canvas.pixels[int(array.box.top + down), int(array.box.left + across)]
            for across, down in array.grid.places()
        ]
        red = [bool((middle == LIGHT.contact).all()) for middle in middles]
        waiting = [bool((middle == LIGHT.grid).all()) for middle in middles]
        assert red == [index < touched for index in range(count)]
        assert waiting == [touched <= index < count - others for index in range(count)]
