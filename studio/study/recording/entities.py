"""What the things in a recording of a study are called: its application and its entity paths."""

from rerun import escape_entity_path_part as entity_part

APPLICATION = "prospect_studio_learning"
"""Blueprints belong to an application, so each kind of recording is one of its own."""

TIMELINE = "pairs"
"""The one timeline: how many pairs were learned from."""

FIGURES = "figures"
SUMMARY = "summary"
SCENES = "scenes"
ABOUT = "about"
STUDY = "/__properties/study"

REGRET, AGREEMENT, LIKELIHOOD = "regret", "agreement", "likelihood"
GAIN_WEIGHTS, LOSS_WEIGHTS, VALUES = "weights_of_gains", "weights_of_losses", "values"
PARAMETERS, CALIBRATION, FAMILIES = "parameters", "calibration", "families"
"""Names of the figures about a teacher, see `figure`."""


def page(teacher: str) -> str:
    """The page that says what was learned from a teacher so far."""
    return f"pages/{entity_part(teacher)}"


def fits(teacher: str, learner: str) -> str:
    """The numbers of every fit, one a seed."""
    return f"fits/{entity_part(teacher)}/{entity_part(learner)}"


def curves(teacher: str, learner: str) -> str:
    """Means over seeds, with their spread."""
    return f"curves/{entity_part(teacher)}/{entity_part(learner)}"


def families(teacher: str, learner: str) -> str:
    """Means over seeds in each family of scenes, with their spread."""
    return f"families/{entity_part(teacher)}/{entity_part(learner)}"


def figure(teacher: str, name: str) -> str:
    """A figure about what was learned from a teacher."""
    return f"{FIGURES}/{entity_part(teacher)}/{name}"


def moving(figure_path: str) -> str:
    """What changes in a figure with the number of pairs."""
    return f"{figure_path}/learnt"


def truth(figure_path: str) -> str:
    """What the teacher is like, above what was learnt."""
    return f"{figure_path}/truth"
