"""The batched engine against pysocialforce itself, and against the symmetries of space."""

from dataclasses import dataclass, replace

import numpy as np
import pytest

from scenes import batched, reference
from scenes.arrays import FloatArray
from scenes.crowd import Crowd, ForceSet, Surroundings

STEPS, DT = 40, 0.1
CROWDS = 200
TOLERANCE = 1e-6  # m


@dataclass(frozen=True)
class World:
    """A crowd, what surrounds it, and where a robot drives."""

    crowd: Crowd
    surroundings: Surroundings
    robots: FloatArray  # [1, K, T+1, R, 4]


def spaced(rng: np.random.Generator, count: int, apart: float, half_width: float) -> FloatArray:
    """Random places that keep a distance from each other."""
    places: list[FloatArray] = []
    while len(places) < count:
        place = rng.uniform(-half_width, half_width, 2)
        if all(np.linalg.norm(place - other) >= apart for other in places):
            places.append(place)
    return np.array(places)


def walls(rng: np.random.Generator, count: int, people: FloatArray) -> tuple[FloatArray, ...]:
    """Walls in random places where nobody stands, as points."""
    points: list[FloatArray] = []
    while len(points) < count:
        start, end = rng.uniform(-6, 6, (2, 2))
        wall = np.linspace(start, end, max(1, int(np.linalg.norm(start - end) * 10)))
        if np.linalg.norm(wall[:, None] - people, axis=-1).min() > 0.3:
            points.append(wall)
    return tuple(points)


def random_world(number: int) -> World:
    """A crowd of 2 to 15: rollout 0 is undisturbed, rollout 1 shaken; every feature turns up."""
    rng = np.random.default_rng([1995, number])
    people = 2 + number % 14
    place = spaced(rng, people + 1, 0.6, 4.0)
    robot_place, starts = place[0], place[1:]
    goals = rng.uniform(-12, 12, (people, 2))
    speeds = rng.uniform(0.6, 1.8, people)
    speeds[rng.random(people) < 0.15] = 0.0  # some stand
    towards = goals - starts
    velocities = speeds[:, None] * towards / np.linalg.norm(towards, axis=1, keepdims=True)
    if number % 4 == 3:  # as in recorded crowds: on their way to somewhere else than their goals
        velocities = np.where(speeds[:, None] > 0, rng.uniform(-1.5, 1.5, (people, 2)), 0.0)
    accelerations = np.zeros((2, STEPS, people, 2))
    accelerations[1] = rng.normal(0.0, 1.0, (STEPS, people, 2))
    crowd = Crowd(*(np.stack([a, a]) for a in (starts, velocities, goals, speeds)), accelerations)

    members = list(rng.permutation(people))
    groups = []
    while len(members) >= 2 and number % 3:
        size = int(rng.integers(2, 5))
        groups.append(tuple(int(m) for m in members[:size]))
        members = members[size:]
    groups = [group for group in groups if len(group) >= 2]
    surroundings = Surroundings(walls(rng, int(rng.integers(0, 4)), starts), tuple(groups))

    robots = np.zeros((1, 2, STEPS + 1, number % 2, 4))
    if number % 2:
        heading = rng.uniform(-np.pi, np.pi)
        turn = rng.uniform(-0.5, 0.5)
        for step in range(STEPS + 1):
            angle = heading + turn * step * DT
            robots[:, :, step, 0] = (*robot_place, angle, 1.0)
            robot_place = robot_place + DT * np.array([np.cos(angle), np.sin(angle)])
    return World(crowd, surroundings, robots)


def paths(engine: object, world: World, model: ForceSet, wrap: bool) -> FloatArray:
    walk = engine.walk  # type: ignore[attr-defined]
    return walk(world.crowd, world.surroundings, world.robots, model, wrap, DT)


@pytest.mark.parametrize("first", range(0, CROWDS, 20))
@pytest.mark.parametrize("model", ["extended", "helbing-molnar"])
def test_batched_engine_follows_pysocialforce(model: ForceSet, first: int) -> None:
    for number in range(first, first + 20):
        world = random_world(number)
        ours, theirs = (paths(engine, world, model, False) for engine in (batched, reference))
        assert np.isfinite(theirs).all()
        np.testing.assert_allclose(ours, theirs, atol=TOLERANCE, rtol=0, err_msg=f"crowd {number}")


@pytest.mark.parametrize("model", ["extended", "helbing-molnar"])
def test_both_engines_put_the_same_things_right(model: ForceSet) -> None:
    for number in range(30):
        world = random_world(number)
        ours, theirs = (paths(engine, world, model, True) for engine in (batched, reference))
        np.testing.assert_allclose(ours, theirs, atol=TOLERANCE, rtol=0, err_msg=f"crowd {number}")


def test_the_random_crowds_have_all_that_can_go_wrong() -> None:
    worlds = [random_world(number) for number in range(CROWDS)]
    assert {world.crowd.people for world in worlds} == set(range(2, 16))
    assert any(not world.surroundings.wall_points for world in worlds)
    assert any(len(world.surroundings.wall_points) == 3 for world in worlds)
    assert any(not world.surroundings.groups for world in worlds)
    assert any(len(world.surroundings.groups) > 2 for world in worlds)
    assert {world.robots.shape[3] for world in worlds} == {0, 1}
    assert any((world.crowd.desired_speeds == 0).any() for world in worlds)


def test_the_library_is_not_rotation_invariant_and_says_why_we_wrap() -> None:
    turned = [transformed(random_world(number), rotation(2.0)) for number in range(10)]
    strayed = [
        np.abs(
            paths(batched, world, "extended", False)
            - paths(batched, random_world(number), "extended", False) @ rotation(2.0).T
        ).max()
        for number, world in enumerate(turned)
    ]
    assert max(strayed) > 0.01


def rotation(angle: float) -> FloatArray:
    return np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])


MIRROR = np.array([[1.0, 0.0], [0.0, -1.0]])


def transformed(world: World, matrix: FloatArray) -> World:
    """The same world, rotated or mirrored."""
    crowd = world.crowd
    heading = world.robots[..., 2]
    ahead = np.stack([np.cos(heading), np.sin(heading)], axis=-1) @ matrix.T
    robots = world.robots.copy()
    robots[..., :2] = world.robots[..., :2] @ matrix.T
    robots[..., 2] = np.arctan2(ahead[..., 1], ahead[..., 0])
    return World(
        Crowd(
            crowd.starts @ matrix.T,
            crowd.velocities @ matrix.T,
            crowd.goals @ matrix.T,
            crowd.desired_speeds,
            crowd.accelerations @ matrix.T,
        ),
        replace(
            world.surroundings,
            wall_points=tuple(points @ matrix.T for points in world.surroundings.wall_points),
        ),
        robots,
    )


@pytest.mark.parametrize(
    "matrix",
    [rotation(0.3), rotation(np.pi / 2), rotation(np.pi), rotation(-2.4), MIRROR],
    ids=["17 degrees", "quarter turn", "half turn", "-138 degrees", "mirror"],
)
@pytest.mark.parametrize("model", ["extended", "helbing-molnar"])
def test_a_turned_or_mirrored_scene_gives_turned_or_mirrored_paths(
    model: ForceSet, matrix: FloatArray
) -> None:
    for number in range(60):
        world = random_world(number)
        straight = paths(batched, world, model, True)
        turned = paths(batched, transformed(world, matrix), model, True)
        np.testing.assert_allclose(turned, straight @ matrix.T, atol=TOLERANCE, rtol=0)


def test_a_perfectly_symmetric_meeting_stays_symmetric_in_every_direction() -> None:
    starts = np.array([[[-2.0, 0.0], [2.0, 0.0]]])
    crowd = Crowd(starts, -0.5 * starts, -10 * starts, np.ones((1, 2)), np.zeros((1, STEPS, 2, 2)))
    world = World(crowd, Surroundings((), ()), np.zeros((1, 1, STEPS + 1, 0, 4)))
    for angle in np.linspace(0, 2 * np.pi, 37):
        turned = paths(batched, transformed(world, rotation(angle)), "extended", True)
        back = turned @ rotation(angle)
        np.testing.assert_allclose(back[..., 0, :], -back[..., 1, :], atol=1e-9)
        np.testing.assert_allclose(back[..., 1], 0.0, atol=1e-9)


@pytest.mark.parametrize("model", ["extended", "helbing-molnar"])
def test_a_rollout_does_not_depend_on_its_neighbours_or_the_threads(model: ForceSet) -> None:
    rng = np.random.default_rng(5)
    world = random_world(29)
    many = 75  # fills two blocks of lanes and part of a third
    crowd = Crowd(
        *(
            np.repeat(a[:1], many, axis=0)
            for a in (
                world.crowd.starts,
                world.crowd.velocities,
                world.crowd.goals,
                world.crowd.desired_speeds,
            )
        ),
        rng.normal(0.0, 1.0, (many, STEPS, world.crowd.people, 2)),
    )
    robots = np.repeat(world.robots[:, :1], many, axis=1)
    together = batched.walk(crowd, world.surroundings, robots, model, True, DT)
    for k in (0, 31, 32, 74):
        one = Crowd(
            crowd.starts[k : k + 1],
            crowd.velocities[k : k + 1],
            crowd.goals[k : k + 1],
            crowd.desired_speeds[k : k + 1],
            crowd.accelerations[k : k + 1],
        )
        alone = batched.walk(one, world.surroundings, robots[:, k : k + 1], model, True, DT)
        np.testing.assert_array_equal(alone[:, 0], together[:, k])
    single = batched.walk(crowd, world.surroundings, robots, model, True, DT, threads=1)
    np.testing.assert_array_equal(single, together)


def test_who_stands_stays_standing() -> None:
    for number in range(40):
        world = random_world(number)
        standing = world.crowd.desired_speeds[0] == 0
        moved = paths(batched, world, "extended", True)[0][:, :, standing]
        np.testing.assert_array_equal(moved, np.broadcast_to(moved[:, :1], moved.shape))


def test_nobody_is_faster_than_the_model_allows() -> None:
    for model, factor in (("extended", 1.0), ("helbing-molnar", 1.3)):
        for number in range(20):
            world = random_world(number)
            steps = np.diff(paths(batched, world, model, True)[0], axis=1)
            speed = np.linalg.norm(steps, axis=-1) / DT
            assert (speed <= factor * world.crowd.desired_speeds[:, None] + 1e-9).all()


def test_importing_the_reference_engine_leaves_no_trace() -> None:
    import subprocess
    import sys
    import tempfile

    script = (
        "import logging, os, scenes.reference, sys\n"
        "assert logging.getLogger().level == logging.WARNING\n"
        "assert not logging.getLogger().handlers\n"
        "assert not os.listdir('.'), os.listdir('.')\n"
        "assert 'matplotlib' not in sys.modules\n"
    )
    with tempfile.TemporaryDirectory() as empty:
        done = subprocess.run(
            [sys.executable, "-c", script], cwd=empty, capture_output=True, text=True, check=False
        )
    assert done.returncode == 0, done.stderr
    assert not done.stdout
    assert not done.stderr
