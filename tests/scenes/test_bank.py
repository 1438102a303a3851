"""The outcome bank."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pyarrow.parquet as pq
import pytest

from scenes import FAMILIES, META_ACTIONS, InputError, Noise, sample_scene, simulate
from scenes.bank import (
    BankPlan,
    metadata,
    outcome_rows,
    planned_scene,
    read_plan,
    simulate_planned,
    write_bank,
)
from scenes.robot import Limits

COLUMNS = [
    "scene",
    "family",
    "pattern",
    "action",
    "rollout",
    "clearance",
    "deviation",
    "progress",
    "smoothness",
    "collisions",
    "clearance_m",
    "deviation_m",
    "progress_m",
    "people_touched",
    "wall_touched",
]
PLAN = BankPlan(scenes=6, seed=11, rollouts=5, noise=Noise(goal=0.2))


@pytest.fixture(scope="module")
def bank(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("bank") / "outcomes.parquet"
    write_bank(path, PLAN)
    return path


def test_there_is_one_row_a_rollout_with_the_promised_columns(bank: Path) -> None:
    table = pq.read_table(bank)
    assert table.column_names == COLUMNS
    assert table.num_rows == 6 * 7 * 5
    types = dict(zip(COLUMNS, map(str, table.schema.types), strict=True))
    assert types["scene"] == types["rollout"] == "int64"
    assert types["family"] == types["pattern"] == types["action"] == "string"
    assert all(types[name] == "double" for name in COLUMNS[5:-2])
    assert (types["people_touched"], types["wall_touched"]) == ("int64", "bool")
    touched = zip(*(table[name].to_pylist() for name in COLUMNS[-2:]), strict=True)
    assert table["collisions"].to_pylist() == [people + wall for people, wall in touched]
    assert sorted(set(table["family"].to_pylist())) == sorted(FAMILIES)
    assert table["action"].to_pylist()[:35:5] == [action.name for action in META_ACTIONS]
    assert table["rollout"].to_pylist()[:6] == [0, 1, 2, 3, 4, 0]


def test_a_scene_of_the_bank_can_be_made_again_alone(bank: Path) -> None:
    table = pq.read_table(bank, filters=[("scene", "=", 4)])
    scene = sample_scene(PLAN.seed, 4)
    alone = simulate(scene, rollouts=5, seed=PLAN.seed, noise=PLAN.noise)
    for index, name in enumerate(COLUMNS[5:10]):
        np.testing.assert_array_equal(table[name], alone.features[..., index].ravel())
    np.testing.assert_array_equal(table["clearance_m"], alone.clearance_m.ravel())
    assert set(table["pattern"].to_pylist()) == {scene.pattern}


def test_metadata_suffices_to_make_the_bank_again(bank: Path, tmp_path: Path) -> None:
    said = json.loads(pq.read_schema(bank).metadata[b"prospect_studio"])
    again = BankPlan(
        scenes=said["scenes"],
        seed=said["seed"],
        rollouts=said["rollouts"],
        horizon=said["horizon"],
        model=said["model"],
        engine=said["engine"],
        noise=Noise(**said["noise"]),
    )
    assert again == PLAN
    assert said["scales"] == {"clearance_m": 2.0, "deviation_m": 0.5, "progress_m": 4.0}
    assert said["versions"]["pysocialforce"] == "1.1.2"
    write_bank(tmp_path / "again.parquet", again)
    assert pq.read_table(tmp_path / "again.parquet").equals(pq.read_table(bank))


def test_the_plan_can_be_read_back(bank: Path, tmp_path: Path) -> None:
    assert read_plan(bank) == PLAN
    plan = BankPlan(
        scenes=1,
        rollouts=2,
        families=("open",),
        patterns=("mixed",),
        limits=Limits(0.5, 1.0),
        actions=META_ACTIONS[:2],
    )
    write_bank(tmp_path / "b.parquet", plan)
    assert read_plan(tmp_path / "b.parquet") == plan


def test_the_plan_gives_the_rollouts_of_the_bank(bank: Path) -> None:
    table = pq.read_table(bank, filters=[("scene", "=", 3)])
    rollouts = simulate_planned(PLAN, replace(planned_scene(PLAN, 3), name="other"))
    assert outcome_rows(rollouts).equals(table.replace_schema_metadata(None))


@pytest.mark.parametrize(
    "said",
    [
        None,
        "no JSON",
        "[]",
        "{}",
        json.dumps(metadata(PLAN) | {"bank_version": 99}),
        json.dumps(metadata(PLAN) | {"dt": 0.2}),
        json.dumps(metadata(PLAN) | {"noise": {"laughter": 1.0}}),
        json.dumps(metadata(PLAN) | {"scenes": -1}),
        json.dumps(metadata(PLAN) | {"engine": "magic"}),
        json.dumps(metadata(PLAN) | {"actions": [{"name": "fly"}]}),
    ],
)
def test_a_bank_from_elsewhere_has_no_plan(bank: Path, said: str | None, tmp_path: Path) -> None:
    table = pq.read_table(bank).replace_schema_metadata(said and {"prospect_studio": said})
    pq.write_table(table, tmp_path / "other.parquet")
    assert read_plan(tmp_path / "other.parquet") is None
    (tmp_path / "no.parquet").write_bytes(b"half a fi")
    assert read_plan(tmp_path / "no.parquet") is None
    assert read_plan(tmp_path / "nothing.parquet") is None


def test_content_does_not_depend_on_the_number_of_workers(bank: Path, tmp_path: Path) -> None:
    write_bank(tmp_path / "one.parquet", PLAN, workers=1)
    write_bank(tmp_path / "five.parquet", PLAN, workers=5)
    assert (tmp_path / "one.parquet").read_bytes() == bank.read_bytes()
    assert (tmp_path / "five.parquet").read_bytes() == bank.read_bytes()


def test_progress_is_told_after_every_scene(tmp_path: Path) -> None:
    told: list[tuple[int, int]] = []
    plan = BankPlan(scenes=4, rollouts=1)
    write_bank(tmp_path / "b.parquet", plan, lambda done, total: told.append((done, total)))
    assert told == [(1, 4), (2, 4), (3, 4), (4, 4)]


def test_the_reference_engine_fills_a_bank_too(tmp_path: Path) -> None:
    plans = [
        BankPlan(scenes=2, rollouts=1, horizon=0.5, engine=engine)
        for engine in ("batched", "pysocialforce")
    ]
    for plan in plans:
        write_bank(tmp_path / f"{plan.engine}.parquet", plan, workers=2)
    ours, theirs = (pq.read_table(tmp_path / f"{plan.engine}.parquet") for plan in plans)
    for name in COLUMNS[5:]:
        np.testing.assert_allclose(ours[name], theirs[name], atol=1e-6)


def test_only_the_named_families_and_patterns_are_sampled(tmp_path: Path) -> None:
    plan = BankPlan(scenes=4, rollouts=1, families=("open", "doorway"), patterns=("head_on",))
    write_bank(tmp_path / "b.parquet", plan)
    table = pq.read_table(tmp_path / "b.parquet")
    assert set(table["family"].to_pylist()) == {"open", "doorway"}
    assert set(table["pattern"].to_pylist()) == {"head_on"}


@pytest.mark.parametrize(
    ("plan", "says"),
    [
        ({"scenes": 0}, "scenes: 0 is not allowed: 1 to 1000000"),
        ({"scenes": 10**12}, "scenes: 1000000000000 is not allowed"),
        ({"rollouts": 0}, "rollouts: 0 is not allowed"),
        ({"families": ("garden",)}, "'garden'"),
        ({"families": ("open",), "patterns": ("bottleneck",)}, "bottleneck"),
    ],
)
def test_a_plan_that_cannot_be_is_refused_before_a_file_is_opened(
    plan: dict[str, object], says: str, tmp_path: Path
) -> None:
    with pytest.raises(InputError) as refused:
        write_bank(tmp_path / "b.parquet", BankPlan(**plan))  # type: ignore[arg-type]
    assert says in str(refused.value)
    assert not list(tmp_path.iterdir())
