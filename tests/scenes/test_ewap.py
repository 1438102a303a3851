"""Recordings in the EWAP format."""

from pathlib import Path

import numpy as np
import pytest

from scenes.errors import InputError
from scenes.ewap import read_tracks
from scenes.tracks import scene_from_tracks
from tests.scenes.crowds import TWO, rows


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


def test_a_recording_is_its_folder_or_its_file(recording) -> None:
    folder = recording(TWO)
    assert scene_from_tracks(folder / "obsmat.txt", 100) == scene_from_tracks(folder, 100)
    file = (folder / "obsmat.txt").rename(folder / "a very ödd name.txt")
    assert scene_from_tracks(file, 100).name == "a_very__dd_name-100"


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
