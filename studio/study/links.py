"""The recordings of single scenes that the recording of a study links to."""

from dataclasses import dataclass


@dataclass(frozen=True)
class SceneLink:
    """The recording of a scene of a study."""

    name: str  # what the scene is called there
    path: str  # where the recording is, from the folder of the study's own recording
    commands: tuple[str, ...]  # that make it again in that folder; none if only a study does


Links = dict[int, SceneLink]
"""Recordings by the scene's id in the bank."""
