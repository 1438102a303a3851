"""What commands print of results that are made up."""

from studio.cli.reports import learned_report
from studio.orchestrator import Learned
from studio.study.results import StudyResults
from tests.studio.study.tables import THREE, study_table, table_with_a_gap


def test_a_learner_whose_regret_has_gaps_has_no_row_as_it_has_no_curve_anywhere() -> None:
    results = StudyResults(table_with_a_gap(), THREE)
    _, heads, *rows = learned_report(Learned(files=(), results=results))
    assert heads.split() == ["teacher", "learner", "25"]
    curves = results.curves("regret_percent")
    assert [row.split() for row in rows] == [
        [curve.teacher, curve.learner, f"{curve.mean[0]:.2f}"] for curve in curves
    ]
    assert ("eu", "eu") not in {(curve.teacher, curve.learner) for curve in curves}


def test_what_is_to_be_known_of_the_fits_is_told() -> None:
    results = StudyResults(study_table(repeated=7, converged=False), THREE)
    *_, again, unsettled, caption = learned_report(Learned(files=(), results=results, caption="x"))
    assert again == "there are fewer pairs than wanted: up to 7 were asked again"
    assert unsettled == "54 of 54 fits did not converge"
    assert caption == "caption: x"
