"""What commands print of results that are made up."""

import pyarrow as pa

from studio.cli.reports import learned_report
from studio.orchestrator import Learned
from studio.study.results import StudyResults
from tests.studio.study.tables import THREE, study_table, table_with_a_gap


def test_a_learner_whose_regret_has_gaps_has_no_row_as_it_has_no_curve_anywhere() -> None:
    results = StudyResults(table_with_a_gap(), THREE)
    said, more, heads, *rows = learned_report(Learned(files=(), results=results))
    assert (said, more) == (
        "regret on held-out scenes, in % of a random action's: mean over seeds, and mean of the",
        "middle half of the seeds",
    )
    assert heads.split() == ["teacher", "learner", "25"]
    curves = results.curves("regret_percent")
    lines = []
    for curve in curves:
        lines.append([curve.teacher, curve.learner, "mean", f"{curve.mean[0]:.2f}"])
        lines.append(["middle", f"{curve.middle[0]:.2f}"])
    assert [row.split() for row in rows[: len(lines)]] == lines
    assert ("eu", "eu") not in {(curve.teacher, curve.learner) for curve in curves}
    told, *lessons = rows[len(lines) :]
    assert told == "at 25 pairs, with 95 % intervals"
    # one seed has no interval, and of EU only one learner is left
    assert [each.partition(": ")[0] for each in lessons] == ["T&K", "Strong"]
    assert all("in the one seed: −" in each for each in lessons)


def test_the_middle_half_of_the_seeds_has_a_row_of_its_own() -> None:
    table = study_table((THREE[0],), learners=("eu",), sizes=(25,), seeds=5)
    regrets = pa.array([43.0, 5.5, 0.5, 1.4, 1.0])
    place = table.column_names.index("regret_percent")
    results = StudyResults(table.set_column(place, "regret_percent", regrets), THREE[:1])
    mean, middle = learned_report(Learned(files=(), results=results))[3:]
    assert mean.split() == ["eu", "eu", "mean", "10.28"]
    assert middle.split() == ["middle", "2.63"]


def test_what_is_to_be_known_of_the_fits_is_told() -> None:
    results = StudyResults(study_table(repeated=7, converged=False), THREE)
    *_, again, unsettled, caption = learned_report(Learned(files=(), results=results, caption="x"))
    assert again == "there are fewer pairs than wanted: up to 7 were asked again"
    assert unsettled == "54 of 54 fits did not converge"
    assert caption == "caption: x"
