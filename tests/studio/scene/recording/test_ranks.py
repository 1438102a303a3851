import numpy as np

from studio.scene.recording.ranks import discordant_pairs, ranks


def test_the_largest_value_ranks_first_and_of_equal_ones_the_earlier() -> None:
    assert ranks(np.array([0.1, 0.3, 0.1, -2.0])).tolist() == [1, 0, 2, 3]


def test_discordant_pairs_are_those_that_are_preferred_the_other_way_round() -> None:
    one, other = np.array([3.0, 2.0, 1.0]), np.array([1.0, 2.0, 1.5])
    assert discordant_pairs(one, other) == [(0, 1), (0, 2)]
    assert discordant_pairs(other, one) == [(1, 0), (2, 0)]
    assert discordant_pairs(one, one) == []


def test_a_tie_contradicts_nobody() -> None:
    assert discordant_pairs(np.array([1.0, 1.0]), np.array([0.0, 1.0])) == []
