import json
from dataclasses import replace

import numpy as np
import pyarrow.parquet as pq
import pytest

from learners import (
    STUDY_SCHEMA,
    TEACHERS,
    CptLearner,
    EuLearner,
    InputError,
    Study,
    Task,
    missing_tasks,
    run_study,
    study_batches,
    study_tasks,
    whole_table,
)

SMALL = {"teachers": ["eu", "strong"], "learners": ["eu", "cpt"], "sizes": (10, 40), "seeds": 2}
CONTRACT = [
    *("teacher", "learner", "pairs", "seed", "regret", "regret_percent", "nll", "certainty"),
    *("theta", "alpha", "eta", "lambda", "gamma", "delta"),
]


@pytest.fixture(scope="module")
def study(prospects):
    return Study(
        prospects,
        (TEACHERS["eu"], TEACHERS["strong"]),
        (EuLearner(), CptLearner()),
        SMALL["sizes"],
        SMALL["seeds"],
    )


@pytest.fixture(scope="module")
def table(prospects):
    return run_study(prospects, **SMALL, workers=1)


class TestTable:
    def test_has_the_columns_of_the_contract_first(self, table):
        assert table.column_names[: len(CONTRACT)] == CONTRACT
        assert table.schema.equals(STUDY_SCHEMA)

    def test_has_one_row_a_fit_in_a_stable_order(self, table, study):
        rows = list(zip(*(table[name].to_pylist() for name in Task._fields), strict=True))
        assert rows == list(study_tasks(study))
        assert len(rows) == 16

    def test_only_expected_utility_has_no_parameters(self, table):
        for row in table.to_pylist():
            for name in ("alpha", "eta", "lambda", "gamma", "delta"):
                assert (row[name] is None) == (row["learner"] == "eu")

    def test_rows_make_sense(self, table):
        for row in table.to_pylist():
            assert row["regret"] >= 0.0
            assert 0.5 <= row["certainty"] <= 1.0
            assert 0.0 <= row["agreement"] <= 1.0
            assert row["nll"] >= row["nll_teacher"]
            assert len(row["theta"]) == 5
            assert np.linalg.norm(row["theta_unit"]) == pytest.approx(1.0)
            assert sum(row["calibration_count"]) == 9 * 6 * 2  # held-out scenes, pairs, sides
            assert row["repeated"] == 0

    def test_survives_a_file(self, table, study, tmp_path):
        pq.write_table(table, tmp_path / "learning.parquet")
        read = pq.read_table(tmp_path / "learning.parquet")
        assert read.equals(table, check_metadata=True)
        assert missing_tasks(study, read) == ()

    def test_says_what_was_studied(self, table):
        said = json.loads(table.schema.metadata[b"prospect_study"])
        assert said["teachers"]["strong"]["parameters"]["loss_aversion"] == 3.0
        assert said["learners"]["cpt"]["name"] == "cpt"

    def test_learners_of_one_seed_answer_the_same_questions(self, table):
        rows = [r for r in table.to_pylist() if (r["teacher"], r["pairs"]) == ("strong", 40)]
        assert len({r["certainty"] for r in rows if r["seed"] == 0}) == 1
        assert len({r["certainty"] for r in rows}) == 2

    def test_questions_that_come_again_are_counted(self, prospects):
        there = run_study(prospects, ["eu"], ["eu"], sizes=(1000,), seeds=1)
        assert there["repeated"].to_pylist() == [1000 - 15 * 6]


class TestResuming:
    @pytest.mark.parametrize("rows", [0, 1, 7, 8, 16])
    def test_continues_bit_for_bit_where_it_stopped(self, prospects, study, table, rows):
        begun = table.slice(0, rows)
        assert missing_tasks(study, begun) == study_tasks(study)[rows:]
        told = []
        resumed = run_study(
            prospects, **SMALL, table=begun, progress=lambda *done: told.append(done)
        )
        assert resumed.equals(table, check_metadata=True)
        assert told == [(done, 16) for done in range(rows + 1, 17)]

    def test_batches_are_numbers_of_pairs(self, study, table):
        batches = list(study_batches(study, workers=2))
        assert [set(batch["pairs"].to_pylist()) for batch in batches] == [{10}, {40}]
        assert whole_table(study, batches).equals(table, check_metadata=True)
        assert [batch.num_rows for batch in study_batches(study, batches[0])] == [8]

    def test_a_row_does_not_depend_on_what_else_is_studied(self, prospects, table):
        alone = run_study(prospects, ["strong"], ["cpt"], sizes=(40,), seeds=2).to_pylist()
        rows = [r for r in table.to_pylist() if (r["teacher"], r["learner"]) == ("strong", "cpt")]
        assert alone == [row for row in rows if row["pairs"] == 40]

    def test_more_seeds_build_on_fewer(self, prospects, study, table):
        more = replace(study, seeds=3)
        assert len(missing_tasks(more, table)) == 8
        assert {task.seed for task in missing_tasks(more, table)} == {2}
        fewer = run_study(prospects, **SMALL | {"seeds": 1}, table=table)
        assert set(fewer["seed"].to_pylist()) == {0}

    def test_rows_of_another_study_are_refused(self, study, table, make):
        others = [
            (replace(study, prospects=make(seed=9)), "rows of bank"),
            (replace(study, held_out=0.5), "rows of held_out 0.333"),
            (
                replace(study, teachers=(replace(TEACHERS["eu"], beta=1.0),)),
                "rows of teachers with another 'eu'",
            ),
            (
                replace(study, learners=(EuLearner(reward_deviation=2.0),)),
                "rows of learners with another 'eu'",
            ),
        ]
        for other, message in others:
            with pytest.raises(InputError, match=message):
                missing_tasks(other, table)
        with pytest.raises(InputError, match="rows without a study are not allowed"):
            missing_tasks(study, table.replace_schema_metadata(None))

    def test_rows_of_an_older_edition_are_refused(self, study, table):
        with pytest.raises(InputError, match="rows without 'scene_regret' are not allowed"):
            missing_tasks(study, table.drop_columns(["scene_regret"]))


class TestRefusals:
    @pytest.mark.parametrize(
        ("change", "message"),
        [
            ({"sizes": (10, 0)}, "pairs 0 is not allowed: 1 or more"),
            ({"sizes": ()}, "pairs: none is given: one or more is needed"),
            ({"sizes": (10, 10)}, r"pairs: \[10, 10\] is not allowed: each once"),
            ({"seeds": 0}, "seeds 0 is not allowed: 1 or more"),
            ({"teachers": ["eu", "eu"]}, "is not allowed: each once"),
            ({"teachers": ["you"]}, "teacher 'you' is not allowed: eu, tk, strong"),
            ({"learners": ["deep"]}, "learner 'deep' is not allowed: eu, cpt"),
            ({"learners": []}, "learners: none is given"),
            ({"held_out": 1.5}, "held_out 1.5 is not allowed: between 0 and 1"),
            ({"teachers": [replace(TEACHERS["eu"], reward=(1.0,))]}, "reward of 1 numbers"),
        ],
    )
    def test_what_cannot_be_studied(self, prospects, change, message):
        with pytest.raises(InputError, match=message):
            run_study(prospects, **SMALL | change)

    def test_too_few_scenes(self, make):
        with pytest.raises(InputError, match="scenes: family corridor has 1"):
            run_study(make(scenes=3), **SMALL)
