import dataclasses

import numpy as np
import pytest

from studio.comparison.dots import BINS, DotMeasure, Dots, DotScale, dot_measures
from studio.comparison.picture.page import lay_out_comparison
from studio.painter.boxes import Box
from studio.scene.measures import NOTHING, PERSON, WALL
from tests.studio.comparison.made_up import SIZE, a_comparison


def measure_of(values, low=0.0, high=1.0):
    kinds = np.full(values.shape[1], NOTHING)
    return DotMeasure(("x",), tuple(Dots.of(own, kinds) for own in values), low, high)


@pytest.mark.parametrize("count", [1, 7, 50, 200, 3000])
def test_dots_of_every_outcome_find_room(count):
    room = Box(0.0, 0.0, 300.0, 120.0)
    rng = np.random.default_rng(0)
    for values in (rng.uniform(0.0, 1.0, (2, count)), np.zeros((2, count)), np.ones((2, count))):
        measure = measure_of(values)
        scale = DotScale.fit(measure, room.width, room.height, 15.0)
        for side, row in enumerate(scale.bins):
            assert 0 <= row.min() <= row.max() < BINS
            tallest = np.bincount(row).max()
            highest = scale.middle(BINS - 1, tallest - 1)[1] + scale.pitch / 2
            assert highest <= room.height + 1e-9
            middles = scale.middles(side, measure.dots[side])
            assert len(np.unique(middles.round(6), axis=0)) == len(row)
        for number in range(scale.abreast):
            across, _ = scale.middle(BINS - 1, number)
            assert (BINS - 1) / BINS * room.width < across < room.width


def test_a_dot_stands_for_one_outcome_and_comes_with_it():
    values, kinds = np.array([0.3, 0.1, 0.2, 0.4]), np.array([NOTHING, PERSON, NOTHING, WALL])
    dots = Dots.of(values, kinds)
    assert dots.kinds.tolist() == [PERSON, WALL, NOTHING, NOTHING]
    assert dots.values.tolist() == [0.1, 0.4, 0.2, 0.3]
    assert dots.arrivals.tolist() == [2, 4, 3, 1]


def test_fifty_dots_stand_for_many_outcomes_kind_by_kind_and_all_come():
    rng = np.random.default_rng(1)
    kinds = np.where(np.arange(1000) % 10 == 0, PERSON, NOTHING)
    values = np.where(kinds == PERSON, 0.0, rng.uniform(1.0, 2.0, 1000))
    dots = Dots.of(values, kinds)
    assert len(dots.values) == 50
    assert (dots.kinds == PERSON).sum() == 5
    assert ((dots.values == 0.0) == (dots.kinds == PERSON)).all()
    assert 1 <= dots.arrivals.min() <= dots.arrivals.max() <= 1000
    assert np.abs(np.sort(dots.arrivals) - 20 * np.arange(50)).max() < 300  # come all along


def test_contacts_lie_lowest_and_later_dots_higher():
    values, kinds = np.zeros(4), np.array([NOTHING, PERSON, NOTHING, WALL])
    measure = DotMeasure(("x",), (Dots.of(values, kinds),), 0.0, 1.0)
    scale = DotScale.fit(measure, 180.0, 400.0, 8.0)
    dots = measure.dots[0]
    heights = scale.middles(0, dots)[:, 1]
    in_order = [(dots.kinds[place], dots.arrivals[place]) for place in np.argsort(heights)]
    assert scale.abreast == 1
    assert in_order == [(PERSON, 2), (WALL, 4), (NOTHING, 1), (NOTHING, 3)]


def test_touching_a_person_has_a_bin_of_its_own_and_ticks_lie_where_their_values_do():
    rollouts = a_comparison(rollouts=4).rollouts
    gaps = np.array([[0.0, 1e-9, 0.5, 1.0], [0.0, 0.0, 0.99, 0.25]])
    _, gap, _ = dot_measures(dataclasses.replace(rollouts, clearance_m=gaps))
    bins = gap.bins(gaps)
    assert ((bins == 0) == (gaps == 0.0)).all()
    assert bins[0, 1] > 1  # apart from it
    for value, place in zip(gaps.ravel(), bins.ravel(), strict=True):
        assert place / BINS - 1e-9 <= gap.at(value) <= (place + 1) / BINS + 1e-9
    assert not any(start <= 1.5 / BINS <= end for start, end in gap.lines())


def test_how_far_people_are_pushed_aside_is_shown_where_there_are_people():
    comparison = a_comparison(rollouts=3)
    *_, aside = dot_measures(comparison.rollouts)
    for side, dots in enumerate(aside.dots):
        own = np.sort(comparison.rollouts.deviation_m[side])
        np.testing.assert_allclose(np.sort(dots.values), own)
    assert len(dot_measures(a_comparison(people=0).rollouts)) == 1


def test_dots_of_all_measures_are_of_one_size(comparison):
    crowded = np.tile([[0.3] * 25 + [1.0] * 25], (2, 1))
    shown = [measure_of(np.tile(np.linspace(0.0, 1.0, 50), (2, 1))), measure_of(crowded)]
    first, second = DotScale.fit_all(shown, 300.0, 120.0, 15.0)
    assert first.pitch == second.pitch
    assert second.pitch == DotScale.fit(shown[1], 300.0, 120.0, 15.0).pitch
    assert len({plot.scale.pitch for plot in lay_out_comparison(comparison, SIZE).plots}) == 1
