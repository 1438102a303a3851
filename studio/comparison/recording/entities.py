"""What the things that only the recording of a comparison has are called; all else as of a scene.

Actions have the names under which they are shown: those of their sides if the comparison is blind.
"""

from rerun import escape_entity_path_part as entity_part

from studio.scene.recording.entities import FIGURES, WORLD

APPLICATION = "prospect_studio_comparison"
"""Blueprints belong to an application, so each kind of recording is one of its own."""

STORY = "story"
"""The timeline along which one outcome plays after the other."""

COMPARED = "/__properties/comparison"


def story(name: str) -> str:
    """The world under one action, its outcomes one after the other."""
    return f"{WORLD}/story/{entity_part(name)}"


def dots(name: str) -> str:
    """The figure of one action's outcomes, on which dots gather, and below it what is said."""
    return f"{FIGURES}/dots/{entity_part(name)}"
