"""The orchestrator from Python."""

import subprocess
from pathlib import Path

import numpy as np
import pytest

from scenes import Noise, Pedestrian, Robot, Scene, simulate
from studio.errors import InputError, RunError
from studio.orchestrator import Studio
from studio.scene.judgements import judge, utilities
from studio.scene.sources import Source, find_scene

PLAIN = {"png": False, "mp4": False}


def test_record_gives_back_what_it_wrote_and_simulated(tmp_path: Path) -> None:
    recorded = Studio(out=tmp_path).record("doorway", seed=2, rollouts=3, horizon=1.0, **PLAIN)
    assert recorded.files == (tmp_path / "doorway-seed2.rrd",)
    again = simulate(find_scene(Source("doorway", seed=2)), rollouts=3, seed=2, horizon=1.0)
    np.testing.assert_array_equal(recorded.rollouts.features, again.features)
    assert [judgement.teacher for judgement in recorded.judgements] == ["eu", "tk", "strong"]


def test_a_scene_of_ones_own_can_be_recorded(tmp_path: Path) -> None:
    scene = Scene("own", Robot((0.0, 0.0), (9.0, 0.0)), (Pedestrian((4.0, 1.0), (-9.0, 1.0)),))
    recorded = Studio(tmp_path).record(scene, rollouts=2, noise=Noise(goal=0.0), **PLAIN)
    assert recorded.files[0].exists()
    assert recorded.rollouts.noise.goal == 0.0


def test_the_viewer_starts_where_links_of_the_recording_start(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    started: list[tuple[Path, Path]] = []

    def start(command: list[Path], *, cwd: Path, check: bool) -> subprocess.CompletedProcess[bytes]:
        started.append((command[1], cwd.resolve()))
        return subprocess.CompletedProcess(command, 0)

    (tmp_path / "some").mkdir()
    (tmp_path / "some" / "learning.rrd").write_bytes(b"RRF2")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(subprocess, "run", start)
    Studio().view("some/learning.rrd")
    assert started == [(tmp_path / "some" / "learning.rrd", tmp_path / "some")]


def test_an_old_file_survives_a_run_that_fails(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    import studio.painter.mp4

    def no_space_left(*_arguments: object, **_keywords: object) -> None:
        raise RunError("no space left")

    for suffix in (".rrd", ".png", ".mp4"):
        (tmp_path / f"doorway{suffix}").write_text("old")
    monkeypatch.setattr(studio.painter.mp4, "write_mp4", no_space_left)
    with pytest.raises(RunError):
        Studio(tmp_path).record("doorway", rollouts=2, horizon=0.5, force=True)
    assert {path.read_text() for path in tmp_path.iterdir()} == {"old"}
    assert len(list(tmp_path.iterdir())) == 3


QUICK = PLAIN | {"rollouts": 2, "horizon": 0.5}


def contents_of(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def test_no_two_scenes_share_a_file(tmp_path: Path) -> None:
    sources = [
        Source("corridor"),
        Source("corridor", "overtaking"),
        Source("corridor", number=11),
        Source("corridor", "overtaking", seed=3, number=11),
    ]
    for source in sources:
        Studio(tmp_path).record(source, seed=source.seed, **QUICK)
    assert sorted(contents_of(tmp_path)) == [
        "corridor-11.rrd",
        "corridor-overtaking-11-seed3.rrd",
        "corridor-overtaking.rrd",
        "corridor.rrd",
    ]
    compared = Studio(tmp_path).compare(sources[1], "stop", "forward", name="mine", **QUICK)
    assert compared.files == (tmp_path / "mine.rrd",)


def test_a_recording_of_something_else_is_replaced_only_by_force(tmp_path: Path) -> None:
    studio = Studio(tmp_path)
    studio.record("doorway", png=True, mp4=False, rollouts=2, horizon=0.5)
    studio.record("doorway", **QUICK)  # the very same
    before = contents_of(tmp_path)
    for change in ({"rollouts": 3}, {"seed": 1, "name": "doorway"}, {"noise": Noise(goal=0.0)}):
        with pytest.raises(InputError, match=r"doorway.rrd: is of .* --name .* --force"):
            studio.record("doorway", **QUICK | change)
    with pytest.raises(InputError, match=r"doorway.rrd: is of another scene"):
        studio.compare("doorway", "stop", "forward", name="doorway", **QUICK)
    assert contents_of(tmp_path) == before
    assert studio.record("doorway", **QUICK | {"rollouts": 3}, force=True).rollouts.count == 3
    assert contents_of(tmp_path)["doorway.rrd"] != before["doorway.rrd"]


def test_a_picture_without_its_recording_may_be_of_anything(tmp_path: Path) -> None:
    (tmp_path / "doorway.png").write_text("mine")
    with pytest.raises(InputError, match=r"doorway.png: is there, but not the recording"):
        Studio(tmp_path).record("doorway", mp4=False, rollouts=2, horizon=0.5)
    assert contents_of(tmp_path) == {"doorway.png": b"mine"}
    Studio(tmp_path).record("doorway", **QUICK)
    assert contents_of(tmp_path)["doorway.png"] == b"mine"


def test_teachers_judge_by_the_value_of_the_prospect() -> None:
    rollouts = simulate(find_scene(Source("doorway")), rollouts=20)
    eu, tk, strong = judge(rollouts)
    outcome = utilities(rollouts)
    np.testing.assert_allclose(eu.values, outcome.mean(axis=1), atol=1e-12)
    for judgement in (eu, tk, strong):
        assert judgement.best == judgement.values.argmax()
        assert judgement.values.shape == (7,)
    assert not np.allclose(eu.values, tk.values)
    assert not np.allclose(tk.values, strong.values)
