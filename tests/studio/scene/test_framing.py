import functools

import numpy as np
import pytest

from scenes import FAMILIES, META_ACTIONS, Pedestrian, Robot, Scene, Wall, load_scene, simulate
from studio.scene.framing import (
    MARGIN,
    NEAR,
    SURROUNDINGS,
    beyond_edges,
    bounds_of_shape,
    bounds_to_show,
    comes_near,
    in_view,
)

SCENES = [
    (family, pattern, number)
    for family, about in FAMILIES.items()
    for pattern in about.patterns
    for number in (0, 3)
]


def some_rollouts(people=((3.0, 0.3),), goal=(6.0, 0.0)):
    scene = Scene(
        name="a-scene",
        robot=Robot(start=(0.0, 0.0), goal=goal),
        pedestrians=tuple(Pedestrian(at, (-9.0, at[1]), desired_speed=1.3) for at in people),
        walls=(Wall((-20.0, 20.0), (20.0, 20.0)), Wall((-20.0, -1.5), (20.0, -1.5))),
    )
    return simulate(scene, META_ACTIONS, rollouts=5, horizon=3.0)


@functools.cache
def generated(family, pattern, number):
    return simulate(load_scene(family, pattern, 0, number), rollouts=8)


def paths(rollouts):
    return rollouts.robot[..., :2].reshape(-1, 2)


def nearest(rollouts, person):
    """How near a person comes to a path of the robot, whenever the robot is where, m."""
    return min(
        np.linalg.norm(path[:, None, :2] - walk[None], axis=-1).min()
        for action, walks in zip(rollouts.robot, rollouts.pedestrians, strict=True)
        for path, walk in zip(action, walks[:, :, person], strict=True)
    )


def test_all_that_the_robot_may_do_is_shown_and_among_few_people_little_else():
    rollouts = some_rollouts()
    x0, y0, x1, y1 = bounds_to_show(rollouts)
    (left, low), (right, high) = paths(rollouts).min(axis=0), paths(rollouts).max(axis=0)
    reach = SURROUNDINGS + MARGIN
    assert (x0, x1, y1) == pytest.approx((left - reach, right + reach, high + reach))
    assert y0 == pytest.approx(max(-1.5, low - SURROUNDINGS) - MARGIN)


@pytest.mark.parametrize("shape", [(16.0, 9.0), (300.0, 100.0), (1.0, 2.0)])
def test_bounds_of_a_shape_show_all_the_others_do(shape):
    rollouts = some_rollouts()
    x0, y0, x1, y1 = bounds_of_shape(rollouts, *shape)
    assert (x1 - x0) / (y1 - y0) == pytest.approx(shape[0] / shape[1])
    inner = bounds_to_show(rollouts)
    hair = 1e-9
    outer = (x0 - hair, y0 - hair, x1 + hair, y1 + hair)
    assert in_view(np.array(inner).reshape(2, 2), outer).all()
    # no farther away than they need be
    assert min((x1 - x0) - (inner[2] - inner[0]), (y1 - y0) - (inner[3] - inner[1])) < 1e-9


def test_spare_room_goes_to_the_goal():
    ahead = bounds_of_shape(some_rollouts((), goal=(6.0, 0.0)), 2.0, 1.0)
    assert in_view(np.array([6.0, 0.0]), ahead)
    behind = bounds_of_shape(some_rollouts((), goal=(-4.0, 0.0)), 2.0, 1.0)
    assert behind[0] < ahead[0]


def test_who_comes_near_a_path_of_the_robot_is_told_from_who_does_not():
    rollouts = some_rollouts(((5.5, 0.3), (-6.0, 15.0), (9.0, 4.5), (8.0, 7.0)))
    told = comes_near(rollouts)
    assert told.tolist() == [nearest(rollouts, person) < NEAR for person in range(4)]
    assert 0 < told.sum() < 4


@pytest.mark.parametrize(("family", "pattern", "number"), SCENES)
def test_whoever_comes_near_the_robot_is_in_the_frame_at_the_start(family, pattern, number):
    rollouts = generated(family, pattern, number)
    bounds = bounds_to_show(rollouts)
    near = [person for person in range(len(rollouts.scene.starts)) if nearest(rollouts, person) < 3]
    assert near
    assert in_view(rollouts.scene.starts[near], bounds).all()


@pytest.mark.parametrize(("family", "pattern", "number"), SCENES)
def test_no_rollout_ends_without_a_person_in_view(family, pattern, number):
    rollouts = generated(family, pattern, number)
    ends = rollouts.pedestrians[:, :, -1]
    assert in_view(ends, bounds_to_show(rollouts)).any(axis=-1).all()


def test_a_robot_that_everybody_has_left_behind_is_not_alone_at_the_end():
    leaving = some_rollouts(((-2.5, 0.1),))
    bounds = bounds_to_show(leaving)
    assert in_view(leaving.pedestrians[:, :, -1], bounds).all()
    nobody = some_rollouts(())
    assert np.isfinite(bounds_to_show(nobody)).all()


def test_whoever_is_out_of_view_is_counted_beyond_the_edge_that_is_nearest():
    starts = np.array([[0.0, 0.0], [9.0, 1.0], [8.0, -3.0], [1.0, -7.0], [-30.0, 9.0]])
    told = beyond_edges(starts, (-4.0, -2.0, 4.0, 2.0))
    assert {(each.direction, each.count) for each in told} == {
        ((1.0, 0.0), 2),
        ((0.0, -1.0), 1),
        ((-1.0, 0.0), 1),
    }
    places = {each.direction: each.place for each in told}
    assert places[1.0, 0.0] == (4.0, -0.5)
    assert places[0.0, -1.0] == (1.0, -2.0)
    assert places[-1.0, 0.0] == (-4.0, 2.0)
    assert beyond_edges(starts[:1], (-4.0, -2.0, 4.0, 2.0)) == ()
