"""What the things in a recording are called: its application and its entity paths.

The recording, its blueprint and its text all take their paths from here.
"""

from rerun import escape_entity_path_part as entity_part

APPLICATION = "prospect_studio_scene"
"""Blueprints belong to an application, so each kind of recording is one of its own."""

WORLD = "world"
GRID = "world/grid"
WALLS = "world/walls"
TASK = "world/task"
LABELS = "world/labels"
WITHOUT_ROBOT = "world/without_robot"
FIGURES = "figures"
ACTION_TABLE = "figures/comparison"
ACTION_TABLE_OUTCOMES = "figures/comparison/outcomes"
PROSPECTS = "figures/prospects"
RANKED_OUTCOMES = "figures/prospects/outcomes"
GAIN_WEIGHTS = "figures/weights_of_gains"
LOSS_WEIGHTS = "figures/weights_of_losses"
DECISION_WEIGHTS = "figures/decision_weights"
VALUES = "figures/values"
CURVES = (GAIN_WEIGHTS, LOSS_WEIGHTS, DECISION_WEIGHTS, VALUES)  # from the left to the right
RANKS = "figures/ranks"
OUTCOMES = "outcomes"
JUDGEMENTS = "judgements"
REFERENCE = "reference"
GAP = "clearance"
SUMMARY = "summary"
DISAGREEMENTS = "disagreements"
ABOUT = "about"
SCENE = "/__properties/scene"
SIMULATION = "/__properties/simulation"


def action(name: str) -> str:
    """The world under one action."""
    return f"{WORLD}/actions/{entity_part(name)}"


def robots(name: str) -> str:
    """The K robots under one action."""
    return f"{action(name)}/robots"


def pedestrians(name: str) -> str:
    """The K times P pedestrians under one action."""
    return f"{action(name)}/pedestrians"


def paths(name: str) -> str:
    """The paths of the K robots under one action, and where they touched something."""
    return f"{action(name)}/paths"


def distributions(name: str) -> str:
    """The figure of how the outcomes of one action are distributed."""
    return f"{FIGURES}/actions/{entity_part(name)}"
