"""The places of generated scenes."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from scenes.families import FAMILIES, load_scene
from scenes.scene import Scene
from tests.scenes.drawn import any_scene, series


def passes_the_opening(start: tuple[float, float], goal: tuple[float, float], scene: Scene) -> bool:
    """Whether the straight line from start to goal leaves half a metre to every wall end at x = 0.

    A line that does not reach x = 0 passes by definition.
    """
    if start[0] * goal[0] > 0:
        return True
    y = start[1] - start[0] * (goal[1] - start[1]) / (goal[0] - start[0])
    ends = [end[1] for wall in scene.walls for end in (wall.start, wall.end) if end[0] == 0.0]
    return all(abs(y - end) > 0.45 for end in ends) and abs(y) < 1.0


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


@pytest.mark.parametrize(("family", "walls"), [("corridor", 2), ("intersection", 8), ("open", 0)])
def test_places_have_their_walls(family: str, walls: int) -> None:
    assert len(load_scene(family).walls) == walls
