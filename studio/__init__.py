"""The orchestrator and everything a person touches."""

from studio.orchestrator import Studio

__all__ = ["Studio"]
