from learners import TEACHERS
from studio.study.results import StudyResults
from studio.study.words import lesson, parameters_told, reached, verdicts
from tests.studio.study.tables import THREE, study_table

TK = TEACHERS["tk"]


def test_the_best_learner_is_told_and_how_sure_that_is() -> None:
    results = StudyResults(study_table(), THREE)
    found = results.difference(TK, "cpt", "eu", 2000)
    assert found is not None
    assert found.low > 0.0
    said = (
        f"by {found.difference:.2f} percentage points (95 %: {found.low:.2f} to {found.high:.2f})."
    )
    assert lesson(results, TK) == f"The EU learner has less regret than the CPT learner, {said}"
    one_seed = lesson(StudyResults(study_table(seeds=1), THREE), TK)
    assert "in the one seed, by" in one_seed
    assert lesson(StudyResults(study_table(learners=("eu",)), THREE), TK) == ""


def test_wordings_of_a_verdict_get_shorter_and_tell_the_same() -> None:
    results = StudyResults(study_table(), THREE)
    said = verdicts(results.stages[-1], TK)
    assert said[0].startswith("At 2000 pairs CPT's regret is ")
    assert [len(each) for each in said] == sorted(map(len, said), reverse=True)
    assert len({each.partition(": ")[2].split()[0] for each in said}) == 1
    assert verdicts(StudyResults(study_table(learners=("eu",)), THREE).stages[0], TK) == []


def test_regrets_of_nothing_have_no_ratio() -> None:
    stage = StudyResults(study_table(regret_percent=0.0), THREE).stages[-1]
    assert verdicts(stage, TK)[-1] == "CPT − EU: 0.00"


def test_a_study_without_fits_reached_nothing() -> None:
    assert reached(StudyResults(study_table().slice(0, 0), THREE).stages[0]) == ""
    assert parameters_told(TK) == "α 0.88  η 0.88  λ 2.25  γ 0.61  δ 0.69"
