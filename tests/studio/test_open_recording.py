"""Recordings as data: what was simulated and learned comes back as tables."""

import re
from collections.abc import Callable
from pathlib import Path
from shutil import copy

import numpy as np
import pytest

from learners import STUDY_SCHEMA
from scenes import FEATURES
from scenes.bank import BANK_SCHEMA
from studio import Studio, open_recording
from studio.errors import InputError

REFERENCE = Path(__file__).parents[2] / "recordings" / "README.md"
PLAIN = {"png": False, "mp4": False, "rollouts": 3, "horizon": 1.0}


def test_a_scene_comes_back_as_one_row_an_outcome(tmp_path: Path) -> None:
    recorded = Studio(tmp_path).record("intersection", **PLAIN)
    rollouts = recorded.rollouts
    opened = open_recording(str(recorded.files[0]))
    assert opened.rollouts.scene == rollouts.scene
    assert [judgement.teacher for judgement in opened.judgements] == ["eu", "tk", "strong"]
    table = opened.to_arrow()
    assert table.column_names == [*BANK_SCHEMA.names, "utility"]
    assert table["action"].to_pylist() == [name for name in rollouts.names for _ in range(3)]
    assert table["rollout"].to_pylist() == [0, 1, 2] * len(rollouts.names)
    for place, feature in enumerate(FEATURES):
        np.testing.assert_array_equal(table[feature], rollouts.features[..., place].ravel())
    np.testing.assert_allclose(table["progress_m"], rollouts.progress_m.ravel())
    np.testing.assert_array_equal(table["people_touched"], rollouts.people_touched.ravel())
    np.testing.assert_array_equal(table["wall_touched"], rollouts.wall_touched.ravel())
    # the teacher EU values a prospect by the mean of these
    utility = np.reshape(table["utility"], (len(rollouts.names), 3))
    np.testing.assert_allclose(utility.mean(axis=1), recorded.judgements[0].values)


def test_a_comparison_says_on_which_side_an_outcome_is(tmp_path: Path) -> None:
    compared = Studio(tmp_path).compare("doorway", "stop", "forward", **PLAIN)
    table = open_recording(compared.files[0]).to_arrow()
    assert table["side"].to_pylist() == ["A"] * 3 + ["B"] * 3
    left, right = compared.comparison.rollouts.names
    assert table["action"].to_pylist() == [left] * 3 + [right] * 3


def test_a_study_comes_back_as_one_row_a_fit(study_recording: Path) -> None:
    opened = open_recording(study_recording)
    table = opened.to_arrow()
    assert set(table.column_names) <= set(STUDY_SCHEMA.names)
    assert table.num_rows == len(opened.results.fits) > 0


def test_a_data_frame_has_the_rows_and_columns_of_the_table(recording: Path) -> None:
    opened = open_recording(recording)
    table, frame = opened.to_arrow(), opened.to_pandas()
    assert [*frame.columns] == table.column_names
    assert len(frame) == table.num_rows
    assert frame["learner" if "learner" in frame else "action"].nunique() >= 2


def test_without_pandas_one_line_says_what_to_install(
    recording: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("studio.recording.find_spec", lambda _name: None)
    opened = open_recording(recording)
    with pytest.raises(InputError, match=r"pandas is not installed: pip install '.*\[pandas\]'"):
        opened.to_pandas()
    assert opened.to_arrow().num_rows > 0


def test_an_opened_recording_prints_in_a_few_lines(recording: Path) -> None:
    assert len(repr(open_recording(recording))) < 1000


def test_what_is_no_recording_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"none.rrd: cannot be read"):
        open_recording(tmp_path / "none.rrd")


def test_the_reference_opens_recordings_as_it_says(
    example: Callable[[str], Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for room, name in (("scene", "doorway"), ("study", "learning")):
        copy(example(room), tmp_path / f"{name}.rrd")
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(r"```python\n(.*?)```", REFERENCE.read_text(encoding="utf-8"), re.DOTALL)
    assert any("open_recording" in block for block in blocks)
    for block in blocks:
        exec(compile(block, "README.md", "exec"), {})
