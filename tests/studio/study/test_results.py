"""What a table comes to, for all media alike."""

import numpy as np
import pytest

from learners import TEACHERS, paired_differences
from studio.study.results import FAMILY_COLUMNS, Stage, StudyResults
from tests.studio.study.tables import THREE, study_table, table_with_a_gap

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
    results = StudyResults(table_with_a_gap(), THREE)
    assert results.curve("regret_percent", TEACHERS["eu"], "eu") is None
    assert len(results.curves("regret_percent")) == 5
    assert np.isfinite(results.regrets.most)


def test_curves_of_families_with_gaps_are_left_out_and_the_others_stay_as_they_are() -> None:
    results = StudyResults(table_with_a_gap(), THREE)
    eu, fit = TEACHERS["eu"], results.fits[0]
    for column in FAMILY_COLUMNS:
        assert results.family_curve(column, "doorway", eu, "eu") is None
        assert results.family_curve(column, "doorway", eu, "cpt") is not None
    assert results.family_percents("doorway", eu, "eu") is None
    held_out = zip(fit["held_out_scenes"], fit["scene_regret"], strict=True)
    of_open = [regret for scene, regret in held_out if results.scenes[scene].family == "open"]
    curve = results.family_curve("regret", "open", eu, "eu")
    assert curve is not None
    assert curve.mean.tolist() == pytest.approx([np.mean(of_open)])


def test_the_most_repeated_pairs_of_a_fit_are_counted() -> None:
    assert StudyResults(study_table(repeated=7), THREE).repeated == 7
    assert StudyResults(study_table().slice(0, 0), THREE).repeated == 0


def test_differences_are_those_of_the_learners(results: StudyResults) -> None:
    assert results.paired == ("cpt", "eu")
    found = results.difference(TEACHERS["tk"], "cpt", "eu", 200)
    [paired] = [each for each in paired_differences(results.table) if each.teacher == "tk"]
    assert found is not None
    assert (found.runs, found.difference) == (3, paired.difference[1])
    assert (found.low, found.high, found.ratio) == (paired.low[1], paired.high[1], paired.ratio[1])
    assert results.difference(TEACHERS["tk"], "cpt", "eu", 201) is None
