"""A recording of a scene, for the tests that look at every kind of recording."""

from pathlib import Path

from studio.orchestrator import Studio


def make(folder: Path) -> Path:
    return Studio(folder).record("doorway", rollouts=5, png=False, mp4=False).files[0]
