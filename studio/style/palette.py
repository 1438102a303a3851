"""One palette for recordings, pictures and films.

Whatever must be told apart in one picture differs by 15 or more in CIEDE2000, to normal sight and
as protanopes, deuteranopes and tritanopes see it (simulated by Machado, Oliveira and Fernandes,
"A physiologically-based model for simulation of color vision deficiency", 2009): actions, people,
walls and contact, in both themes; teachers among one another; learners among one another; the two
sides of a comparison. A search found the colours: it began with those of Okabe and Ito ("Color
universal design", 2008) and moved them as little as that takes. All stand out from both a white
and a near-black ground. Colour is never the only cue all the same: contact is a cross, walls are
lines, and teachers and learners have pens with dashes and a marker of their own.

Vermilion red is kept for contact and used for nothing else; people are grey.
"""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Literal

Colour = tuple[int, int, int]
"""Red, green, blue, each 0 to 255."""

Marker = Literal[
    "circle", "square", "triangle", "diamond", "triangle_down", "plus", "pentagon", "star"
]
"""The shape of a curve's points; a cross (×) is not among them, since it says contact."""

ACTION_COLOURS: tuple[Colour, ...] = (
    (23, 108, 253),  # blue
    (81, 183, 240),  # sky blue
    (99, 58, 151),  # indigo
    (9, 153, 96),  # green
    (233, 160, 1),  # orange
    (165, 97, 150),  # mauve
    (123, 62, 56),  # brown
)
"""Colour of each action, in the order of a scene's actions; an eighth action begins anew."""

SIDE_COLOURS: tuple[Colour, Colour] = ((0, 110, 150), (233, 160, 1))
"""Colours of A and B where two actions are compared without their names."""


@dataclass(frozen=True)
class Pen:
    """How the curve of a teacher or a learner is drawn: three cues, any two of which may go."""

    colour: Colour
    dashes: tuple[float, ...]  # lengths of dashes and gaps, in widths of the line; empty: solid
    marker: Marker
    filled: bool = True  # the inside of a marker; where not, it has the colour of the ground


TEACHER_PENS: dict[str, Pen] = {
    "eu": Pen((99, 100, 102), (), "circle"),  # grey
    "tk": Pen((88, 75, 194), (6.0, 2.0), "square"),  # indigo
    "strong": Pen((222, 118, 132), (2.0, 1.5), "triangle"),  # rose
}

LEARNER_PENS: dict[str, Pen] = {
    "eu": Pen((225, 143, 3), (3.0, 1.5), "square", filled=False),  # amber
    "cpt": Pen((33, 137, 114), (), "circle"),  # teal
    "cpt-tied": Pen((63, 156, 255), (6.0, 1.4, 1.2, 1.4), "triangle"),  # azure
    "cpt-reference": Pen((126, 54, 248), (1.2, 1.2), "diamond", filled=False),  # violet
    "cpt-tied-reference": Pen((175, 118, 167), (8.0, 2.0), "triangle_down", filled=False),  # mauve
}

OTHER_TEACHERS: tuple[Pen, ...] = (
    Pen((118, 127, 185), (6.0, 1.4, 1.2, 1.4), "diamond"),  # periwinkle
    Pen((39, 134, 82), (8.0, 2.0), "triangle_down"),  # fern
    Pen((195, 169, 74), (1.2, 1.2), "pentagon"),  # sand
)
"""Pens of teachers that a user adds; a teacher's name decides which of them it has."""

OTHER_LEARNERS: tuple[Pen, ...] = (
    Pen((113, 116, 0), (4.0, 1.2, 1.2, 1.2, 1.2, 1.2), "plus"),  # olive
    Pen((110, 80, 59), (2.0, 2.5), "pentagon"),  # brown
    Pen((76, 80, 86), (8.0, 2.0, 1.2, 2.0), "star"),  # slate
    Pen((0, 85, 134), (5.0, 3.0), "pentagon", filled=False),  # cerulean
)
"""Pens of learners that a user adds; a learner's name decides which of them it has."""


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
    action_colours: tuple[Colour, ...] = ACTION_COLOURS  # of these actions, in the same order

    def of(self, actions: Iterable[str]) -> "Theme":
        """The theme with a colour for each action of these names; itself if it has them already."""
        names = tuple(actions)
        return self if set(names) <= set(self.actions) else replace(self, actions=names)

    def of_sides(self, sides: tuple[str, str]) -> "Theme":
        """The theme with a colour for each of two actions that are told by their sides alone."""
        return replace(self, actions=sides, action_colours=SIDE_COLOURS)

    def action_colour(self, name: str) -> Colour:
        """The colour of the action of this name."""
        return self.action_colours[self.actions.index(name) % len(self.action_colours)]

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
    wall=(42, 45, 50),
    pedestrian=(156, 157, 159),
    contact=(219, 44, 24),
)

DARK = Theme(
    ground=(18, 20, 24),
    panel=(25, 28, 33),
    grid=(45, 49, 56),
    faint=(150, 155, 163),
    ink=(234, 236, 240),
    wall=(205, 210, 216),
    pedestrian=(153, 155, 155),
    contact=(228, 52, 33),
)

THEMES = {"light": LIGHT, "dark": DARK}


def teacher_pen(name: str) -> Pen:
    """How a teacher's curve is drawn, which depends on nothing but the teacher's name."""
    return _pen(name, TEACHER_PENS, OTHER_TEACHERS)


def learner_pen(name: str) -> Pen:
    """How a learner's curve is drawn, which depends on nothing but the learner's name."""
    return _pen(name, LEARNER_PENS, OTHER_LEARNERS)


def teacher_colour(name: str) -> Colour:
    """The colour of a teacher's pen."""
    return teacher_pen(name).colour


def learner_colour(name: str) -> Colour:
    """The colour of a learner's pen."""
    return learner_pen(name).colour


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


def _pen(name: str, named: dict[str, Pen], others: tuple[Pen, ...]) -> Pen:
    """The pen of this name, or one of the others; two of a user's names may share one."""
    return named[name] if name in named else others[sum(name.encode()) % len(others)]
