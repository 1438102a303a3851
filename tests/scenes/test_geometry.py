"""Distances to segments."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from scenes.geometry import distance_to_segments, lengths, nearest_on_segments

coordinates = st.floats(-50, 50, allow_subnormal=False)
points = st.tuples(coordinates, coordinates)


def test_distance_to_a_segment_beside_it_and_beyond_its_ends() -> None:
    segment = np.array([[[0.0, 0.0], [4.0, 0.0]]])
    places = np.array([[2.0, 3.0], [-3.0, 4.0], [7.0, -4.0], [1.0, 0.0]])
    np.testing.assert_allclose(distance_to_segments(places, segment)[:, 0], [3.0, 5.0, 5.0, 0.0])


def test_no_segments_give_no_distances() -> None:
    assert distance_to_segments(np.zeros((3, 2)), np.empty((0, 2, 2))).shape == (3, 0)


@settings(deadline=None, derandomize=True)
@given(points, points, points, st.floats(0, 1))
def test_no_point_of_the_segment_is_nearer(
    place: tuple[float, float], start: tuple[float, float], end: tuple[float, float], share: float
) -> None:
    if np.hypot(end[0] - start[0], end[1] - start[1]) < 0.1:
        return
    segment = np.array([[start, end]])
    nearest = nearest_on_segments(np.array(place), segment)[0]
    other = np.array(start) + share * (np.array(end) - np.array(start))
    assert lengths(nearest - place) <= lengths(other - place) + 1e-9
    assert distance_to_segments(np.array(place), segment)[0] == lengths(nearest - place)
