from dataclasses import replace

import cv2
import numpy as np
import pytest

from scenes import Pedestrian, Robot, Scene, load_scene, simulate
from studio.comparison.comparison import QUESTION, side_by_side
from studio.comparison.picture.page import compose_comparison_picture, lay_out_comparison
from studio.scene.framing import in_view
from studio.style.palette import DARK, LIGHT, SIDE_COLOURS
from tests.canvases import check_texts, red_pixels, texts
from tests.studio.comparison.made_up import SIZE, a_comparison


@pytest.mark.parametrize("size", [(640, 360), (1280, 720), (1000, 1400)])
def test_texts_stay_on_the_page_and_off_one_another(unusual, size):
    canvas = compose_comparison_picture(unusual, size)
    check_texts(canvas)
    assert QUESTION in texts(canvas)


def test_texts_stay_apart_on_a_large_page(comparison):
    check_texts(compose_comparison_picture(comparison, (3840, 2160)))


def test_the_page_counts_contacts_with_their_interval_and_shows_all_measures(comparison):
    told = texts(compose_comparison_picture(comparison))
    assert told.index("2 of 5 with contact") < told.index("0 of 5 with contact")
    assert "40 % [12, 77] · × 2 a person" in told
    assert "0 % [0, 43]" in told
    axes = (
        "progress towards the goal, m",
        "smallest gap to a person, m",
        "people are pushed aside",
    )
    for axis in axes:
        assert sum(text.startswith(axis) for text in told) == 2


def test_names_are_told_only_where_they_shall_be(comparison):
    left, right = (action.name.replace("_", " ") for action in comparison.rollouts.actions)
    blind = texts(compose_comparison_picture(comparison))
    assert not any(name in text for text in blind for name in (left, right))
    named = texts(compose_comparison_picture(replace(comparison, named=True)))
    assert named.index("A") < named.index(left) < named.index("B") < named.index(right)


def test_everybody_who_comes_near_is_in_view_and_the_others_are_counted_at_the_edge():
    near = Pedestrian((2.0, 1.0), (-9.0, 1.0))
    far = [Pedestrian((place, 60.0), (place, 90.0)) for place in (0.0, 1.0, 2.0)]
    scene = Scene("a-scene", Robot((0.0, 0.0), (6.0, 0.0)), (near, *far))
    comparison = side_by_side(simulate(scene, rollouts=3, horizon=0.5), "stop", "slow_down")
    canvas = compose_comparison_picture(comparison, (1280, 720))
    check_texts(canvas)
    told = texts(canvas)
    assert told.count("3 more people") == 2
    assert any("4 people (1 in view, 3 not)" in text for text in told)
    for view in lay_out_comparison(comparison, (1280, 720)).views:
        x, y = view.to_pixels(near.start).astype(int)
        assert (canvas.pixels[y, x] == LIGHT.pedestrian).all()


def test_a_picture_never_ends_without_a_person():
    scene = load_scene("intersection", number=11)
    comparison = side_by_side(simulate(scene, rollouts=5), "stop", "slow_down")
    page = lay_out_comparison(comparison, SIZE)
    for view in page.views:
        assert in_view(scene.starts, view.bounds).sum() >= 1
        ends = comparison.rollouts.pedestrians[:, :, -1]
        assert in_view(ends, view.bounds).any(axis=-1).all()


def test_both_sides_have_the_same_axes(comparison):
    page = lay_out_comparison(comparison, (1600, 900))
    for plot in page.plots:
        left, right = plot.rooms
        assert left.width == pytest.approx(right.width)
        assert left.bottom == right.bottom
    assert page.views[0].scale == page.views[1].scale
    assert page.views[0].centre == page.views[1].centre


def test_an_action_keeps_the_colour_that_it_has_among_all_actions(comparison):
    pixels = compose_comparison_picture(replace(comparison, named=True)).pixels
    blind = compose_comparison_picture(comparison).pixels
    theme = LIGHT.of(comparison.actions)
    for side, action in enumerate(comparison.rollouts.actions):
        half = slice(0, 800) if side == 0 else slice(800, 1600)
        own = theme.action_colour(action.name)
        assert (pixels[:, half] == own).all(axis=-1).sum() > 300
        assert (blind[:, half] == own).all(axis=-1).sum() == 0
        assert (blind[:, half] == SIDE_COLOURS[side]).all(axis=-1).sum() > 300


def test_a_sample_says_so_while_counts_and_dots_are_of_all():
    comparison = a_comparison(people=2, rollouts=600, paths=7)
    told = texts(compose_comparison_picture(comparison, (1280, 720)))
    assert any("a sample of 7" in text for text in told)
    assert any("50 dots: 600 outcomes" in text for text in told)
    assert sum(text.endswith("of 600 with contact") for text in told) == 2


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
