"""Scenes as TOML text, and what is said of a wrong one."""

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scenes import (
    FAMILIES,
    InputError,
    Pedestrian,
    Robot,
    Scene,
    Wall,
    load_scene,
    scene_from_file,
    scene_from_toml,
    scene_to_toml,
)

TOML = """
name = "mine"
groups = [[0, 1]]

[robot]
start = [0.0, 0.0]
goal = [8.0, 0.0]

[[pedestrians]]
start = [3.0, 0.0]
goal = [-30.0, 0.0]

[[pedestrians]]
start = [3.0, 1.0]
goal = [-30.0, 1.0]
desired_speed = 1.1

[[walls]]
start = [-5.0, 2.0]
end = [9.0, 2.0]
"""


def test_a_hand_written_scene_is_read_with_its_defaults() -> None:
    scene = scene_from_toml(TOML)
    assert scene.name == "mine"
    assert scene.family == "custom"
    assert scene.robot == Robot((0.0, 0.0), (8.0, 0.0), heading=None, speed=1.0)
    assert scene.pedestrians[0].desired_speed == 1.34
    assert scene.groups == ((0, 1),)
    assert scene.walls == (Wall((-5.0, 2.0), (9.0, 2.0)),)
    assert scene.bounds == (-5.0, 0.0, 9.0, 2.0)


@settings(deadline=None, derandomize=True, max_examples=60)
@given(st.sampled_from(sorted(FAMILIES)), st.integers(0, 2**63 - 1), st.integers(0, 2**31 - 1))
def test_a_generated_scene_round_trips_through_toml(family: str, seed: int, number: int) -> None:
    scene = load_scene(family, seed=seed, number=number)
    assert scene_from_toml(scene_to_toml(scene)) == scene


def test_every_optional_field_round_trips() -> None:
    scene = Scene(
        "full",
        Robot((0.0, 0.0), (8.0, 0.0), heading=-0.5, speed=0.3),
        (Pedestrian((3.0, 0.0), (3.0, 0.0), 0.0), Pedestrian((4, 1), (9, 1), 1.0, (0.1, -0.2))),
        (Wall((0.0, 3.0), (1.0, 3.0)),),
        ((0, 1),),
        "corridor",
        "mixed",
        5,
    )
    assert scene_from_toml(scene_to_toml(scene)) == scene


def changed(old: str, new: str) -> str:
    assert old in TOML
    return TOML.replace(old, new, 1)


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("name = ", "not TOML: Invalid value"),
        (changed('name = "mine"', 'name = "mine"\ncolour = "red"'), "colour: unknown key"),
        (changed("[robot]", "[robot]\nwheels = 3"), "robot.wheels: unknown key"),
        (changed("goal = [8.0, 0.0]", ""), "robot.goal: missing"),
        (changed('"mine"', '"../mine"'), "name: '../mine' is not allowed"),
        (changed("[3.0, 0.0]", "[nan, 0.0]"), "pedestrians[0].start[0]: nan is not allowed"),
        (changed("[3.0, 0.0]", "[1e9, 0.0]"), "pedestrians[0].start[0]: 1000000000.0 is not"),
        (changed("[3.0, 0.0]", "[3.0]"), "pedestrians[0].start[1]: missing"),
        (changed("1.1", "-1.1"), "pedestrians[1].desired_speed: -1.1 is not allowed"),
        (changed("1.1", '"1.1"'), "pedestrians[1].desired_speed: '1.1' is not allowed"),
        (changed("1.1", "true"), "pedestrians[1].desired_speed: True is not allowed"),
        (changed("[[0, 1]]", "[[0, 1.0]]"), "groups[0][1]: 1.0 is not allowed"),
        ("x = " + "[" * 5000, "nested too deep"),
        (changed("1.1", '"fast"'), "pedestrians[1].desired_speed: 'fast' is not allowed"),
        (changed("[9.0, 2.0]", "[-5.0, 2.0]"), "walls[0] is 0 m long: at least 0.1 m is needed"),
        (changed("[[0, 1]]", "[[0, 2]]"), "groups[0] names pedestrian 2: there are 2"),
        (changed("[[0, 1]]", "[[0]]"), "groups[0] has 1 members: at least 2"),
        (changed("[[0, 1]]", "[[0, 0]]"), "groups[0] names pedestrian 0, who is in groups[0]"),
        (changed("[3.0, 1.0]", "[3.0, 1.9]"), "pedestrians[1].start is 0.10 m from walls[0]"),
        (changed("[3.0, 1.0]", "[3.1, 0.1]"), "pedestrians[0] and pedestrians[1] start 0.14 m"),
        (changed("[3.0, 1.0]", "[0.1, 0.1]"), "pedestrians[1] starts 0.14 m from the robot"),
        (changed("[0.0, 0.0]", "[0.0, 1.9]"), "robot.start is 0.10 m from walls[0], inside it"),
        (changed("[8.0, 0.0]", "[0.1, 0.0]"), "robot.goal is 0.1 m from robot.start"),
        (changed("[-30.0, 0.0]", "[3.0, 0.0]"), "pedestrians[0] walks at 1.34 m/s but starts at"),
    ],
)
def test_a_wrong_scene_is_refused_in_one_line_that_names_the_field(text: str, says: str) -> None:
    with pytest.raises(InputError) as refused:
        scene_from_toml(text, source="mine.toml")
    assert str(refused.value).startswith("mine.toml: ")
    assert says in str(refused.value)
    assert "\n" not in str(refused.value)


def test_several_mistakes_are_counted() -> None:
    text = changed("1.1", "-1.1").replace('"mine"', '"a b"')
    with pytest.raises(InputError, match=r"\(and 1 more\)"):
        scene_from_toml(text)


def test_a_file_that_cannot_be_read_is_named(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"none\.toml: cannot be read as a scene: No such file"):
        scene_from_file(tmp_path / "none.toml")
    (tmp_path / "binary.toml").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(InputError, match="not UTF-8 text"):
        scene_from_file(tmp_path / "binary.toml")
