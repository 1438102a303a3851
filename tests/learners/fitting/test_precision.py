from dataclasses import replace

import numpy as np
import pytest

from learners import TEACHERS, CptLearner, InputError, ask, attainable_precision, sample_pairs

TK = TEACHERS["tk"]


def test_more_choices_tell_more_and_ties_help(prospects):
    few, many = (attainable_precision(TK, prospects, count) for count in (100, 10_000))
    tied = attainable_precision(TK, prospects, 10_000, tied=True)
    assert (few.theta > many.theta).all()
    assert (many.log_parameters > tied.log_parameters).all()
    assert few.theta_cosine < many.theta_cosine < 1.0
    assert tied.log_parameters[0] == tied.log_parameters[1]


def test_no_choice_tells_more_than_the_prior(prospects):
    vague = attainable_precision(replace(TK, beta=1e-6), prospects, 1)
    np.testing.assert_allclose(vague.log_parameters, [0.5, 0.5, 1.0, 0.5, 0.5], rtol=1e-3)


def test_learners_are_about_as_precise(make):
    there = make(scenes=100)
    expected = attainable_precision(TK, there, 600, tied=True)
    fits = [
        CptLearner(tied=True).fit(there, ask(TK, there, sample_pairs(there, 600, seed), seed))
        for seed in range(12)
    ]
    spread = np.std([fit.theta for fit in fits], axis=0, ddof=1)
    np.testing.assert_allclose(spread, expected.theta, rtol=0.4)
    logs = np.log([fit.parameters.numbers for fit in fits])
    np.testing.assert_allclose(np.std(logs, axis=0, ddof=1), expected.log_parameters, rtol=0.4)


def test_refusals(prospects):
    with pytest.raises(InputError, match="pairs 0 is not allowed"):
        attainable_precision(TK, prospects, 0)
    with pytest.raises(InputError, match="weighting 'tversky-kahneman' is not allowed: prelec"):
        attainable_precision(replace(TK, weighting="tversky-kahneman"), prospects, 10)
