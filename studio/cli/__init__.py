"""The command line `studio`: it parses what a person types, calls the orchestrator, and prints."""

from studio.cli.commands import main

__all__ = ["main"]
