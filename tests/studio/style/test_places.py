import math

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from studio.style.places import choose_places, places_around, spread_apart

HALF = np.array([3.0, 1.0])


@given(st.lists(st.floats(0.0, 100.0), min_size=1, max_size=8).map(sorted))
def test_heights_are_spread_apart_within_their_limits(heights):
    spread = spread_apart(heights, 10.0, 5.0, 95.0)
    assert min(spread) >= 5.0 - 1e-9
    assert max(spread) <= 95.0 + 1e-9
    assert (np.diff(spread) >= 10.0 - 1e-9).all()


def test_places_around_a_point_touch_an_oval_around_it():
    angles = np.linspace(0.0, math.tau, 8, endpoint=False)
    places = places_around(np.array([1.0, 2.0]), HALF, np.array([0.0, 2.0]), angles)
    assert places.shape == (16, 2)
    np.testing.assert_allclose(places[[0, 8]], [(4.0, 2.0), (6.0, 2.0)])
    np.testing.assert_allclose(places[10], (1.0, 5.0))


def test_boxes_take_their_cheapest_place_that_is_free():
    middles = [np.array([(0.0, 0.0), (10.0, 0.0)])] * 3
    costs = [np.array([0.0, 1.0])] * 3
    chosen = choose_places(middles, [HALF] * 3, costs)
    np.testing.assert_array_equal(chosen, [(0.0, 0.0), (10.0, 0.0), (np.nan, np.nan)])


def test_boxes_may_overlap_at_a_cost_and_choose_anew_when_they_know_the_others():
    middles = [np.array([(0.0, 0.0), (10.0, 0.0)]), np.array([(0.0, 0.0)])]
    costs = [np.array([0.0, 1.0]), np.array([0.0])]
    once = choose_places(middles, [HALF] * 2, costs, cost_of_overlap=5.0)
    twice = choose_places(middles, [HALF] * 2, costs, cost_of_overlap=5.0, rounds=2)
    np.testing.assert_array_equal(once, [(0.0, 0.0), (0.0, 0.0)])
    np.testing.assert_array_equal(twice, [(10.0, 0.0), (0.0, 0.0)])
