"""The orchestrator from Python."""

import subprocess
from pathlib import Path

import numpy as np
import pytest

from scenes import Noise, Pedestrian, Robot, Scene, simulate
from studio.errors import InputError, RunError
from studio.files import replacing
from studio.orchestrator import Studio
from studio.scene.judgements import judge, utilities
from studio.scene.sources import Source, find_scene

PLAIN = {"png": False, "mp4": False}


def test_record_gives_back_what_it_wrote_and_simulated(tmp_path: Path) -> None:
    recorded = Studio(out=tmp_path).record("doorway", seed=2, rollouts=3, horizon=1.0, **PLAIN)
    assert recorded.files == (tmp_path / "doorway.rrd",)
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
        Studio(tmp_path).record("doorway", rollouts=2, horizon=0.5)
    assert {path.read_text() for path in tmp_path.iterdir()} == {"old"}
    assert len(list(tmp_path.iterdir())) == 3


def test_replacing_is_all_or_nothing(tmp_path: Path) -> None:
    final = tmp_path / "a.txt"
    with replacing(final) as [part]:
        part.write_text("new")
        assert not final.exists()
        assert part.parent == final.parent
    assert final.read_text() == "new"
    with pytest.raises(ZeroDivisionError), replacing(final, tmp_path / "b.txt") as parts:
        parts[0].write_text("half" + str(parts[1].write_text("half") / 0))
    assert final.read_text() == "new"
    assert list(tmp_path.iterdir()) == [final]


def test_folders_are_made_and_go_again_if_nothing_comes_of_it(tmp_path: Path) -> None:
    final = tmp_path / "new" / "deep" / "a.txt"
    with pytest.raises(ZeroDivisionError), replacing(final) as [part]:
        part.write_text(str(1 / 0))
    assert not list(tmp_path.iterdir())
    with replacing(final) as [part]:
        part.write_text("done")
    assert final.read_text() == "done"


def test_what_cannot_be_written_is_known_before_the_work_begins(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    (tmp_path / "folder").mkdir()
    for path in (tmp_path / "file" / "a.txt", tmp_path / "folder"):
        with pytest.raises(InputError, match=r"--out: .*(cannot be written|is a folder)"):  # noqa: SIM117
            with replacing(tmp_path / "other.txt", path):
                pytest.fail("the work began")
    assert not (tmp_path / "other.txt").exists()


def test_a_full_disk_is_named_with_the_final_name(tmp_path: Path) -> None:
    final = tmp_path / "a.txt"
    with pytest.raises(RunError, match=r"a\.txt: cannot be written: No space left"):  # noqa: SIM117
        with replacing(final) as [part]:
            raise OSError(28, "No space left on device", str(part))
    assert not list(tmp_path.iterdir())


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
