"""The study as a person runs it."""

import re
import shlex
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from rerun.chunk import RrdReader

import studio.study.run
from learners import FEATURES, TEACHERS
from scenes import Noise
from scenes.bank import BankPlan, write_bank
from studio import Studio, open_recording
from studio.errors import InputError
from studio.study.recording.entities import scenes_about
from tests.command_line import run

CONTRACT = [
    "teacher", "learner", "pairs", "seed", "regret", "regret_percent", "nll", "certainty",
    "theta", "alpha", "eta", "lambda", "gamma", "delta",
]  # fmt: skip
SMALL: dict[str, Any] = {"teachers": ("eu", "tk"), "pairs": (10, 30), "seeds": 2}


@pytest.fixture(scope="module")
def bank(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("bank") / "bank.parquet"
    write_bank(path, BankPlan(scenes=16, rollouts=8))
    return path


def test_learn_writes_table_pictures_and_recording(bank: Path, tmp_path: Path) -> None:
    result = run(
        "learn", "--outcomes", bank, "--pairs", "10,30", "--seeds", "2", "--out", tmp_path
    )  # fmt: skip
    assert result.exit_code == 0, result.stderr
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        "learning-2.png",
        "learning.parquet",
        "learning.png",
        "learning.rrd",
        "scenes",
    ]
    table = pq.read_table(tmp_path / "learning.parquet")
    assert table.column_names[: len(CONTRACT)] == CONTRACT
    assert table.num_rows == 3 * 2 * 2 * 2
    eu = table.filter(pa.compute.equal(table["learner"], "eu"))
    assert eu["lambda"].null_count == eu.num_rows
    for word in ("regret on held-out scenes", "strong", "cpt", "learning.rrd"):
        assert word in result.stdout


def page_of_scenes(out: Path) -> str:
    """The pages of scenes at the largest number of pairs, of all teachers."""
    texts: list[str] = []
    for teacher in TEACHERS:
        pages: dict[int, Any] = {}
        stream = RrdReader(out / "learning.rrd").stream()
        for chunk in stream.filter(content=f"/{scenes_about(teacher)}").to_chunks():
            columns = chunk.to_record_batch().to_pydict()
            pages |= dict(zip(columns["pairs"], columns["TextDocument:text"], strict=True))
        texts += pages[max(pages)] if pages else []
    return "\n".join(texts)


def outcomes_of(recording: Path) -> dict[str, list[Any]]:
    """What a scene's own recording says of its outcomes."""
    outcomes: dict[str, list[Any]] = open_recording(recording).to_arrow().to_pydict()
    return outcomes


def test_scenes_that_are_told_of_have_recordings_of_the_very_rollouts_of_the_bank(
    bank: Path, tmp_path: Path
) -> None:
    learned = Studio(tmp_path).learn(bank, **SMALL)
    links = re.findall(r"\]\(<([^>]+)>\)", page_of_scenes(tmp_path))
    assert 1 <= len(set(links)) <= 6
    assert {tmp_path / link for link in links} == set(learned.files[4:])
    assert sorted(set(links)) == sorted(f"scenes/{p.name}" for p in (tmp_path / "scenes").iterdir())
    for link in links:
        family, *pattern, seed, number = Path(link).stem.split("-")
        rows = pq.read_table(bank, filters=[("scene", "=", int(number))])
        assert (family, seed) == (rows["family"][0].as_py(), "0")
        assert {*pattern} <= {rows["pattern"][0].as_py()}
        recorded = outcomes_of(tmp_path / link)
        for feature in FEATURES:
            np.testing.assert_array_equal(recorded[feature], rows[feature])


def test_the_page_tells_how_to_make_a_recording_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    bank = tmp_path / "bank.parquet"
    write_bank(bank, BankPlan(scenes=16, seed=3, rollouts=4, horizon=2.0, noise=Noise(goal=0.2)))
    Studio(tmp_path).learn(bank, teachers=("strong",), pairs=(10,), seeds=1)
    commands = re.findall(r"^studio (.+)$", page_of_scenes(tmp_path), re.MULTILINE)
    recordings = {path: outcomes_of(path) for path in (tmp_path / "scenes").iterdir()}
    assert len(commands) == 2 * len(recordings) > 0
    for path in recordings:
        path.unlink()
    monkeypatch.chdir(tmp_path)
    for command in commands:
        words, _, file = command.partition(" > ")
        result = run(*shlex.split(words))
        assert result.exit_code == 0, result.stderr
        if file:
            Path(file).write_text(result.stdout)
    assert {path: outcomes_of(path) for path in recordings} == recordings


def without_plan(table: pa.Table) -> pa.Table:
    return table.replace_schema_metadata(None)


def shaken(table: pa.Table) -> pa.Table:
    """The same bank, it says, but the outcomes are others."""
    place = table.column_names.index("progress")
    other = pa.compute.multiply(table["progress"], 0.99)
    return table.set_column(place, table.schema.field("progress"), other)


def renumbered(table: pa.Table) -> pa.Table:
    place = table.column_names.index("scene")
    other = pa.compute.subtract(table["scene"], 8)
    return table.set_column(place, table.schema.field("scene"), other)


def halved(table: pa.Table) -> pa.Table:
    return table.filter(pa.compute.less(table["rollout"], 4))


@pytest.mark.parametrize("change", [without_plan, shaken, renumbered, halved])
def test_scenes_that_do_not_come_out_as_in_the_bank_are_not_recorded(
    change: Callable[[pa.Table], pa.Table], bank: Path, tmp_path: Path
) -> None:
    other = tmp_path / "other.parquet"
    pq.write_table(change(pq.read_table(bank)), other)
    learned = Studio(tmp_path / "out").learn(other, **SMALL)
    names = ["learning.parquet", "learning.png", "learning.rrd", "learning-2.png"]
    assert [path.name for path in learned.files] == names
    assert not (tmp_path / "out" / "scenes").exists()
    page = page_of_scenes(tmp_path / "out")
    assert "These scenes have no recordings" in page
    assert "](" not in page


def test_what_an_older_edition_left_behind_is_not_continued(bank: Path, tmp_path: Path) -> None:
    table = Studio(tmp_path / "whole").learn(bank, **SMALL).table
    pq.write_table(table.drop_columns(["scene_regret"]), tmp_path / ".learning.unfinished.parquet")
    assert Studio(tmp_path).learn(bank, **SMALL).table.equals(table)


def test_the_same_study_gives_the_same_table(bank: Path, tmp_path: Path) -> None:
    one, other = (Studio(tmp_path / name).learn(bank, **SMALL).table for name in ("one", "other"))
    assert one.equals(other)


def test_an_interrupted_study_continues_where_it_stopped(
    bank: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole = Studio(tmp_path / "whole").learn(bank, **SMALL).table
    whole_batches = studio.study.run.study_batches
    fitted: list[int] = []

    def counted(*arguments: Any, **keywords: Any) -> Iterator[pa.Table]:
        for batch in whole_batches(*arguments, **keywords):
            fitted.append(batch.num_rows)
            yield batch

    def interrupted(*arguments: Any, **keywords: Any) -> Iterator[pa.Table]:
        yield next(iter(whole_batches(*arguments, **keywords)))
        raise KeyboardInterrupt

    monkeypatch.setattr(studio.study.run, "study_batches", interrupted)
    with pytest.raises(KeyboardInterrupt):
        Studio(tmp_path / "broken").learn(bank, **SMALL)
    assert not (tmp_path / "broken" / "learning.parquet").exists()
    monkeypatch.setattr(studio.study.run, "study_batches", counted)
    continued = Studio(tmp_path / "broken").learn(bank, **SMALL).table
    assert sum(fitted) == whole.num_rows // 2
    assert continued.equals(whole)
    assert not list((tmp_path / "broken").glob(".*"))


def test_what_another_study_left_behind_is_not_taken(bank: Path, tmp_path: Path) -> None:
    others = tmp_path / ".learning.unfinished.parquet"
    pq.write_table(pa.table({"teacher": ["somebody else"]}), others)
    table = Studio(tmp_path).learn(bank, teachers=("eu",), pairs=(10,), seeds=1).table
    assert table.num_rows == 2
    others.write_bytes(b"half a fi")
    again = Studio(tmp_path).learn(bank, teachers=("eu",), pairs=(10,), seeds=1).table
    assert again.equals(table)


def test_a_teacher_of_ones_own_can_be_named(bank: Path, tmp_path: Path) -> None:
    result = run(
        "learn", "--outcomes", bank, "--teachers", "tk", "--profile", "cautious=0.9,0.9,4,0.6,0.7",
        "--beta", "30", "--pairs", "10", "--seeds", "1", "--out", tmp_path,
    )  # fmt: skip
    assert result.exit_code == 0, result.stderr
    table = pq.read_table(tmp_path / "learning.parquet")
    assert set(table["teacher"].to_pylist()) == {"tk", "cautious"}


Change = Callable[[pa.Table], pa.Table]


def without(column: str) -> Change:
    return lambda table: table.drop_columns([column])


def with_nan(table: pa.Table) -> pa.Table:
    place = table.column_names.index("progress")
    column = pa.array([float("nan"), *table["progress"].to_pylist()[1:]])
    return table.set_column(place, table.schema.field("progress"), column)


def one_action(table: pa.Table) -> pa.Table:
    return table.filter(pa.compute.equal(table["action"], "stop"))


def two_scenes(table: pa.Table) -> pa.Table:
    return table.filter(pa.compute.less(table["scene"], 2))


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (without("progress"), "progress"),
        (without("scene"), "scene"),
        (with_nan, "progress"),
        (one_action, "action"),
        (two_scenes, "scenes"),
    ],
)
def test_a_bank_that_cannot_be_studied_is_refused(
    change: Change, says: str, bank: Path, tmp_path: Path
) -> None:
    wrong = tmp_path / "wrong.parquet"
    pq.write_table(change(pq.read_table(bank)), wrong)
    result = run("learn", "--outcomes", wrong, "--out", tmp_path / "out")
    assert result.exit_code == 2
    assert result.stderr.count("\n") == 1
    assert says in result.stderr
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("options", "says"),
    [
        ("--teachers nobody", "nobody"),
        ("--learners guess", "guess"),
        ("--beta 0", "beta 0.0 is not allowed"),
        ("--beta nan", "beta nan is not allowed"),
        ("--pairs 0", "pairs 0 is not allowed"),
        ("--seeds 0", "seeds 0 is not allowed"),
        ("--profile mine=1,2,3", "--profile: 'mine=1,2,3' is not a profile"),
        ("--profile mine=1,1,-2,1,1", "-2"),
        ("--outcomes none.parquet", "none.parquet"),
    ],
)
def test_wrong_input_is_one_line_and_exit_code_2(
    options: str, says: str, bank: Path, tmp_path: Path
) -> None:
    result = run("learn", "--outcomes", bank, *options.split(), "--out", tmp_path / "out")
    assert result.exit_code == 2, result.exception
    assert result.stderr.count("\n") == 1
    assert says in result.stderr
    assert not (tmp_path / "out").exists()


def test_fits_of_another_study_are_replaced_only_by_force(bank: Path, tmp_path: Path) -> None:
    small: dict[str, Any] = {"teachers": ("eu",), "pairs": (10,), "seeds": 1}
    studio, larger = Studio(tmp_path), small | {"seeds": 2}
    studio.learn(bank, **small)
    assert studio.learn(bank, **small).table.num_rows == 2  # the very same
    assert studio.learn(bank, **larger).table.num_rows == 4  # has all of its fits, and more
    before = pq.read_table(tmp_path / "learning.parquet")
    other = tmp_path / "other.parquet"
    write_bank(other, BankPlan(scenes=16, rollouts=4))
    for bank_of, plan in ((bank, small), (bank, larger | {"pairs": (20,)}), (other, larger)):
        with pytest.raises(InputError, match=r"learning.parquet: holds fits .* --force"):
            studio.learn(bank_of, **plan)
    assert pq.read_table(tmp_path / "learning.parquet").equals(before)
    assert studio.learn(other, **small, name="mine").files[0].name == "mine.parquet"
    assert (tmp_path / "mine-scenes").is_dir()
    assert studio.learn(other, **small, force=True).table.num_rows == 2


def test_what_another_study_has_finished_is_replaced_only_by_force(
    bank: Path, tmp_path: Path
) -> None:
    table = Studio(tmp_path / "whole").learn(bank, **SMALL).table
    pq.write_table(table, tmp_path / ".learning.unfinished.parquet")
    with pytest.raises(InputError, match="holds what another study finished"):
        Studio(tmp_path).learn(bank, **SMALL | {"pairs": (20,)})
    assert Studio(tmp_path).learn(bank, **SMALL).table.equals(table)


def test_a_bank_that_is_not_the_default_one_is_not_sampled_over(tmp_path: Path) -> None:
    bank = tmp_path / "outcomes.parquet"
    write_bank(bank, BankPlan(scenes=4, rollouts=2))
    before = bank.read_bytes()
    with pytest.raises(InputError, match=r"outcomes.parquet: is not the default bank"):
        Studio(tmp_path).learn(pairs=(10,))
    assert bank.read_bytes() == before
