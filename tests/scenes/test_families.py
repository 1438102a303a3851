"""Families and patterns of generated scenes, and series of them."""

import numpy as np
import pytest

from scenes.errors import InputError
from scenes.families import FAMILIES, PATTERNS, load_scene, sample_scene
from scenes.rollouts import simulate
from scenes.scene_text import scene_from_toml, scene_to_toml
from tests.scenes.drawn import COMBINATIONS


@pytest.mark.parametrize(("family", "pattern"), COMBINATIONS)
def test_a_scene_says_what_it_is(family: str, pattern: str) -> None:
    scene = load_scene(family, pattern, seed=5, number=11)
    assert (scene.name, scene.family, scene.pattern, scene.number) == (family, family, pattern, 11)


@pytest.mark.parametrize("family", FAMILIES)
def test_without_a_pattern_the_familys_first_is_taken(family: str) -> None:
    assert load_scene(family) == load_scene(family, FAMILIES[family].patterns[0])


def test_every_pattern_is_described_and_happens_somewhere() -> None:
    assert {pattern for _, pattern in COMBINATIONS} == set(PATTERNS)
    assert all(PATTERNS.values())
    assert all(family.description for family in FAMILIES.values())


def test_a_scene_depends_on_seed_and_number_alone() -> None:
    first = load_scene("open", "crossing", 3, 4)
    load_scene("open", "crossing", 9, 9)
    assert load_scene("open", "crossing", 3, 4) == first
    assert load_scene("open", "crossing", 3, 5).pedestrians != first.pedestrians
    assert load_scene("open", "crossing", 4, 4).pedestrians != first.pedestrians


@pytest.mark.parametrize(("family", "pattern"), COMBINATIONS)
def test_a_scene_survives_toml(family: str, pattern: str) -> None:
    scene = load_scene(family, pattern, seed=1)
    assert scene_from_toml(scene_to_toml(scene)) == scene


def test_a_series_is_balanced_by_family_and_by_pattern_within_it() -> None:
    scenes = [sample_scene(0, number) for number in range(80)]
    assert [scene.number for scene in scenes] == list(range(80))
    for name, family in FAMILIES.items():
        patterns = [scene.pattern for scene in scenes if scene.family == name]
        assert len(patterns) == 20
        counts = [patterns.count(pattern) for pattern in family.patterns]
        assert max(counts) - min(counts) <= 1


def test_a_series_can_be_narrowed() -> None:
    scenes = [sample_scene(0, number, ["doorway", "open"], ["crossing"]) for number in range(6)]
    assert {(scene.family, scene.pattern) for scene in scenes} == {("open", "crossing")}


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda: load_scene("kitchen"), "family: 'kitchen' is unknown: choose from corridor, "),
        (lambda: load_scene("open", "bottleneck"), "pattern: open has no pattern 'bottleneck': "),
        (lambda: load_scene("open", seed=-1), "seed: -1 is not allowed: 0 to 9223372036854775807"),
        (lambda: load_scene("open", seed=2**63), "seed: 9223372036854775808 is not allowed: "),
        (lambda: load_scene("open", number=2**31), "number: 2147483648 is not allowed: 0 to "),
        (lambda: load_scene("open", number=-1), "number: -1 is not allowed: 0 to 2147483647"),
        (lambda: sample_scene(0, -1), "number: -1 is not allowed"),
        (lambda: sample_scene(0, 0, ["hall"]), "family: 'hall' is unknown"),
        (lambda: sample_scene(0, 0, None, ["dance"]), "pattern: 'dance' is unknown"),
        (lambda: sample_scene(0, 0, ["doorway"], ["crossing"]), "no scene is left to draw: "),
        (lambda: sample_scene(0, 0, []), "no scene is left to draw: "),
    ],
)
def test_a_wrong_wish_is_refused_in_one_line(call, said: str) -> None:  # type: ignore[no-untyped-def]
    with pytest.raises(InputError) as refused:
        call()
    assert str(refused.value).startswith(said)
    assert "\n" not in str(refused.value)


@pytest.mark.slow
def test_a_bank_is_dangerous_now_and_then() -> None:
    scenes = [sample_scene(0, number) for number in range(300)]
    touched = np.array([simulate(scene).features[..., 4].astype(bool).mean(1) for scene in scenes])
    assert 0.02 < touched.mean() < 0.15
    for family in FAMILIES:
        assert touched[[scene.family == family for scene in scenes]].mean() > 0.01
    rare = ((touched > 0.0) & (touched < 0.2)).any(axis=1)
    assert rare.mean() > 0.5
