import numpy as np

from studio.study.regret import RegretRange
from studio.study.results import StudyResults
from tests.studio.study.tables import THREE, study_table


def test_the_range_holds_all_curves() -> None:
    results = StudyResults(study_table(), THREE)
    curves = results.curves("regret_percent")
    assert results.regrets.least == results.regrets.start == min(c.mean.min() for c in curves)
    assert results.regrets.most >= max(curve.high.max() for curve in curves)
    assert not results.regrets.has_zero


def test_a_regret_of_zero_has_no_place_on_a_logarithmic_axis() -> None:
    nothing = StudyResults(study_table(regret_percent=0.0), THREE).regrets
    assert nothing == RegretRange(least=np.inf, most=0.0, has_zero=True)
    assert nothing.start == 0.1
    assert RegretRange.around([]) == RegretRange(least=np.inf, most=0.0, has_zero=False)
