import doctest
import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
import torch
from hypothesis import given, settings
from hypothesis import strategies as st

import learners.judging.values
from learners import (
    PROFILES,
    CptParameters,
    InputError,
    decision_weights,
    expected_utility,
    prospect_value,
    value,
    weight,
)

WEIGHTINGS = ["prelec", "tversky-kahneman"]
EU, TK, STRONG = PROFILES.values()
repeatable = settings(deadline=None, derandomize=True, max_examples=60)

# sizes that are either nothing or well above the smoothing at 0
size = st.floats(1e-3, 10.0)
utility = st.one_of(st.just(0.0), size, size.map(lambda u: -u))
weightings = st.sampled_from(WEIGHTINGS)
# exponents, loss aversions and curvatures that people have, and beyond
parameters = st.builds(
    CptParameters,
    alpha=st.floats(0.5, 1.5),
    eta=st.floats(0.5, 1.5),
    loss_aversion=st.floats(0.5, 4.0),
    gamma=st.floats(0.3, 1.5),
    delta=st.floats(0.3, 1.5),
)


@st.composite
def prospects(draw):
    utilities = draw(st.lists(utility, min_size=1, max_size=8))
    k = len(utilities)
    odds = draw(st.lists(st.integers(0, 20), min_size=k, max_size=k).filter(any))
    return utilities, [o / sum(odds) for o in odds]


def plain_weight(p, gamma, weighting):
    if p <= 0.0:
        return 0.0
    if p >= 1.0:
        return 1.0
    if weighting == "prelec":
        return math.exp(-((-math.log(p)) ** gamma))
    return p**gamma / (p**gamma + (1 - p) ** gamma) ** (1 / gamma)


def plain_prospect_value(utilities, odds, parameters, weighting, reference=0.0):
    """CPT once more, in plain Python, from integer odds so that probabilities are exact."""
    a, total = parameters, sum(odds)
    outcomes = sorted((u - reference, o) for u, o in zip(utilities, odds, strict=True))
    result = 0.0
    for i, (x, o) in enumerate(outcomes):
        if x < 0:
            worse = sum(odd for _, odd in outcomes[:i])
            result -= (a.loss_aversion * (-x) ** a.eta) * (
                plain_weight((worse + o) / total, a.delta, weighting)
                - plain_weight(worse / total, a.delta, weighting)
            )
        elif x > 0:
            better = sum(odd for _, odd in outcomes[i + 1 :])
            result += x**a.alpha * (
                plain_weight((better + o) / total, a.gamma, weighting)
                - plain_weight(better / total, a.gamma, weighting)
            )
    return result


def test_the_examples_in_the_docstrings_hold():
    assert doctest.testmod(learners.judging.values) == doctest.TestResults(failed=0, attempted=3)


class TestValue:
    @repeatable
    @given(st.floats(-100.0, 100.0), st.sampled_from([EU, TK, STRONG]))
    def test_is_the_closed_form(self, x, profile):
        a = profile
        expected = x**a.alpha if x >= 0 else -a.loss_aversion * (-x) ** a.eta
        assert value(x, a).item() == pytest.approx(expected, rel=1e-12, abs=1e-10)

    def test_nothing_is_worth_nothing(self):
        assert value([0.0, -0.0], STRONG).tolist() == [0.0, 0.0]

    def test_exponents_of_1_are_exact(self):
        x = torch.tensor([-1e-13, 1e-300, 0.1, 1e300], dtype=torch.float64)
        assert torch.equal(value(x, EU), x)

    @repeatable
    @given(st.lists(st.floats(-1e-9, 1e-9), min_size=2), parameters)
    def test_is_monotone_also_where_it_is_smoothed(self, x, people):
        assert (np.diff(value(sorted(x), people)) >= 0.0).all()

    @repeatable
    @given(st.lists(st.floats(-100.0, 100.0), min_size=1), parameters)
    def test_arrays_and_tensors_agree(self, x, people):
        array, tensor = value(x, people), value(torch.tensor(x, dtype=torch.float64), people)
        assert isinstance(array, np.ndarray)
        assert (array.dtype, tensor.dtype) == (np.float64, torch.float64)
        np.testing.assert_allclose(array, tensor, rtol=1e-15, atol=0.0)

    def test_gradients_are_those_of_finite_differences(self):
        x = torch.tensor([-2.0, -0.1, 0.05, 3.0], dtype=torch.float64, requires_grad=True)
        people = torch.tensor([0.88, 0.7, 2.25], dtype=torch.float64, requires_grad=True)

        def of(x, people):
            alpha, eta, loss_aversion = people
            return value(x, SimpleNamespace(alpha=alpha, eta=eta, loss_aversion=loss_aversion))

        assert torch.autograd.gradcheck(of, (x, people))
        assert torch.autograd.gradgradcheck(of, (x, people))

    @pytest.mark.parametrize("exponent", [0.3, 0.88, 1.0, 2.0])
    def test_gradients_are_finite_at_0(self, exponent):
        x = torch.tensor([0.0, -0.0, 1e-300, -1e-300], dtype=torch.float64, requires_grad=True)
        alpha, eta = torch.full((2,), exponent, dtype=torch.float64, requires_grad=True)
        alpha.retain_grad()
        eta.retain_grad()
        value(x, SimpleNamespace(alpha=alpha, eta=eta, loss_aversion=2.0)).sum().backward()
        for gradient in (x.grad, alpha.grad, eta.grad):
            assert torch.isfinite(gradient).all()


class TestProspectValue:
    @repeatable
    @given(
        st.lists(st.tuples(utility, st.integers(1, 20)), min_size=1, max_size=8),
        parameters,
        weightings,
        st.sampled_from([0.0, 0.5, -2.0]),
    )
    def test_agrees_with_plain_python(self, outcomes, people, weighting, reference):
        utilities, odds = zip(*outcomes, strict=True)
        probabilities = np.array(odds) / sum(odds)
        got = prospect_value(
            utilities, people, probabilities, weighting=weighting, reference=reference
        )
        expected = plain_prospect_value(utilities, odds, people, weighting, reference)
        assert got.item() == pytest.approx(expected, rel=1e-9, abs=1e-9)

    @repeatable
    @given(prospects(), weightings)
    def test_all_ones_is_the_mean(self, prospect, weighting):
        utilities, probabilities = prospect
        v = prospect_value(utilities, EU, probabilities, weighting=weighting)
        mean = math.fsum(p * u for p, u in zip(probabilities, utilities, strict=True))
        assert v.item() == pytest.approx(mean, abs=1e-13)
        v = prospect_value(utilities, EU, weighting=weighting)
        assert v.item() == pytest.approx(math.fsum(utilities) / len(utilities), abs=1e-13)

    def test_all_ones_is_the_mean_of_many_outcomes(self):
        utilities = np.random.default_rng(0).normal(size=(100, 500))
        v = prospect_value(utilities, EU)
        np.testing.assert_allclose(v, utilities.mean(-1), rtol=0.0, atol=1e-14)

    @repeatable
    @given(utility, st.integers(1, 200), parameters, weightings)
    def test_a_sure_thing_has_the_value_of_what_it_gives(self, u, k, people, weighting):
        # curvatures below 1 magnify a probability that misses 1 by rounding
        v = prospect_value([u] * k, people, weighting=weighting).item()
        assert v == pytest.approx(value(u, people).item(), rel=1e-13)

    @repeatable
    @given(prospects(), parameters, weightings, st.data())
    def test_better_outcomes_never_lower_it(self, prospect, people, weighting, data):
        utilities, probabilities = prospect
        k = len(utilities)
        better = np.array(data.draw(st.lists(st.floats(0.0, 3.0), min_size=k, max_size=k)))
        before, after = prospect_value(
            [utilities, utilities + better], people, probabilities, weighting=weighting
        )
        assert after >= before - 1e-9

    @repeatable
    @given(prospects(), parameters, weightings, st.data())
    def test_likelier_good_outcomes_never_lower_it(self, prospect, people, weighting, data):
        utilities, probabilities = prospect
        outcome = st.integers(0, len(utilities) - 1)
        worse, better = sorted((data.draw(outcome), data.draw(outcome)), key=utilities.__getitem__)
        moved = probabilities[worse] * data.draw(st.floats(0.0, 1.0))
        shifted = list(probabilities)
        shifted[worse] -= moved
        shifted[better] += moved
        before, after = prospect_value(
            utilities, people, [probabilities, shifted], weighting=weighting
        )
        assert after >= before - 1e-9

    @repeatable
    @given(prospects(), parameters, weightings, st.randoms(use_true_random=False))
    def test_order_does_not_matter(self, prospect, people, weighting, random):
        pairs = list(zip(*prospect, strict=True))
        random.shuffle(pairs)
        utilities, probabilities = zip(*pairs, strict=True)
        before = prospect_value(prospect[0], people, prospect[1], weighting=weighting)
        after = prospect_value(utilities, people, probabilities, weighting=weighting)
        assert after.item() == pytest.approx(before.item(), rel=1e-10, abs=1e-10)

    @repeatable
    @given(prospects(), parameters, st.floats(0.01, 100.0))
    def test_scale_comes_out_as_a_power(self, prospect, people, scale):
        people = replace(people, eta=people.alpha)
        utilities, probabilities = prospect
        scaled = prospect_value(scale * np.array(utilities), people, probabilities)
        v = scale**people.alpha * prospect_value(utilities, people, probabilities)
        assert scaled.item() == pytest.approx(v.item(), rel=1e-10, abs=1e-10)

    @repeatable
    @given(prospects(), parameters, weightings)
    def test_losses_mirror_gains_when_their_parameters_are_equal(self, prospect, people, weighting):
        people = replace(people, eta=people.alpha, delta=people.gamma, loss_aversion=1.0)
        utilities, probabilities = prospect
        v = prospect_value(utilities, people, probabilities, weighting=weighting)
        mirrored = prospect_value(-np.array(utilities), people, probabilities, weighting=weighting)
        assert mirrored.item() == pytest.approx(-v.item(), rel=1e-10, abs=1e-10)

    @repeatable
    @given(prospects(), parameters, weightings, st.data())
    def test_an_outcome_split_in_two_halves_changes_nothing(
        self, prospect, people, weighting, data
    ):
        utilities, probabilities = prospect
        i = data.draw(st.integers(0, len(utilities) - 1))
        halves = [*probabilities, probabilities[i] / 2]
        halves[i] /= 2
        split = prospect_value([*utilities, utilities[i]], people, halves, weighting=weighting)
        whole = prospect_value(utilities, people, probabilities, weighting=weighting)
        assert split.item() == pytest.approx(whole.item(), rel=1e-10, abs=1e-10)

    @repeatable
    @given(prospects(), parameters, weightings, utility)
    def test_an_impossible_outcome_changes_nothing(self, prospect, people, weighting, u):
        utilities, probabilities = prospect
        more = prospect_value([u, *utilities], people, [0.0, *probabilities], weighting=weighting)
        v = prospect_value(utilities, people, probabilities, weighting=weighting)
        assert more.item() == pytest.approx(v.item(), rel=1e-12, abs=1e-12)

    @repeatable
    @given(st.lists(utility, min_size=1, max_size=8), parameters, weightings, utility)
    def test_a_reference_is_what_utilities_are_measured_from(
        self, utilities, people, weighting, reference
    ):
        v = prospect_value(utilities, people, weighting=weighting, reference=reference)
        measured = prospect_value(np.array(utilities) - reference, people, weighting=weighting)
        assert v.item() == measured.item()

    def test_a_coin_toss_for_100_is_refused_by_the_person_of_tversky_and_kahneman(self):
        # Tversky and Kahneman (1992): w+(1/2) = 2^-(0.61 + 1/0.61 - 1) = 0.4206 and
        # w-(1/2) = 2^-(0.69 + 1/0.69 - 1) = 0.4540, v(±100) = 57.544 and -129.474
        v = prospect_value([100.0, -100.0], TK, weighting="tversky-kahneman").item()
        by_hand = 2 ** -(0.61 + 1 / 0.61 - 1) * 100**0.88 - 2 ** -(0.69 + 1 / 0.69 - 1) * (
            2.25 * 100**0.88
        )
        assert v == pytest.approx(by_hand, rel=1e-12)
        assert v == pytest.approx(0.4206 * 57.544 - 0.4540 * 129.474, abs=0.02)

    def test_the_die_of_tversky_and_kahneman_is_ranked_as_in_their_paper(self):
        # section 1.1: a die pays its number if even and costs it if odd,
        # a loss counts from the worst, -5, and a gain from the best, 6
        numbers = [1, 2, 3, 4, 5, 6]
        utilities = [n if n % 2 == 0 else -n for n in numbers]
        sixths = weight(np.arange(7) / 6, TK.gamma), weight(np.arange(7) / 6, TK.delta)
        gain, loss = (np.diff(w) for w in sixths)
        expected = [loss[2], gain[2], loss[1], gain[1], loss[0], gain[0]]
        np.testing.assert_allclose(decision_weights(utilities, TK), expected, atol=1e-15)


class TestDecisionWeights:
    @repeatable
    @given(prospects(), parameters, weightings)
    def test_are_shares_of_certainty(self, prospect, people, weighting):
        utilities, probabilities = prospect
        weights = decision_weights(utilities, people, probabilities, weighting=weighting)
        assert ((weights >= 0.0) & (weights <= 1.0)).all()
        assert all(weights[np.array(probabilities) == 0.0] == 0.0)

    @pytest.mark.parametrize("weighting", WEIGHTINGS)
    @pytest.mark.parametrize("sign", [1.0, -1.0])
    @pytest.mark.parametrize("k", [1, 2, 3, 10, 49, 1000])
    def test_sum_to_1_when_all_are_gains_or_all_are_losses(self, k, sign, weighting):
        utilities = sign * np.random.default_rng(k).permutation(np.arange(1.0, k + 1.0))
        weights = decision_weights(utilities, STRONG, weighting=weighting)
        assert weights.sum().item() == pytest.approx(1.0, abs=1e-13)

    @pytest.mark.parametrize("sign", [1.0, -1.0])
    def test_overweight_the_rare_extremes(self, sign):
        utilities = sign * np.array([1.0, 2.0, 3.0, 4.0])
        probabilities = np.array([0.01, 0.49, 0.49, 0.01])
        weights = decision_weights(utilities, TK, probabilities)
        assert (weights > 3 * probabilities).tolist() == [True, False, False, True]

    def test_all_ones_weigh_outcomes_by_their_probabilities(self):
        probabilities = [0.1, 0.2, 0.0, 0.7]
        weights = decision_weights([3.0, -1.0, 0.0, 1.0], EU, probabilities)
        np.testing.assert_allclose(weights, probabilities, rtol=0.0, atol=1e-15)

    def test_gains_and_losses_part_at_the_reference(self):
        below = decision_weights([1.0, 2.0], TK, reference=3.0)
        np.testing.assert_array_equal(below, decision_weights([-2.0, -1.0], TK))


class TestExpectedUtility:
    def test_is_the_mean(self):
        utilities = np.random.default_rng(1).normal(size=(3, 4, 50))
        np.testing.assert_allclose(expected_utility(utilities), utilities.mean(-1), atol=1e-15)

    def test_weighs_by_probability(self):
        assert expected_utility([1.0, 10.0], [0.9, 0.1]).item() == pytest.approx(1.9)
        both = expected_utility([1.0, 10.0], [[0.9, 0.1], [0.0, 1.0]])
        np.testing.assert_allclose(both, [1.9, 10.0])


FUNCTIONS = {
    "expected_utility": lambda u, p=None: expected_utility(u, p),
    "prospect_value": lambda u, p=None: prospect_value(u, TK, p),
    "decision_weights": lambda u, p=None: decision_weights(u, TK, p),
}


@pytest.mark.parametrize("function", FUNCTIONS.values(), ids=FUNCTIONS)
class TestEveryFunctionOfProspects:
    def test_a_batch_equals_a_loop(self, function):
        rng = np.random.default_rng(2)
        utilities = rng.normal(size=(3, 7, 20)).round(1)
        probabilities = rng.dirichlet(np.ones(20), size=(3, 7))
        for p in (None, probabilities, probabilities[0, 0], probabilities[:, :1]):
            batch = function(utilities, p)
            for i, j in np.ndindex(3, 7):
                one = None if p is None else np.broadcast_to(p, utilities.shape)[i, j]
                np.testing.assert_allclose(
                    batch[i, j], function(utilities[i, j], one), rtol=0.0, atol=1e-14
                )

    def test_probabilities_may_have_the_larger_batch(self, function):
        probabilities = np.random.default_rng(3).dirichlet(np.ones(4), size=5)
        batch = function([0.3, -0.2, 0.0, 1.0], probabilities)
        loop = [function([0.3, -0.2, 0.0, 1.0], p) for p in probabilities]
        np.testing.assert_allclose(batch, loop, rtol=0.0, atol=1e-15)

    def test_equal_probabilities_may_be_left_out(self, function):
        utilities = np.random.default_rng(4).normal(size=(6, 9))
        np.testing.assert_allclose(
            function(utilities), function(utilities, np.full(9, 1 / 9)), rtol=0.0, atol=1e-14
        )

    @pytest.mark.parametrize("dtype", [np.float32, np.float64, np.int64])
    def test_lists_arrays_and_tensors_give_the_same_float64(self, function, dtype):
        array = np.array([[1, -2, 3], [4, 0, -1]], dtype=dtype)
        array.setflags(write=False)
        expected = function(array.tolist())
        assert expected.dtype == np.float64
        for given_utilities in (array, array[:, ::-1][:, ::-1]):
            assert np.array_equal(function(given_utilities), expected)
            assert function(given_utilities).dtype == np.float64
        of_tensor = function(torch.tensor(array.copy()))
        assert of_tensor.dtype == torch.float64
        np.testing.assert_allclose(of_tensor, expected, rtol=0.0, atol=1e-15)

    def test_one_tensor_makes_the_result_a_tensor(self, function):
        utilities, probabilities = [[1.0, -2.0, 3.0], [4.0, 0.0, -1.0]], [0.2, 0.3, 0.5]
        expected = function(utilities, probabilities)
        for some in (
            function(torch.tensor(utilities), probabilities),
            function(np.array(utilities), torch.tensor(probabilities, dtype=torch.float64)),
        ):
            assert some.dtype == torch.float64
            np.testing.assert_allclose(some, expected, rtol=0.0, atol=1e-15)

    def test_probabilities_of_single_precision_are_normalised(self, function):
        probabilities = torch.tensor([0.01, 0.49, 0.49, 0.01])
        exact = probabilities.double() / probabilities.double().sum()
        got = function([1.0, -2.0, 3.0, 4.0], probabilities)
        expected = function([1.0, -2.0, 3.0, 4.0], exact)
        torch.testing.assert_close(got, expected, rtol=0.0, atol=1e-14)

    def test_inputs_are_left_as_they_are(self, function):
        utilities, probabilities = torch.tensor([3.0, -1.0]), torch.tensor([0.25, 0.75])
        function(utilities, probabilities)
        assert utilities.tolist() == [3.0, -1.0]
        assert probabilities.tolist() == [0.25, 0.75]

    def test_an_empty_batch_gives_an_empty_batch(self, function):
        assert function(np.zeros((0, 5))).shape[0] == 0

    @pytest.mark.parametrize(
        ("utilities", "probabilities", "message"),
        [
            (1.0, None, r"utilities of shape \[\] are not allowed: .* one or more outcomes"),
            ([], None, r"utilities of shape \[0\] are not allowed: .* one or more outcomes"),
            ([1.0, math.nan], None, r"utilities contains nan: only finite numbers are allowed"),
            (["a"], None, r"utilities of type list is not allowed: an array of numbers"),
            ([1.0, 2.0], [0.5, 0.6], r"probabilities sum to 1\.1: they must sum to 1"),
            ([1.0, 2.0], [1.5, -0.5], r"probabilities contain -0\.5: 0 to 1 is allowed"),
            ([1.0, 2.0], [math.inf, 0.0], r"probabilities contains inf: .*"),
            ([1.0, 2.0], [1.0], r"probabilities of shape \[1\] are not allowed: .*"),
            ([1.0, 2.0], 0.5, r"probabilities of shape \[\] are not allowed: .*"),
            (
                np.ones((2, 2)),
                np.full((3, 2), 0.5),
                r"probabilities of shape \[3, 2\] are not allowed: a shape that broadcasts "
                r"against utilities \[2, 2\] and has the same last axis",
            ),
        ],
    )
    def test_wrong_input_is_refused_by_name(self, function, utilities, probabilities, message):
        with pytest.raises(InputError, match=f"^{message}$"):
            function(utilities, probabilities)


@pytest.mark.parametrize("function", [prospect_value, decision_weights])
class TestEveryFunctionOfCpt:
    def test_a_reference_that_does_not_fit_is_refused(self, function):
        for reference in (torch.zeros(3), torch.zeros(2, 1, 5), [math.nan, 0.0]):
            with pytest.raises(InputError, match=r"^reference "):
                function([1.0, 2.0], TK, reference=reference)
        with pytest.raises(InputError, match=r"^reference of shape \[2\] is not allowed"):
            function([1.0], TK, reference=[0.0, 1.0])

    def test_a_curvature_too_low_for_the_weighting_is_refused_by_name(self, function):
        low = replace(TK, delta=0.2)
        function([1.0], low)
        with pytest.raises(InputError, match=r"^delta 0\.2 is not allowed with the tversky"):
            function([1.0], low, weighting="tversky-kahneman")

    def test_an_unknown_weighting_is_refused(self, function):
        with pytest.raises(InputError, match=r"^weighting 'none' is not allowed"):
            function([1.0], TK, weighting="none")

    def test_a_tensor_parameter_out_of_range_is_refused_by_name(self, function):
        wrong = SimpleNamespace(**{**vars(TK), "gamma": torch.tensor(-1.0)})
        with pytest.raises(InputError, match=r"^gamma -1\.0 is not allowed"):
            function([1.0], wrong)

    def test_a_batch_of_people_broadcasts(self, function):
        utilities = np.random.default_rng(5).normal(size=(4, 6))
        people = [EU, TK, STRONG]
        names = ("alpha", "eta", "loss_aversion", "gamma", "delta")
        batch = SimpleNamespace(
            **{
                n: torch.tensor([[[getattr(a, n)]] for a in people], dtype=torch.float64)
                for n in names
            }
        )
        loop = [function(utilities, a) for a in people]
        of_tensors = function(utilities, batch)
        assert of_tensors.dtype == torch.float64
        np.testing.assert_allclose(of_tensors, loop, rtol=0.0, atol=1e-14)
        arrays = SimpleNamespace(**{n: numbers.numpy() for n, numbers in vars(batch).items()})
        of_arrays = function(utilities, arrays)
        assert isinstance(of_arrays, np.ndarray)
        np.testing.assert_allclose(of_arrays, loop, rtol=0.0, atol=1e-14)

    @pytest.mark.parametrize("name", ["gamma", "delta"])
    def test_one_tensor_among_parameters_or_a_reference_makes_a_tensor(self, function, name):
        utilities, p = [1.0, -2.0, 3.0], [0.2, 0.3, 0.5]
        expected = function(utilities, TK, p)
        one = torch.tensor(getattr(TK, name), dtype=torch.float64, requires_grad=True)
        of_parameter = function(utilities, SimpleNamespace(**{**vars(TK), name: one}), p)
        of_reference = function(utilities, TK, p, reference=torch.tensor(0.0))
        for some in (of_parameter, of_reference):
            assert some.dtype == torch.float64
            np.testing.assert_allclose(some.detach(), expected, rtol=0.0, atol=1e-15)
        assert torch.autograd.grad(of_parameter.square().sum(), one)[0] != 0.0

    @repeatable
    @given(prospects(), parameters, weightings, utility)
    def test_arrays_and_tensors_agree(self, function, prospect, people, weighting, reference):
        utilities, probabilities = prospect
        largest = np.abs(value(np.array(utilities) - reference, people)).max()
        for p in (probabilities, None):
            array = function(utilities, people, p, weighting=weighting, reference=reference)
            tensor = function(
                torch.tensor(utilities, dtype=torch.float64),
                people,
                p,
                weighting=weighting,
                reference=reference,
            )
            assert (array.dtype, tensor.dtype) == (np.float64, torch.float64)
            # each of the eight outcomes or fewer may be rounded otherwise
            np.testing.assert_allclose(array, tensor, rtol=0.0, atol=1e-15 * max(1.0, 2 * largest))


def as_parameters(vector):
    names = ("alpha", "eta", "loss_aversion", "gamma", "delta")
    return SimpleNamespace(**dict(zip(names, vector, strict=True)))


@pytest.mark.parametrize("weighting", WEIGHTINGS)
class TestGradients:
    def test_are_those_of_finite_differences(self, weighting):
        utilities = torch.tensor(
            [[0.5, -1.0, 2.0, -0.3], [0.1, 0.2, 0.3, 0.4], [-0.4, -0.3, -0.2, -0.1]],
            dtype=torch.float64,
            requires_grad=True,
        )
        odds = torch.tensor([0.3, 0.7, -0.2, 0.1], dtype=torch.float64, requires_grad=True)
        people = torch.tensor([0.88, 0.7, 2.25, 0.61, 0.5], dtype=torch.float64)
        people.requires_grad_()
        reference = torch.tensor(0.03, dtype=torch.float64, requires_grad=True)

        def of_all(utilities, odds, people, reference):
            return prospect_value(
                utilities,
                as_parameters(people),
                odds.softmax(-1),
                weighting=weighting,
                reference=reference,
            )

        assert torch.autograd.gradcheck(of_all, (utilities, odds, people, reference))

        def of_equal_odds(utilities, people):
            return prospect_value(utilities, as_parameters(people), weighting=weighting)

        assert torch.autograd.gradcheck(of_equal_odds, (utilities, people))

    @pytest.mark.parametrize("profile", PROFILES.values(), ids=PROFILES)
    @pytest.mark.parametrize(
        "outcomes",
        [[0.0], [0.0, 0.0, 0.0], [0.0, -0.0, 1.0], [1.0, 1.0, 1.0], [-1.0, -1.0, 0.0, 2.0, 2.0]],
    )
    def test_are_finite_at_ties_and_at_0(self, weighting, profile, outcomes):
        utilities = torch.tensor(outcomes, dtype=torch.float64, requires_grad=True)
        # one impossible outcome, so that cumulated probabilities meet 0 and 1 within too
        odds = torch.ones(len(outcomes), dtype=torch.float64)
        odds[1:2] = 0.0
        probabilities = (odds / odds.sum()).requires_grad_()
        people = torch.tensor([*vars(profile).values()], dtype=torch.float64, requires_grad=True)
        for p in (None, probabilities):
            v = prospect_value(utilities, as_parameters(people), p, weighting=weighting)
            for gradient in torch.autograd.grad(
                v, [utilities, people] if p is None else [utilities, people, p]
            ):
                assert torch.isfinite(gradient).all()

    def test_tied_outcomes_share_the_gradient_of_one(self, weighting):
        tied = torch.full((4,), 0.7, dtype=torch.float64, requires_grad=True)
        prospect_value(tied, TK, weighting=weighting).backward()
        assert tied.grad.sum().item() == pytest.approx(0.88 * 0.7**-0.12)

    def test_of_all_ones_is_the_probability(self, weighting):
        utilities = torch.tensor([0.0, -1.0, 0.0, 2.0], dtype=torch.float64, requires_grad=True)
        prospect_value(utilities, EU, weighting=weighting).backward()
        np.testing.assert_allclose(utilities.grad, np.full(4, 0.25), atol=1e-15)
