import dataclasses

import numpy as np

from scenes import FEATURES
from studio.comparison.telling import telling_outcomes
from tests.studio.comparison.made_up import a_comparison


def with_progress(progress):
    """Rollouts of two actions that differ in nothing but this progress [2, K], without a unit."""
    rollouts = a_comparison(rollouts=len(progress[0])).rollouts
    features = np.zeros((*np.shape(progress), len(FEATURES)))
    features[..., FEATURES.index("progress")] = progress
    return dataclasses.replace(rollouts, features=features)


def test_the_worst_and_the_typical_outcome_of_each_side_are_found():
    told = telling_outcomes(with_progress([[0.3, 0.1, 0.2, 0.9, 0.4], [0.5, 0.4, 0.3, 0.2, 0.1]]))
    assert [(each.name, each.places) for each in told] == [("worst", (1, 4)), ("typical", (0, 2))]


def test_they_are_among_those_whose_paths_are_kept():
    rollouts = with_progress([[0.3, 0.4, 0.2, 0.1], [0.1, 0.2, 0.3, 0.0]])
    told = telling_outcomes(rollouts.keep_paths(3))
    assert [each.places for each in told] == [(2, 0), (0, 1)]


def test_a_single_outcome_stands_for_nothing():
    assert telling_outcomes(with_progress([[0.3], [0.1]])) == ()
