"""Figures that the picture shares with recordings: each is drawn into a box of any page."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from learners import PROFILES
from scenes import META_ACTIONS, Rollouts, load_scene, simulate
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.scene.judgements import Judgement, judge
from studio.scene.picture.curves import draw_value_curves, draw_weighting
from studio.scene.picture.ranks import draw_ranks
from studio.scene.picture.utilities import draw_utilities
from studio.style.palette import LIGHT, THEMES, teacher_colour
from tests.canvases import check_texts, red_pixels, texts

NAMES = tuple(action.name for action in META_ACTIONS)
BOX = Box(600.0, 50.0, 1250.0, 600.0)


@pytest.fixture(scope="module")
def rollouts() -> Rollouts:
    return simulate(load_scene("intersection", number=11), rollouts=50)


@pytest.fixture(scope="module")
def judgements(rollouts: Rollouts) -> tuple[Judgement, ...]:
    return judge(rollouts)


def page(theme: str = "light") -> Canvas:
    return Canvas(1280, 720, THEMES[theme].of(NAMES))


def surely(judgement: Judgement, values: Sequence[float]) -> Judgement:
    """A judgement that every draw agrees with."""
    given = np.array(values)
    return replace(judgement, values=given, resampled=np.tile(given, (10, 1)), reference=None)


def test_nothing_is_drawn_outside_of_the_box(
    rollouts: Rollouts, judgements: tuple[Judgement, ...]
) -> None:
    for draw in (
        lambda canvas: draw_utilities(canvas, BOX, rollouts, judgements),
        lambda canvas: draw_weighting(canvas, BOX, judgements),
        lambda canvas: draw_value_curves(canvas, BOX, judgements, 0.5),
        lambda canvas: draw_ranks(canvas, BOX, NAMES, judgements),
    ):
        canvas = page()
        draw(canvas)
        check_texts(canvas)
        drawn = (canvas.pixels != LIGHT.ground).any(axis=-1)
        y, x = np.nonzero(drawn)
        assert x.min() >= BOX.left - 3
        assert x.max() <= BOX.right + 3
        assert y.min() >= BOX.top - 3
        assert y.max() <= BOX.bottom + 3


def test_every_rollout_has_a_dot_that_says_which_it_is(
    rollouts: Rollouts, judgements: tuple[Judgement, ...]
) -> None:
    canvas = page()
    drawn = draw_utilities(canvas, BOX, rollouts, judgements)
    assert "a dot: one rollout · ×: touches a person" in texts(canvas)
    assert len(drawn.dots) == 7
    for places, numbers in zip(drawn.dots, drawn.rollouts, strict=True):
        assert sorted(numbers.tolist()) == list(range(50))
        assert ((places > (BOX.left, BOX.top)) & (places < (BOX.right, BOX.bottom))).all()
    # the better the outcome, the farther right
    worths = rollouts.features[0] @ np.array([0.10, -0.20, 0.30, 0.05, -0.25])
    x = drawn.dots[0][:, 0]
    by_rollout = x[np.argsort(drawn.rollouts[0])]
    assert (np.diff(by_rollout[np.argsort(worths)]) > -1e-9).all()


def test_fifty_dots_stand_for_more_rollouts_and_say_so(
    rollouts: Rollouts, judgements: tuple[Judgement, ...]
) -> None:
    many = simulate(rollouts.scene, META_ACTIONS[:2], rollouts=1200, horizon=1.0)
    canvas = page()
    drawn = draw_utilities(canvas, BOX, many, judge(many))
    assert [len(places) for places in drawn.dots] == [50, 50]
    assert (drawn.rollouts[0] == -1).all()
    assert any("50 dots stand for 1200 rollouts" in text for text in texts(canvas))


def test_values_come_with_their_intervals_and_a_pick_is_told_from_what_is_open(
    rollouts: Rollouts, judgements: tuple[Judgement, ...]
) -> None:
    sure = surely(judgements[0], [0.3, 0.2, 0.1, 0.0, -0.1, -0.2, -0.3])
    drawn = np.tile(sure.values, (10, 1))
    drawn[5:, 1] = 0.4
    unsure = replace(judgements[1], values=sure.values, resampled=drawn)
    canvas = page()
    draw_utilities(canvas, BOX, rollouts, [sure, unsure])
    said = texts(canvas)
    assert "filled: pick" in said
    assert "outlined: open" in said
    assert "[0.200, 0.400]" in said
    filled, outlined = (
        int((canvas.pixels == teacher_colour(name)).all(axis=-1).sum()) for name in ("eu", "tk")
    )
    assert filled > 2 * outlined


def test_where_rows_are_low_intervals_are_brief_but_right(rollouts: Rollouts) -> None:
    one = surely(judge(rollouts)[0], [10.04, -10.04, 0.5, -0.5, -0.001, 0.0, 1.5])
    canvas = Canvas(640, 360, LIGHT.of(NAMES))
    draw_utilities(canvas, Box(20.0, 20.0, 420.0, 150.0), rollouts, [one] * 2)
    expected = {"−10.040 [−10.04, −10.04]", "−0.500 [−.50, −.50]", "−0.001 [.00, .00]"}
    assert expected <= set(texts(canvas))


def test_contacts_are_red_and_walls_are_told_from_people(rollouts: Rollouts) -> None:
    never = np.full_like(rollouts.person_step, -1)
    counts = []
    for people, walls in ((never, never), (never + 3, never), (never, never + 3)):
        canvas = page()
        touching = replace(rollouts, person_step=people, wall_step=walls)
        draw_utilities(canvas, BOX, touching, ())
        counts.append(red_pixels(canvas.pixels))
        said = " ".join(texts(canvas))
        assert ("touches a person" in said) == (people.max() > 0)
        assert ("touches a wall" in said) == (walls.max() > 0)
    assert counts[0] == 0
    assert min(counts[1:]) > 200
    assert counts[1] != counts[2]


def test_ranks_bend_where_minds_part_and_name_the_actions_at_both_ends(
    judgements: tuple[Judgement, ...],
) -> None:
    one = surely(judgements[0], [7.0, 6.0, 5.0, 4.0, 3.0, 2.0, 1.0])
    same, other = surely(judgements[1], one.values), surely(judgements[2], -one.values)
    canvas = page("dark")
    draw_ranks(canvas, BOX, NAMES, [one, same, other])
    said = texts(canvas)
    assert said.count("slow down") == 2
    assert {"EU", "T&K", "Strong", "7.000", "−7.000"} <= set(said)
    heights = {text.box.top for text in canvas.texts if text.text in ("stop", "5.000", "−5.000")}
    # at the same height until the last teacher turns everything upside down
    assert len(heights) == 2
    alone = page()
    draw_ranks(alone, BOX, NAMES, [one])
    assert texts(alone).count("slow down") == 1


def test_curves_have_numbers_at_both_axes_and_the_teachers_names() -> None:
    every = [Judgement(name, own, np.zeros(1), np.zeros((2, 1))) for name, own in PROFILES.items()]
    for draw in (
        lambda canvas: draw_weighting(canvas, BOX, every),
        lambda canvas: draw_value_curves(canvas, BOX, every, 0.4),
    ):
        canvas = page()
        draw(canvas)
        said = texts(canvas)
        assert {"EU", "T&K", "Strong"} <= set(said)
        left = [text.text for text in canvas.texts if text.box.right < BOX.left + 40]
        assert len(left) >= 3
