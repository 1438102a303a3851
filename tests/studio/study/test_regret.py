import numpy as np
import pyarrow as pa

from studio.study.regret import RegretRange
from studio.study.results import StudyResults
from tests.studio.study.tables import THREE, study_table


def test_the_range_holds_all_curves() -> None:
    results = StudyResults(study_table(), THREE)
    curves = results.curves("regret_percent")
    seeds = [float(sample) for curve in curves for samples in curve.samples for sample in samples]
    assert results.regrets.least == results.regrets.start == min(seeds)
    assert results.regrets.most == max(seeds) >= max(curve.high.max() for curve in curves)
    assert not results.regrets.has_zero
    assert not results.regrets.has_less


def test_a_single_lucky_seed_does_not_stretch_the_range() -> None:
    table = study_table()
    regrets = table["regret_percent"].to_pylist()
    regrets[0] = 1e-6
    place = table.column_names.index("regret_percent")
    results = StudyResults(table.set_column(place, "regret_percent", pa.array(regrets)), THREE)
    means = [curve.mean.min() for curve in results.curves("regret_percent")]
    assert results.regrets.has_less
    assert results.regrets.least == min(means) / 4.0


def test_a_regret_of_zero_has_no_place_on_a_logarithmic_axis() -> None:
    nothing = StudyResults(study_table(regret_percent=0.0), THREE).regrets
    assert nothing == RegretRange(least=np.inf, most=0.0, has_zero=True, has_less=False)
    assert nothing.start == 0.1
    empty = RegretRange.around([])
    assert empty == RegretRange(least=np.inf, most=0.0, has_zero=False, has_less=False)
