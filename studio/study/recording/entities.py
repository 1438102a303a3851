"""What the things in a recording of a study are called: its application and its entity paths."""

from rerun import escape_entity_path_part as entity_part

APPLICATION = "prospect_studio_learning"
"""Blueprints belong to an application, so each kind of recording is one of its own."""

TIMELINE = "pairs"
"""The timeline that plays: how many pairs were learned from."""

ROWS = "row"
"""The timeline of the tables: the number of a row."""

SUMMARY = "summary"
ABOUT = "about"
KEY = "key"
STUDY = "/__properties/study"

LEARNER_TABLE, FIT_TABLE, SCENE_TABLE = "tables/learners", "tables/fits", "tables/scenes"


def page(teacher: str) -> str:
    """The page that says what was learned from a teacher so far."""
    return f"pages/{entity_part(teacher)}"


def scenes_about(teacher: str) -> str:
    """The page of the scenes that tell most about who learned from a teacher."""
    return f"scenes/{entity_part(teacher)}"


def fits(teacher: str, learner: str) -> str:
    """The numbers of every fit, one a seed."""
    return f"fits/{entity_part(teacher)}/{entity_part(learner)}"


def curves(teacher: str, name: str) -> str:
    """A plot of what was learned from a teacher, over the number of pairs."""
    parts = (entity_part(part) for part in (teacher, *name.split("/")))
    return f"curves/{'/'.join(parts)}"


def shapes(teacher: str) -> str:
    """The figure of how a teacher weighs and values, and what learners make of it."""
    return f"shapes/{entity_part(teacher)}"


def calibration(teacher: str, learner: str) -> str:
    """The plot of how often a teacher does what a learner predicts."""
    return f"calibration/{entity_part(teacher)}/{entity_part(learner)}"
