import json

import numpy as np
import pyarrow.compute as pc
import pytest

from learners import (
    TEACHERS,
    InputError,
    family_curves,
    family_table,
    run_study,
    scene_regrets,
    study_scenes,
    telling_scenes,
)

TASK = ("teacher", "learner", "pairs", "seed")


@pytest.fixture(scope="module")
def table(prospects):
    return run_study(prospects, ["eu", "strong"], ["eu", "cpt"], sizes=(10, 40), seeds=3, workers=1)


def with_regrets(table, change):
    """The table with other regrets in its scenes."""
    rows = table.to_pylist()
    for row in rows:
        row["scene_regret"] = [change(row, scene) for scene in row["held_out_scenes"]]
    return table.from_pylist(rows, schema=table.schema)


def test_what_was_picked_costs_what_is_said(table, prospects):
    truth = TEACHERS["strong"].values(prospects.features)
    for row in table.to_pylist():
        if row["teacher"] != "strong":
            continue
        for scene, regret, pick in zip(
            row["held_out_scenes"], row["scene_regret"], row["scene_picks"], strict=True
        ):
            worth = truth[prospects.scenes.tolist().index(scene)]
            assert regret == worth.max() - worth[prospects.actions.index(pick)]
        assert np.mean(row["scene_regret"]) == pytest.approx(row["regret"])


def test_families_together_have_the_regret_of_the_fit(table):
    cells = family_table(table).to_pylist()
    scenes = study_scenes(table)
    for row in table.to_pylist():
        ours = [cell for cell in cells if all(cell[name] == row[name] for name in TASK)]
        assert {cell["family"] for cell in ours} == {"corridor", "doorway", "open"}
        counts = [cell["scenes"] for cell in ours]
        assert sum(counts) == len(row["held_out_scenes"])
        mean = np.average([cell["regret"] for cell in ours], weights=counts)
        assert mean == pytest.approx(row["regret"])
        for cell in ours:
            cost = np.mean(
                [
                    scenes[scene].random_regret[row["teacher"]]
                    for scene in row["held_out_scenes"]
                    if scenes[scene].family == cell["family"]
                ]
            )
            assert cell["regret_percent"] == pytest.approx(100.0 * cell["regret"] / cost)


def test_curves_of_a_family_are_means_over_seeds(table):
    curves = family_curves(table, "regret")
    assert list(curves) == ["corridor", "doorway", "open"]
    for family, of_family in curves.items():
        assert [(c.teacher, c.learner) for c in of_family] == [
            ("eu", "eu"),
            ("eu", "cpt"),
            ("strong", "eu"),
            ("strong", "cpt"),
        ]
        one = of_family[2]
        cells = [
            cell["regret"]
            for cell in family_table(table).to_pylist()
            if (cell["teacher"], cell["learner"], cell["pairs"]) == ("strong", "eu", 40)
            and cell["family"] == family
        ]
        assert one.runs.tolist() == [3, 3]
        assert one.mean[1] == pytest.approx(np.mean(cells))
        assert one.low[1] <= one.mean[1] <= one.high[1]


def test_where_nothing_can_be_lost_the_regret_is_nothing(table):
    said = json.loads(table.schema.metadata[b"prospect_study"])
    for scene in said["scenes"]:
        scene["random_regret"] = dict.fromkeys(scene["random_regret"], 0.0)
    idle = with_regrets(table, lambda row, scene: 0.0)
    idle = idle.replace_schema_metadata({"prospect_study": json.dumps(said)})
    assert set(family_table(idle)["regret_percent"].to_pylist()) == {0.0}


def test_a_scene_has_the_mean_of_the_seeds_that_held_it_out(table):
    marked = with_regrets(table, lambda row, scene: float(scene + 10 * row["seed"]))
    by_seed = {row["seed"]: row["held_out_scenes"] for row in table.to_pylist()}
    for regrets in scene_regrets(marked):
        held_out = sorted({scene for scenes in by_seed.values() for scene in scenes})
        assert regrets.scenes.tolist() == held_out
        for scene, runs, regret in zip(held_out, regrets.runs, regrets.regret, strict=True):
            seeds = [seed for seed, scenes in by_seed.items() if scene in scenes]
            assert runs == len(seeds)
            assert regret == pytest.approx(scene + 10 * np.mean(seeds))


def test_a_pick_is_that_of_most_seeds(table):
    rows = table.to_pylist()
    for row in rows:
        pick = "stop" if row["seed"] == 1 else "forward"
        row["scene_picks"] = [pick] * len(row["held_out_scenes"])
    (regrets, *_) = scene_regrets(table.from_pylist(rows, schema=table.schema))
    often = [pick for pick, runs in zip(regrets.picks, regrets.runs, strict=True) if runs == 3]
    assert set(often) <= {"forward"}
    assert {"forward", "stop"} == set(regrets.picks)


def test_telling_scenes_are_those_in_which_learners_differ_most(table):
    held_out = sorted({s for row in table.to_pylist() for s in row["held_out_scenes"]})
    first, second, third, fourth = held_out[:4]
    at_the_end = {first: 0.1, second: 0.4, third: 0.0, fourth: 0.0}
    alike = {third: 0.2, fourth: 0.7}

    def change(row, scene):
        if row["teacher"] == "eu":
            return 0.0
        if row["pairs"] == 10:  # what was early on does not count
            return float(scene) if row["learner"] == "cpt" else 0.0
        return alike.get(scene, 0.0) + at_the_end.get(scene, 0.0) * (row["learner"] == "cpt")

    made = with_regrets(table, change)
    assert telling_scenes(made, 5) == {"eu": (), "strong": (second, first, fourth, third)}
    assert telling_scenes(made, 1) == {"eu": (), "strong": (second,)}


def test_of_one_learner_the_largest_regrets_tell(table):
    alone = table.filter(pc.equal(table["learner"], "eu"))
    made = with_regrets(alone, lambda row, scene: float(scene))
    held_out = sorted({s for row in table.to_pylist() for s in row["held_out_scenes"]})
    assert telling_scenes(made, 2)["eu"] == tuple(held_out[:-3:-1])


def test_a_table_that_does_not_tell_of_its_scenes_is_refused(table):
    for metadata in (None, {"prospect_study": "{}"}, {"prospect_study": '{"scenes": [1]}'}):
        bare = table.replace_schema_metadata(metadata)
        with pytest.raises(InputError, match="rows without a description of their scenes"):
            family_table(bare)
