"""Scenes from real crowds."""

import math
import os
from pathlib import Path

import numpy as np
import pytest

from scenes.errors import InputError
from scenes.ewap import read_tracks
from scenes.geometry import distance_to_segments
from scenes.scene_text import scene_from_toml, scene_to_toml
from scenes.tracks import busiest_frames, scene_from_tracks
from tests.scenes.crowds import TWO, rows, walker

EWAP = Path(
    os.environ.get("STUDIO_EWAP", Path(__file__).resolve().parents[3] / "shared" / "data" / "ewap")
)


def test_people_start_as_they_were(recording) -> None:
    scene = scene_from_tracks(recording(TWO), 106)
    assert (scene.name, scene.family, scene.pattern) == ("square-106", "tracks", "recorded")
    assert scene.number == 106
    third, seventh = scene.pedestrians  # in the order of their numbers
    np.testing.assert_allclose(third.start, (0.0, 1.8))
    np.testing.assert_allclose(seventh.start, (0.4, 0.0))
    assert seventh.velocity == (1.0, 0.0)
    assert seventh.desired_speed == pytest.approx(1.0)


def test_the_desired_speed_is_the_mean_of_what_follows(recording) -> None:
    slowing = {1: lambda step: (step, 0.0, 1.5 - 0.2 * step, 0.0)}
    scene = scene_from_tracks(recording(slowing), 112)
    assert scene.pedestrians[0].velocity == (1.1, 0.0)
    assert scene.pedestrians[0].desired_speed == pytest.approx(0.8)


def test_a_goal_lies_behind_the_end_of_the_track_and_far_away(recording) -> None:
    turning = {1: lambda step: (min(step, 3), max(0, step - 3), 1.0, 0.0)}
    scene = scene_from_tracks(recording(turning), 100)
    person = scene.pedestrians[0]
    x, y = person.goal
    assert math.atan2(y, x) == pytest.approx(math.atan2(2.0, 3.0))
    assert math.dist(person.start, person.goal) > 30.0


def test_who_leaves_the_picture_walks_on(recording) -> None:
    scene = scene_from_tracks(recording(TWO), 130)
    seventh = scene.pedestrians[1]
    assert seventh.goal[0] > 30.0
    assert seventh.goal[1] == pytest.approx(0.0)


def test_who_stands_stays(recording) -> None:
    scene = scene_from_tracks(recording({1: walker(1.0, 1.0, 0.1, 0.1)}), 100)
    assert scene.pedestrians[0].desired_speed == 0.0
    assert scene.pedestrians[0].velocity is None


def test_the_true_walk_is_kept_from_the_moment_on(recording) -> None:
    every = rows({1: walker(0.0, 0.0, 1.0, 0.25)})
    folder = recording([row for row in every if not row.startswith("112 ")])
    [person] = scene_from_tracks(folder, 100).pedestrians
    assert person.track is not None
    # a missing annotation lies between its neighbours
    np.testing.assert_allclose(person.track[:4], [(0, 0), (0.4, 0.1), (0.8, 0.2), (1.2, 0.3)])
    [later] = scene_from_tracks(folder, 106).pedestrians
    assert later.track == person.track[1:]


def test_groups_are_of_those_present(recording) -> None:
    people = {number: walker(float(number), 0.0, 0.0, 1.0) for number in (1, 2, 3, 5, 8)}
    folder = recording(people, groups_txt="2 9\n3 8 4 3\n\n 8 1\n1 5\n")
    scene = scene_from_tracks(folder, 100)
    assert scene.groups == ((2, 4), (0, 3))


def test_who_is_annotated_inside_a_wall_is_moved_out_no_further_than_needed(recording) -> None:
    people = {1: walker(0.0, 0.05, 1.0, 0.0), 2: walker(3.0, 0.5, 1.0, 0.0)}
    folder = recording(people, map_xml='<Map><Line x1="-9" y1="0" x2="9" y2="0" /></Map>')
    scene = scene_from_tracks(folder, 100)
    assert scene.starts[1] == pytest.approx((3.0, 0.5))
    assert 0.2 <= scene.starts[0, 1] <= 0.21
    assert abs(scene.starts[0, 0]) < 0.02


def test_people_annotated_inside_each_other_are_moved_apart(recording) -> None:
    people = {number: walker(0.01 * number, 0.0, 1.0, 0.0) for number in range(5)}
    starts = scene_from_tracks(recording(people), 100).starts
    apart = np.linalg.norm(starts[:, None] - starts, axis=-1) + np.eye(5)
    assert apart.min() >= 0.2
    assert np.abs(starts).max() < 0.6


def test_the_busiest_moments_come_first_and_are_seconds_apart(recording) -> None:
    alone, joined = {1: walker(0, 0, 1, 0)}, {2: walker(0, 5, 1, 0)}
    later = [line for line in rows(joined, 16) if int(line.split()[0]) >= 172]  # from step 12 on
    folder = recording(rows(alone, 16) + later)
    # 4 s are ten annotations, that is 60 frames
    assert busiest_frames(folder) == [(172, 2), (100, 1)]
    assert busiest_frames(folder, 1) == [(172, 2)]


def test_the_scene_survives_toml(recording) -> None:
    scene = scene_from_tracks(recording(TWO), 100)
    assert scene_from_toml(scene_to_toml(scene)) == scene


@pytest.mark.parametrize(
    ("frame", "nearest"), [(99, "100"), (101, "100 and 106"), (500, "130"), (-1, "100")]
)
def test_an_empty_frame_is_refused_with_its_neighbours(recording, frame: int, nearest: str) -> None:
    with pytest.raises(InputError) as refused:
        scene_from_tracks(recording(TWO), frame)
    assert str(refused.value) == (
        f"frame: nobody is annotated at frame {frame} of square: the nearest with people: {nearest}"
    )


def test_people_faster_than_people_are_are_refused(recording) -> None:
    with pytest.raises(InputError, match=r"person 1: desired_speed: 9\.0 is not allowed"):
        scene_from_tracks(recording({1: walker(0.0, 0.0, 9.0, 0.0)}), 100)


def test_a_count_below_one_is_refused(recording) -> None:
    with pytest.raises(InputError, match="count: 0 is not allowed"):
        busiest_frames(recording(TWO), 0)


@pytest.fixture(params=["seq_eth", "seq_hotel"])
def real(request) -> Path:
    folder = EWAP / request.param
    if not folder.is_dir():
        pytest.skip(f"no recording at {folder}: set STUDIO_EWAP to the folder that holds it")
    return folder


def test_the_busiest_real_moment_makes_a_scene(real: Path) -> None:
    (frame, people), *_ = busiest_frames(real, 1)
    scene = scene_from_tracks(real, frame)
    assert len(scene.pedestrians) == people >= 15
    assert scene.walls
    assert scene.groups


@pytest.mark.slow
def test_every_real_frame_makes_a_scene(real: Path) -> None:
    tracks = read_tracks(real)
    for frame in np.unique(tracks.frames):
        scene = scene_from_tracks(real, int(frame))
        recorded = tracks.positions[tracks.frames == frame]
        moved = np.linalg.norm(scene.starts - recorded, axis=1)
        assert moved.max() < 0.45
        assert np.linalg.norm(scene.starts - scene.robot.start, axis=1).min() > 0.8
        robot = np.array([scene.robot.start])
        assert distance_to_segments(robot, scene.wall_segments).min() > 0.4
