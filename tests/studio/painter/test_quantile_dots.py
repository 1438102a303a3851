import numpy as np
import pytest

from studio.painter.axes import Axis
from studio.painter.quantile_dots import MOST_DOTS, DotStacks, QuantileDots


def some_dots(count: int, kinds: int = 2) -> tuple[QuantileDots, np.ndarray, np.ndarray]:
    generator = np.random.default_rng(0)
    values = generator.normal(size=count)
    labels = np.sort(generator.integers(0, kinds, count))
    return QuantileDots.of(values, labels), values, labels


def test_few_values_have_a_dot_each() -> None:
    dots, values, labels = some_dots(30)
    assert sorted(dots.values.tolist()) == sorted(values.tolist())
    assert np.bincount(dots.kinds).tolist() == np.bincount(labels).tolist()


def test_many_values_have_fifty_dots_that_are_distributed_as_they_are() -> None:
    dots, values, _ = some_dots(5000)
    assert len(dots.values) == MOST_DOTS == 50
    assert dots.values.mean() == pytest.approx(values.mean(), abs=0.02)
    assert dots.values.std() == pytest.approx(values.std(), abs=0.05)


def test_kinds_have_their_share_of_the_dots() -> None:
    kinds = np.repeat([0, 1, 2], [1000, 10, 3990])
    dots = QuantileDots.of(np.arange(5000.0), kinds)
    assert np.bincount(dots.kinds, minlength=3).tolist() == [10, 0, 40]
    # and the quantiles of their own values
    assert dots.values[:10].max() < 1000 <= dots.values[10:].min()


def test_stacks_stay_in_their_room_and_hold_dots_that_touch() -> None:
    plots = [some_dots(50)[0], QuantileDots.of(np.zeros(20), np.zeros(20, np.int64))]
    stacks = DotStacks.fit(plots, Axis(-4.0, 4.0, 100.0, 500.0), 60.0, 1.0)
    assert stacks.pitch == pytest.approx(60.0 / 20, rel=0.06)
    for dots in plots:
        middles = stacks.middles(dots)
        assert middles[:, 1].max() + stacks.pitch / 2 <= 60.0 + 1e-9
        assert len(np.unique(middles.round(6), axis=0)) == len(middles)
        # no dot lies farther from its value than half a dot
        away = np.abs(middles[:, 0] - stacks.axis.along(dots.values))
        assert away.max() <= stacks.pitch / 2 + 1e-9


def test_stacks_of_dots_that_must_not_be_smaller_are_pressed_together() -> None:
    one = QuantileDots.of(np.zeros(40), np.zeros(40, np.int64))
    stacks = DotStacks.fit([one], Axis(-1.0, 1.0, 0.0, 100.0), 20.0, 4.0)
    assert stacks.pitch == 4.0
    assert stacks.middles(one)[:, 1].max() == pytest.approx(18.0)
