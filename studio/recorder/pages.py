"""Pages of a recording: Markdown, and the versions of packages that such pages name."""

import sys
from importlib.metadata import version

import rerun as rr

PACKAGES = ("prospect-studio", "rerun-sdk", "numpy", "numba", "pysocialforce")
"""Packages that shape what a recording holds."""


def log_page(stream: rr.RecordingStream, path: str, markdown: str, *, static: bool = True) -> None:
    """Add a page of Markdown to a recording.

    A page that is not static is shown from the stream's time on, until there is another one.
    """
    stream.log(path, rr.TextDocument(markdown, media_type=rr.MediaType.MARKDOWN), static=static)


def package_versions() -> dict[str, str]:
    """Versions of Python and of `PACKAGES`, by name."""
    versions = {package: version(package) for package in PACKAGES}
    return {"python": sys.version.split()[0], **versions}
