"""The orchestrator and everything a person touches."""

from studio.kinds import open_recording
from studio.made.notebook import register_pictures
from studio.orchestrator import Studio

__all__ = ["Studio", "open_recording"]

register_pictures()
