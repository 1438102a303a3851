"""The people of generated scenes."""

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given

from scenes.families import FAMILIES, load_scene
from scenes.geometry import distance_to_segments
from scenes.scene import Scene
from tests.scenes.drawn import any_scene, series


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
