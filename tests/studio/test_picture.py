import dataclasses
import itertools

import cv2
import numpy as np
import pytest

from scenes import META_ACTIONS, MetaAction, Pedestrian, Robot, Scene, Wall, simulate
from studio.errors import InputError, RunError
from studio.judgements import judge
from studio.painter.picture import compose_picture, draw_picture, write_png
from studio.palette import LIGHT

SIZES = [(640, 360), (1280, 720), (1600, 900), (3840, 2160), (1000, 1400)]


def a_scene(name="a-scene", origin=(0.0, 0.0), people=4, groups=((0, 1),)):
    x, y = origin
    starts = [(2.0 + 0.6 * (i % 5), -1.2 + 0.7 * (i // 5)) for i in range(people)]
    return Scene(
        name=name,
        robot=Robot(start=(x, y), goal=(x + 6.0, y)),
        pedestrians=tuple(
            Pedestrian((x + px, y + py), (x - 5.0, y + py), desired_speed=0.8) for px, py in starts
        ),
        walls=(Wall((x - 2.0, y + 6.0), (x + 7.0, y + 6.0)),),
        groups=groups,
    )


def some_rollouts(scene=None, actions=META_ACTIONS, rollouts=6, horizon=1.5):
    return simulate(scene or a_scene(), actions, rollouts=rollouts, horizon=horizon)


def long_names(count):
    return tuple(
        MetaAction(f"a_long_name_of_an_action_that_goes_on_and_on_{index}", 0.1 * index, 0.0)
        for index in range(count)
    )


CASES = {
    "default": lambda: some_rollouts(),
    "nobody": lambda: some_rollouts(a_scene(people=0, groups=())),
    "one action, one rollout": lambda: some_rollouts(actions=META_ACTIONS[:1], rollouts=1),
    "forty people": lambda: some_rollouts(a_scene(people=40)),
    "long names": lambda: some_rollouts(a_scene(name="W" * 64), actions=long_names(16)),
    "far from the origin": lambda: some_rollouts(a_scene(origin=(700.0, -300.0))),
    "one step": lambda: some_rollouts(horizon=0.1),
    "many rollouts": lambda: some_rollouts(rollouts=300, horizon=0.5),
}


@pytest.fixture(scope="module", params=CASES)
def case(request):
    rollouts = CASES[request.param]()
    return rollouts, judge(rollouts)


@pytest.fixture(scope="module")
def default():
    rollouts = some_rollouts()
    return rollouts, judge(rollouts)


def red_pixels(pixels):
    return int((pixels == LIGHT.contact).all(axis=-1).sum())


def with_contacts(rollouts, step):
    return dataclasses.replace(rollouts, contact_step=np.full_like(rollouts.contact_step, step))


@pytest.mark.parametrize("size", [(640, 360), (1600, 900)])
def test_texts_stay_on_the_page_and_off_one_another(case, size):
    canvas = compose_picture(*case, size)
    assert len(canvas.texts) > 20
    for text in canvas.texts:
        assert canvas.box.contains(text.box), text
    for first, second in itertools.combinations(canvas.texts, 2):
        assert not first.box.overlaps(second.box), (first, second)


@pytest.mark.parametrize("size", SIZES)
def test_the_png_has_the_size_asked_for_and_shows_something(default, tmp_path, size):
    path = tmp_path / "picture.png"
    write_png(path, *default, size)
    pixels = cv2.imread(str(path))
    assert pixels.shape == (size[1], size[0], 3)
    assert np.array_equal(cv2.cvtColor(pixels, cv2.COLOR_BGR2RGB), draw_picture(*default, size))
    empty = (pixels == LIGHT.ground).all(axis=-1).mean()
    assert 0.2 < empty < 0.95


def test_the_page_says_what_was_simulated_what_happened_and_what_it_is_worth(default):
    rollouts, judgements = default
    texts = [placed.text for placed in compose_picture(*default).texts]
    assert "a-scene" in texts
    assert any(
        all(part in text for part in ("7 actions × 6 rollouts", "4 pedestrians", "1.5 s", "seed 0"))
        for text in texts
    )
    for index, action in enumerate(rollouts.actions):
        assert texts.count(action.name.replace("_", " ")) >= 2  # at its path and in the table
        touched = (rollouts.contact_step[index] >= 0).sum()
        assert f"{touched} of 6" in texts
        for judgement in judgements:
            assert f"{judgement.values[index]:.3f}".replace("-", "−") in texts
    for heading in ("Clearance, m", "Deviation, m", "Progress, m", "Smoothness", "Collisions"):
        assert heading in texts


def test_red_appears_if_and_only_if_something_was_touched(default):
    rollouts, judgements = default
    assert red_pixels(draw_picture(with_contacts(rollouts, -1), judgements)) == 0
    assert red_pixels(draw_picture(with_contacts(rollouts, 3), judgements)) > 500


def test_the_same_input_gives_the_same_picture(default):
    assert np.array_equal(draw_picture(*default), draw_picture(*default))


def test_a_table_too_long_for_the_page_says_how_many_actions_it_leaves_out():
    rollouts = some_rollouts(actions=long_names(28), rollouts=2)
    canvas = compose_picture(rollouts, judge(rollouts), (640, 360))
    assert any(
        text.text.startswith("and ") and "more actions" in text.text for text in canvas.texts
    )


def test_an_odd_size_is_fine_for_a_picture_but_a_tiny_one_is_not(default):
    assert draw_picture(*default, (641, 361)).shape == (361, 641, 3)
    with pytest.raises(InputError, match="size: 64x36 pixels is not allowed"):
        draw_picture(*default, (64, 36))


def test_a_file_that_cannot_be_written_is_reported_in_one_line(default, tmp_path):
    with pytest.raises(RunError, match="cannot be written") as error:
        write_png(tmp_path / "no" / "picture.png", *default, (640, 360))
    assert "\n" not in str(error.value)
