"""The noise: one stream a rollout, and the distributions that its fields promise."""

import numpy as np
import pytest

from scenes import NO_NOISE, InputError, Noise, Pedestrian, Robot, Scene
from scenes.noise import disturb

SCENE = Scene(
    "noisy",
    Robot((0.0, 0.0), (9.0, 0.0)),
    (
        Pedestrian((4.0, 0.0), (-40.0, 0.0)),
        Pedestrian((4.0, 2.0), (4.0, 2.0), desired_speed=0.0),
        Pedestrian((6.0, -1.0), (-40.0, -1.0), 1.0, velocity=(-0.5, 0.5)),
    ),
    number=7,
)


def test_more_rollouts_do_not_change_the_first_ones() -> None:
    few, many = (disturb(SCENE, Noise(), k, 20, 0.1, seed=3) for k in (4, 9))
    for name in ("starts", "velocities", "goals", "desired_speeds", "accelerations"):
        np.testing.assert_array_equal(getattr(few.crowd, name), getattr(many.crowd, name)[:4])
    np.testing.assert_array_equal(few.robot_turn, many.robot_turn[:4])


def test_a_longer_horizon_begins_alike() -> None:
    short, long = (disturb(SCENE, Noise(), 5, steps, 0.1, seed=3) for steps in (10, 40))
    np.testing.assert_array_equal(short.crowd.starts, long.crowd.starts)
    np.testing.assert_array_equal(short.crowd.accelerations, long.crowd.accelerations[:, :10])
    np.testing.assert_array_equal(short.robot_speed, long.robot_speed[:, :10])


def test_seed_scene_number_and_rollout_each_change_the_draw() -> None:
    from dataclasses import replace

    base = disturb(SCENE, Noise(), 2, 5, 0.1, seed=0).crowd.starts
    other_seed = disturb(SCENE, Noise(), 2, 5, 0.1, seed=1).crowd.starts
    other_number = disturb(replace(SCENE, number=8), Noise(), 2, 5, 0.1, seed=0).crowd.starts
    draws = [base[0], base[1], other_seed[0], other_seed[1], other_number[0], other_number[1]]
    for index, one in enumerate(draws):
        for another in draws[:index]:
            assert not np.allclose(one, another)


def test_the_global_random_state_is_left_alone() -> None:
    np.random.seed(5)  # noqa: NPY002  # the very thing that must not matter
    expected = np.random.random()  # noqa: NPY002
    np.random.seed(5)  # noqa: NPY002
    disturb(SCENE, Noise(), 3, 5, 0.1, seed=0)
    assert np.random.random() == expected  # noqa: NPY002


def test_without_noise_everything_is_as_the_scene_says() -> None:
    crowd = disturb(SCENE, NO_NOISE, 2, 5, 0.1, seed=0).crowd
    np.testing.assert_array_equal(crowd.starts[1], SCENE.starts)
    np.testing.assert_allclose(crowd.velocities[1], [[-1.34, 0.0], [0.0, 0.0], [-0.5, 0.5]])
    np.testing.assert_allclose(crowd.desired_speeds[1], [1.34, 0.0, 1.0])
    assert not crowd.accelerations.any()


def test_who_stands_is_not_given_a_speed() -> None:
    crowd = disturb(SCENE, Noise(), 50, 5, 0.1, seed=0).crowd
    assert not crowd.desired_speeds[:, 1].any()
    assert not crowd.velocities[:, 1].any()
    assert not crowd.accelerations[:, :, 1].any()


def test_a_recorded_velocity_keeps_its_direction() -> None:
    velocity = disturb(SCENE, Noise(), 50, 5, 0.1, seed=0).crowd.velocities[:, 2]
    np.testing.assert_allclose(velocity[:, 0], -velocity[:, 1])
    assert velocity[:, 0].std() > 0.05


def test_a_recorded_walker_sets_off_about_as_fast_as_recorded() -> None:
    slow = Pedestrian((4.0, 0.0), (-40.0, 0.0), 0.21, velocity=(-0.9, 0.0))
    scene = Scene("slow", Robot((0.0, 3.0), (9.0, 3.0)), (slow,))
    velocity = disturb(scene, Noise(), 500, 5, 0.1, seed=0).crowd.velocities[:, 0, 0]
    assert velocity.min() > -0.9 - 0.53
    assert velocity.max() <= 0.0


def test_the_spread_is_what_the_fields_promise() -> None:
    rollouts = 4000
    noise = Noise(start=0.05, desired_speed=0.26, goal=0.5, acceleration=1.0)
    drawn = disturb(SCENE, noise, rollouts, 30, 0.1, seed=1)
    crowd = drawn.crowd
    jitter = crowd.starts[:, 0] - SCENE.starts[0]
    assert np.abs(jitter).max() <= 0.1 + 1e-12  # two standard deviations
    assert jitter.std() == pytest.approx(0.05, rel=0.08)
    speed = crowd.desired_speeds[:, 0]
    assert speed.mean() == pytest.approx(1.34, abs=0.02)
    # A normal distribution cut off at two sd has 0.8796 of its sd.
    assert speed.std() == pytest.approx(0.8796 * 0.26, rel=0.05)
    assert speed.min() >= 1.34 - 0.52
    assert speed.max() <= 1.34 + 0.52
    assert (crowd.goals[:, 0] - [-40.0, 0.0]).std() == pytest.approx(0.5, rel=0.05)
    assert crowd.accelerations[:, :, 0].std() == pytest.approx(1.0, rel=0.02)
    assert drawn.robot_speed.std() == pytest.approx(0.1, rel=0.03)
    assert drawn.robot_turn.std() == pytest.approx(0.1, rel=0.03)
    # After the memory of 1 s, that is ten steps, the errors correlate by 1/e.
    one, other = drawn.robot_turn[:, 5], drawn.robot_turn[:, 15]
    assert np.corrcoef(one, other)[0, 1] == pytest.approx(np.exp(-1), abs=0.05)


@pytest.mark.parametrize("value", [-0.1, float("nan"), float("inf"), 1e6])
def test_a_strength_that_makes_no_sense_is_refused_in_one_line(value: float) -> None:
    with pytest.raises(InputError, match=r"noise goal: .* is not allowed: 0 to 100") as refused:
        Noise(goal=value)
    assert "\n" not in str(refused.value)
