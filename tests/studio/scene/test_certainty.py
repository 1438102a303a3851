"""How sure numbers are that come from rollouts."""

import numpy as np
import pytest

from studio.scene.certainty import RESAMPLES, resampled_counts, wilson


@pytest.mark.parametrize(
    ("happened", "count", "low", "high"),
    # worked examples of Newcombe, "Two-sided confidence intervals for the single proportion",
    # Statistics in Medicine 17 (1998), table I, method 3
    [
        (81, 263, 0.2553, 0.3662),
        (15, 148, 0.0624, 0.1605),
        (0, 20, 0.0, 0.1611),
        (1, 29, 0.0061, 0.1718),
    ],
)
def test_shares_have_the_interval_of_wilson(happened, count, low, high) -> None:
    share = wilson(happened, count)
    assert share.value == happened / count
    assert (share.low, share.high) == pytest.approx((low, high), abs=5e-5)


def test_what_always_happens_mirrors_what_never_does() -> None:
    never, always = wilson(0, 50), wilson(50, 50)
    assert (always.low, always.high) == pytest.approx((1.0 - never.high, 1.0))


def test_every_draw_has_as_many_rollouts_and_is_the_same_each_time() -> None:
    counts = resampled_counts(50, 1000)
    assert counts.shape == (RESAMPLES, 1000)
    assert (counts.sum(axis=1) == 50).all()
    np.testing.assert_array_equal(counts, resampled_counts(50, 1000))
    # every rollout is drawn about as often as any other
    assert counts.sum(axis=0) == pytest.approx(50.0, abs=6 * 50**0.5)
