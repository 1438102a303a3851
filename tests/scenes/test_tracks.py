import math
import os
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from scenes.errors import InputError
from scenes.ewap import read_tracks
from scenes.geometry import distance_to_segments
from scenes.scene_text import scene_from_toml, scene_to_toml
from scenes.tracks import busiest_frames, scene_at, scene_from_tracks

EWAP = Path(
    os.environ.get("STUDIO_EWAP", Path(__file__).resolve().parents[3] / "shared" / "data" / "ewap")
)

Person = Callable[[int], tuple[float, float, float, float]]
"""x, y, vx, vy of a person at step 0, 1, …"""


def walker(x: float, y: float, vx: float, vy: float) -> Person:
    return lambda step: (x + 0.4 * step * vx, y + 0.4 * step * vy, vx, vy)


def rows(people: dict[int, Person], steps: int = 6) -> list[str]:
    """Annotations every sixth frame from frame 100."""
    return [
        f"{100 + 6 * step} {number} {x} 0 {y} {vx} 0 {vy}"
        for step in range(steps)
        for number, person in people.items()
        for x, y, vx, vy in [person(step)]
    ]


@pytest.fixture
def recording(tmp_path: Path) -> Callable[..., Path]:
    """Writes a made-up recording and gives its folder."""

    def write(people: dict[int, Person] | list[str], **beside: str) -> Path:
        folder = tmp_path / "square"
        folder.mkdir(exist_ok=True)
        lines = people if isinstance(people, list) else rows(people)
        (folder / "obsmat.txt").write_text("\n".join(lines) + "\n", encoding="utf-8")
        for name, text in beside.items():
            (folder / name.replace("_", ".")).write_text(text, encoding="utf-8")
        return folder

    return write


TWO = {7: walker(0.0, 0.0, 1.0, 0.0), 3: walker(0.0, 2.0, 0.0, -0.5)}


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


def test_groups_are_of_those_present(recording) -> None:
    people = {number: walker(float(number), 0.0, 0.0, 1.0) for number in (1, 2, 3, 5, 8)}
    folder = recording(people, groups_txt="2 9\n3 8 4 3\n\n 8 1\n1 5\n")
    scene = scene_from_tracks(folder, 100)
    assert scene.groups == ((2, 4), (0, 3))


def test_a_map_gives_walls(recording) -> None:
    walls = '<Line x1="-5" y1="3" x2="5" y2="3" /><Line x1="6" y1="6" x2="6" y2="6" />'
    circle = '<Circle x="4" y="-4" radius="0.2" /><Circle x="8" y="-4" radius="0.01" />'
    namespaced = f'<?xml version="1.0"?><Trial xmlns="https://maps">{walls}{circle}</Trial>'
    folder = recording(TWO, map_xml=namespaced)
    scene = scene_from_tracks(folder, 100)
    assert (scene.walls[0].start, scene.walls[0].end) == ((-5.0, 3.0), (5.0, 3.0))
    middles = scene.wall_segments.mean(axis=1)
    on_circle = np.hypot(*(middles - (4.0, -4.0)).T) < 0.21
    assert on_circle.sum() >= 6
    assert (np.hypot(*(middles - (8.0, -4.0)).T) < 0.1).sum() == 3
    assert scene == scene_from_tracks(
        recording(TWO, map_xml=namespaced.replace("xmlns=", "n=")), 100
    )


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


def test_the_busiest_moments_come_first_and_are_seconds_apart(recording) -> None:
    alone, joined = {1: walker(0, 0, 1, 0)}, {2: walker(0, 5, 1, 0)}
    later = [line for line in rows(joined, 16) if int(line.split()[0]) >= 172]  # from step 12 on
    folder = recording(rows(alone, 16) + later)
    # 4 s are ten annotations, that is 60 frames
    assert busiest_frames(folder) == [(172, 2), (100, 1)]
    assert busiest_frames(folder, 1) == [(172, 2)]


def test_a_recording_is_its_folder_or_its_file(recording) -> None:
    folder = recording(TWO)
    assert scene_from_tracks(folder / "obsmat.txt", 100) == scene_from_tracks(folder, 100)
    file = (folder / "obsmat.txt").rename(folder / "a very ödd name.txt")
    assert scene_from_tracks(file, 100).name == "a_very__dd_name-100"


def test_the_scene_survives_toml(recording) -> None:
    scene = scene_from_tracks(recording(TWO), 100)
    assert scene_from_toml(scene_to_toml(scene)) == scene


GOOD = rows(TWO)


@pytest.mark.parametrize(
    ("lines", "said"),
    [
        ([], "no annotations in it"),
        (["1 2 3 4"], "4 columns: 8 are needed (frame, person, x, z, y, vx, vz, vy)"),
        ([*GOOD, "1 2 3 4"], "the number of columns changed"),
        ([GOOD[0], GOOD[1].replace("0.0", "left", 1)], "could not convert string 'left'"),
        ([GOOD[0], GOOD[1].replace("0.0", "nan", 1)], "x is nan in row 2: a finite number"),
        (["100.5 1 0 0 0 1 0 0"], "frame is 100.5 in row 1: a whole number from 0 to"),
        ([GOOD[0], GOOD[0]], "person 7 is annotated twice at frame 100"),
        (["-6 1 0 0 0 1 0 0"], "frame is -6 in row 1: a whole number from 0 to"),
    ],
)
def test_malformed_annotations_are_refused_in_one_line(recording, lines, said: str) -> None:
    folder = recording(lines)
    with pytest.raises(InputError) as refused:
        read_tracks(folder)
    assert str(refused.value).startswith(f"{folder / 'obsmat.txt'}: ")
    assert said in str(refused.value)
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize(
    ("beside", "said"),
    [
        ({"map_xml": "<Trial><Line"}, "map.xml: not XML: "),
        ({"map_xml": '<Map><Line x1="0" y1="0" x2="a" y2="1"/></Map>'}, "Line has x2 'a': "),
        ({"map_xml": '<Map><Circle x="0" y="0"/></Map>'}, "Circle has no radius: "),
        ({"map_xml": '<Map><Circle x="0" y="nan" radius="1"/></Map>'}, "Circle has y 'nan': "),
        ({"map_xml": '<Map><Circle x="0" y="0" radius="-1"/></Map>'}, "Circle has radius '-1': "),
        ({"map_xml": '<Map><Circle x="1000" y="0" radius="1"/></Map>'}, "a wall's start[0]: 1001"),
        ({"groups_txt": "1 2\n3 four\n"}, "groups.txt: line 2 is '3 four': "),
    ],
)
def test_malformed_files_beside_it_are_refused_in_one_line(recording, beside, said: str) -> None:
    with pytest.raises(InputError) as refused:
        read_tracks(recording(TWO, **beside))
    assert said in str(refused.value)
    assert "\n" not in str(refused.value)


def test_a_missing_recording_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"obsmat\.txt: cannot be read: No such file"):
        read_tracks(tmp_path)
    with pytest.raises(InputError, match="nowhere: cannot be read: No such file"):
        read_tracks(tmp_path / "nowhere")


@pytest.mark.parametrize(
    ("frame", "nearest"), [(99, "100"), (101, "100 and 106"), (500, "130"), (-1, "100")]
)
def test_an_empty_frame_is_refused_with_its_neighbours(recording, frame: int, nearest: str) -> None:
    with pytest.raises(InputError) as refused:
        scene_from_tracks(recording(TWO), frame)
    assert str(refused.value) == (
        f"frame: nobody is annotated at frame {frame} of square: the nearest with people: {nearest}"
    )


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
        scene = scene_at(tracks, int(frame))
        recorded = tracks.positions[tracks.frames == frame]
        moved = np.linalg.norm(scene.starts - recorded, axis=1)
        assert moved.max() < 0.45
        assert np.linalg.norm(scene.starts - scene.robot.start, axis=1).min() > 0.8
        robot = np.array([scene.robot.start])
        assert distance_to_segments(robot, scene.wall_segments).min() > 0.4
