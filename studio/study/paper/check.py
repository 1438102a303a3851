"""Whether a figure for a paper can be drawn, found out before there is anything to draw.

Drawing it takes matplotlib, which comes with the package's extra `figures` and not without.
"""

from importlib.util import find_spec
from pathlib import Path

from studio.errors import InputError


def check_figure(path: Path) -> Path:
    """Make sure that a figure for a paper can be drawn into this file.

    Raises:
        InputError: if the file is of another kind, or matplotlib is missing.
    """
    if path.suffix.lower() not in (".pdf", ".svg"):
        raise InputError(f"--figure: {path} is not allowed: a name that ends in .pdf or .svg")
    if find_spec("matplotlib") is None:
        install = "pip install 'prospect-studio[figures]'"
        raise InputError(f"--figure: matplotlib is not installed: {install}")
    return path
