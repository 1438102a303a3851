"""A recording of a comparison, for the tests that look at every kind of recording."""

from pathlib import Path

from studio.orchestrator import Studio


def make(folder: Path) -> Path:
    studio = Studio(folder)
    compared = studio.compare("doorway", "forward", "stop", rollouts=5, png=False, mp4=False)
    return compared.files[0]
