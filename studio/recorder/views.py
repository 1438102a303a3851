"""How a recording looks when it opens: its tabs, their views, and the time that plays.

Every view costs about eight kilobytes, and every style that a view lays over the data five more, so
views are few and show things as they were logged.
"""

from collections.abc import Iterable, Sequence
from typing import Literal

import rerun as rr
import rerun.blueprint as rrb

from studio.arrays import Bounds
from studio.style.palette import LIGHT


def opening(
    tabs: Sequence[rrb.Container | rrb.View],
    timeline: str,
    play_state: Literal["playing", "following"] = "playing",
    loop_mode: Literal["all", "off"] = "all",
    frames_per_second: float | None = None,
) -> rrb.Blueprint:
    """A recording that opens with the first of these tabs and with its panels out of the way.

    Args:
        tabs: what is shown, each with a name.
        timeline: along which time runs.
        play_state: whether time plays from the first moment on, or stands at the last.
        loop_mode: whether it begins anew at the end.
        frames_per_second: how fast numbers follow one another, on a timeline that counts.
    """
    return rrb.Blueprint(
        rrb.Tabs(*tabs, active_tab=0),
        rrb.TimePanel(
            state="collapsed",
            timeline=timeline,
            play_state=play_state,
            loop_mode=loop_mode,
            fps=frames_per_second,
        ),
        collapse_panels=True,
        auto_layout=False,
        auto_views=False,
    )


def drawn_view(contents: Iterable[str], bounds: Bounds, title: str) -> rrb.View:
    """A view of drawn things, in which y counts upwards, on light ground.

    The contents are entities; `/**` at the end of one stands for everything below it, and a `-`
    before it leaves out what an entity before it holds.
    """
    x0, y0, x1, y1 = bounds
    rules = (rule if rule.startswith("- ") else f"+ {rule}" for rule in contents)
    return rrb.Spatial2DView(
        # only views from the root apply the transform that turns y upwards
        origin="/",
        contents=[f"{rule[:2]}/{rule[2:]}" for rule in rules],
        name=title,
        background=LIGHT.panel,
        visual_bounds=rrb.VisualBounds2D(x_range=[x0, x1], y_range=[-y1, -y0]),
    )


def y_upwards() -> rr.Transform3D:
    """The transform of an entity below which y counts upwards; on screens it counts downwards."""
    return rr.Transform3D(scale=[1.0, -1.0, 1.0])


def page_view(path: str, title: str) -> rrb.View:
    """A view of a page of Markdown."""
    return rrb.TextDocumentView(origin=f"/{path}", name=title)
