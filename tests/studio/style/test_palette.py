from itertools import combinations, product

import numpy as np
import pytest

from studio.style.palette import (
    ACTION_COLOURS,
    LEARNER_PENS,
    LIGHT,
    OTHER_LEARNERS,
    OTHER_TEACHERS,
    SIDE_COLOURS,
    TEACHER_PENS,
    THEMES,
    Colour,
    Pen,
    Theme,
    contrast,
    learner_colour,
    learner_pen,
    teacher_colour,
    teacher_pen,
)
from tests.studio.style.colour_vision import VISIONS, ciede2000, difference_seen, seen

TEACHERS = (*TEACHER_PENS.values(), *OTHER_TEACHERS)
LEARNERS = (*LEARNER_PENS.values(), *OTHER_LEARNERS)
NAMED = (*ACTION_COLOURS, *SIDE_COLOURS, *(pen.colour for pen in (*TEACHERS, *LEARNERS)))

TOLD_APART = 15.0
"""Least difference of two colours that a picture tells apart.

It is CIEDE2000, since the plainer distance in L*a*b* (CIE76) overrates what strong colours differ
by, and dichromats are left with little but strong blues and yellows.
"""


@pytest.mark.parametrize("theme", THEMES.values(), ids=THEMES)
def test_every_colour_can_be_made_text_that_is_read_on_its_ground(theme: Theme):
    for colour in (*NAMED, theme.contact):
        assert contrast(theme.legible(colour), theme.ground) >= 4.5
    assert theme.legible(theme.ink) == theme.ink


@pytest.mark.parametrize("theme", THEMES.values(), ids=THEMES)
def test_every_colour_stands_out_from_its_ground(theme: Theme):
    for colour in (*NAMED, theme.contact, theme.wall, theme.pedestrian):
        assert contrast(colour, theme.panel) >= 2.1


def assert_told_apart(pairs: list[tuple[Colour, Colour]]) -> None:
    """Make sure that the two colours of every pair look different to everybody."""
    for vision, (one, other) in product(VISIONS, pairs):
        assert difference_seen(one, other, vision) >= TOLD_APART, (vision, one, other)


@pytest.mark.parametrize("theme", THEMES.values(), ids=THEMES)
def test_everybody_tells_actions_people_walls_and_contact_apart(theme: Theme):
    drawn = (*ACTION_COLOURS, theme.pedestrian, theme.wall, theme.contact)
    assert_told_apart(list(combinations(drawn, 2)))


@pytest.mark.parametrize("pens", [TEACHERS, LEARNERS], ids=["teachers", "learners"])
def test_everybody_tells_pens_apart_by_colour_and_by_shape(pens: tuple[Pen, ...]):
    assert_told_apart([(one.colour, other.colour) for one, other in combinations(pens, 2)])
    for one, other in combinations(pens, 2):
        assert one.dashes != other.dashes or (one.marker, one.filled) != (
            other.marker,
            other.filled,
        )


def test_pens_that_have_names_differ_in_dashes_and_in_markers():
    for named in (TEACHER_PENS, LEARNER_PENS):
        assert len({pen.dashes for pen in named.values()}) == len(named)
        assert len({pen.marker for pen in named.values()}) == len(named)


@pytest.mark.parametrize("theme", THEMES.values(), ids=THEMES)
def test_everybody_tells_the_sides_of_a_comparison_apart_and_from_all_around(theme: Theme):
    around = (theme.pedestrian, theme.wall, theme.contact)
    assert_told_apart([SIDE_COLOURS, *product(SIDE_COLOURS, around)])


def test_a_pen_depends_on_nothing_but_the_name():
    assert teacher_pen("tk") == TEACHER_PENS["tk"]
    assert teacher_colour("tk") == TEACHER_PENS["tk"].colour
    assert learner_colour("cpt") == LEARNER_PENS["cpt"].colour
    assert teacher_pen("cautious") in OTHER_TEACHERS
    assert learner_pen("mine") in OTHER_LEARNERS


@pytest.mark.parametrize(
    ("one", "other", "expected"),
    [  # pairs 1, 7, 9, 17, 24 and 25 of the table of Sharma, Wu and Dalal
        ((50.0, 2.6772, -79.7751), (50.0, 0.0, -82.7485), 2.0425),
        ((50.0, 0.0, 0.0), (50.0, -1.0, 2.0), 2.3669),
        ((50.0, 2.49, -0.001), (50.0, -2.49, 0.0009), 7.1792),
        ((50.0, 2.5, 0.0), (73.0, 25.0, -18.0), 27.1492),
        ((50.0, 2.5, 0.0), (50.0, 3.2592, 0.3350), 1.0),
        ((60.2574, -34.0099, 36.2677), (60.4626, -34.1751, 39.4387), 1.2644),
    ],
)
def test_differences_of_colours_are_those_of_the_published_table(one, other, expected):
    assert ciede2000(np.array(one), np.array(other)) == pytest.approx(expected, abs=1e-4)
    assert ciede2000(np.array(other), np.array(one)) == pytest.approx(expected, abs=1e-4)


def test_grey_looks_alike_to_everybody_and_red_and_green_do_not():
    for vision in VISIONS:
        assert np.abs(seen((120, 120, 120), vision) - seen((120, 120, 120), "normal")).max() < 0.1
    reds = (200, 60, 40), (110, 110, 30)
    assert difference_seen(*reds, "deutan") < 10.0 < 40.0 < difference_seen(*reds, "normal")


def test_an_action_has_its_colour_whichever_others_are_shown():
    whole = LIGHT.of(["forward", "stop", "turn_left"])
    assert whole.of(["turn_left"]).action_colour("turn_left") == ACTION_COLOURS[2]
    assert LIGHT.of(["turn_left"]).action_colour("turn_left") == ACTION_COLOURS[0]


@pytest.mark.parametrize("theme", THEMES.values(), ids=THEMES)
def test_ink_on_a_colour_is_read_more_easily_than_the_other_ink(theme: Theme):
    assert theme.ink_on(theme.ground) == theme.ink
    assert theme.ink_on(theme.ink) == theme.ground


def test_contrast_is_that_of_the_guidelines():
    assert contrast((0, 0, 0), (255, 255, 255)) == pytest.approx(21.0)
    assert contrast((119, 119, 119), (255, 255, 255)) == pytest.approx(4.48, abs=0.01)
