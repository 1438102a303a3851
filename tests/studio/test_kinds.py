"""Recordings that are no kind of the studio's, or none that it can read, are refused."""

from pathlib import Path

import pyarrow as pa
import pytest
import rerun as rr

from studio.recorder.contents import Contents
from studio.scene.recording import entities
from studio.scene.recording.write import SCHEMA_VERSION
from tests.studio.reading import refused


def test_somebody_elses_recording_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "theirs.rrd"
    with rr.RecordingStream("their_own", recording_id="x") as stream:
        stream.save(path)
        stream.log("world", rr.Points2D([[0.0, 0.0]]), static=True)
    assert "their_own" in refused(path)


def test_a_recording_that_only_claims_to_be_ours_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "claim.rrd"
    with rr.RecordingStream(entities.APPLICATION, recording_id="x") as stream:
        stream.save(path)
        stream.send_property("simulation", rr.AnyValues(schema_version=SCHEMA_VERSION))
    assert "is damaged" in refused(path)


def test_a_recording_of_a_newer_edition_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "newer.rrd"
    with rr.RecordingStream(entities.APPLICATION, recording_id="x") as stream:
        stream.save(path)
        stream.send_property("simulation", rr.AnyValues(schema_version=SCHEMA_VERSION + 1))
    assert f"edition {SCHEMA_VERSION + 1}" in refused(path)


@pytest.mark.parametrize("told", [["two"], [], None])
def test_an_edition_that_is_no_number_is_refused(
    told: list[str] | None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    batch = pa.record_batch({"schema_version": pa.array([told], pa.list_(pa.string()))})
    odd = Contents(tmp_path / "odd.rrd", entities.APPLICATION, {entities.SIMULATION: [batch]})
    monkeypatch.setattr("studio.recorder.contents.read_contents", lambda _path: odd)
    assert "is damaged" in refused(tmp_path / "odd.rrd")
