"""Which kinds of recordings there are, and how any of them is read back.

A kind is a folder whose file `kind.py` keeps to the protocol `Kind`, and one line in `KINDS`. That
file imports what it reads and paints with only when it reads and paints, so that a kind costs
nothing until a recording of it is met.
"""

from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Protocol, cast

from studio.errors import InputError

if TYPE_CHECKING:
    from studio.recorder.contents import Contents
    from studio.recording import Recording

KINDS = {
    "prospect_studio_scene": "studio.scene.kind",
    "prospect_studio_comparison": "studio.comparison.kind",
    "prospect_studio_learning": "studio.study.kind",
}
"""Where each kind of recording is at home, by the application id that its files bear."""


class Kind(Protocol):
    """What the file `kind.py` of a kind of recording offers."""

    SPAN: str
    """What a part of such a recording is counted in, for example "s of a scene"."""

    def read(self, contents: "Contents") -> "Recording":
        """Read a recording of this kind, of this edition or an older one.

        Raises:
            InputError: if it is of a newer edition, or something is missing or contradicts itself.
            ValueError: if something is not as the studio writes it; TypeError, KeyError and
                IndexError mean the same.
        """


def _kind_in(module: str) -> Kind:
    return cast(Kind, import_module(module))


def spans() -> str:
    """What parts of recordings are counted in, all kinds in one line."""
    return ", ".join(_kind_in(module).SPAN for module in KINDS.values())


def open_recording(path: str | Path) -> "Recording":
    """Open a recording as data, whichever version of the studio has written it.

    Returns:
        Of a scene, an object with its `rollouts` and `judgements`; of a comparison, with its
        `comparison` and `judgements`; of a study, with its `results`. All of them have `to_arrow()`
        and `to_pandas()`: one row an outcome, or a fit.

    Raises:
        InputError: if the file is not a whole recording of the studio, or of a newer edition.
    """
    return read_recording(Path(path))


def read_recording(path: Path) -> "Recording":
    """Read a recording of any kind.

    Raises:
        InputError: if the file is not a whole recording of the studio, or of a newer edition.
    """
    from studio.recorder.contents import read_contents

    contents = read_contents(path)
    home = KINDS.get(contents.application)
    if home is None:
        raise InputError(
            f"{path}: is a recording of {contents.application!r}, not one of the studio"
        )
    try:
        return _kind_in(home).read(contents)
    except InputError:
        raise
    except (ValueError, TypeError, KeyError, IndexError) as error:
        # what a room refuses says what is wrong with it
        raise contents.damaged(str(error)) from None
