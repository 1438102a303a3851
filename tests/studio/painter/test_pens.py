from typing import get_args

import numpy as np
import pytest

from studio.painter.pens import pen_line, pen_mark
from studio.style.palette import LIGHT, Colour, Marker, Pen
from tests.canvases import a_canvas

BLUE: Colour = (0, 0, 200)


def covered(pen: Pen) -> np.ndarray:
    """The pixels that a marker of radius 20 covers."""
    canvas = a_canvas()
    pen_mark(canvas, (100.0, 100.0), pen, 20.0, LIGHT.ground)
    return (canvas.pixels == BLUE).all(axis=-1)


@pytest.mark.parametrize("marker", get_args(Marker))
def test_markers_are_about_as_large_as_one_another_and_hollow_where_they_should_be(
    marker: Marker,
) -> None:
    filled, hollow = (covered(Pen(BLUE, (), marker, filled)) for filled in (True, False))
    assert 0.7 < filled.sum() / (np.pi * 20.0**2) < 1.2
    assert filled[100, 100]
    assert not hollow[100, 100]
    assert 0 < hollow.sum() < filled.sum()


def test_no_two_markers_look_alike() -> None:
    drawn = [covered(Pen(BLUE, (), marker)) for marker in get_args(Marker)]
    for place, one in enumerate(drawn):
        for other in drawn[:place]:
            assert (one ^ other).sum() > 0.15 * one.sum()


def test_dashes_and_gaps_are_as_long_as_the_pen_says() -> None:
    canvas = a_canvas()
    pen_line(canvas, np.array([(0.0, 50.5), (600.0, 50.5)]), Pen(BLUE, (6.0, 4.0), "circle"), 4.0)
    row = (canvas.pixels[50, :600] == BLUE).all(axis=-1)
    # round ends reach beyond a dash by half the width of the pen
    assert row[4:22].all()
    assert not row[28:36].any()
    assert row[44:60].all()


def test_a_pen_without_dashes_draws_without_gaps() -> None:
    canvas = a_canvas()
    pen_line(canvas, np.array([(0.0, 50.5), (600.0, 50.5)]), Pen(BLUE, (), "circle"), 4.0)
    assert (canvas.pixels[50, 5:595] == BLUE).all()
