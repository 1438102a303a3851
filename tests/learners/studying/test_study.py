import json
from dataclasses import replace

import numpy as np
import pytest

from learners import (
    PARAMETER_COLUMNS,
    Task,
    missing_tasks,
    run_study,
    study_batches,
    study_tasks,
    whole_table,
)


def test_has_one_row_a_fit_in_a_stable_order(table, study):
    rows = list(zip(*(table[name].to_pylist() for name in Task._fields), strict=True))
    assert rows == list(study_tasks(study))
    assert len(rows) == 16


def test_only_expected_utility_has_no_parameters(table):
    for row in table.to_pylist():
        for name in PARAMETER_COLUMNS:
            assert (row[name] is None) == (row["learner"] == "eu")


def test_rows_make_sense(table):
    for row in table.to_pylist():
        assert row["regret"] >= 0.0
        assert 0.5 <= row["certainty"] <= 1.0
        assert 0.0 <= row["agreement"] <= 1.0
        assert row["nll"] >= row["nll_teacher"]
        assert len(row["theta"]) == 5
        assert np.linalg.norm(row["theta_unit"]) == pytest.approx(1.0)
        assert sum(row["calibration_count"]) == 9 * 6 * 2  # held-out scenes, pairs, sides
        assert row["repeated"] == 0


def test_says_what_was_studied(table):
    said = json.loads(table.schema.metadata[b"prospect_study"])
    assert said["teachers"]["strong"]["parameters"]["loss_aversion"] == 3.0
    assert said["learners"]["cpt"]["name"] == "cpt"


def test_learners_of_one_seed_answer_the_same_questions(table):
    rows = [r for r in table.to_pylist() if (r["teacher"], r["pairs"]) == ("strong", 40)]
    assert len({r["certainty"] for r in rows if r["seed"] == 0}) == 1
    assert len({r["certainty"] for r in rows}) == 2


def test_questions_that_come_again_are_counted(prospects):
    there = run_study(prospects, ["eu"], ["eu"], sizes=(1000,), seeds=1)
    assert there["repeated"].to_pylist() == [1000 - 15 * 6]


@pytest.mark.parametrize("rows", [0, 1, 7, 8, 16])
def test_continues_bit_for_bit_where_it_stopped(prospects, study, small, table, rows):
    begun = table.slice(0, rows)
    assert missing_tasks(study, begun) == study_tasks(study)[rows:]
    told = []
    resumed = run_study(prospects, **small, table=begun, progress=lambda *done: told.append(done))
    assert resumed.equals(table, check_metadata=True)
    assert told == [(done, 16) for done in range(rows + 1, 17)]


def test_batches_are_numbers_of_pairs(study, table):
    batches = list(study_batches(study, workers=2))
    assert [set(batch["pairs"].to_pylist()) for batch in batches] == [{10}, {40}]
    assert whole_table(study, batches).equals(table, check_metadata=True)
    assert [batch.num_rows for batch in study_batches(study, batches[0])] == [8]


def test_a_row_does_not_depend_on_what_else_is_studied(prospects, table):
    alone = run_study(prospects, ["strong"], ["cpt"], sizes=(40,), seeds=2).to_pylist()
    rows = [r for r in table.to_pylist() if (r["teacher"], r["learner"]) == ("strong", "cpt")]
    assert alone == [row for row in rows if row["pairs"] == 40]


def test_more_seeds_build_on_fewer(prospects, study, small, table):
    more = replace(study, seeds=3)
    assert len(missing_tasks(more, table)) == 8
    assert {task.seed for task in missing_tasks(more, table)} == {2}
    fewer = run_study(prospects, **small | {"seeds": 1}, table=table)
    assert set(fewer["seed"].to_pylist()) == {0}
