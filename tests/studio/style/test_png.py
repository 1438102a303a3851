import cv2
import numpy as np
import pytest

from studio.arrays import PixelArray
from studio.painter.canvas import Canvas
from studio.style.palette import ACTION_COLOURS, LIGHT
from studio.style.png import palette_png


def decoded(png: bytes) -> PixelArray:
    pixels = cv2.imdecode(np.frombuffer(png, np.uint8), cv2.IMREAD_COLOR_RGB)
    return np.asarray(pixels, np.uint8)


def test_a_figure_of_few_colours_is_kept_as_it_is() -> None:
    pixels = np.random.default_rng(0).choice([0, 3, 255], (37, 53, 3)).astype(np.uint8)
    np.testing.assert_array_equal(decoded(palette_png(pixels)), pixels)


def test_of_many_colours_the_common_ones_are_kept_and_the_others_hardly_changed() -> None:
    canvas = Canvas(1280, 720, LIGHT)
    for row, colour in enumerate(ACTION_COLOURS):
        canvas.text((40, 60 + 80 * row), "weights of probabilities", 20 + 4 * row, colour)
        canvas.line([(500, 60 + 80 * row), (1200, 90 + 70 * row)], colour, 5.0)
    png = palette_png(canvas.pixels)
    away = np.abs(decoded(png).astype(int) - canvas.pixels).max(axis=-1)
    assert len(np.unique(canvas.pixels.reshape(-1, 3), axis=0)) > 256
    assert away.max() <= 40
    assert (away == 0).mean() > 0.98
    whole = cv2.imencode(".png", canvas.pixels)[1]
    assert len(png) < 0.6 * len(whole)


@pytest.mark.parametrize("colours", [1, 256, 257])
def test_palettes_of_any_size_are_valid(colours: int) -> None:
    numbers = np.arange(colours)
    pixels = np.stack([numbers % 256, numbers // 256, 0 * numbers], axis=-1).astype(np.uint8)[None]
    away = np.abs(decoded(palette_png(pixels)).astype(int) - pixels).max(axis=-1)
    assert (away > 0).sum() == max(colours - 256, 0)
