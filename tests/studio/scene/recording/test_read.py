"""Scenes are read back as what they were recorded from."""

from collections.abc import Callable
from dataclasses import fields, replace
from pathlib import Path

import numpy as np
import pytest

from learners import PROFILES
from scenes import META_ACTIONS, Rollouts, Wall, load_scene, simulate
from studio.kinds import read_recording
from studio.scene.judgements import judge, utilities
from studio.scene.kind import SceneRecording
from studio.scene.recording.read import contacts_by_kind
from studio.scene.recording.write import write_recording

ROUNDED = {"robot": 1.0 / 128.0, "pedestrians": 1.0 / 256.0, "without_robot": 1.0 / 256.0}


@pytest.fixture(scope="module")
def rollouts() -> Rollouts:
    return simulate(load_scene("doorway"), rollouts=6, seed=3, horizon=2.0)


@pytest.fixture(scope="module")
def recording(rollouts: Rollouts, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("read") / "doorway.rrd"
    write_recording(path, rollouts, judge(rollouts))
    return path


def read_scene(path: Path) -> SceneRecording:
    read = read_recording(path)
    assert isinstance(read, SceneRecording)
    return read


def test_a_scene_is_read_back_as_it_was_simulated(recording: Path, rollouts: Rollouts) -> None:
    read = read_scene(recording).rollouts
    for field in fields(Rollouts):
        mine, theirs = getattr(read, field.name), getattr(rollouts, field.name)
        if isinstance(theirs, np.ndarray):
            assert mine.shape == theirs.shape
            assert mine.dtype == theirs.dtype
            assert np.abs(mine - theirs).max() <= ROUNDED.get(field.name, 1e-15)
            assert not mine.flags.writeable
        else:
            assert mine == theirs, field.name


def test_what_the_teachers_think_is_read_back(recording: Path, rollouts: Rollouts) -> None:
    for mine, theirs in zip(read_scene(recording).judgements, judge(rollouts), strict=True):
        assert (mine.teacher, mine.parameters, mine.best) == (
            theirs.teacher,
            theirs.parameters,
            theirs.best,
        )
        np.testing.assert_array_equal(mine.values, theirs.values)


def test_what_is_read_and_written_again_reads_the_same(recording: Path, tmp_path: Path) -> None:
    once = read_scene(recording)
    write_recording(tmp_path / "again.rrd", once.rollouts, once.judgements)
    twice = read_scene(tmp_path / "again.rrd")
    for field in fields(Rollouts):
        np.testing.assert_array_equal(
            getattr(once.rollouts, field.name), getattr(twice.rollouts, field.name)
        )


def test_teachers_of_ones_own_are_read_back_in_their_order(
    rollouts: Rollouts, tmp_path: Path
) -> None:
    own = judge(rollouts, {"zoë": PROFILES["tk"], "adam": PROFILES["eu"]})
    write_recording(tmp_path / "own.rrd", rollouts, own)
    assert [each.teacher for each in read_scene(tmp_path / "own.rrd").judgements] == ["zoë", "adam"]


def test_a_scene_without_people_is_read_back(tmp_path: Path) -> None:
    alone = replace(load_scene("open"), pedestrians=(), groups=())
    rollouts = simulate(alone, rollouts=2, horizon=1.0)
    write_recording(tmp_path / "alone.rrd", rollouts, judge(rollouts))
    assert read_scene(tmp_path / "alone.rrd").rollouts.pedestrians.shape == (7, 2, 11, 0, 2)


def test_a_scene_of_the_first_edition_is_read(old: Callable[[str], Path]) -> None:
    read = read_scene(old("scene-edition-1"))
    assert read.rollouts.robot.shape == (3, 4, 21, 3)
    assert read.rollouts.without_robot.shape == (0, 21, 2, 2)  # it does not tell
    assert [each.teacher for each in read.judgements] == ["eu", "tk", "strong"]
    np.testing.assert_allclose(read.rollouts.robot[:, :, 0, :2], 0.0, atol=1e-9)
    again = judge(read.rollouts)
    for mine, theirs in zip(read.judgements, again, strict=True):
        np.testing.assert_allclose(mine.values, theirs.values, atol=1e-6)


def test_a_scene_of_the_second_edition_is_read(old: Callable[[str], Path]) -> None:
    read = read_scene(old("scene-edition-2"))
    assert read.rollouts.robot.shape == (3, 4, 31, 3)
    assert read.rollouts.without_robot.shape == (4, 31, 3, 2)
    assert [each.parameters for each in read.judgements] == list(PROFILES.values())
    for mine, theirs in zip(read.judgements, judge(read.rollouts), strict=True):
        np.testing.assert_allclose(mine.values, theirs.values, atol=1e-12)


def test_the_second_edition_tells_people_and_walls_apart(old: Callable[[str], Path]) -> None:
    read = read_scene(old("scene-edition-2")).rollouts
    assert read.person_step.tolist() == [[15, 17, 16, 20], [26, -1, 28, 30], [-1] * 4]
    assert read.wall_step.tolist() == [[-1] * 4, [-1] * 4, [29, 25, 28, 25]]
    assert read.people_touched.tolist() == [[2, 2, 2, 1], [1, 0, 1, 1], [0] * 4]


def test_of_what_kind_old_contacts_are_follows_from_where_everybody_was() -> None:
    scene = load_scene("intersection", number=4)
    (x, y), heading = scene.robot.start, scene.robot.start_heading
    ahead = np.array([np.cos(heading), np.sin(heading)])
    ends = [(x, y) + 2.6 * ahead + aside * ahead[::-1] * (-1, 1) for aside in (0.3, 1.0)]
    ledge = Wall(*(tuple(end.tolist()) for end in ends))
    rollouts = simulate(replace(scene, walls=(*scene.walls, ledge)), rollouts=20)
    kinds = rollouts.person_step >= 0, rollouts.wall_step >= 0
    for people, walls in ((True, True), (True, False), (False, True), (False, False)):
        assert ((kinds[0] == people) & (kinds[1] == walls)).any()
    found = contacts_by_kind(
        rollouts.scene,
        rollouts.robot,
        rollouts.pedestrians,
        rollouts.contact_step,
        rollouts.features[..., -1],
    )
    for mine, theirs in zip(found, (rollouts.person_step, rollouts.wall_step), strict=True):
        np.testing.assert_array_equal(mine, theirs)


def test_of_many_rollouts_the_first_keep_their_paths_and_all_their_outcomes(tmp_path: Path) -> None:
    rollouts = simulate(load_scene("open"), META_ACTIONS[:2], rollouts=150, horizon=0.5)
    write_recording(tmp_path / "many.rrd", rollouts, judge(rollouts))
    read = read_scene(tmp_path / "many.rrd")
    assert (read.rollouts.count, read.rollouts.paths) == (150, 100)
    assert read.rollouts.without_robot.shape[0] == 100
    np.testing.assert_array_equal(read.rollouts.features, rollouts.features)
    for mine, theirs in zip(read.judgements, judge(rollouts), strict=True):
        np.testing.assert_array_equal(mine.values, theirs.values)


def test_what_values_are_held_against_is_read_back(rollouts: Rollouts, tmp_path: Path) -> None:
    many = np.tile(utilities(rollouts), (1, 3)) + 0.01
    given = judge(rollouts, reference=many)
    write_recording(tmp_path / "held.rrd", rollouts, given)
    for mine, theirs in zip(read_scene(tmp_path / "held.rrd").judgements, given, strict=True):
        assert mine.reference is not None
        assert theirs.reference is not None
        np.testing.assert_array_equal(mine.reference.values, theirs.reference.values)
        np.testing.assert_array_equal(mine.reference.bias, theirs.reference.bias)
        assert mine.candidates == theirs.candidates
