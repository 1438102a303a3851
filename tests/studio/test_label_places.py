from itertools import combinations

import numpy as np
import pytest

from studio.recorder.label_places import half_size, label_places, leader

BOUNDS = (-3.0, -4.0, 9.0, 4.0)


@pytest.mark.parametrize("spread", [0.0, 1.2], ids=["all one way", "a fan"])
def test_labels_neither_overlap_nor_leave_the_view(spread: float) -> None:
    labels = tuple(f"action {number}" for number in range(12))
    turns = np.linspace(-spread, spread, 12)[:, None, None]
    ahead = np.linspace(0.0, 4.0, 11)
    ways = np.stack(np.broadcast_arrays(ahead * np.cos(turns), ahead * np.sin(turns)), axis=-1)
    walls = np.array([[(-3.0, 2.0), (9.0, 2.0)]])
    places = label_places(labels, ways, walls, BOUNDS)
    half = half_size(labels[0], BOUNDS)
    for one, other in combinations(places, 2):
        assert np.any(np.abs(one - other) >= 2.0 * half - 1e-9)
    low, high = np.array(BOUNDS).reshape(2, 2)
    assert np.all((places - half >= low) & (places + half <= high))


def test_a_leader_ends_at_the_edge_of_its_label() -> None:
    line = leader(np.array([5.0, 0.0]), np.array([1.0, 0.0]), np.array([0.5, 0.2]))
    assert line.tolist() == [[5.0, 0.0], [1.5, 0.0]]
