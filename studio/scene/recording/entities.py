"""What the things in a recording are called: its application and its entity paths.

The recording, its blueprint and its text all take their paths from here.
"""

from rerun import escape_entity_path_part as entity_part

APPLICATION = "prospect_studio_scene"
"""Blueprints belong to an application, so each kind of recording is one of its own."""

WORLD = "world"
WALLS = "world/walls"
TASK = "world/task"
SCALE = "world/scale"
WITHOUT_ROBOT = "world/without_robot"
ACTIONS = "actions"
OUTCOMES = "outcomes"
HISTOGRAMS = "histograms"
JUDGEMENTS = "judgements"
REFERENCE = "reference"
UTILITIES = "figures/utilities"
MINDS = "figures/minds"
FIGURES = "figures"
SUMMARY = "summary"
DISAGREEMENTS = "disagreements"
ABOUT = "about"
SCENE = "/__properties/scene"
SIMULATION = "/__properties/simulation"


def action(name: str) -> str:
    """The world under one action."""
    return f"{WORLD}/actions/{entity_part(name)}"


def robots(name: str) -> str:
    """The robots under one action, in all rollouts whose paths are kept."""
    return f"{action(name)}/robots"


def pedestrians(name: str) -> str:
    """The pedestrians under one action, in all rollouts whose paths are kept."""
    return f"{action(name)}/pedestrians"


def paths(name: str) -> str:
    """The paths of the robots under one action."""
    return f"{action(name)}/paths"


def contacts(name: str) -> str:
    """Where the robots under one action first touch a person, and where a wall."""
    return f"{action(name)}/contacts"


def shown(name: str) -> str:
    """The one rollout under one action that is drawn in true size."""
    return f"{action(name)}/shown"


def outcomes(name: str) -> str:
    """The table of the outcomes of one action."""
    return f"{OUTCOMES}/{entity_part(name)}"


def histogram(feature: str, name: str) -> str:
    """How a feature of the outcomes of one action is distributed."""
    return f"{HISTOGRAMS}/{feature}/{entity_part(name)}"


def any_action(feature: str) -> str:
    """The most outcomes that any action has in each bin of a feature."""
    return f"{HISTOGRAMS}/{feature}"


def gap(name: str) -> str:
    """The gap to the nearest person over time under one action."""
    return f"gap/{entity_part(name)}"


def states(name: str) -> str:
    """What the robots under one action are touching over time."""
    return f"touching/{entity_part(name)}"
