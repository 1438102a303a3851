"""The features, by hand."""

from dataclasses import replace

import numpy as np
import pytest

from scenes import FEATURES, Pedestrian, Robot, Scene, Wall
from scenes.features import describe

SCENE = Scene("measured", Robot((0.0, 0.0), (10.0, 0.0)), (Pedestrian((5.0, 3.0), (9.0, 3.0)),))
STEPS = 40


def still_people(*places: tuple[float, float]) -> np.ndarray:
    return np.broadcast_to(np.array(places), (1, 1, STEPS + 1, len(places), 2)).copy()


def straight_robot(speed: float = 1.0) -> np.ndarray:
    path = np.zeros((1, 1, STEPS + 1, 3))
    path[..., 0] = speed * 0.1 * np.arange(STEPS + 1)
    return path


def test_each_feature_of_a_straight_drive_past_one_person() -> None:
    people = still_people((2.0, 1.0))
    outcome = describe(SCENE, straight_robot(), people, people[0], 0.1)
    values = dict(zip(FEATURES, outcome.features[0, 0], strict=True))
    assert outcome.clearance_m[0, 0] == pytest.approx(1.0 - 0.45)
    assert values["clearance"] == pytest.approx(0.55 / 2)
    assert values["deviation"] == 0.0
    assert outcome.progress_m[0, 0] == pytest.approx(4.0)
    assert values["progress"] == pytest.approx(1.0)
    assert values["smoothness"] == 1.0
    assert values["collisions"] == 0.0
    assert outcome.contact_step[0, 0] == -1


def test_deviation_is_the_mean_distance_from_the_path_without_the_robot() -> None:
    people = still_people((5.0, 3.0), (5.0, -3.0))
    without = people[0].copy()
    without[..., 0, :] += [0.3, 0.4]  # one of the two is 0.5 m off, all the time
    outcome = describe(SCENE, straight_robot(), people, without, 0.1)
    assert outcome.deviation_m[0, 0] == pytest.approx(0.25)
    assert outcome.features[0, 0, 1] == pytest.approx(0.5)


def test_smoothness_falls_with_every_turn_either_way() -> None:
    robot = straight_robot()
    robot[..., 10:20, 2] = 0.5  # left by 0.5 rad and back again
    people = still_people((5.0, 3.0))
    assert describe(SCENE, robot, people, people[0], 0.1).features[0, 0, 3] == pytest.approx(0.5)


def test_collisions_count_each_person_once_and_the_walls_once() -> None:
    people = still_people((1.0, 0.1), (2.0, -0.2), (3.0, 2.0))
    walled = replace(SCENE, walls=(Wall((3.5, 0.2), (3.5, 4.0)), Wall((3.5, -0.2), (3.5, -4.0))))
    outcome = describe(walled, straight_robot(), people, people[0], 0.1)
    assert outcome.features[0, 0, 4] == 3.0
    assert outcome.clearance_m[0, 0] == 0.0
    first = outcome.contact_step[0, 0]
    assert np.hypot(0.1 * first - 1.0, 0.1) < 0.45
    assert np.hypot(0.1 * (first - 1) - 1.0, 0.1) >= 0.45
    assert outcome.people_touched[0, 0] == 2
    assert outcome.wall_touched[0, 0]
    assert outcome.person_step[0, 0] == first
    gap = np.hypot(3.5 - 0.1 * np.arange(STEPS + 1), 0.2)  # from the ends of the walls
    assert outcome.wall_step[0, 0] == (gap < 0.25).argmax()


def test_the_first_contact_is_whichever_comes_first() -> None:
    people = still_people((3.0, 0.1))
    walled = replace(SCENE, walls=(Wall((1.0, 0.2), (1.0, 4.0)),))
    wall_first = describe(walled, straight_robot(), people, people[0], 0.1)
    assert 0 <= wall_first.wall_step[0, 0] < wall_first.person_step[0, 0]
    assert wall_first.contact_step[0, 0] == wall_first.wall_step[0, 0]
    no_wall = describe(SCENE, straight_robot(), people, people[0], 0.1)
    assert no_wall.wall_step[0, 0] == -1
    assert no_wall.contact_step[0, 0] == no_wall.person_step[0, 0] > 0


def test_touching_means_nearer_than_both_radii() -> None:
    for gap, touched in ((0.449, 1.0), (0.451, 0.0)):
        people = still_people((2.0, gap))
        outcome = describe(SCENE, straight_robot(), people, people[0], 0.1)
        assert outcome.features[0, 0, 4] == touched


def test_among_nobody_clearance_is_full_and_deviation_nothing() -> None:
    nobody = np.zeros((1, 1, STEPS + 1, 0, 2))
    outcome = describe(replace(SCENE, pedestrians=()), straight_robot(), nobody, nobody[0], 0.1)
    np.testing.assert_allclose(outcome.features[0, 0], [1.0, 0.0, 1.0, 1.0, 0.0])


def test_far_people_are_no_more_than_clear() -> None:
    people = still_people((2.0, 30.0))
    outcome = describe(SCENE, straight_robot(), people, people[0], 0.1)
    assert outcome.features[0, 0, 0] == 1.0
    assert outcome.clearance_m[0, 0] == 2.0
