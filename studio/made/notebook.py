"""How results show themselves in a notebook: a picture and a few lines, or Rerun's own viewer."""

from __future__ import annotations

import sys
from base64 import b64encode
from html import escape
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any

from studio.errors import InputError

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from scenes import Rollouts, Scene
    from studio.arrays import PixelArray
    from studio.recording import Recording

SHOWN_SIZE = (960, 540)
"""Size of the picture in a notebook, px."""


def page_of(recording: Recording, lines: Sequence[str]) -> str:
    """The still picture of a recording above lines of text, as HTML."""
    from studio.recording import Excerpt, Look

    shown = recording.still(Look(SHOWN_SIZE), Excerpt()).pixels
    told = "".join(f"<div>{escape(line)}</div>" for line in lines)
    return image_of(shown, ", ".join(lines) or type(recording).__name__) + told


def image_of(pixels: PixelArray, alternative: str) -> str:
    """A picture [height, width, 3] as HTML, and what is told to those who cannot see it."""
    from studio.style.png import palette_png

    source = f"data:image/png;base64,{b64encode(palette_png(pixels)).decode()}"
    return f'<img src="{source}" alt="{escape(alternative)}" style="max-width: 100%">'


def show_inline(path: Path, width: int | None, height: int) -> None:
    """Show a recording in Rerun's viewer below the cell that calls this.

    Args:
        path: of the recording.
        width: of the viewer, px; None is as wide as the cell.
        height: of the viewer, px.

    Raises:
        InputError: if the viewer for notebooks is not installed.
    """
    if find_spec("rerun_notebook") is None:
        install = "pip install 'prospect-studio[notebook]'"
        raise InputError(f"show: rerun-notebook is not installed: {install}")
    from IPython.display import display
    from rerun_notebook import Viewer

    viewer = Viewer(width="auto" if width is None else width, height=height)
    viewer.send_rrd(path.read_bytes())
    display(viewer)  # type: ignore[no-untyped-call]


def register_pictures() -> None:
    """Let scenes, rollouts and opened recordings be pictures in a notebook.

    Scenes and rollouts know nothing of the studio, and recordings nothing of notebooks. Nothing
    happens outside of IPython.
    """
    shell = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    if shell is None:
        return
    html: Any = shell.display_formatter.formatters["text/html"]
    html.for_type_by_name("scenes.scene", "Scene", _scene_page)
    html.for_type_by_name("scenes.rollouts", "Rollouts", _rollouts_page)
    html.for_type_by_name("studio.recording", "Recording", lambda recording: page_of(recording, []))


def _scene_page(scene: Scene) -> str:
    from studio.scene.picture.plan import compose_plan, scene_told

    return image_of(compose_plan(scene, SHOWN_SIZE).pixels, ": ".join(scene_told(scene)))


def _rollouts_page(rollouts: Rollouts) -> str:
    from studio.scene.judgements import judge
    from studio.scene.kind import SceneRecording

    return page_of(SceneRecording(rollouts, judge(rollouts)), [repr(rollouts).strip("<>")])
