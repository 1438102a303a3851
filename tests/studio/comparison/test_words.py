import pytest

from scenes import Pedestrian, Robot, Scene
from studio.comparison.words import contacts_in_detail, crowd_told, dots_told


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
