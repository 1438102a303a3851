from dataclasses import replace

import cv2
import numpy as np
import pytest

from scenes import META_ACTIONS, Pedestrian, Robot, Scene, load_scene, simulate
from studio.comparison.comparison import QUESTION, ended_after, side_by_side
from studio.comparison.picture.page import compose_comparison_picture, lay_out_comparison
from studio.scene.framing import comes_near, in_view
from studio.style.palette import DARK, LIGHT, SIDE_COLOURS
from studio.style.words import action_label
from tests.canvases import check_texts, red_pixels, texts
from tests.studio.comparison.made_up import NAMES, a_comparison


@pytest.mark.parametrize("size", [(640, 360), (1280, 720), (1000, 1400)])
def test_texts_stay_on_the_page_and_off_one_another(unusual, size):
    canvas = compose_comparison_picture(unusual, size)
    check_texts(canvas)
    assert QUESTION in texts(canvas)


def test_texts_stay_apart_on_a_large_page(comparison):
    check_texts(compose_comparison_picture(comparison, (3840, 2160)))


def test_the_page_counts_contacts_with_an_interval_and_tells_people_from_walls(comparison):
    told = texts(compose_comparison_picture(comparison))
    assert told.index("A") < told.index("B")
    assert told.index("2 of 5 with contact") < told.index("0 of 5 with contact")
    assert {"40 % [12, 77] · × 2 a person", "0 % [0, 43]"} < {*told}
    for axis in ("progress towards the goal, m", "people are pushed aside, m"):
        assert told.count(axis) == 2
    walls = replace(
        comparison.rollouts,
        person_step=comparison.rollouts.wall_step,
        wall_step=comparison.rollouts.person_step,
    )
    told = texts(compose_comparison_picture(replace(comparison, rollouts=walls)))
    assert "40 % [12, 77] · □ 2 a wall" in told
    assert any("touched: □ a wall" in text for text in told)


def test_unless_names_are_asked_for_nothing_tells_which_action_is_which(comparison):
    labels = [action_label(name) for name in comparison.actions]
    blind = compose_comparison_picture(comparison)
    assert not any(label in text for text in texts(blind) for label in labels)
    named = compose_comparison_picture(replace(comparison, named=True))
    told = texts(named)
    left, right = (action_label(name) for name in comparison.rollouts.names)
    assert told.index("A") < told.index(left) < told.index("B") < told.index(right)


def test_the_colours_of_a_blind_picture_are_those_of_its_sides_alone(comparison):
    others = replace(comparison.rollouts, actions=META_ACTIONS[3:5])
    other = replace(comparison, rollouts=others, actions=tuple(a.name for a in META_ACTIONS))
    pictures = [compose_comparison_picture(each).pixels for each in (comparison, other)]
    np.testing.assert_array_equal(*pictures)
    for side, colour in enumerate(SIDE_COLOURS):
        half = pictures[0][:, 800 * side : 800 * (side + 1)]
        assert (half == colour).all(axis=-1).sum() > 300


def test_everybody_who_comes_near_is_in_view_and_the_others_are_counted():
    starts = [(2.5, 2.8), (2.0, -2.5), (60.0, 0.0), (60.0, 2.0)]
    people = tuple(Pedestrian(start, start, desired_speed=0.0) for start in starts)
    scene = Scene("a-scene", Robot((0.0, 0.0), (5.0, 0.0)), people)
    page = lay_out_comparison(side_by_side(simulate(scene, rollouts=3), *NAMES), (1280, 720))
    inside = in_view(scene.starts, page.views[0].bounds)
    assert inside.tolist() == [True, True, False, False]
    assert comes_near(page.sample).tolist() == inside.tolist()
    told = texts(page.canvas)
    assert any("4 people (2 in view, 2 not)" in text for text in told)
    assert told.count("2 more people") == 2  # beside the arrow on each side


@pytest.mark.parametrize(("family", "number"), [("intersection", 11), ("corridor", 3), ("open", 0)])
def test_somebody_is_in_view_at_the_end_of_every_outcome(family, number):
    page = lay_out_comparison(comparison_of(family, number, "stop", "slow_down"), (640, 360))
    ends = page.sample.pedestrians[:, :, -1]
    assert in_view(ends, page.views[0].bounds).any(axis=-1).all()


def comparison_of(family, number, *names):
    rollouts = simulate(load_scene(family, number=number), rollouts=4)
    return side_by_side(rollouts, *names)


def test_where_there_are_many_outcomes_a_sample_of_paths_is_shown_and_said_so():
    many = a_comparison(rollouts=60, horizon=0.2)
    few = replace(many, rollouts=many.rollouts.keep_paths(20))
    page = lay_out_comparison(few, (1280, 720))
    assert page.sample.count == 20
    assert ended_after(page.rollouts)[[0, 10, 20]].tolist() == [0, 30, 60]
    told = texts(compose_comparison_picture(few, (1280, 720)))
    assert any("a sample of 20" in text for text in told)
    assert any("50 dots: 60 outcomes" in text for text in told)
    assert sum("of 60 with contact" in text for text in told) == 2


def test_both_sides_have_the_same_axes(comparison):
    page = lay_out_comparison(comparison, (1600, 900))
    for plot in page.plots:
        left, right = plot.rooms
        assert left.width == pytest.approx(right.width)
        assert left.bottom == right.bottom
    assert page.views[0].scale == page.views[1].scale
    assert page.views[0].centre == page.views[1].centre


def test_a_named_action_keeps_the_colour_that_it_has_among_all_actions(comparison):
    pixels = compose_comparison_picture(replace(comparison, named=True)).pixels
    theme = LIGHT.of(comparison.actions)
    for side, action in enumerate(comparison.rollouts.actions):
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
