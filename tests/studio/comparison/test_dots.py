import dataclasses

import numpy as np
import pytest

from studio.comparison.dots import BINS, DotMeasure, Dots, DotScale, dot_measures
from studio.comparison.picture.page import lay_out_comparison
from studio.painter.boxes import Box
from studio.painter.quantile_dots import MOST_DOTS
from studio.scene.measures import NOTHING, PERSON, WALL
from tests.studio.comparison.made_up import SIZE, a_comparison


def a_measure(values, low=0.0, high=1.0):
    """A measure of outcomes of two actions, none of which had contact."""
    nothing = np.full(len(values[0]), NOTHING)
    return DotMeasure(("x",), tuple(Dots.of(np.array(own), nothing) for own in values), low, high)


@pytest.mark.parametrize("count", [1, 7, 50, 200, 3000])
def test_dots_of_all_outcomes_find_room(count):
    room = Box(0.0, 0.0, 300.0, 120.0)
    rng = np.random.default_rng(0)
    for values in (rng.uniform(0.0, 1.0, (2, count)), np.zeros((2, count)), np.ones((2, count))):
        measure = a_measure(values)
        scale = DotScale.fit(measure, room.width, room.height, 15.0)
        for bins in scale.bins:
            assert len(bins) == min(count, MOST_DOTS)
            assert bins.min() >= 0
            assert bins.max() < BINS
            highest = scale.middle(0, int(np.bincount(bins).max()) - 1)[1] + scale.pitch / 2
            assert highest <= room.height + 1e-9
        for number in range(scale.abreast):
            across, _ = scale.middle(BINS - 1, number)
            assert (BINS - 1) / BINS * room.width < across < room.width


def test_every_outcome_has_a_dot_of_its_own_that_comes_when_it_ends():
    values, kinds = np.array([0.4, 0.1, 0.9, 0.1]), np.array([NOTHING, WALL, PERSON, NOTHING])
    dots = Dots.of(values, kinds)
    assert sorted(dots.arrivals.tolist()) == [1, 2, 3, 4]
    for value, kind, arrival in zip(dots.values, dots.kinds, dots.arrivals, strict=True):
        assert (value, kind) == (values[arrival - 1], kinds[arrival - 1])


def test_where_there_are_many_outcomes_dots_stand_for_equally_many_and_all_arrive():
    values, kinds = np.linspace(0.0, 1.0, 5000), np.full(5000, NOTHING)
    kinds[:1000] = PERSON
    dots = Dots.of(values, kinds)
    assert len(dots.values) == MOST_DOTS
    assert (dots.kinds == PERSON).sum() == MOST_DOTS // 5
    assert dots.arrivals.min() > 0
    assert dots.arrivals.max() <= 5000
    # half of the outcomes have come to their end when half of the dots are there
    assert (dots.arrivals <= 2500).sum() == pytest.approx(MOST_DOTS / 2, abs=1)


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


def test_it_is_shown_how_far_people_are_pushed_aside_unless_there_is_nobody():
    rollouts = a_comparison(rollouts=4).rollouts
    far = dataclasses.replace(rollouts, deviation_m=np.array([[0.0, 0.1, 0.2, 1.3], [0.0] * 4]))
    aside = dot_measures(far)[-1]
    assert "aside" in aside.names[0]
    assert sorted(aside.dots[0].values.tolist()) == [0.0, 0.1, 0.2, 1.3]
    assert aside.low == 0.0
    assert aside.high >= 1.3
    assert [measure.names[0] for measure in dot_measures(a_comparison(people=0).rollouts)] == [
        "progress towards the goal, m"
    ]


def test_dots_of_all_measures_are_of_one_size(comparison):
    crowded = np.tile([0.3] * 25 + [1.0] * 25, (2, 1))
    shown = [a_measure(np.tile(np.linspace(0.0, 1.0, 50), (2, 1))), a_measure(crowded)]
    first, second = DotScale.fit_all(shown, 300.0, 120.0, 15.0)
    assert first.pitch == second.pitch
    assert second.pitch == DotScale.fit(shown[1], 300.0, 120.0, 15.0).pitch
    assert len({plot.scale.pitch for plot in lay_out_comparison(comparison, SIZE).plots}) == 1


def test_contacts_lie_lowest_and_later_dots_higher():
    values, kinds = np.zeros(4), np.array([NOTHING, PERSON, NOTHING, WALL])
    measure = DotMeasure(("x",), (Dots.of(values, kinds),), 0.0, 1.0)
    scale = DotScale.fit(measure, 180.0, 400.0, 8.0)
    dots = measure.dots[0]
    heights = scale.middles(0, dots)[:, 1]
    in_order = [(dots.kinds[place], dots.arrivals[place]) for place in np.argsort(heights)]
    assert scale.abreast == 1
    assert in_order == [(PERSON, 2), (WALL, 4), (NOTHING, 1), (NOTHING, 3)]
