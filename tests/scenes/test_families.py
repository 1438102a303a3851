import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from scenes.errors import InputError
from scenes.families import FAMILIES, PATTERNS, load_scene, sample_scene
from scenes.geometry import distance_to_segments
from scenes.rollouts import simulate
from scenes.scene import Scene
from scenes.scene_text import scene_from_toml, scene_to_toml

COMBINATIONS = [(name, p) for name, family in FAMILIES.items() for p in family.patterns]

any_scene = st.builds(
    lambda combination, seed, number: load_scene(*combination, seed, number),
    st.sampled_from(COMBINATIONS),
    st.integers(0, 2**63 - 1),
    st.integers(0, 2**31 - 1),
)
series = settings(deadline=None, derandomize=True, max_examples=150)


def passes_the_opening(start: tuple[float, float], goal: tuple[float, float], scene: Scene) -> bool:
    """Whether the straight line from start to goal leaves half a metre to every wall end at x = 0.

    A line that does not reach x = 0 passes by definition.
    """
    if start[0] * goal[0] > 0:
        return True
    y = start[1] - start[0] * (goal[1] - start[1]) / (goal[0] - start[0])
    ends = [end[1] for wall in scene.walls for end in (wall.start, wall.end) if end[0] == 0.0]
    return all(abs(y - end) > 0.45 for end in ends) and abs(y) < 1.0


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


@series
@given(any_scene)
def test_nobody_starts_near_anything(scene: Scene) -> None:
    starts = scene.starts
    apart = np.linalg.norm(starts[:, None] - starts, axis=-1)
    assert apart[np.triu_indices(len(starts), k=1)].min(initial=np.inf) >= 0.5
    assert np.linalg.norm(starts - scene.robot.start, axis=-1).min() > 0.8
    if scene.walls:
        assert distance_to_segments(starts, scene.wall_segments).min() >= 0.45
        robot = np.array([scene.robot.start])
        assert distance_to_segments(robot, scene.wall_segments).min() >= 0.6


@series
@given(any_scene)
def test_nobody_arrives_within_ten_seconds(scene: Scene) -> None:
    for person in scene.pedestrians:
        if person.desired_speed > 0:
            reach = 10.0 * (person.desired_speed + 0.6)
            assert math.dist(person.start, person.goal) > reach + 0.5


@series
@given(any_scene)
def test_the_robot_faces_right_and_has_people_to_meet(scene: Scene) -> None:
    assert abs(scene.robot.start_heading) < math.radians(20.0)
    assert math.dist(scene.robot.start, scene.robot.goal) > 4.0
    assert 4 <= len(scene.pedestrians) <= 14
    assert np.linalg.norm(scene.starts - scene.robot.start, axis=-1).min() < 8.0


@series
@given(st.integers(0, 2**31 - 1), st.sampled_from(FAMILIES["doorway"].patterns))
def test_everyone_in_a_doorway_walks_through_the_opening(number: int, pattern: str) -> None:
    scene = load_scene("doorway", pattern, 0, number)
    assert passes_the_opening(scene.robot.start, scene.robot.goal, scene)
    for person in scene.pedestrians:
        if person.desired_speed > 0:
            assert passes_the_opening(person.start, person.goal, scene)


@series
@given(any_scene)
def test_a_group_stands_shoulder_to_shoulder_and_goes_one_way(scene: Scene) -> None:
    for group in scene.groups:
        people = [scene.pedestrians[member] for member in group]
        assert 2 <= len(people) <= 4
        assert len({person.desired_speed for person in people}) == 1
        for left, right in pairwise(people):
            assert 0.6 <= math.dist(left.start, right.start) <= 0.76


@pytest.mark.parametrize("family", FAMILIES)
def test_a_blocking_group_is_in_the_robots_way(family: str) -> None:
    for number in range(30):
        scene = load_scene(family, "group_blocking", 0, number)
        blocking = scene.starts[list(scene.groups[0])]
        x, y = scene.robot.start
        assert (blocking[:, 0] > x + 0.8).all()
        way = y + (blocking[:, 0] - x) * math.tan(scene.robot.start_heading)
        assert abs(blocking[:, 1] - way).min() < 1.0


def test_blocking_groups_stand_come_or_walk_ahead() -> None:
    directions = set()
    for number in range(40):
        scene = load_scene("corridor", "group_blocking", 0, number)
        person = scene.pedestrians[scene.groups[0][0]]
        directions.add(np.sign(person.desired_speed * (person.goal[0] - person.start[0])))
    assert directions == {-1.0, 0.0, 1.0}


def test_people_cross_from_both_sides() -> None:
    scenes = [load_scene("intersection", "crossing", 0, number) for number in range(20)]
    sides = {np.sign(person.goal[1]) for scene in scenes for person in scene.pedestrians}
    assert {-1.0, 1.0} <= sides


@pytest.mark.parametrize(("family", "walls"), [("corridor", 2), ("intersection", 8), ("open", 0)])
def test_places_have_their_walls(family: str, walls: int) -> None:
    assert len(load_scene(family).walls) == walls


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
