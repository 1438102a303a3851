import dataclasses
import functools

import cv2
import numpy as np
import pytest

from learners import PROFILES
from scenes import META_ACTIONS, MetaAction, Pedestrian, Robot, Scene, Wall, simulate
from studio.errors import InputError
from studio.scene.certainty import wilson
from studio.scene.judgements import judge, utilities
from studio.scene.picture.film import lay_out_film, play_action
from studio.scene.picture.page import compose_picture
from studio.style.palette import LIGHT, THEMES
from studio.style.words import number, share_told
from tests.canvases import check_texts, red_pixels

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
    """Names of eighty letters."""
    name = "a_long_name" + 3 * "_that_goes_on_and_on" + "_number"
    return tuple(MetaAction(f"{name}{index:02d}", 0.1 * index, 0.0) for index in range(count))


def foreign_names(count):
    """Names in letters some of which the face lacks."""
    return tuple(
        MetaAction(f"στροφή-λ_走廊_ทาง_{index}\n", 0.1 * index, -0.2) for index in range(count)
    )


def a_real_crowd():
    """Four people of a recording, who truly walked past their simulated selves."""
    scene = a_scene("seq_square-1234")
    people = tuple(
        dataclasses.replace(person, track=tuple((x - 0.4 * step, y) for step in range(9)))
        for person in scene.pedestrians
        for x, y in [person.start]
    )
    return dataclasses.replace(
        scene, pedestrians=people, family="tracks", pattern="recorded", number=1234
    )


def with_contacts(rollouts, person, wall=-1):
    """The rollouts with a person and a wall touched at these steps of each."""
    never = np.zeros_like(rollouts.person_step)
    return dataclasses.replace(rollouts, person_step=never + person, wall_step=never + wall)


CASES = {
    "default": lambda: some_rollouts(),
    "nobody": lambda: some_rollouts(a_scene(people=0, groups=())),
    "one action, one rollout": lambda: some_rollouts(actions=META_ACTIONS[:1], rollouts=1),
    "forty people": lambda: some_rollouts(a_scene(people=40), rollouts=40),
    "long names": lambda: some_rollouts(a_scene(name="W" * 64), actions=long_names(16)),
    "twelve actions": lambda: some_rollouts(a_scene(people=1, groups=()), foreign_names(12)),
    "far from the origin": lambda: some_rollouts(a_scene(origin=(700.0, -300.0))),
    "one step": lambda: some_rollouts(horizon=0.1),
    "a real crowd": lambda: some_rollouts(a_real_crowd()),
    "walls touched": lambda: with_contacts(some_rollouts(), 3, wall=2),
    "a sample": lambda: some_rollouts(rollouts=3000, horizon=0.3).keep_paths(20),
    "many rollouts": lambda: some_rollouts(actions=long_names(7), rollouts=200, horizon=0.3),
}

PAGES = [  # every size and theme with a few of the cases, every case on a few of the pages
    ("default", (640, 360), "light"),
    ("default", (1080, 1350), "dark"),
    ("default", (3840, 2160), "light"),
    ("nobody", (640, 360), "dark"),
    ("nobody", (1080, 1350), "light"),
    ("one action, one rollout", (640, 360), "light"),
    ("one action, one rollout", (1600, 900), "dark"),
    ("forty people", (640, 360), "dark"),
    ("forty people", (1280, 720), "light"),
    ("long names", (640, 360), "light"),
    ("long names", (1600, 900), "dark"),
    ("long names", (1080, 1350), "light"),
    ("twelve actions", (640, 360), "dark"),
    ("twelve actions", (1280, 720), "light"),
    ("far from the origin", (1600, 900), "light"),
    ("one step", (640, 360), "light"),
    ("one step", (1600, 900), "light"),
    ("a real crowd", (640, 360), "light"),
    ("a real crowd", (1280, 720), "dark"),
    ("walls touched", (640, 360), "dark"),
    ("walls touched", (1280, 720), "light"),
    ("walls touched", (1080, 1350), "light"),
    ("a sample", (640, 360), "light"),
    ("a sample", (1280, 720), "light"),
    ("many rollouts", (640, 360), "light"),
    ("many rollouts", (1000, 1000), "light"),
]


FOUR_TEACHERS = {**PROFILES, "a_teacher_with_a_name_of_its_own": PROFILES["tk"]}


@functools.cache
def the_case(name):
    rollouts = CASES[name]()
    profiles = FOUR_TEACHERS if name in ("twelve actions", "walls touched") else PROFILES
    # as if there were as many more rollouts as a reference has
    return rollouts, judge(rollouts, profiles, np.tile(utilities(rollouts), 3))


@pytest.fixture(scope="module")
def default():
    return the_case("default")


@pytest.mark.parametrize(("name", "size", "theme"), PAGES)
def test_texts_stay_on_the_page_and_off_one_another(name, size, theme):
    canvas = compose_picture(*the_case(name), size, THEMES[theme])
    assert len(canvas.texts) > 20
    check_texts(canvas)


@pytest.mark.parametrize(("name", "size", "theme"), PAGES)
def test_texts_of_a_film_stay_on_the_page_and_off_one_another(name, size, theme):
    rollouts = the_case(name)[0].with_paths()
    page, last = lay_out_film(rollouts, size, THEMES[theme]), len(rollouts.actions) - 1
    for canvas in play_action(page, last, np.array([0.0, rollouts.horizon])):
        check_texts(canvas)


@pytest.mark.parametrize("size", SIZES)
def test_the_png_has_the_size_asked_for_and_shows_something(default, tmp_path, size):
    path = tmp_path / "picture.png"
    compose_picture(*default, size).save(path)
    pixels = cv2.imread(str(path))
    assert pixels.shape == (size[1], size[0], 3)
    assert np.array_equal(
        cv2.cvtColor(pixels, cv2.COLOR_BGR2RGB), compose_picture(*default, size).pixels
    )
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
        share = wilson(int((rollouts.person_step[index] >= 0).sum()), 6)
        assert share_told(share.value, share.low, share.high) in texts
        for judgement in judgements:
            assert number(judgement.values[index], ".3f") in texts
            low, high = (number(end[index], ".3f") for end in (judgement.low, judgement.high))
            assert f"[{low}, {high}]" in texts
    for heading in ("Clearance, m", "Deviation, m", "Progress, m", "Smoothness", "Collisions"):
        assert heading in texts


def test_long_names_are_told_apart_by_their_ends():
    texts = [placed.text for placed in compose_picture(*the_case("many rollouts")).texts]
    for index in range(7):
        assert sum(text.startswith("a ") and text.endswith(f"{index:02d}") for text in texts) >= 2


def test_letters_that_the_face_lacks_are_shown_as_boxes():
    texts = [placed.text for placed in compose_picture(*the_case("twelve actions")).texts]
    assert any("στροφή-λ 走廊 □□" in text for text in texts)
    assert not any("?" in text for text in texts)


def test_people_are_spoken_of_where_there_are_some(default):
    def said(case):
        return " ".join(placed.text for placed in compose_picture(*case).texts)

    assert "Grey: people" in said(default)
    assert "Grey: people" not in said(the_case("nobody"))


def test_values_that_round_to_zero_have_no_sign(default):
    rollouts, judgements = default
    nothing = [
        dataclasses.replace(judgement, values=np.full(7, -0.0001)) for judgement in judgements
    ]
    texts = [placed.text for placed in compose_picture(rollouts, nothing).texts]
    assert texts.count("0.000") == 7 * len(nothing)


def test_red_appears_if_and_only_if_something_was_touched(default):
    rollouts, judgements = default
    assert red_pixels(compose_picture(with_contacts(rollouts, -1), judgements).pixels) == 0
    assert red_pixels(compose_picture(with_contacts(rollouts, 3), judgements).pixels) > 500


def test_the_same_input_gives_the_same_picture(default):
    assert np.array_equal(compose_picture(*default).pixels, compose_picture(*default).pixels)


def test_a_table_too_long_for_the_page_says_how_many_actions_it_leaves_out():
    rollouts = some_rollouts(actions=long_names(28), rollouts=2)
    canvas = compose_picture(rollouts, judge(rollouts), (640, 360))
    assert any(
        text.text.startswith("and ") and "more actions" in text.text for text in canvas.texts
    )


def test_an_odd_size_is_fine_for_a_picture_but_a_tiny_one_is_not(default):
    assert compose_picture(*default, (641, 361)).pixels.shape == (361, 641, 3)
    with pytest.raises(InputError, match="size: 64x36 pixels is not allowed"):
        compose_picture(*default, (64, 36))


def test_a_file_that_cannot_be_written_is_no_silent_failure(default, tmp_path):
    with pytest.raises(FileNotFoundError):
        compose_picture(*default, (640, 360)).save(tmp_path / "no" / "picture.png")
