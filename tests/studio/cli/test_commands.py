"""The command line as a person meets it."""

import json
import os
import signal
import subprocess
import sys
import time
from dataclasses import replace
from inspect import signature
from pathlib import Path

import pyarrow.parquet as pq
import pytest

from learners import CptParameters
from learners.studying.plan import SIZES
from scenes import FAMILIES, PATTERNS, load_scene, scene_from_toml, scene_to_toml
from studio.cli import main
from studio.orchestrator import Studio
from tests.command_line import only_line, run

QUICK = ("--rollouts", "3", "--horizon", "1", "--no-png", "--no-mp4")


def test_record_writes_recording_picture_and_film(tmp_path: Path) -> None:
    result = run(
        "record", "--scene", "doorway", "--rollouts", "3", "--horizon", "0.5", "--out", tmp_path
    )
    assert result.exit_code == 0, result.stderr
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        "doorway.mp4",
        "doorway.png",
        "doorway.rrd",
    ]
    assert all(path.stat().st_size > 1000 for path in tmp_path.iterdir())
    for word in ("forward left", "of 3", "value V to", "T&K", "doorway.rrd"):
        assert word in result.stdout


def test_pictures_and_films_can_be_left_out(tmp_path: Path) -> None:
    assert run("record", "--scene", "open", *QUICK, "--out", tmp_path).exit_code == 0
    assert [path.name for path in tmp_path.iterdir()] == ["open.rrd"]


def test_a_printed_scene_can_be_edited_and_recorded(tmp_path: Path) -> None:
    printed = run("scenes", "doorway", "--seed", "3", "--pattern", "group_blocking")
    scene = load_scene("doorway", "group_blocking", seed=3)
    assert scene_from_toml(printed.stdout) == replace(scene, name="doorway-group_blocking-3-0")
    mine = tmp_path / "mine.toml"
    mine.write_text(printed.stdout.replace('name = "doorway-group_blocking-3-0"', 'name = "mine"'))
    assert run("record", "--scene", mine, *QUICK, "--out", tmp_path).exit_code == 0
    assert (tmp_path / "mine.rrd").exists()


def test_scenes_lists_every_family_and_pattern() -> None:
    lines = run("scenes").stdout.splitlines()
    for name in (*FAMILIES, *PATTERNS):
        assert sum(line.split()[0] == name for line in lines) == 1


def tracks(folder: Path) -> Path:
    """A made-up recording: two people walk, one more comes later."""
    rows = []
    for frame in range(0, 100, 10):
        t = frame / 25
        rows.append((frame, 1, 1.0 + t, 0, 2.0, 1.0, 0, 0.0))
        rows.append((frame, 2, 9.0 - t, 0, 3.0, -1.0, 0, 0.0))
        if frame >= 50:
            rows.append((frame, 3, 5.0, 0, 8.0 - t, 0.0, 0, -1.0))
    file = folder / "obsmat.txt"
    file.write_text("\n".join(" ".join(map(str, row)) for row in rows))
    return file


def test_scenes_lists_the_busiest_frames_of_tracks(tmp_path: Path) -> None:
    lines = run("scenes", tracks(tmp_path)).stdout.splitlines()
    assert lines[0].split() == ["frame", "people"]
    assert lines[1].split() == ["50", "3"]


def test_a_frame_of_tracks_can_be_recorded(tmp_path: Path) -> None:
    result = run(
        "record",
        "--scene",
        tracks(tmp_path),
        "--frame",
        "50",
        "--robot-start",
        "0,-2",
        "--robot-goal",
        "8,6",
        *QUICK,
        "--out",
        tmp_path / "out",
    )
    assert result.exit_code == 0, result.stderr
    [recording] = (tmp_path / "out").iterdir()
    assert recording.suffix == ".rrd"
    assert "50" in recording.stem


def test_sample_writes_the_bank(tmp_path: Path) -> None:
    out = tmp_path / "new" / "outcomes.parquet"
    result = run(
        "sample", "--scenes", "3", "--seed", "2", "--rollouts", "2", "--families", "open,corridor",
        "--patterns", "head_on", "--noise", "goal=0.1", "--noise", "start=0", "--out", out,
    )  # fmt: skip
    assert result.exit_code == 0, result.stderr
    table = pq.read_table(out)
    assert table.num_rows == 3 * 7 * 2
    assert set(table["pattern"].to_pylist()) == {"head_on"}
    said = json.loads(table.schema.metadata[b"prospect_studio"])
    assert said["seed"] == 2
    assert said["noise"]["goal"] == 0.1
    assert said["noise"]["start"] == 0.0
    assert "42 outcomes of 3 scenes" in result.stdout


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ("record --scene garden", "'garden' is neither a family (corridor, intersection, doorway"),
        ("record --scene none.toml", "none.toml: cannot be read"),
        ("record --scene open --pattern bottleneck", "bottleneck"),
        ("record --scene open --pattern waltz", "waltz"),
        ("record --scene open --frame 3", "--frame: goes with recorded tracks"),
        ("record --scene open --rollouts 0", "rollouts: 0 is not allowed: 1 to 10000"),
        ("record --scene open --rollouts -5", "rollouts: -5 is not allowed"),
        ("record --scene open --rollouts many", "'--rollouts': 'many' is not a valid integer"),
        ("record --scene open --horizon nan", "horizon: nan s is not allowed"),
        ("record --scene open --horizon 1e9", "horizon: 1000000000.0 s is not allowed"),
        ("record --scene open --seed -1", "seed: -1"),
        ("record --scene open --number -1", "number: -1"),
        ("record --scene open --model newton", "'newton' is not one of 'extended'"),
        ("record --scene open --engine warp", "'warp' is not one of 'batched'"),
        ("record --scene open --noise goal=-1", "noise goal: -1.0 is not allowed"),
        ("record", "Missing option '--scene'"),
        ("record --scene open --name a/b", "--name: 'a/b' is not allowed: up to 200 letters"),
        ("compare --scene open stop forward --name .x", "--name: '.x' is not allowed"),
        ("learn --name a/b", "--name: 'a/b' is not allowed"),
        ("record --scene open --seed 99999999999999999999", "seed: 99999999999999999999 is not"),
        ("record --scene " + "x" * 5000, "neither a family"),
        ("scenes garden", "garden"),
        ("scenes --pattern head_on", "--pattern: goes with the NAME of a family"),
        ("sample --scenes 0", "scenes: 0 is not allowed"),
        ("sample --families garden", "garden"),
        ("view none.rrd", "none.rrd: cannot be read: No such file"),
        ("fly", "No such command 'fly'"),
    ],
)
def test_wrong_input_is_one_line_and_exit_code_2(
    arguments: str, says: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    result = run(*arguments.split())
    assert says in only_line(result)
    assert result.exit_code == 2
    assert not list(tmp_path.iterdir())


def test_an_edited_scene_that_contradicts_itself_names_the_field(tmp_path: Path) -> None:
    text = scene_to_toml(load_scene("doorway")).replace("groups = [", "groups = [[0, 99], ", 1)
    (tmp_path / "mine.toml").write_text(text)
    result = run("record", "--scene", tmp_path / "mine.toml", "--out", tmp_path / "out")
    assert "mine.toml: groups[0] names pedestrian 99" in only_line(result)
    assert result.exit_code == 2
    assert not (tmp_path / "out").exists()


def test_tracks_with_a_column_missing_or_nobody_there_are_refused(tmp_path: Path) -> None:
    file = tracks(tmp_path)
    result = run("record", "--scene", file, "--frame", "7", "--out", tmp_path / "out")
    assert "7" in only_line(result)
    assert result.exit_code == 2
    file.write_text("1 2 3\n")
    result = run("record", "--scene", file, "--frame", "50", "--out", tmp_path / "out")
    assert "obsmat.txt" in only_line(result)
    assert result.exit_code == 2
    assert not (tmp_path / "out").exists()


def test_a_folder_where_a_file_should_go_is_refused_and_nothing_replaced(tmp_path: Path) -> None:
    (tmp_path / "open.rrd").mkdir()
    (tmp_path / "open.png").write_text("old")
    result = run("record", "--scene", "open", "--rollouts", "1", "--out", tmp_path)
    assert "open.rrd: is a folder" in only_line(result)
    assert result.exit_code == 2
    assert (tmp_path / "open.png").read_text() == "old"
    assert len(list(tmp_path.iterdir())) == 2


@pytest.mark.parametrize("command", ["record --scene open", "sample --scenes 1"])
def test_an_output_place_that_cannot_be_is_refused(command: str, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("mine")
    out = tmp_path / "file" / "deeper" / "x"
    result = run(*command.split(), "--rollouts", "1", "--out", out)
    assert "--out: " in only_line(result)
    assert result.exit_code == 2
    assert (tmp_path / "file").read_text() == "mine"


def test_files_are_named_by_a_person_and_replaced_by_force(tmp_path: Path) -> None:
    record = ("record", *QUICK, "--out", tmp_path, "--name", "mine")
    assert run(*record, "--scene", "open").exit_code == 0
    before = (tmp_path / "mine.rrd").read_bytes()
    result = run(*record, "--scene", "corridor")
    assert "mine.rrd: is of another scene or other settings: --name" in only_line(result)
    assert result.exit_code == 2
    assert (tmp_path / "mine.rrd").read_bytes() == before
    assert run(*record, "--scene", "corridor", "--force").exit_code == 0
    assert [path.name for path in tmp_path.iterdir()] == ["mine.rrd"]


def test_a_film_is_not_a_recording(tmp_path: Path) -> None:
    (tmp_path / "film.rrd").write_bytes(b"....ftypisom")
    result = run("view", tmp_path / "film.rrd")
    assert "is not a recording" in only_line(result)
    assert result.exit_code == 2


@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGTERM])
def test_interrupted_work_leaves_nothing_behind(how: signal.Signals, tmp_path: Path) -> None:
    out = tmp_path / "outcomes.parquet"
    out.write_text("an older bank")
    process = subprocess.Popen(
        [sys.executable, "-m", "studio", "sample", "--scenes", "100000", "--out", str(out)],
        stderr=subprocess.PIPE,
        text=True,
    )
    deadline = time.monotonic() + 60
    while len(list(tmp_path.iterdir())) < 2 and time.monotonic() < deadline:
        time.sleep(0.05)  # until the temporary file is there
    time.sleep(0.5)
    os.kill(process.pid, how)
    _, said = process.communicate(timeout=60)
    assert process.returncode == 130
    assert said.splitlines()[-1] == "studio: interrupted"
    assert [path.name for path in tmp_path.iterdir()] == ["outcomes.parquet"]
    assert out.read_text() == "an older bank"


def test_the_help_of_learn_which_loads_no_learners_says_what_they_say() -> None:
    options = {option.name: option for option in main.commands["learn"].params}
    assert options["pairs"].default == ",".join(map(str, SIZES))
    assert signature(Studio.learn).parameters["pairs"].default == SIZES
    assert options["profiles"].metavar == f"NAME={','.join(CptParameters.SYMBOLS)}"
