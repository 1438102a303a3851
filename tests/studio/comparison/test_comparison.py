from itertools import combinations

import numpy as np
import pytest

from scenes import META_ACTIONS, Pedestrian, Robot, Scene, simulate
from studio.comparison.comparison import Timetable, ended_after, side_by_side, words_of_pair
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


def test_what_is_shown_tells_no_action_unless_it_shall(rollouts):
    blind = side_by_side(rollouts, "forward", "stop")
    assert blind.shown.names == ("A", "B")
    assert blind.rollouts.names in (("forward", "stop"), ("stop", "forward"))
    named = side_by_side(rollouts, "forward", "stop", named=True)
    assert named.shown.names == named.rollouts.names
    for side, colour in zip("AB", SIDE_COLOURS, strict=True):
        assert blind.coloured(LIGHT).action_colour(side) == colour
    assert named.coloured(LIGHT).action_colour("stop") == LIGHT.of(rollouts.names).action_colour(
        "stop"
    )


def test_files_of_a_blind_comparison_tell_pairs_apart_and_no_action():
    assert words_of_pair("forward", "stop", named=True) == ("forward", "stop")
    names = [action.name for action in META_ACTIONS]
    pairs = list(combinations(names, 2))
    blind = {words_of_pair(*pair, named=False) for pair in pairs}
    assert len(blind) == len(pairs)
    assert not any(name in "-".join(words) for words in blind for name in names)
    assert words_of_pair("stop", "forward", named=False) in blind


@pytest.mark.parametrize("count", [1, 2, 3, 7, 50, 100, 300])
def test_the_first_three_play_slowly_and_the_others_fast(count):
    table = Timetable.of(count, 4.0)
    np.testing.assert_allclose(4.0 / table.moving[:3], 2.5)
    assert (table.moving <= table.lengths).all()
    assert (np.diff(table.starts) >= table.moving[:-1]).all()
    assert table.starts[0] == 1.0
    assert table.ends[-1] < table.over < 1.0 + 3 * 2.1 + 30.1
    if count == 50:
        assert table.lengths[3:] == pytest.approx(20.0 / 47)


@pytest.mark.parametrize("horizon", [0.1, 1.0, 60.0])
def test_no_outcome_is_too_fast_to_see_or_takes_for_ever(horizon):
    assert 0.8 <= Timetable.of(3, horizon).moving.min() <= 6.0


def test_all_outcomes_are_counted_once_their_sample_has_played(rollouts):
    assert ended_after(rollouts).tolist() == [0, 1, 2, 3]
    assert ended_after(rollouts.keep_paths(2)).tolist() == [0, 1, 3]


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
