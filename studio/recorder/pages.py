"""Pages of a recording: Markdown, and the versions of packages that such pages name."""

import sys
from importlib.metadata import version

import rerun as rr

PACKAGES = ("prospect-studio", "rerun-sdk", "numpy", "numba", "pysocialforce")
"""Packages that shape what a recording holds."""


def log_page(stream: rr.RecordingStream, path: str, markdown: str) -> None:
    """Add a page of Markdown to a recording."""
    stream.log(path, rr.TextDocument(markdown, media_type=rr.MediaType.MARKDOWN), static=True)


def package_versions() -> dict[str, str]:
    """Versions of Python and of `PACKAGES`, by name."""
    versions = {package: version(package) for package in PACKAGES}
    return {"python": sys.version.split()[0], **versions}
