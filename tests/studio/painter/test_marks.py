import pytest

from studio.painter.axes import Axis
from studio.painter.boxes import Box
from studio.painter.marks import draw_icons
from tests.canvases import a_canvas


def test_values_off_an_axis_lie_at_its_end():
    axis = Axis(0.0, 2.0, 100.0, 200.0)
    assert [axis.at(value) for value in (-1.0, 0.0, 1.0, 5.0)] == [100.0, 100.0, 150.0, 200.0]


def test_an_icon_array_has_one_dot_a_rollout_and_the_touched_ones_in_red():
    canvas = a_canvas()
    draw_icons(canvas, Box(0.0, 0.0, 300.0, 150.0), 12, 50, (0, 0, 200))
    reds = (canvas.pixels == (213, 43, 30)).all(axis=-1)
    blues = (canvas.pixels == (0, 0, 200)).all(axis=-1)
    assert reds.sum() / (reds.sum() + blues.sum()) == pytest.approx(12 / 50, abs=0.01)
