import cv2
import numpy as np
import pytest

from studio.comparison.comparison import QUESTION
from studio.comparison.picture.page import compose_comparison_picture, lay_out_comparison
from studio.style.palette import DARK, LIGHT
from tests.canvases import check_texts, red_pixels, texts


@pytest.mark.parametrize("size", [(640, 360), (1280, 720), (1000, 1400)])
def test_texts_stay_on_the_page_and_off_one_another(unusual, size):
    canvas = compose_comparison_picture(unusual, size)
    check_texts(canvas)
    assert canvas.texts[0].text == QUESTION


def test_texts_stay_apart_on_a_large_page(comparison):
    check_texts(compose_comparison_picture(comparison, (3840, 2160)))


def test_the_page_names_both_sides_and_counts_their_contacts(comparison):
    told = texts(compose_comparison_picture(comparison))
    left, right = (action.name.replace("_", " ") for action in comparison.rollouts.actions)
    assert told.index("A") < told.index(left) < told.index("B") < told.index(right)
    assert told.index("2 of 5 with contact") < told.index("0 of 5 with contact")
    for axis in ("progress towards the goal, m", "smallest gap to a person, m"):
        assert told.count(axis) == 2


def test_both_sides_have_the_same_axes(comparison):
    page = lay_out_comparison(comparison, (1600, 900))
    for plot in page.plots:
        left, right = plot.rooms
        assert left.width == pytest.approx(right.width)
        assert left.bottom == right.bottom
    assert page.views[0].scale == page.views[1].scale
    assert page.views[0].centre == page.views[1].centre


def test_an_action_keeps_the_colour_that_it_has_among_all_actions(comparison):
    pixels = compose_comparison_picture(comparison).pixels
    names = list(comparison.actions)
    for side, action in enumerate(comparison.rollouts.actions):
        theme = LIGHT.of(names)
        half = pixels[:, :800] if side == 0 else pixels[:, 800:]
        assert (half == theme.action_colour(action.name)).all(axis=-1).sum() > 300


def test_red_appears_if_and_only_if_something_was_touched(comparison):
    width = 1600
    pixels = compose_comparison_picture(comparison, (width, 900)).pixels
    assert red_pixels(pixels[:, : width // 2]) > 300
    assert red_pixels(pixels[:, width // 2 :]) == 0


def test_the_png_shows_what_was_drawn_in_either_theme(comparison, tmp_path):
    for theme in (LIGHT, DARK):
        compose_comparison_picture(comparison, (641, 361), theme).save(tmp_path / "picture.png")
        pixels = cv2.cvtColor(cv2.imread(str(tmp_path / "picture.png")), cv2.COLOR_BGR2RGB)
        assert np.array_equal(
            pixels, compose_comparison_picture(comparison, (641, 361), theme).pixels
        )
        assert 0.2 < (pixels == theme.ground).all(axis=-1).mean() < 0.95
