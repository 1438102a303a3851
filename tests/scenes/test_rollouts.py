"""`simulate`: what a user gets, and what is refused."""

from dataclasses import fields, replace

import numpy as np
import pytest

from scenes import (
    FEATURES,
    META_ACTIONS,
    InputError,
    Noise,
    Pedestrian,
    Robot,
    Scene,
    load_scene,
    simulate,
)

DOORWAY = load_scene("doorway")


def test_shapes_are_as_promised() -> None:
    result = simulate(DOORWAY, rollouts=6, horizon=2.0)
    people = len(DOORWAY.pedestrians)
    assert result.robot.shape == (7, 6, 21, 3)
    assert result.pedestrians.shape == (7, 6, 21, people, 2)
    assert result.without_robot.shape == (6, 21, people, 2)
    assert result.features.shape == (7, 6, len(FEATURES))
    assert result.contact_step.shape == (7, 6)
    assert result.horizon == pytest.approx(2.0)
    for array in (result.robot, result.pedestrians, result.without_robot, result.features):
        assert array.dtype == np.float64
        assert np.isfinite(array).all()


def test_paths_may_be_kept_of_some_rollouts_alone() -> None:
    every = simulate(DOORWAY, rollouts=6, horizon=1.0)
    some = every.keep_paths(2)
    assert (every.paths, some.paths, some.count, some.steps) == (6, 2, 6, 10)
    assert some.without_robot.shape[0] == 2
    np.testing.assert_array_equal(some.features, every.features)
    alone, two = some.with_paths(), simulate(DOORWAY, rollouts=2, horizon=1.0)
    assert (alone.count, alone.paths) == (2, 2)
    for field in fields(two):
        np.testing.assert_array_equal(getattr(alone, field.name), getattr(two, field.name))
    assert every.with_paths() is every


def test_the_same_seed_gives_the_same_result_and_another_another() -> None:
    one, again, other = (simulate(DOORWAY, rollouts=4, seed=seed) for seed in (1, 1, 2))
    np.testing.assert_array_equal(one.pedestrians, again.pedestrians)
    np.testing.assert_array_equal(one.features, again.features)
    assert not np.allclose(one.features, other.features)


def test_result_does_not_depend_on_how_much_is_asked_for_at_once() -> None:
    everything = simulate(DOORWAY, rollouts=40, seed=5)
    part = simulate(DOORWAY, META_ACTIONS[3:5], rollouts=7, seed=5, threads=1)
    np.testing.assert_array_equal(part.robot, everything.robot[3:5, :7])
    np.testing.assert_array_equal(part.pedestrians, everything.pedestrians[3:5, :7])
    np.testing.assert_array_equal(part.without_robot, everything.without_robot[:7])
    np.testing.assert_array_equal(part.features, everything.features[3:5, :7])


def test_a_longer_horizon_begins_alike() -> None:
    short, long = (simulate(DOORWAY, rollouts=3, horizon=h) for h in (1.0, 3.0))
    np.testing.assert_array_equal(short.pedestrians, long.pedestrians[:, :, :11])


@pytest.mark.parametrize("model", ["extended", "helbing-molnar"])
@pytest.mark.parametrize("wrap_angles", [True, False])
def test_both_engines_give_the_same_outcomes(model: str, wrap_angles: bool) -> None:
    ours, theirs = (
        simulate(
            DOORWAY,
            META_ACTIONS[:2],
            rollouts=2,
            engine=engine,
            model=model,
            wrap_angles=wrap_angles,
        )
        for engine in ("batched", "pysocialforce")
    )
    np.testing.assert_allclose(ours.pedestrians, theirs.pedestrians, atol=1e-6)
    np.testing.assert_allclose(ours.features, theirs.features, atol=1e-6)


def test_people_react_to_the_robot() -> None:
    scene = Scene("one", Robot((0.0, 0.0), (9.0, 0.0)), (Pedestrian((4.0, 0.3), (-40.0, 0.3)),))
    result = simulate(scene, META_ACTIONS[:1], rollouts=20)
    aside = np.abs(result.pedestrians - result.without_robot).max(axis=(1, 2, 3))
    assert (aside > 0.05).all()
    assert (result.deviation_m > 0.01).all()


def test_people_who_are_far_from_the_robot_do_not_notice_it() -> None:
    scene = Scene("far", Robot((0.0, 0.0), (9.0, 0.0)), (Pedestrian((500.0, 0.0), (900.0, 0.0)),))
    assert (simulate(scene, META_ACTIONS[:1], rollouts=3).deviation_m < 1e-12).all()


def test_a_person_does_not_walk_into_a_robot_that_stands_in_plain_view() -> None:
    for offset in (0.0, 0.1, 0.3):
        scene = Scene(
            "standing",
            Robot((0.0, 0.0), (9.0, 0.0), speed=0.0),
            (Pedestrian((5.0, offset), (-40.0, offset)),),
        )
        stop = tuple(action for action in META_ACTIONS if action.name == "stop")
        result = simulate(scene, stop, rollouts=200, horizon=8.0)
        assert (result.pedestrians[..., 0] < 0).any(axis=(2, 3)).mean() > 0.9  # they get past
        assert (result.contact_step >= 0).mean() <= 0.01


def test_an_empty_scene_can_be_simulated() -> None:
    empty = Scene("empty", Robot((0.0, 0.0), (9.0, 0.0)))
    result = simulate(empty, rollouts=3)
    assert result.pedestrians.shape == (7, 3, 41, 0, 2)
    assert (result.features[..., 0] == 1.0).all()
    assert not result.features[..., 4].any()


def test_what_does_not_fit_into_memory_is_refused() -> None:
    crowd = tuple(Pedestrian((5.0 + i % 20, 0.5 * (i // 20)), (-90.0, 0.0)) for i in range(400))
    scene = Scene("crowded", Robot((0.0, -5.0), (9.0, -5.0)), crowd)
    with pytest.raises(InputError, match="take fewer rollouts or a shorter horizon"):
        simulate(scene, rollouts=10_000, horizon=60.0)


def test_the_largest_seeds_are_as_different_as_any() -> None:
    robots = [simulate(DOORWAY, rollouts=2, seed=2**63 - 1 - less).robot for less in range(3)]
    assert not np.allclose(robots[0], robots[1])
    assert not np.allclose(robots[1], robots[2])
    assert not np.allclose(robots[0][:, 0], robots[0][:, 1])


def test_a_result_cannot_be_changed_by_accident() -> None:
    result = simulate(DOORWAY, rollouts=1, horizon=0.1)
    with pytest.raises(ValueError, match="read-only"):
        result.robot[0, 0, 0, 0] = 1.0


def test_noise_makes_a_distribution_and_none_makes_a_point() -> None:
    shaken = simulate(DOORWAY, rollouts=10)
    still = simulate(DOORWAY, rollouts=10, noise=Noise(0, 0, 0, 0, 0, 0, 0))
    assert (shaken.features[..., 0].std(axis=1) > 0).any()
    np.testing.assert_array_equal(still.features, np.repeat(still.features[:, :1], 10, axis=1))


def test_the_callers_scene_number_keys_the_noise() -> None:
    one, other = (simulate(replace(DOORWAY, number=number), rollouts=2).robot for number in (0, 1))
    assert not np.allclose(one, other)


@pytest.mark.parametrize(
    ("wrong", "says"),
    [
        ({"rollouts": 0}, "rollouts: 0 is not allowed: 1 to 10000"),
        ({"rollouts": 10**9}, "rollouts: 1000000000 is not allowed"),
        ({"seed": -1}, "seed: -1 is not allowed"),
        ({"seed": 2**63}, "seed: 9223372036854775808 is not allowed: 0 to 9223372036854775807"),
        ({"seed": 1.5}, "seed: 1.5 is not allowed: a whole number is needed"),
        ({"rollouts": 2.5}, "rollouts: 2.5 is not allowed: a whole number is needed"),
        ({"threads": 0}, "threads: 0 is not allowed: 1 to 1024"),
        ({"engine": "warp"}, "engine: 'warp' is not known: batched, pysocialforce"),
        ({"model": "magic"}, "model: 'magic' is not known: extended, helbing-molnar"),
        ({"horizon": 0.0}, "horizon: 0.0 s is not allowed"),
        ({"horizon": float("nan")}, "horizon: nan s is not allowed"),
        ({"horizon": 1e6}, "horizon: 1000000.0 s is not allowed"),
        ({"horizon": 0.25}, "a multiple of the step"),
        ({"dt": 0.0}, "dt: 0.0 s is not allowed"),
        ({"actions": ()}, "actions: none given"),
        ({"actions": META_ACTIONS[:1] * 2}, "every action needs a name of its own"),
    ],
)
def test_wrong_input_is_refused_in_one_line(wrong: dict[str, object], says: str) -> None:
    with pytest.raises(InputError) as refused:
        simulate(DOORWAY, **wrong)  # type: ignore[arg-type]
    assert says in str(refused.value)
    assert "\n" not in str(refused.value)
