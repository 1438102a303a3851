from dataclasses import replace

import pyarrow.parquet as pq
import pytest

from learners import (
    PARAMETER_COLUMNS,
    STUDY_SCHEMA,
    TEACHERS,
    CptParameters,
    EuLearner,
    InputError,
    missing_tasks,
    study_scenes,
    study_tasks,
    whole_table,
)

CONTRACT = [
    *("teacher", "learner", "pairs", "seed", "regret", "regret_percent", "nll", "certainty"),
    *("theta", "alpha", "eta", "lambda", "gamma", "delta"),
]


def test_has_the_columns_of_the_contract_first(table):
    assert table.column_names[: len(CONTRACT)] == CONTRACT
    assert table.schema.equals(STUDY_SCHEMA)


def test_survives_a_file(table, study, tmp_path):
    pq.write_table(table, tmp_path / "learning.parquet")
    read = pq.read_table(tmp_path / "learning.parquet")
    assert read.equals(table, check_metadata=True)
    assert missing_tasks(study, read) == ()


def test_parameters_have_a_column_each():
    assert len(PARAMETER_COLUMNS) == len(CptParameters.SYMBOLS)


def test_tables_of_one_study_make_a_whole_in_the_order_of_its_tasks(study, table):
    parts = [table[8:], table[:10]]
    assert whole_table(study, parts).equals(table, check_metadata=True)
    assert missing_tasks(study, None) == study_tasks(study)


def test_rows_of_another_study_are_refused(study, table, make):
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


def test_rows_of_an_older_edition_are_refused(study, table):
    with pytest.raises(InputError, match="rows without 'scene_regret' are not allowed"):
        missing_tasks(study, table.drop_columns(["scene_regret"]))


def test_scenes_are_told_as_the_teacher_sees_them(table, prospects):
    scenes = study_scenes(table)
    assert list(scenes) == prospects.scenes.tolist()
    truth = TEACHERS["strong"].values(prospects.features)
    for place, scene in enumerate(scenes.values()):
        assert (scene.family, scene.pattern) == (prospects.families[place], "mixed")
        assert scene.best["strong"] == prospects.actions[truth[place].argmax()]
        cost = (truth[place].max() - truth[place]).mean()
        assert scene.random_regret["strong"] == pytest.approx(cost)


def test_scenes_survive_a_file(table, tmp_path):
    pq.write_table(table, tmp_path / "learning.parquet")
    assert study_scenes(pq.read_table(tmp_path / "learning.parquet")) == study_scenes(table)
