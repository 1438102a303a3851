import numpy as np
import pytest

from scenes import META_ACTIONS, Pedestrian, Robot, Scene, simulate
from studio.comparison.comparison import side_by_side
from studio.errors import InputError


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
