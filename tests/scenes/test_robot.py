"""How the robot drives."""

import math
from dataclasses import replace

import numpy as np
import pytest

from scenes import META_ACTIONS, NO_NOISE, InputError, Limits, MetaAction, Noise, Robot, Scene, Wall
from scenes.arrays import FloatArray
from scenes.geometry import distance_to_segments
from scenes.noise import disturb
from scenes.robot import drive
from scenes.scene import ROBOT_RADIUS

OPEN = Scene("open", Robot((0.0, 0.0), (8.0, 0.0)))
ACTIONS = {action.name: action for action in META_ACTIONS}


def driven(
    scene: Scene, *actions: MetaAction, noise: Noise = NO_NOISE, rollouts: int = 1
) -> FloatArray:
    disturbance = disturb(scene, noise, rollouts, 40, 0.1, seed=0)
    return drive(scene, actions, disturbance, Limits(), 0.1)


def test_forward_keeps_its_speed_and_line() -> None:
    path = driven(OPEN, ACTIONS["forward"])[0, 0]
    np.testing.assert_allclose(path[-1], [4.0, 0.0, 0.0, 1.0], atol=1e-12)


def test_stop_brakes_at_the_limit_and_then_stands() -> None:
    path = driven(OPEN, ACTIONS["stop"], noise=Noise(), rollouts=20)[0]
    assert (path[:, 11:, 3] == 0).all()  # 1 m/s at 1 m/s² takes ten steps, and rounding one more
    np.testing.assert_array_equal(
        path[:, 11:, :3], np.broadcast_to(path[:, 11:12, :3], (20, 30, 3))
    )
    undisturbed = driven(OPEN, ACTIONS["stop"])[0, 0]
    assert undisturbed[-1, 0] == pytest.approx(0.45)  # 0.1 (0.9 + 0.8 + ... + 0.1)


def test_turn_rate_is_taken_up_within_the_limit() -> None:
    path = driven(OPEN, ACTIONS["turn_left"])[0, 0]
    turned = np.diff(path[:, 2])
    np.testing.assert_allclose(turned[:4], [0.02, 0.04, 0.05, 0.05], atol=1e-12)
    assert path[-1, 2] == pytest.approx(0.02 + 0.04 + 38 * 0.05)


def test_left_and_right_mirror_each_other() -> None:
    left, right = driven(OPEN, ACTIONS["forward_left"], ACTIONS["forward_right"])[:, 0]
    np.testing.assert_allclose(left * [1, -1, -1, 1], right, atol=1e-12)


def test_the_scene_says_where_it_faces() -> None:
    up = replace(OPEN, robot=Robot((0.0, 0.0), (0.0, 8.0)))
    assert driven(up, ACTIONS["forward"])[0, 0, -1, 1] == pytest.approx(4.0)
    told = replace(OPEN, robot=Robot((0.0, 0.0), (0.0, 8.0), heading=math.pi))
    assert driven(told, ACTIONS["forward"])[0, 0, -1, 0] == pytest.approx(-4.0)


def test_a_wall_stops_it_for_good() -> None:
    walled = replace(OPEN, walls=(Wall((2.0, -3.0), (2.0, 3.0)),))
    path = driven(walled, ACTIONS["forward"], noise=Noise(), rollouts=50)[0]
    gap = distance_to_segments(path[..., :2], walled.wall_segments)[..., 0]
    assert (gap > 0.1).all()  # it never drives through
    assert (path[:, -1, 3] == 0).all()
    touching = gap < ROBOT_RADIUS
    assert touching.any(axis=1).all()
    first = touching.argmax(axis=1)
    for rollout, step in enumerate(first):
        assert (path[rollout, step:, :3] == path[rollout, step, :3]).all()


@pytest.mark.parametrize("dt", [0.1, 0.5])
def test_no_robot_is_so_fast_that_it_jumps_over_a_wall(dt: float) -> None:
    walled = replace(OPEN, walls=(Wall((2.0, -9.0), (2.0, 9.0)),))
    disturbance = disturb(walled, Noise(robot_speed=1.0), 500, 40, dt, seed=0)
    path = drive(walled, (MetaAction("dash", 3.0, 0.0),), disturbance, Limits(9.0, 2.0), dt)
    assert path[..., 0].max() < 2.0
    assert (path[:, :, -1, 3] == 0).mean() > 0.9


def test_noise_spreads_the_paths_and_no_two_actions_differ_in_luck() -> None:
    paths = driven(OPEN, ACTIONS["forward"], ACTIONS["forward"], noise=Noise(), rollouts=200)
    np.testing.assert_array_equal(paths[0], paths[1])
    assert 0.1 < paths[0, :, -1, 1].std() < 1.0


def test_limits_must_be_positive() -> None:
    with pytest.raises(InputError, match="acceleration"):
        Limits(acceleration=0.0)


def test_an_action_that_drives_backwards_is_refused() -> None:
    with pytest.raises(InputError, match=r"'back': speed -1.0 m/s is not allowed: 0 to 3 m/s"):
        MetaAction("back", -1.0, 0.0)
