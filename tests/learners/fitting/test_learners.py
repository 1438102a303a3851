"""What every learner keeps to, and how well each recovers what there is to learn."""

from dataclasses import asdict, replace

import numpy as np
import pytest

from learners import (
    LEARNERS,
    PROFILES,
    TEACHERS,
    CptLearner,
    EuLearner,
    InputError,
    Preferences,
    Problem,
    Prospects,
    Teacher,
    ask,
    fit_many,
    sample_pairs,
)
from learners.fitting.cpt import STARTS

learner = pytest.mark.parametrize("learner", LEARNERS.values(), ids=LEARNERS)


def answers(prospects, teacher=TEACHERS["tk"], count=120, seed=0):
    return ask(teacher, prospects, sample_pairs(prospects, count, seed), seed)


def with_features(prospects, features):
    return replace(prospects, features=features)


def assert_sensible(fit, prospects):
    assert np.isfinite(fit.theta).all()
    assert np.isfinite(fit.values(prospects.features)).all()
    assert np.isfinite([fit.nll, fit.reference, fit.expected_decrease]).all()
    assert np.abs(fit.theta).max() < 5.0
    if fit.parameters is not None:
        assert all(0.05 < number < 20.0 for number in fit.parameters.numbers)
    assert fit.converged


def same(one, other):
    return all(np.array_equal(getattr(one, name), getattr(other, name)) for name in vars(one))


@learner
class TestEveryLearner:
    def test_explains_choices_better_than_chance_and_converges(self, learner, prospects):
        fit = learner.fit(prospects, answers(prospects))
        assert_sensible(fit, prospects)
        assert fit.learner == learner.name
        assert (fit.pairs, fit.beta) == (120, 20.0)
        assert fit.nll < np.log(2.0)
        assert np.linalg.norm(fit.unit_theta) == pytest.approx(1.0)

    def test_nll_is_that_of_the_learnt_values(self, learner, prospects):
        told = answers(prospects)
        fit = learner.fit(prospects, told)
        values = fit.values(prospects.features)
        margin = 20.0 * (values[told.scenes, told.preferred] - values[told.scenes, told.other])
        assert fit.nll == pytest.approx(np.logaddexp(0.0, -margin).mean(), rel=1e-9)

    def test_is_deterministic(self, learner, prospects):
        assert same(*(learner.fit(prospects, answers(prospects)) for _ in range(2)))

    def test_does_not_depend_on_the_order_of_the_choices(self, learner, prospects):
        told = answers(prospects, count=60)
        order = np.random.default_rng(0).permutation(60)
        turned = Preferences(*(getattr(told, f)[order] for f in ("scenes", "preferred", "other")))
        one, other = (learner.fit(prospects, t) for t in (told, turned))
        assert one.nll == pytest.approx(other.nll, abs=1e-3)

    def test_one_pair(self, learner, prospects):
        assert_sensible(learner.fit(prospects, answers(prospects, count=1)), prospects)

    def test_separable_choices(self, learner, prospects):
        decided = Teacher("sure", PROFILES["eu"], beta=1e9)
        assert_sensible(learner.fit(prospects, answers(prospects, decided)), prospects)

    def test_identical_prospects(self, learner, prospects):
        alike = with_features(prospects, np.full(prospects.features.shape, 0.5))
        fit = learner.fit(alike, answers(alike))
        assert_sensible(fit, alike)
        assert fit.nll == pytest.approx(np.log(2.0))

    def test_nothing_but_zeros(self, learner, prospects):
        nothing = with_features(prospects, np.zeros(prospects.features.shape))
        fit = learner.fit(nothing, answers(nothing))
        assert_sensible(fit, nothing)
        assert np.linalg.norm(fit.unit_theta) == 0.0

    def test_a_constant_feature(self, learner, prospects):
        features = prospects.features.copy()
        features[..., 3] = 1.0
        constant = with_features(prospects, features)
        assert_sensible(learner.fit(constant, answers(constant)), constant)

    @pytest.mark.parametrize("side", [1.0, -1.0])
    def test_all_gains_or_all_losses(self, learner, prospects, side):
        one_sided = with_features(prospects, np.abs(prospects.features))
        teacher = replace(TEACHERS["tk"], reward=(0.2 * side,) * 5)
        assert_sensible(learner.fit(one_sided, answers(one_sided, teacher)), one_sided)

    def test_single_outcomes(self, learner, prospects):
        certain = with_features(prospects, prospects.features[:, :, :1])
        assert_sensible(learner.fit(certain, answers(certain)), certain)

    def test_another_beta(self, learner, prospects):
        fit = learner.fit(prospects, answers(prospects), beta=2.0)
        assert np.isfinite(fit.theta).all()
        assert fit.converged
        assert fit.nll < np.log(2.0)

    @pytest.mark.parametrize("beta", [0.0, -1.0, float("nan"), float("inf")])
    def test_beta_out_of_range(self, learner, prospects, beta):
        with pytest.raises(InputError, match=f"beta {beta} is not allowed: a finite number above"):
            learner.fit(prospects, answers(prospects, count=5), beta=beta)

    def test_no_preferences(self, learner, prospects):
        nothing = Preferences(*(np.zeros(0, dtype=np.int64) for _ in range(3)))
        with pytest.raises(InputError, match="preferences: none is there"):
            learner.fit(prospects, nothing)


def test_eu_finds_the_reward_of_expected_utility(make):
    there = make(scenes=200)
    fit = EuLearner().fit(there, answers(there, TEACHERS["eu"], 1200))
    np.testing.assert_allclose(fit.theta, TEACHERS["eu"].reward, atol=0.05)
    assert fit.parameters is None
    assert fit.steps < 20


@pytest.mark.parametrize("name", ["tk", "strong"])
def test_cpt_finds_the_person(make, name):
    there = make(scenes=300, outcomes=12)
    teacher = replace(TEACHERS[name], beta=100.0)
    told = ask(teacher, there, sample_pairs(there, 1800, 0), 0)
    fit = CptLearner(tied=True).fit(there, told, beta=100.0)
    assert fit.unit_theta @ teacher.reward / np.linalg.norm(teacher.reward) > 0.99
    truth = teacher.parameters
    assert fit.parameters.alpha == pytest.approx(truth.alpha, abs=0.1)
    assert fit.parameters.loss_aversion == pytest.approx(truth.loss_aversion, rel=0.2)
    # tied, so between the two
    assert truth.gamma - 0.08 < fit.parameters.gamma < truth.delta + 0.08


@pytest.mark.parametrize("reference", [0.1, -0.1])
def test_cpt_finds_a_reference(make, reference):
    there = make(scenes=500)
    teacher = replace(TEACHERS["strong"], reference=reference)
    told = ask(teacher, there, sample_pairs(there, 3000, 0), 0)
    fit = CptLearner(tied=True, learns_reference=True).fit(there, told)
    assert fit.reference == pytest.approx(reference, abs=0.03)


def test_tied_parameters_are_tied(prospects):
    fit = CptLearner(tied=True).fit(prospects, answers(prospects))
    assert fit.parameters.alpha == fit.parameters.eta
    assert fit.parameters.gamma == fit.parameters.delta
    assert fit.reference == 0.0


def test_no_fit_begins_at_the_truth():
    for start in STARTS:
        for truth in PROFILES.values():
            assert not set(asdict(start).items()) & set(asdict(truth).items())


def test_a_fit_does_not_depend_on_its_company(prospects, make):
    others = make(scenes=30, seed=5)
    problems = [
        Problem(learner, there, answers(there, count=count, seed=seed))
        for learner in (CptLearner(), EuLearner(), CptLearner(tied=True))
        for there in (prospects, others)
        for count, seed in ((20, 0), (70, 1))
    ]
    alone = [p.learner.fit(*p[1:]) for p in problems]
    for workers, order in ((1, problems), (2, problems), (3, problems[::-1])):
        fits = fit_many(order, workers)
        if order is not problems:
            fits = fits[::-1]
        assert all(same(one, other) for one, other in zip(alone, fits, strict=True))


def test_prospects_are_left_as_they_were(prospects):
    before = prospects.features.copy()
    CptLearner().fit(prospects, answers(prospects, count=10))
    assert np.array_equal(prospects.features, before)
    assert isinstance(prospects, Prospects)
