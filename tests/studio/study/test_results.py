"""What a table comes to, for all media alike."""

import numpy as np
import pyarrow as pa
import pytest

from learners import TEACHERS, paired_differences
from studio.study.results import Stage, StudyResults
from tests.studio.study.tables import THREE, study_table

SIZES = (25, 200, 2000)


@pytest.fixture(scope="module")
def results() -> StudyResults:
    return StudyResults(study_table(), THREE)


def test_fits_come_by_seed(results: StudyResults) -> None:
    fits = results.fits_of(TEACHERS["tk"], "cpt", 200)
    assert [fit["seed"] for fit in fits] == [0, 1, 2]
    assert {(fit["teacher"], fit["learner"], fit["pairs"]) for fit in fits} == {("tk", "cpt", 200)}
    assert results.fits_of(TEACHERS["tk"], "cpt", 201) == []


def test_a_stage_knows_what_was_found_by_its_time(results: StudyResults) -> None:
    assert [stage.sizes for stage in results.stages] == [SIZES[:1], SIZES[:2], SIZES]
    stage = Stage(results, 199)
    assert stage.sizes == SIZES[:1]
    assert {fit["pairs"] for fit in stage.fits} == {25}
    assert stage.largest(TEACHERS["eu"], "eu") == results.fits_of(TEACHERS["eu"], "eu", 25)
    curve = results.curve("regret_percent", TEACHERS["eu"], "cpt")
    assert curve is not None
    assert stage.so_far(curve).mean.tolist() == curve.mean[:1].tolist()


def test_a_study_without_fits_has_one_stage_of_nothing() -> None:
    [stage] = StudyResults(study_table().slice(0, 0), THREE).stages
    assert stage.sizes == ()
    assert stage.largest(TEACHERS["eu"], "eu") == []


def test_teachers_without_fits_are_known_and_can_be_left_out() -> None:
    results = StudyResults(study_table(THREE[:2]), THREE)
    assert results.teachers == THREE
    assert results.among(results.taught).teachers == THREE[:2]
    assert results.among(THREE[:1]).table.num_rows == results.table.num_rows // 2


def test_curves_with_gaps_are_left_out() -> None:
    table = study_table(sizes=SIZES[:1], seeds=1)
    regrets = [float("nan"), *table["regret_percent"].to_pylist()[1:]]
    place = table.column_names.index("regret_percent")
    table = table.set_column(place, table.schema.field("regret_percent"), pa.array(regrets))
    results = StudyResults(table, THREE)
    assert results.curve("regret_percent", TEACHERS["eu"], "eu") is None
    assert len(results.curves("regret_percent")) == 5
    assert np.isfinite(results.regrets.most)


def test_differences_are_those_of_the_learners(results: StudyResults) -> None:
    assert results.paired == ("cpt", "eu")
    found = results.difference(TEACHERS["tk"], "cpt", "eu", 200)
    [paired] = [each for each in paired_differences(results.table) if each.teacher == "tk"]
    assert found is not None
    assert (found.runs, found.difference) == (3, paired.difference[1])
    assert (found.low, found.high, found.ratio) == (paired.low[1], paired.high[1], paired.ratio[1])
    assert results.difference(TEACHERS["tk"], "cpt", "eu", 201) is None
