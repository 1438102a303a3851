import itertools

import numpy as np
import pytest

from scenes import META_ACTIONS, Pedestrian, Robot, Scene, simulate
from studio.comparison.comparison import side_by_side, words_of_pair
from studio.errors import InputError
from studio.style.palette import LIGHT, SIDE_COLOURS


@pytest.fixture(scope="module")
def rollouts():
    person = Pedestrian(start=(3.0, 0.2), goal=(-9.0, 0.2))
    scene = Scene("a-scene", Robot(start=(0.0, 0.0), goal=(8.0, 0.0)), (person,))
    return simulate(scene, rollouts=3, horizon=0.5)


@pytest.mark.parametrize("seed", range(8))
def test_sides_do_not_depend_on_which_action_is_named_first(rollouts, seed):
    one = side_by_side(rollouts, "forward", "stop", seed)
    other = side_by_side(rollouts, "stop", "forward", seed)
    assert one.rollouts.actions == other.rollouts.actions
    assert {one.left.name, one.right.name} == {"forward", "stop"}


def test_sides_are_random_over_seeds_and_over_pairs(rollouts):
    over_seeds = [side_by_side(rollouts, "forward", "stop", seed).left.name for seed in range(200)]
    assert 70 < over_seeds.count("stop") < 130
    first, *others = (action.name for action in META_ACTIONS)
    assert len({side_by_side(rollouts, first, other).left.name == first for other in others}) == 2


def test_a_comparison_keeps_the_numbers_of_its_actions_and_the_names_of_all(rollouts):
    comparison = side_by_side(rollouts, "forward", "turn_left", seed=3)
    names = [action.name for action in META_ACTIONS]
    for side, action in enumerate((comparison.left, comparison.right)):
        index = names.index(action.name)
        np.testing.assert_array_equal(comparison.rollouts.robot[side], rollouts.robot[index])
    assert comparison.actions == tuple(names)
    assert comparison.seed == 3


def test_a_comparison_is_blind_unless_names_are_asked_for(rollouts):
    blind = side_by_side(rollouts, "forward", "stop")
    assert blind.shown.names == ("A", "B")
    np.testing.assert_array_equal(blind.shown.robot, blind.rollouts.robot)
    named = side_by_side(rollouts, "forward", "stop", named=True)
    assert named.shown.names == named.rollouts.names
    assert {*named.rollouts.names} == {"forward", "stop"}


def test_colours_of_a_blind_comparison_are_the_same_whichever_actions_it_is_of(rollouts):
    pairs = list(itertools.combinations((action.name for action in META_ACTIONS), 2))
    found = {
        tuple(comparison.coloured(LIGHT).action_colour(name) for name in comparison.shown.names)
        for comparison in (side_by_side(rollouts, *pair) for pair in pairs)
    }
    assert found == {SIDE_COLOURS}


def test_names_of_files_tell_no_action_of_a_blind_comparison_but_which_pair_it_is():
    names = [action.name for action in META_ACTIONS]
    pairs = list(itertools.combinations(names, 2))
    found = {words_of_pair(*pair, named=False) for pair in pairs}
    assert len(found) == len(pairs)
    for words in found:
        assert not any(name in word for word in words for name in names)
    for one, other in pairs:
        assert words_of_pair(one, other, False) == words_of_pair(other, one, False)
        assert words_of_pair(one, other, True) == (one, other)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("forward", "fly"), "action: 'fly' is not there: forward, slow_down"),
        (("forward", "forward"), "'forward' twice: two different ones are needed"),
        (("forward", "stop", -1), "seed: -1 is not allowed: 0 to"),
    ],
)
def test_what_cannot_be_compared_is_refused_in_one_line(rollouts, arguments, message):
    with pytest.raises(InputError, match=message) as error:
        side_by_side(rollouts, *arguments)
    assert "\n" not in str(error.value)
