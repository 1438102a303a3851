import numpy as np

from learners import PROFILES, TEACHERS
from studio.study.fits import learnt_parameters, parameters_of, pooled_calibration
from tests.studio.study.tables import study_fit


def test_calibration_is_pooled_by_the_number_of_predictions() -> None:
    fits = [
        {
            "calibration_count": [0, 1, 0],
            "calibration_predicted": [None, 0.4, None],
            "calibration_preferred": [None, 0.5, None],
        },
        {
            "calibration_count": [0, 3, 4],
            "calibration_predicted": [None, 0.6, 0.9],
            "calibration_preferred": [None, 0.7, 0.8],
        },
    ]
    pooled = pooled_calibration(fits)
    assert pooled.count.tolist() == [4, 4]
    np.testing.assert_allclose(pooled.predicted, [0.55, 0.9])
    np.testing.assert_allclose(pooled.preferred, [0.65, 0.8])
    assert pooled_calibration([]).count.tolist() == []


def test_who_learns_no_parameters_learns_expected_utility() -> None:
    rng = np.random.default_rng(0)
    eu, cpt = (study_fit(rng, TEACHERS["tk"], learner, 25, 0) for learner in ("eu", "cpt"))
    assert parameters_of(eu) is None
    assert learnt_parameters(eu) == PROFILES["eu"]
    assert learnt_parameters(cpt) == parameters_of(cpt)
    assert learnt_parameters(cpt).delta == cpt["delta"]
