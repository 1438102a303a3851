"""What a file holds is read whole or not at all."""

import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import rerun as rr
from hypothesis import given, settings
from hypothesis import strategies as st

from studio.recorder.contents import read_contents
from studio.scene.recording import entities
from tests.studio.reading import refused


@pytest.fixture(scope="module")
def recording(scene_recording: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A recording in a folder in which others may be made of it."""
    return Path(shutil.copy(scene_recording, tmp_path_factory.mktemp("contents")))


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"", "is empty"),
        (b"PK\x03\x04 something else", "is not a recording"),
        ("Ärger".encode() * 100, "is not a recording"),
        (b"RRF", "is cut off or damaged"),
        (b"RRF2" + bytes(range(256)) * 10, "is cut off or damaged"),
    ],
)
def test_what_is_not_a_recording_is_refused(content: bytes, said: str, tmp_path: Path) -> None:
    path = tmp_path / "x.rrd"
    path.write_bytes(content)
    assert said in refused(path)


def test_a_file_that_is_not_there_and_a_folder_are_refused(tmp_path: Path) -> None:
    assert "No such file" in refused(tmp_path / "none.rrd")
    assert "s a directory" in refused(tmp_path)


@settings(max_examples=40, deadline=None)
@given(share=st.floats(0.0, 1.0, exclude_max=True))
def test_a_recording_that_is_cut_off_is_refused(share: float, recording: Path) -> None:
    whole = recording.read_bytes()
    cut = recording.with_name("cut.rrd")
    # the last bytes repeat where the footer is, and are not missed
    cut.write_bytes(whole[: int(share * (len(whole) - 32))])
    refused(cut)


def test_a_recording_without_its_footer_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "killed.rrd"
    stream = rr.RecordingStream(entities.APPLICATION, recording_id="x")
    stream.save(path)
    stream.log("world", rr.Points2D([[0.0, 0.0]]), static=True)
    stream.flush()
    shutil.copy(path, tmp_path / "copy.rrd")
    stream.disconnect()
    assert "is cut off" in refused(tmp_path / "copy.rrd")


def test_rows_are_read_in_order_of_time_whatever_their_order_in_the_file(recording: Path) -> None:
    contents = read_contents(recording)
    entity = f"/{entities.robots('forward')}"
    [batch] = [b for b in contents.batches[entity] if "step" in b.schema.names]
    half = batch.num_rows // 2
    swapped = replace(contents, batches={entity: [batch.slice(half), batch.slice(0, half)]})
    for component in ("Points2D:positions", "heading"):
        np.testing.assert_array_equal(
            swapped.over_time(entity, component, "step"),
            contents.over_time(entity, component, "step"),
        )
