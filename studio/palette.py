"""One palette for recordings, pictures and films.

The seven action colours are told apart with every common form of colour blindness (they build on
Okabe and Ito, "Color universal design", 2008) and stand out from both a white and a near-black
ground. Vermilion red is kept for contact and used for nothing else; people are grey.
"""

from dataclasses import dataclass

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
"""Colour of each action, in the order of the actions; a user's eighth action begins anew."""

CONTACT: Colour = (213, 43, 30)
"""Touching a pedestrian or a wall, and nothing else."""

PEDESTRIAN: Colour = (120, 124, 130)
WALL: Colour = (62, 66, 72)

TEACHER_COLOURS: dict[str, Colour] = {
    "eu": (90, 90, 90),
    "tk": (51, 34, 136),
    "strong": (204, 102, 119),
}

LEARNER_COLOURS: dict[str, Colour] = {
    "eu": (221, 139, 0),  # amber
    "cpt": (0, 134, 120),  # teal
    "cpt-tied": (64, 146, 222),  # azure
    "cpt-reference": (122, 74, 160),  # violet
    "cpt-tied-reference": (190, 80, 160),  # magenta
}

OTHER_LEARNERS: tuple[Colour, ...] = (
    (121, 133, 30),  # olive
    (136, 103, 53),  # brown
    (46, 70, 90),  # slate
    (0, 118, 158),  # cerulean
)
"""Colours of learners that a user adds, told by their names."""


@dataclass(frozen=True)
class Theme:
    """The ground that things are drawn on.

    Attributes:
        ground: the page.
        panel: a plot on the page.
        grid: grid lines.
        faint: minor text and axes.
        ink: text.
    """

    ground: Colour
    panel: Colour
    grid: Colour
    faint: Colour
    ink: Colour


LIGHT = Theme(
    ground=(255, 255, 255),
    panel=(249, 249, 250),
    grid=(230, 231, 234),
    faint=(112, 116, 122),
    ink=(32, 35, 40),
)


def action_colour(index: int) -> Colour:
    """The colour of the action at this place in the list of actions."""
    return ACTION_COLOURS[index % len(ACTION_COLOURS)]


def teacher_colour(name: str) -> Colour:
    """The teacher's colour; that of text for one who has none."""
    return TEACHER_COLOURS.get(name, LIGHT.ink)


def learner_colour(name: str) -> Colour:
    """The learner's colour: always the same one for the same name."""
    if name in LEARNER_COLOURS:
        return LEARNER_COLOURS[name]
    return OTHER_LEARNERS[sum(name.encode()) % len(OTHER_LEARNERS)]


def blend(colour: Colour, ground: Colour, opacity: float) -> Colour:
    """The colour as it looks through at this opacity (0 to 1) on the ground."""
    red, green, blue = (
        round(opacity * over + (1.0 - opacity) * under)
        for over, under in zip(colour, ground, strict=True)
    )
    return red, green, blue


def legible(colour: Colour) -> Colour:
    """The colour darkened just so far that small type in it can be read on white (4.5 to 1)."""
    while _luminance(colour) > 0.183:
        colour = blend(colour, (0, 0, 0), 0.95)
    return colour


def _luminance(colour: Colour) -> float:
    """Relative luminance (WCAG 2), 0 to 1."""
    red, green, blue = (
        share / 12.92 if share <= 0.04045 else ((share + 0.055) / 1.055) ** 2.4
        for share in (channel / 255.0 for channel in colour)
    )
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue
