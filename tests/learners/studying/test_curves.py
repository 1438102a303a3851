from itertools import product

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
import pytest

from learners import TEACHERS, InputError, learning_curves, paired_differences
from learners.seeds import Stream, generator
from learners.studying.curves import RESAMPLES, Spread, mean_interval, middle_interval, middle_mean


@pytest.fixture
def table():
    rows = [
        {
            "teacher": teacher,
            "learner": learner,
            "pairs": pairs,
            "seed": seed,
            "regret_percent": 100.0 / pairs + seed + (learner == "eu") * 2.0,
            "alpha": None if learner == "eu" else TEACHERS[teacher].parameters.alpha,
            "theta_unit": [1.0 * seed, 2.0],
            "converged": True,
        }
        for pairs, teacher, learner, seed in product(
            (100, 25), ("tk", "eu"), ("eu", "cpt"), range(4)
        )
    ]
    return pa.Table.from_pylist(rows)


def test_curves_are_means_over_seeds_in_order(table):
    curves = learning_curves(table)
    assert [(c.teacher, c.learner) for c in curves] == [
        ("tk", "eu"),
        ("tk", "cpt"),
        ("eu", "eu"),
        ("eu", "cpt"),
    ]
    one = curves[1]
    assert one.pairs.tolist() == [25, 100]
    assert one.runs.tolist() == [4, 4]
    assert one.mean.tolist() == [5.5, 2.5]
    np.testing.assert_allclose(one.std, np.std(range(4), ddof=1))
    assert (one.low < one.mean).all()
    assert (one.mean < one.high).all()


def test_lists_and_missing_and_logical_columns(table):
    assert learning_curves(table, "theta_unit")[0].mean.tolist() == [[1.5, 2.0], [1.5, 2.0]]
    assert [c.learner for c in learning_curves(table, "alpha")] == ["cpt", "cpt"]
    assert learning_curves(table, "converged")[0].mean.tolist() == [1.0, 1.0]


def test_a_single_seed_has_no_spread(table):
    curve = learning_curves(table[:1])[0]
    assert (curve.std, curve.low, curve.high) == (0.0, curve.mean, curve.mean)


def test_a_curve_answers_for_one_number_of_pairs(table):
    there = learning_curves(table)[1].at(100)
    assert (there.runs, there.mean) == (4, 2.5)
    assert there.low < there.mean < there.high
    assert learning_curves(table)[1].at(50) is None
    assert learning_curves(table, "theta_unit")[0].at(25).mean.tolist() == [1.5, 2.0]


def test_a_difference_answers_for_one_number_of_pairs(table):
    there = paired_differences(table)[0].at(25)
    assert (there.runs, there.difference, there.low, there.high) == (4, -2.0, -2.0, -2.0)
    assert there.ratio == pytest.approx(5.5 / 7.5)
    assert paired_differences(table)[0].at(50) is None


def test_comparison_is_paired(table):
    for comparison in paired_differences(table):
        assert comparison.difference.tolist() == [-2.0, -2.0]
        assert comparison.low.tolist() == comparison.high.tolist() == [-2.0, -2.0]
        assert comparison.ratio.tolist() == pytest.approx([5.5 / 7.5, 2.5 / 4.5])


def test_comparison_uses_the_seeds_that_both_have(table):
    left_out = pc.and_(pc.equal(table["learner"], "eu"), pc.greater(table["seed"], 1))
    fewer = table.filter(pc.invert(left_out))
    assert paired_differences(fewer)[0].runs.tolist() == [2, 2]


def test_intervals_hold_the_mean_about_as_often_as_they_say():
    random = np.random.default_rng(0)
    holds = [
        low <= 0.0 <= high
        for low, high in (mean_interval(random.normal(size=20)) for _ in range(200))
    ]
    assert 0.87 < np.mean(holds) < 0.99


def test_the_interquartile_mean_does_not_hang_on_one_seed():
    regrets = np.array([43.0, 5.5, 0.5, 1.4, 1.0])
    assert middle_mean(regrets) == pytest.approx((1.0 + 1.4 + 5.5) / 3)
    assert middle_mean(regrets[:3]) == pytest.approx(regrets[:3].mean())  # no quarter of three
    of_ten = middle_mean(np.arange(10.0) ** 2)  # two are left out at either end
    assert of_ten == pytest.approx((np.arange(2, 8.0) ** 2).mean())
    columns = np.stack([regrets, -regrets], axis=1)
    assert middle_mean(columns).tolist() == pytest.approx([7.9 / 3, -7.9 / 3])


@pytest.mark.parametrize("count", [1, 3, 5, 8])
def test_intervals_are_quantiles_of_draws_with_replacement(count):
    samples = np.random.default_rng(count).exponential(size=(count, 2))
    places = generator(0, Stream.BOOTSTRAP).integers(count, size=(RESAMPLES, count))
    means = samples[places].mean(axis=1)
    np.testing.assert_allclose(mean_interval(samples), np.quantile(means, [0.025, 0.975], axis=0))
    # the places stand for ranks here
    draws = np.sort(samples, axis=0)[places]
    middles = [middle_mean(draw) for draw in draws]
    np.testing.assert_allclose(
        middle_interval(samples), np.quantile(middles, [0.025, 0.975], axis=0)
    )


def test_what_cannot_be_averaged_is_refused(table):
    with pytest.raises(InputError, match="column 'speed' is not allowed: teacher, learner"):
        learning_curves(table, "speed")
    with pytest.raises(InputError, match="column 'teacher' of string is not allowed"):
        learning_curves(table, "teacher")
    with pytest.raises(InputError, match="learner 'deep' is not allowed: eu, cpt"):
        paired_differences(table, "deep")


# The middle half of the seeds


FIVE = np.array([43.0, 5.5, 0.5, 1.4, 1.0])


@pytest.mark.parametrize(
    ("samples", "middle"),
    [
        (FIVE, (5.5 + 1.4 + 1.0) / 3.0),
        (FIVE[:4], (5.5 + 1.4) / 2.0),
        (FIVE[:3], (43.0 + 5.5 + 0.5) / 3.0),  # of fewer than four none is left out
        (FIVE[:1], 43.0),
        (np.arange(10.0), 4.5),
        (np.array([9.0, 8.0, 7.0, 6.0, 5.0, 4.0, 3.0, 100.0]), 6.5),
    ],
)
def test_the_interquartile_mean_leaves_a_quarter_out_at_either_end(samples, middle):
    assert middle_mean(samples) == pytest.approx(middle)


def test_the_interquartile_mean_is_that_of_scipy():
    stats = pytest.importorskip("scipy.stats")
    rng = np.random.default_rng(1)
    for count in range(1, 22):
        samples = rng.lognormal(size=(count, 3))
        np.testing.assert_allclose(middle_mean(samples), stats.trim_mean(samples, 0.25, axis=0))


def test_the_interval_of_the_interquartile_mean_is_that_of_resampled_seeds():
    low, high = middle_interval(FIVE)
    # another bootstrap, draw by draw
    rng = np.random.default_rng(5)
    draws = [np.sort(rng.choice(FIVE, 5))[1:4].mean() for _ in range(40_000)]
    np.testing.assert_allclose((low, high), np.quantile(draws, (0.025, 0.975)), rtol=0.1)
    assert low < middle_mean(FIVE) < high


def test_curves_carry_median_middle_and_every_seed():
    rows = [
        {"teacher": "eu", "learner": "eu", "pairs": pairs, "seed": seed, "regret_percent": value}
        for pairs, values in ((25, FIVE), (50, FIVE[::-1] / 2.0))
        for seed, value in enumerate(values.tolist())
    ]
    [curve] = learning_curves(pa.Table.from_pylist(rows))
    assert curve.median.tolist() == [1.4, 0.7]
    assert curve.middle.tolist() == pytest.approx([7.9 / 3.0, 7.9 / 6.0])
    assert [samples.tolist() for samples in curve.samples] == [
        FIVE.tolist(),
        (FIVE[::-1] / 2.0).tolist(),
    ]
    assert (curve.middle_low[0], curve.middle_high[0]) == middle_interval(FIVE)
    assert curve.at(50).middle == curve.middle[1]


def test_some_points_of_a_curve_are_a_curve(table):
    curve = learning_curves(table, "theta_unit")[0]
    last = curve.where(curve.pairs > 25)
    assert (last.teacher, last.learner, last.column) == ("tk", "eu", "theta_unit")
    assert (last.pairs.tolist(), last.runs.tolist()) == ([100], [4])
    assert last.mean.tolist() == curve.mean[1:].tolist()
    assert len(last.samples) == 1
    np.testing.assert_array_equal(last.samples[0], curve.samples[1])
    assert last.at(25) is None
    assert last.at(100).middle_high.tolist() == curve.at(100).middle_high.tolist()
    nothing = curve.where(curve.pairs < 0)
    assert (len(nothing.pairs), nothing.mean.shape, nothing.samples) == (0, (0, 2), ())


def test_a_curve_in_another_unit_is_changed_as_a_whole(table):
    curve = learning_curves(table)[1]
    doubled = curve.mapped(lambda entries: 2.0 * entries)
    assert doubled.pairs.tolist() == curve.pairs.tolist()
    assert doubled.runs.tolist() == curve.runs.tolist()
    names = ("mean", "std", "low", "high", "median", "middle", "middle_low", "middle_high")
    for name in names:
        assert getattr(doubled, name).tolist() == (2.0 * getattr(curve, name)).tolist()
    for before, after in zip(curve.samples, doubled.samples, strict=True):
        assert after.tolist() == (2.0 * before).tolist()


def test_a_spread_of_lists_has_one_of_each_number(table):
    spread = learning_curves(table, "theta_unit")[0].at(25)
    one = spread.of(0)
    assert isinstance(one, Spread)
    assert (one.runs, one.mean, one.median, one.middle) == (4, 1.5, 1.5, 1.5)
    assert one.samples.tolist() == [0.0, 1.0, 2.0, 3.0]
    assert spread.of(1).std == 0.0
