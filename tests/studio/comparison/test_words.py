import pytest

from scenes import Pedestrian, Robot, Scene
from studio.comparison.words import (
    contacts_in_detail,
    crowd_told,
    dots_told,
    outcomes_told,
    playing_told,
)
from tests.studio.comparison.made_up import a_comparison


def test_contacts_are_told_with_their_share_and_interval_and_people_apart_from_walls():
    longest, *_, briefest = contacts_in_detail(3, 1, 50)
    assert longest == "8 % [3, 19] · × 3 a person, □ 1 a wall"
    assert briefest == "8 % [3, 19]"
    assert contacts_in_detail(0, 2, 50)[0] == "4 % [1, 13] · □ 2 a wall"
    assert contacts_in_detail(0, 0, 50) == ["0 % [0, 7]"]
    assert contacts_in_detail(600, 0, 5000)[0] == "12 % [11.1, 12.9] · × 600 a person"


@pytest.mark.parametrize(
    ("starts", "told"),
    [
        ([], ""),
        ([(0.5, 0.5)], "1 person"),
        ([(0.5, 0.5), (0.1, 0.9)], "2 people"),
        ([(0.5, 0.5), (9.0, 0.0), (0.0, 9.0)], "3 people (1 in view, 2 not)"),
    ],
)
def test_people_in_view_and_out_of_it_are_counted(starts, told):
    people = tuple(Pedestrian(start, (5.0, 5.0)) for start in starts)
    scene = Scene("a-scene", Robot((0.0, 0.0), (5.0, 0.0)), people)
    assert crowd_told(scene, (0.0, 0.0, 1.0, 1.0)) == told


def test_a_dot_stands_for_one_outcome_unless_there_are_many():
    assert dots_told(50, 50) == "a dot: one outcome"
    assert dots_told(51, 50) == "50 dots: 51 outcomes"


def test_what_an_outcome_was_tells_its_side_and_metres_and_no_action():
    comparison = a_comparison(contact=((True, False, True, False, False), (False,) * 5))
    told = outcomes_told(comparison.rollouts, 0)
    gap, progress = comparison.rollouts.clearance_m[0, 2], comparison.rollouts.progress_m[0, 2]
    assert told[2].startswith(f"outcome 3 of A: gap {gap:.2f} m, progress {progress:.2f} m, aside ")
    assert [words.endswith(", touches a person") for words in told] == [True, False, True, 0, 0]
    assert outcomes_told(comparison.rollouts, 1)[0].startswith("outcome 1 of B: ")


def test_what_is_said_grows_with_the_outcomes_that_have_ended():
    comparison = a_comparison(rollouts=3, contact=((True, False, True), (False,) * 3))
    assert playing_told(comparison.rollouts, 0) == [
        "3 outcomes, one at a time",
        "Outcome 1 of 3",
        "Outcome 1 of 3 · 1 of 1 so far",
        "Outcome 2 of 3 · 1 of 1 so far",
        "Outcome 2 of 3 · 1 of 2 so far",
        "Outcome 3 of 3 · 1 of 2 so far",
        "Outcome 3 of 3 · 2 of 3 with contact",
    ]
