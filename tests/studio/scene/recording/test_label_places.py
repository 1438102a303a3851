from itertools import combinations

import numpy as np
import pytest

from studio.scene.recording.label_places import half_size, label_places, leader

BOUNDS = (-3.0, -4.0, 9.0, 4.0)


@pytest.mark.parametrize("spread", [0.0, 1.2], ids=["all one way", "a fan"])
def test_labels_neither_overlap_nor_leave_the_view(spread: float) -> None:
    labels = tuple(f"action {number}" for number in range(12))
    turns = np.linspace(-spread, spread, 12)[:, None, None]
    ahead = np.linspace(0.0, 4.0, 11)
    ways = np.stack(np.broadcast_arrays(ahead * np.cos(turns), ahead * np.sin(turns)), axis=-1)
    walls = np.array([[(-3.0, 2.0), (9.0, 2.0)]])
    places = label_places(labels, ways[:, 0, -1], ways, walls, BOUNDS)
    half = half_size(labels[0], BOUNDS)
    for one, other in combinations(places, 2):
        assert np.any(np.abs(one - other) >= 2.0 * half - 1e-9)
    low, high = np.array(BOUNDS).reshape(2, 2)
    assert np.all((places - half >= low) & (places + half <= high))


def test_a_label_is_nearest_to_the_end_of_its_own_way() -> None:
    labels = ("forward", "slow_down", "stop")
    ends = np.array([(4.0, 0.0), (2.5, 0.0), (0.5, 0.0)])  # each lies on the way to the first
    ways = np.linspace(0.0, 1.0, 11)[:, None] * ends[:, None, None]
    places = label_places(labels, ends, ways, np.empty((0, 2, 2)), BOUNDS)
    away = np.linalg.norm(places[:, None] - ends, axis=-1)
    assert away.argmin(axis=1).tolist() == [0, 1, 2]


@pytest.mark.parametrize("zoom", [1.0, 2.0])
@pytest.mark.parametrize("end", [(5.0, 0.0), (1.0, 3.0), (0.0, -2.0)])
def test_a_leader_meets_its_label_however_large_the_view_is(
    zoom: float, end: tuple[float, float]
) -> None:
    middle, half = np.array([1.0, 0.0]), np.array([0.5, 0.2])
    begin, met = leader(np.array(end), middle, half)
    assert tuple(begin) == end
    hanging = middle + half * [0.0, 1.0 - 1.0 / zoom]  # from the same top, in any view
    assert np.all(np.abs(met - hanging) <= half / zoom + 1e-9)
