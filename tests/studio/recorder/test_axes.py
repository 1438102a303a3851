import numpy as np
import pytest

from studio.recorder.axes import ratio_scale, sizes_scale


@pytest.mark.parametrize(("low", "high"), [(0.01, 0.03), (0.4, 20.0), (1.0, 1.0), (30.0, 100.0)])
def test_ratio_scales_hold_everything_and_no_more(low: float, high: float) -> None:
    scale = ratio_scale(low, high)
    assert scale.ticks[0] <= low < scale.ticks[1]
    assert scale.ticks[-1] >= high
    assert len(scale.ticks) == 2 or scale.ticks[-2] < high
    np.testing.assert_allclose(scale([scale.ticks[0], scale.ticks[-1]]), [0.0, 1.0])


def test_crowded_ticks_leave_out_words_but_never_the_last() -> None:
    scale = sizes_scale(range(1, 101))
    assert scale.words[-1] == "100"
    assert 3 <= sum(bool(words) for words in scale.words) <= 8
