"""What pictures and films say in words, and how they fit it into their room."""

from collections.abc import Sequence

from scenes import Rollouts
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.lettering import SEMIBOLD
from studio.style.words import counted


def titles(rollouts: Rollouts) -> list[str]:
    """What the scene is called, the longest wording first."""
    scene = rollouts.scene
    silent = (scene.name, "custom")  # words that would repeat the name, or say nothing
    words = [word for word in (scene.family, scene.pattern) if word not in silent]
    kind = [word.replace("_", " ") for word in words]
    return [" · ".join([scene.name, *kind]), scene.name]


def subtitles(rollouts: Rollouts) -> list[str]:
    """What was simulated in one line, the longest wording first."""
    scene = rollouts.scene
    crowd = counted(len(scene.pedestrians), "pedestrian")
    if scene.groups:
        in_groups = sum(map(len, scene.groups))
        joint = ", " if in_groups < len(scene.pedestrians) else " in "
        crowd += joint + counted(len(scene.groups), "group")
    horizon = f"horizon {rollouts.horizon:g} s"
    sizes = f"{counted(len(rollouts.actions), 'action')} × {counted(rollouts.count, 'rollout')}"
    seed = f"seed {rollouts.seed}" + (f", number {scene.number}" if scene.number else "")
    return [
        f"{sizes} · {crowd} · {horizon} · social force model: {rollouts.model} · {seed}",
        f"{sizes} · {crowd} · {horizon} · {rollouts.model} · {seed}",
        f"{sizes} · {horizon} · {rollouts.model} · {seed}",
    ]


def draw_heading(
    canvas: Canvas, page: Box, titles: Sequence[str], subtitles: Sequence[str], room: float
) -> Box:
    """Write a title and below it a subtitle along the top of a page (px).

    Both are given in several wordings, the longest first. The title has some room (px) from the
    left of the page on, the subtitle all of the page's width. Returns the box of both, as wide as
    the page.
    """
    kind, theme = canvas.type, canvas.theme
    at = (page.left, page.top)
    title = canvas.fit(at, titles, room, kind.title, theme.ink, SEMIBOLD, line="top")
    at = (page.left, title.bottom + 4 * canvas.unit)
    subtitle = canvas.fit(at, subtitles, page.width, kind.body, theme.faint, line="top")
    return Box(page.left, page.top, page.right, subtitle.bottom)


def draw_heading_in_line(
    canvas: Canvas, titles: Sequence[str], subtitles: Sequence[str], size: int, lower: float
) -> Box:
    """Write a title of this size (px) at the left and a subtitle at the right of the page's top.

    Both are given in several wordings, the longest first. The subtitle stands a little lower (px).
    Returns the box of the title.
    """
    page, theme = canvas.page, canvas.theme
    at = (page.left, page.top)
    title = canvas.fit(at, titles, page.width, size, theme.ink, SEMIBOLD, line="top")
    room = page.right - title.right - canvas.type.heading
    at = (page.right, title.centre[1] + lower)
    canvas.fit(at, subtitles, room, canvas.type.body, theme.faint, anchor="right")
    return title


def joined(*wordings: Sequence[str]) -> list[str]:
    """Wordings of one line, each made of parts, of which empty ones are left out."""
    return [" · ".join(part for part in parts if part) for parts in wordings]


def contacts_counted(touched: int, count: int, so_far: str = "") -> list[str]:
    """In how many of `count` rollouts there was contact, the longest wording first."""
    return [f"{touched} of {count} contact{so_far}", f"{touched} of {count}{so_far}"]
