import pyarrow as pa
import pytest

from learners import TEACHERS, Teacher
from studio.study.results import StudyResults
from studio.study.words import findings_told, lesson, parameters_told, reached, verdicts
from studio.style.words import signed
from tests.studio.study.tables import THREE, study_table

TK = TEACHERS["tk"]


def with_shifts(
    shifts: dict[str, float], spread: float, teachers: tuple[Teacher, ...] = THREE
) -> StudyResults:
    """A study in which EU regrets 1 % with every seed, and CPT so much more of each teacher.

    The paired differences of the seeds scatter by `spread` to either side, percentage points.
    """
    table = study_table(teachers)
    regrets = [
        1.0 + (row["learner"] == "cpt") * (shifts[row["teacher"]] + (row["seed"] - 1) * spread)
        for row in table.to_pylist()
    ]
    place = table.column_names.index("regret_percent")
    return StudyResults(table.set_column(place, "regret_percent", pa.array(regrets)), teachers)


@pytest.mark.parametrize(
    ("shifts", "spread", "said"),
    [
        (
            {"eu": 0.0, "tk": -0.5, "strong": -0.5},
            0.1,
            "CPT has less regret than EU for teachers T&K and Strong, open for EU",
        ),
        (
            {"eu": 0.5, "tk": -0.5, "strong": 0.0},
            0.1,
            "CPT has less regret than EU for teacher T&K, "
            "EU has less regret than CPT for teacher EU, open for Strong",
        ),
        (
            {"eu": 0.5, "tk": 0.5, "strong": 0.5},
            0.1,
            "EU has less regret than CPT for teachers EU, T&K and Strong",
        ),
        # a mean below 0 whose interval holds 0 states nothing
        (
            {"eu": -0.1, "tk": -0.1, "strong": -0.1},
            0.5,
            "Whether CPT has less regret than EU is open",
        ),
    ],
)
def test_the_title_states_who_has_less_regret_where_that_is_sure(
    shifts: dict[str, float], spread: float, said: str
) -> None:
    longest, plain, *_ = findings_told(with_shifts(shifts, spread).stages[-1])
    assert plain == said
    assert longest == f"After 2000 pairs, {said.replace('Whether', 'whether')}"


def test_where_names_have_no_room_the_title_counts_teachers() -> None:
    told = findings_told(with_shifts({"eu": 0.0, "tk": -0.5, "strong": -0.5}, 0.1).stages[-1])
    assert "CPT has less regret than EU for 2 of 3 teachers" in told
    assert "EU has less regret" not in " ".join(told)


def test_a_single_seed_and_a_single_learner_state_no_result() -> None:
    one_seed = StudyResults(study_table(seeds=1), THREE)
    assert findings_told(one_seed.stages[-1])[1] == "Whether CPT has less regret than EU is open"
    alone = StudyResults(study_table(learners=("eu",)), THREE)
    assert findings_told(alone.stages[-1]) == ["Learning what people prefer", "Preferences learnt"]
    nothing = StudyResults(study_table().slice(0, 0), THREE)
    assert findings_told(nothing.stages[-1]) == findings_told(alone.stages[-1])


def test_a_lesson_never_says_less_for_nothing() -> None:
    for shift in (0.0, 0.004, -0.004):
        said = lesson(with_shifts(dict.fromkeys(("eu", "tk", "strong"), shift), 0.0), TK)
        assert " less " not in said
        assert "the same regret in the mean, to 0.01 percentage points" in said
    small = lesson(with_shifts({"eu": 0.0, "tk": -0.02, "strong": 0.0}, 0.0), TK)
    assert small == (
        "The CPT learner has less regret than the EU learner: "
        "−0.02 percentage points [−0.02, −0.02]."
    )


def test_a_lesson_that_is_not_sure_says_so() -> None:
    said = lesson(with_shifts({"eu": 0.0, "tk": -0.1, "strong": 0.0}, 0.5), TK)
    assert said.startswith("The CPT learner has less regret than the EU learner in the mean, ")
    assert "though not for sure: −0.10 percentage points [−0.60, +0.40]" in said


def test_the_best_learner_is_told_and_how_sure_that_is() -> None:
    results = StudyResults(study_table(), THREE)
    found = results.difference(TK, "eu", "cpt", 2000)
    assert found is not None
    assert found.high < 0.0
    # first named minus second named
    shift, low, high = map(signed, (found.difference, found.low, found.high))
    assert lesson(results, TK) == (
        "The EU learner has less regret than the CPT learner: "
        f"{shift} percentage points [{low}, {high}]."
    )
    one_seed = lesson(StudyResults(study_table(seeds=1), THREE), TK)
    assert "in the one seed: −0.0" in one_seed
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
    assert not any("less" in said or "×" in said for said in verdicts(stage, TK))


def test_a_study_without_fits_reached_nothing() -> None:
    assert reached(StudyResults(study_table().slice(0, 0), THREE).stages[0]) == ""
    assert parameters_told(TK) == "α 0.88  η 0.88  λ 2.25  γ 0.61  δ 0.69"
