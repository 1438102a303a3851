import pytest

from scenes import Pedestrian, Robot, Scene
from studio.comparison.words import (
    contacts_in_detail,
    crowd_told,
    dots_told,
    outcomes_told,
    playing_told,
)
from studio.style.words import counted
from tests.studio.comparison.made_up import a_comparison


def test_contacts_come_with_their_interval_and_people_and_walls_apart():
    assert contacts_in_detail(9, 3, 50)[0] == "24 % [14, 37] · × 9 a person, □ 3 a wall"
    assert contacts_in_detail(9, 0, 50) == [
        "18 % [10, 31] · × 9 a person",
        "18 % [10, 31] · × 9",
        "18 % [10, 31]",
    ]
    assert contacts_in_detail(0, 0, 50) == ["0 % [0, 7]"]


@pytest.mark.parametrize(
    ("people", "told"),
    [(0, ""), (1, "1 person"), (2, "2 people"), (5, "5 people (3 in view, 2 not)")],
)
def test_people_are_counted_who_are_in_view_and_who_are_not(people, told):
    crowd = tuple(Pedestrian((4.0 * place, 0.0), (0.0, -9.0)) for place in range(people))
    scene = Scene("a-scene", Robot((-1.0, 0.0), (9.0, 0.0)), crowd)
    assert crowd_told(scene, (-2.0, -2.0, 10.0, 2.0)) == told


def test_it_is_told_how_many_outcomes_a_dot_stands_for():
    assert dots_told(50, 50) == "a dot: one outcome"
    assert dots_told(5000, 50) == f"50 dots: {counted(5000, 'outcome')}"


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
