import math

import numpy as np
import pytest

from studio.scene.measures import Measure
from studio.scene.recording.distributions import bin_edges


@pytest.mark.parametrize(
    ("values", "width"),
    [([0.0, 1.0], 0.05), ([-3.2, 4.0], 0.2), ([2.0 + 1e-12, 0.5], 0.1), ([0.0, 0.0], 0.05)],
)
def test_bins_are_round_and_hold_every_outcome(values: list[float], width: float) -> None:
    edges = bin_edges(Measure("progress", "m", np.array(values)))
    counts, _ = np.histogram(values, edges)
    assert counts.sum() == len(values)
    np.testing.assert_allclose(np.diff(edges), width)
    assert math.isclose(edges[np.abs(edges).argmin()], 0.0, abs_tol=1e-9)


@pytest.mark.parametrize(("most", "last"), [(0.0, 2.5), (4.0, 4.5)])
def test_bins_of_collisions_reach_as_far_as_there_are_any(most: float, last: float) -> None:
    edges = bin_edges(Measure("collisions", "", np.array([0.0, most])))
    np.testing.assert_allclose(edges, np.arange(-0.5, last + 1.0), atol=1e-6)
