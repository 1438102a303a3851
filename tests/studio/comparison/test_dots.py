import dataclasses

import numpy as np
import pytest

from studio.comparison.dots import DotMeasure, DotScale, dot_measures
from studio.comparison.picture.page import lay_out_comparison
from studio.painter.boxes import Box
from tests.studio.comparison.made_up import SIZE, a_comparison


@pytest.mark.parametrize("count", [1, 7, 50, 200, 3000])
def test_dots_of_every_outcome_find_room(count):
    room = Box(0.0, 0.0, 300.0, 120.0)
    rng = np.random.default_rng(0)
    for values in (rng.uniform(0.0, 1.0, (2, count)), np.zeros((2, count)), np.ones((2, count))):
        measure = DotMeasure(("x",), values, 0.0, 1.0)
        scale = DotScale.fit(measure, room.width, room.height, 15.0)
        assert scale.bins.min() >= 0
        assert scale.bins.max() <= 23
        for row in scale.bins:
            tallest = np.bincount(row).max()
            highest = scale.middle(23, tallest - 1)[1] + scale.pitch / 2
            assert highest <= room.height + 1e-9
        for number in range(scale.abreast):
            across, _ = scale.middle(23, number)
            assert 23 / 24 * room.width < across < room.width


def test_touching_a_person_has_a_bin_of_its_own_and_ticks_lie_where_their_values_do():
    rollouts = a_comparison(rollouts=4).rollouts
    gaps = np.array([[0.0, 1e-9, 0.5, 1.0], [0.0, 0.0, 0.99, 0.25]])
    _, gap = dot_measures(dataclasses.replace(rollouts, clearance_m=gaps))
    bins = gap.bins()
    assert ((bins == 0) == (gaps == 0.0)).all()
    assert bins[0, 1] > 1  # apart from it
    for value, place in zip(gaps.ravel(), bins.ravel(), strict=True):
        assert place / 24 - 1e-9 <= gap.at(value) <= (place + 1) / 24 + 1e-9
    assert not any(start <= 1.5 / 24 <= end for start, end in gap.lines())


def test_dots_of_both_measures_are_of_one_size(comparison):
    crowded = np.tile([[0.3] * 25 + [1.0] * 25], (2, 1))
    shown = [
        DotMeasure(("x",), np.tile(np.linspace(0.0, 1.0, 50), (2, 1)), 0.0, 1.0),
        DotMeasure(("y",), crowded, 0.0, 1.0),
    ]
    first, second = DotScale.fit_all(shown, 300.0, 120.0, 15.0)
    assert first.pitch == second.pitch
    assert second.pitch == DotScale.fit(shown[1], 300.0, 120.0, 15.0).pitch
    assert len({plot.scale.pitch for plot in lay_out_comparison(comparison, SIZE).plots}) == 1
