from dataclasses import replace
from pathlib import Path

import pytest

from scenes import load_scene, scene_to_toml
from studio.errors import InputError
from studio.scene.sources import Source, find_scene, numbered_scene, words_of


def test_a_family_and_a_file_are_told_apart(tmp_path: Path) -> None:
    doorway = find_scene(Source("doorway", seed=2, number=3))
    assert doorway == load_scene("doorway", None, 2, 3)
    (tmp_path / "mine.toml").write_text(scene_to_toml(doorway))
    assert find_scene(Source(str(tmp_path / "mine.toml"))) == doorway


def test_options_that_do_not_go_with_the_scene_are_refused(tmp_path: Path) -> None:
    (tmp_path / "obsmat.txt").touch()
    for source, message in (
        (Source("doorway", frame=7), "--frame: goes with recorded tracks, not with the family"),
        (Source("mine.toml", number=0), "--number: goes with families or tracks, not with a scene"),
        (Source("mine.toml", robot_goal=(1.0, 2.0)), "--robot-goal: goes with families or tracks"),
        (Source(str(tmp_path / "obsmat.txt"), pattern="head_on"), "--pattern: goes with families"),
        (Source(str(tmp_path / "nowhere.txt")), "is neither a family"),
        (Source(""), "is neither a family"),
    ):
        with pytest.raises(InputError, match=message):
            find_scene(source)


def test_a_numbered_scene_has_a_name_of_its_own() -> None:
    scene = numbered_scene("doorway", None, 2, 3)
    assert scene.name == "doorway-2-3"
    assert numbered_scene("doorway", "mixed", 2, 3).name == "doorway-mixed-2-3"
    assert scene.pedestrians == load_scene("doorway", None, 2, 3).pedestrians


def test_files_are_named_by_what_tells_a_scene_from_the_others_of_its_family() -> None:
    assert words_of(load_scene("doorway"), 0) == ("doorway",)
    assert words_of(load_scene("doorway", number=11), 0) == ("doorway", "11")
    assert words_of(load_scene("doorway", "mixed", 2, 11), 2) == ("doorway", "mixed", "11", "seed2")
    # a name of its own says which scene it is
    assert words_of(numbered_scene("doorway", "mixed", 2, 11), 0) == ("doorway-mixed-2-11",)
    assert words_of(replace(load_scene("doorway"), name="mine"), 5) == ("mine", "seed5")
