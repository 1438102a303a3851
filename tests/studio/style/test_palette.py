import pytest

from studio.style.palette import (
    ACTION_COLOURS,
    LEARNER_COLOURS,
    LIGHT,
    OTHER_LEARNERS,
    TEACHER_COLOURS,
    THEMES,
    Theme,
    contrast,
)


@pytest.mark.parametrize("theme", THEMES.values(), ids=THEMES)
def test_every_colour_can_be_made_text_that_is_read_on_its_ground(theme: Theme):
    given = [*ACTION_COLOURS, *TEACHER_COLOURS.values(), *LEARNER_COLOURS.values(), theme.contact]
    for colour in given:
        assert contrast(theme.legible(colour), theme.ground) >= 4.5
    assert theme.legible(theme.ink) == theme.ink


@pytest.mark.parametrize("theme", THEMES.values(), ids=THEMES)
def test_every_colour_stands_out_from_its_ground(theme: Theme):
    named = [*ACTION_COLOURS, *TEACHER_COLOURS.values(), *LEARNER_COLOURS.values()]
    for colour in (*named, *OTHER_LEARNERS, theme.contact, theme.wall, theme.pedestrian):
        assert contrast(colour, theme.panel) >= 2.1


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
