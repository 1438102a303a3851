import numpy as np

from studio.comparison.telling import telling_outcomes
from studio.scene.judgements import utilities
from tests.studio.comparison.made_up import a_comparison


def test_the_worst_and_the_typical_outcome_of_each_side_are_those_by_utility():
    rollouts = a_comparison(rollouts=9).rollouts
    worst, typical = telling_outcomes(rollouts)
    assert (worst.name, typical.name) == ("worst", "typical")
    worths = utilities(rollouts)
    for side in range(2):
        assert worths[side, worst.places[side]] == worths[side].min()
        assert worths[side, typical.places[side]] == np.median(worths[side])


def test_only_outcomes_with_paths_are_told_and_a_single_one_is_not():
    rollouts = a_comparison(rollouts=40, paths=3).rollouts
    assert all(place < 3 for each in telling_outcomes(rollouts) for place in each.places)
    assert telling_outcomes(a_comparison(rollouts=1).rollouts) == ()
