import numpy as np
import pyarrow as pa

from studio.study.regret import RegretRange
from studio.study.results import StudyResults
from tests.studio.study.tables import THREE, study_table


def test_the_range_holds_all_curves() -> None:
    results = StudyResults(study_table(), THREE)
    curves = results.curves("regret_percent")
    seeds = np.concatenate([samples for curve in curves for samples in curve.samples])
    assert results.regrets.least == results.regrets.start == seeds.min()
    assert results.regrets.most >= seeds.max()
    assert not results.regrets.has_less
    assert results.regrets.most >= max(curve.high.max() for curve in curves)
    assert not results.regrets.has_zero


def test_a_regret_of_zero_has_no_place_on_a_logarithmic_axis() -> None:
    nothing = StudyResults(study_table(regret_percent=0.0), THREE).regrets
    assert nothing == RegretRange(least=np.inf, most=0.0, has_zero=True, has_less=False)
    assert nothing.start == 0.1
    assert RegretRange.around([]) == RegretRange(
        least=np.inf, most=0.0, has_zero=False, has_less=False
    )


def test_a_single_lucky_seed_does_not_stretch_the_axis() -> None:
    table = study_table()
    rows = table.to_pylist()
    rows[0]["regret_percent"] = 1e-9
    found = StudyResults(pa.Table.from_pylist(rows, schema=table.schema), THREE)
    means = [curve.mean.min() for curve in found.curves("regret_percent")]
    assert found.regrets.least == min(means) / 4.0
    assert found.regrets.has_less
