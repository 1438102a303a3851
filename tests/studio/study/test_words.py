import pyarrow as pa

from learners import TEACHERS
from studio.study.results import StudyResults
from studio.study.words import findings_told, lesson, parameters_told, reached, verdicts
from tests.studio.study.tables import THREE, study_table

TK = TEACHERS["tk"]


def test_the_best_learner_is_told_and_how_sure_that_is() -> None:
    results = StudyResults(study_table(), THREE)
    found = results.difference(TK, "cpt", "eu", 2000)
    assert found is not None
    assert found.low > 0.0
    # the better one comes first, and the difference is that of the first from the second
    ends = f"[−{found.high:.2f}, −{found.low:.2f}]"
    said = f"−{found.difference:.2f} percentage points {ends}."
    assert lesson(results, TK) == f"The EU learner has less regret than the CPT learner: {said}"
    one_seed = lesson(StudyResults(study_table(seeds=1), THREE), TK)
    assert "in the one seed: −" in one_seed
    assert lesson(StudyResults(study_table(learners=("eu",)), THREE), TK) == ""


def test_wordings_of_a_verdict_get_shorter_and_tell_the_same() -> None:
    results = StudyResults(study_table(), THREE)
    said = verdicts(results.stages[-1], TK)
    assert said[0].startswith("CPT − EU: +")
    assert [len(each) for each in said] == sorted(map(len, said), reverse=True)
    assert len({each.partition(": ")[2].split()[0] for each in said}) == 1
    assert all("[" in each for each in said[:-1])
    assert verdicts(StudyResults(study_table(learners=("eu",)), THREE).stages[0], TK) == []


def test_regrets_of_nothing_have_no_ratio() -> None:
    stage = StudyResults(study_table(regret_percent=0.0), THREE).stages[-1]
    assert verdicts(stage, TK)[-1] == "CPT − EU: 0.00"


def test_a_study_without_fits_reached_nothing() -> None:
    assert reached(StudyResults(study_table().slice(0, 0), THREE).stages[0]) == ""
    assert parameters_told(TK) == "α 0.88  η 0.88  λ 2.25  γ 0.61  δ 0.69"


def test_nobody_has_less_regret_by_nothing() -> None:
    results = StudyResults(study_table(regret_percent=1.0), THREE)
    assert "same regret in the mean" in lesson(results, TK)
    assert "less" not in lesson(results, TK)


def titles(**shifts: float) -> list[str]:
    """Titles of a study in which CPT has by so much (%) more regret, in every seed or mostly."""
    table = study_table()
    rows = table.to_pylist()
    for row in rows:
        shift = shifts[row["teacher"]] if row["learner"] == "cpt" else 0.0
        row["regret_percent"] = 5.0 + 0.1 * row["seed"] + shift * (row["seed"] - 0.5)
        if abs(shift) > 1.0:
            row["regret_percent"] = 5.0 + 0.1 * row["seed"] + shift
    results = StudyResults(pa.Table.from_pylist(rows, schema=table.schema), THREE)
    return findings_told(results.stages[-1])


def test_the_title_tells_whom_the_result_holds_for_and_for_whom_it_is_open() -> None:
    told = titles(eu=0.5, tk=-2.0, strong=-3.0)
    assert told[0].startswith("After 2000 pairs, CPT has less regret than EU for teachers T&K and ")
    assert told[1] == "CPT has less regret than EU for teachers T&K and Strong, open for EU"
    told = titles(eu=2.0, tk=-2.0, strong=-3.0)
    assert "CPT has less regret than EU for teachers T&K and Strong" in told[1]
    assert "EU has less regret than CPT for teacher EU" in told[1]
    told = titles(eu=0.5, tk=0.5, strong=0.5)
    assert told[1] == "Whether CPT or EU has less regret is open"


def test_a_title_without_two_learners_states_no_result() -> None:
    results = StudyResults(study_table(learners=("eu",)), THREE)
    assert not any("regret" in each for each in findings_told(results.stages[-1]))
