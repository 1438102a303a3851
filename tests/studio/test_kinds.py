"""Recordings are read back as what they were made from."""

import lzma
import shutil
from collections.abc import Callable
from dataclasses import fields, replace
from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
import rerun as rr
from hypothesis import given, settings
from hypothesis import strategies as st

from learners import PROFILES
from scenes import Rollouts, load_scene, simulate
from scenes.bank import BankPlan, write_bank
from studio.errors import InputError
from studio.kinds import read_recording
from studio.orchestrator import Studio
from studio.recorder.contents import Contents, read_contents
from studio.scene.judgements import Judgement, judge
from studio.scene.kind import SceneRecording
from studio.scene.recording import entities
from studio.scene.recording.write import SCHEMA_VERSION, write_recording
from studio.study.kind import StudyRecording

DATA = Path(__file__).parent / "data"
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
    values = np.arange(7.0)
    own = (Judgement("zoë", PROFILES["tk"], values), Judgement("adam", PROFILES["eu"], -values))
    write_recording(tmp_path / "own.rrd", rollouts, own)
    assert [each.teacher for each in read_scene(tmp_path / "own.rrd").judgements] == ["zoë", "adam"]


def test_a_scene_without_people_is_read_back(tmp_path: Path) -> None:
    alone = replace(load_scene("open"), pedestrians=(), groups=())
    rollouts = simulate(alone, rollouts=2, horizon=1.0)
    write_recording(tmp_path / "alone.rrd", rollouts, judge(rollouts))
    assert read_scene(tmp_path / "alone.rrd").rollouts.pedestrians.shape == (7, 2, 11, 0, 2)


def test_a_study_is_read_back_as_its_table(tmp_path: Path) -> None:
    write_bank(tmp_path / "bank.parquet", BankPlan(scenes=16, rollouts=8))
    Studio(tmp_path).learn(
        tmp_path / "bank.parquet", teachers=("eu", "tk"), pairs=(10, 30), seeds=2
    )
    read = read_recording(tmp_path / "learning.rrd")
    assert isinstance(read, StudyRecording)
    written = pq.read_table(tmp_path / "learning.parquet")
    assert read.results.table.equals(written)
    assert read.results.table.schema.equals(written.schema, check_metadata=True)
    assert [teacher.name for teacher in read.results.teachers] == ["eu", "tk"]


# Older editions


@pytest.fixture
def old(tmp_path: Path) -> Callable[[str], Path]:
    """Unpacks a recording that an older version of the studio has written."""

    def unpack(name: str) -> Path:
        path = tmp_path / f"{name}.rrd"
        path.write_bytes(lzma.decompress((DATA / f"{name}.rrd.xz").read_bytes()))
        return path

    return unpack


def test_a_scene_of_the_first_edition_is_read(old: Callable[[str], Path]) -> None:
    read = read_scene(old("scene-edition-1"))
    assert read.rollouts.robot.shape == (3, 4, 21, 3)
    assert read.rollouts.without_robot.shape == (0, 21, 2, 2)  # it does not tell
    assert [each.teacher for each in read.judgements] == ["eu", "tk", "strong"]
    np.testing.assert_allclose(read.rollouts.robot[:, :, 0, :2], 0.0, atol=1e-9)
    again = judge(read.rollouts)
    for mine, theirs in zip(read.judgements, again, strict=True):
        np.testing.assert_allclose(mine.values, theirs.values, atol=1e-6)


def test_a_study_of_the_first_edition_is_read(old: Callable[[str], Path]) -> None:
    read = read_recording(old("learning-edition-1"))
    assert isinstance(read, StudyRecording)
    assert read.results.table.num_rows == 8
    assert sorted(set(read.results.table["pairs"].to_pylist())) == [25, 100]


# What is not a recording of the studio


def refused(path: Path) -> str:
    with pytest.raises(InputError) as error:
        read_recording(path)
    message = str(error.value)
    assert str(path) in message
    assert "\n" not in message
    return message


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


def test_rows_are_read_in_order_of_time_whatever_their_order_in_the_file(
    recording: Path, rollouts: Rollouts
) -> None:
    contents = read_contents(recording)
    entity = f"/{entities.robots(rollouts.names[0])}"
    [batch] = [b for b in contents.batches[entity] if "step" in b.schema.names]
    half = batch.num_rows // 2
    swapped = replace(contents, batches={entity: [batch.slice(half), batch.slice(0, half)]})
    for component in ("Points2D:positions", "heading"):
        np.testing.assert_array_equal(
            swapped.over_time(entity, component, "step"),
            contents.over_time(entity, component, "step"),
        )


@pytest.mark.parametrize("told", [["two"], [], None])
def test_an_edition_that_is_no_number_is_refused(
    told: list[str] | None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    batch = pa.record_batch({"schema_version": pa.array([told], pa.list_(pa.string()))})
    odd = Contents(tmp_path / "odd.rrd", entities.APPLICATION, {entities.SIMULATION: [batch]})
    monkeypatch.setattr("studio.recorder.contents.read_contents", lambda _path: odd)
    assert "is damaged" in refused(tmp_path / "odd.rrd")
