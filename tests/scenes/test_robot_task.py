"""The robot's task in a scene from a real crowd."""

import math

import numpy as np
import pytest

from scenes.errors import InputError
from scenes.tracks import scene_from_tracks
from tests.scenes.crowds import TWO, walker


def test_the_robot_meets_people_by_itself(recording) -> None:
    scene = scene_from_tracks(recording(TWO), 100)
    heading = scene.robot.start_heading
    along = np.array([math.cos(heading), math.sin(heading)])
    velocities = np.array([person.velocity for person in scene.pedestrians])
    times = np.linspace(0.0, 4.0, 41)[:, None, None]
    gaps = scene.starts - scene.robot.start + times * (velocities - along)
    nearest = np.linalg.norm(gaps, axis=-1).min(axis=0)
    assert (nearest > 0.8).all()
    assert nearest.min() < 2.0
    assert math.dist(scene.robot.start, scene.robot.goal) > 4.0


def test_the_robot_finds_another_place_when_the_best_is_taken(recording) -> None:
    standing = {n: walker(2.0 + n % 5, n // 5 - 2.0, 0.0, 0.0) for n in range(25)}
    folder = recording({**standing, 50: walker(0.0, 0.0, 1.2, 0.0)})
    scene = scene_from_tracks(folder, 100)
    assert np.linalg.norm(scene.starts - scene.robot.start, axis=1).min() > 0.8


def test_the_robots_task_can_be_given(recording) -> None:
    folder = recording(TWO)
    robot = scene_from_tracks(folder, 100, (-3.0, 0.0), (9.0, 0.0)).robot
    assert (robot.start, robot.goal) == ((-3.0, 0.0), (9.0, 0.0))
    only_start = scene_from_tracks(folder, 100, robot_start=(-3.0, 0.0)).robot
    assert only_start.start == (-3.0, 0.0)
    assert only_start.goal[0] > 0.0  # towards the people
    only_goal = scene_from_tracks(folder, 100, robot_goal=(9.0, 0.0)).robot
    assert only_goal.goal == (9.0, 0.0)
    assert math.dist(only_goal.start, (0.0, 1.0)) < 8.0  # near the people all the same


@pytest.mark.parametrize(
    ("task", "said"),
    [
        ({"robot_start": (0.1, 0.0)}, "robot_start: (0.1, 0) is 0.10 m from the nearest person"),
        ({"robot_start": (1.0, 4.9)}, "robot_start: (1, 4.9) is 0.10 m from the nearest wall"),
        ({"robot_start": (-3.0, 0.0), "robot_goal": (-3.0, 0.1)}, "robot.goal is 0.1 m from "),
        ({"robot_start": (math.nan, 0.0)}, "robot_start: (nan, 0) is not allowed: "),
        ({"robot_goal": (2e4, 0.0)}, "robot_goal: (20000, 0) is not allowed: "),
    ],
)
def test_an_impossible_robot_is_refused_in_one_line(recording, task, said: str) -> None:
    folder = recording(TWO, map_xml='<Map><Line x1="-9" y1="5" x2="9" y2="5" /></Map>')
    with pytest.raises(InputError) as refused:
        scene_from_tracks(folder, 100, **task)
    assert said in str(refused.value)
    assert "\n" not in str(refused.value)
