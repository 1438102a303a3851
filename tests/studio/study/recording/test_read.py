"""A study is read back as its table."""

from collections.abc import Callable
from pathlib import Path

import pyarrow.parquet as pq

from scenes.bank import BankPlan, write_bank
from studio.kinds import read_recording
from studio.orchestrator import Studio
from studio.study.kind import StudyRecording


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


def test_a_study_of_the_first_edition_is_read(old: Callable[[str], Path]) -> None:
    read = read_recording(old("learning-edition-1"))
    assert isinstance(read, StudyRecording)
    assert read.results.table.num_rows == 8
    assert sorted(set(read.results.table["pairs"].to_pylist())) == [25, 100]


def test_a_study_of_the_second_edition_is_read(old: Callable[[str], Path]) -> None:
    read = read_recording(old("learning-edition-2"))
    assert isinstance(read, StudyRecording)
    assert read.results.table.num_rows == 16
    assert sorted(set(read.results.table["pairs"].to_pylist())) == [25, 100]
    assert set(read.results.scenes) == set(range(16))
