"""One palette for recordings, pictures and films.

The seven action colours are told apart with every common form of colour blindness (they build on
Okabe and Ito, "Color universal design", 2008). They, and those of teachers and learners, stand out
from both a white and a near-black ground. Vermilion red is kept for contact and used for nothing
else; people are grey.
"""

from collections.abc import Iterable
from dataclasses import dataclass, replace

Colour = tuple[int, int, int]
"""Red, green, blue, each 0 to 255."""

ACTION_COLOURS: tuple[Colour, ...] = (
    (0, 114, 178),  # blue
    (86, 180, 233),  # sky blue
    (140, 140, 140),  # grey
    (0, 158, 115),  # bluish green
    (230, 159, 0),  # orange
    (170, 68, 153),  # purple
    (136, 103, 53),  # brown
)
"""Colour of each action, in the order of a scene's actions; an eighth action begins anew."""

TEACHER_COLOURS: dict[str, Colour] = {
    "eu": (112, 112, 112),
    "tk": (88, 76, 196),
    "strong": (204, 102, 119),
}

LEARNER_COLOURS: dict[str, Colour] = {
    "eu": (221, 139, 0),  # amber
    "cpt": (0, 134, 120),  # teal
    "cpt-tied": (64, 146, 222),  # azure
    "cpt-reference": (122, 74, 160),  # violet
    "cpt-tied-reference": (190, 80, 160),  # magenta
}

SLATE: Colour = (84, 110, 135)  # of all teachers that a user adds

OTHER_LEARNERS: tuple[Colour, ...] = (
    (121, 133, 30),  # olive
    (136, 103, 53),  # brown
    SLATE,
    (0, 118, 158),  # cerulean
)
"""Colours of learners that a user adds; a learner's name decides which of them it has."""


@dataclass(frozen=True)
class Theme:
    """The ground that things are drawn on, and the colours that depend on it.

    Actions have their colours by their order in the scene, even where only some of them are drawn.
    """

    ground: Colour  # of the page
    panel: Colour  # of a plot on the page
    grid: Colour
    faint: Colour  # of minor text and axes
    ink: Colour  # of text
    wall: Colour
    pedestrian: Colour
    contact: Colour  # of touching a pedestrian or a wall, and of nothing else
    actions: tuple[str, ...] = ()  # names of all actions of the scene, in their order

    def of(self, actions: Iterable[str]) -> "Theme":
        """The theme with a colour for each action of these names; itself if it has them already."""
        names = tuple(actions)
        return self if set(names) <= set(self.actions) else replace(self, actions=names)

    def action_colour(self, name: str) -> Colour:
        """The colour of the action of this name."""
        return ACTION_COLOURS[self.actions.index(name) % len(ACTION_COLOURS)]

    def legible(self, colour: Colour) -> Colour:
        """The colour, shifted towards that of text until small type in it can be read.

        That takes a contrast of 4.5 to 1 with the ground ("Web Content Accessibility Guidelines").
        """
        while contrast(colour, self.ground) < 4.5:
            darkened = blend(colour, self.ink, 0.95)
            colour = darkened if darkened != colour else self.ink
        return colour

    def ink_on(self, colour: Colour) -> Colour:
        """The colour of the ground or of text, whichever is read more easily on this colour."""
        return max(self.ground, self.ink, key=lambda ink: contrast(ink, colour))


LIGHT = Theme(
    ground=(255, 255, 255),
    panel=(249, 249, 250),
    grid=(230, 231, 234),
    faint=(112, 116, 122),
    ink=(32, 35, 40),
    wall=(62, 66, 72),
    pedestrian=(120, 124, 130),
    contact=(213, 43, 30),
)

DARK = Theme(
    ground=(18, 20, 24),
    panel=(25, 28, 33),
    grid=(45, 49, 56),
    faint=(150, 155, 163),
    ink=(234, 236, 240),
    wall=(176, 181, 189),
    pedestrian=(138, 143, 151),
    contact=(240, 72, 56),
)

THEMES = {"light": LIGHT, "dark": DARK}


def teacher_colour(name: str) -> Colour:
    """The colour of a teacher; teachers without one of their own share a quiet one."""
    return TEACHER_COLOURS.get(name, SLATE)


def learner_colour(name: str) -> Colour:
    """The colour of a learner, which depends on nothing but its name."""
    if name in LEARNER_COLOURS:
        return LEARNER_COLOURS[name]
    return OTHER_LEARNERS[sum(name.encode()) % len(OTHER_LEARNERS)]


def blend(colour: Colour, ground: Colour, opacity: float) -> Colour:
    """A colour as it looks on the ground if it is only as opaque as this, 0 to 1."""
    red, green, blue = (
        round(opacity * over + (1.0 - opacity) * under)
        for over, under in zip(colour, ground, strict=True)
    )
    return red, green, blue


def contrast(one: Colour, other: Colour) -> float:
    """Contrast of two colours, 1 (none) to 21 ("Web Content Accessibility Guidelines" 2)."""
    low, high = sorted((_luminance(one), _luminance(other)))
    return (high + 0.05) / (low + 0.05)


def _luminance(colour: Colour) -> float:
    """Relative luminance, 0 to 1."""
    red, green, blue = (
        share / 12.92 if share <= 0.04045 else ((share + 0.055) / 1.055) ** 2.4
        for share in (channel / 255.0 for channel in colour)
    )
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue
