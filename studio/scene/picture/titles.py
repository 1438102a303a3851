"""What pictures and films say about themselves in words."""

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
    actions, count, steps, _ = rollouts.robot.shape
    people, groups = len(rollouts.scene.pedestrians), len(rollouts.scene.groups)
    crowd = counted(people, "pedestrian") + (f" in {counted(groups, 'group')}" if groups else "")
    if groups and sum(map(len, rollouts.scene.groups)) < people:
        crowd = f"{counted(people, 'pedestrian')}, {counted(groups, 'group')}"
    horizon = f"horizon {(steps - 1) * rollouts.dt:g} s"
    sizes = f"{counted(actions, 'action')} × {counted(count, 'rollout')}"
    number = rollouts.scene.number
    seed = f"seed {rollouts.seed}, number {number}" if number else f"seed {rollouts.seed}"
    return [
        f"{sizes} · {crowd} · {horizon} · social force model: {rollouts.model} · {seed}",
        f"{sizes} · {crowd} · {horizon} · {rollouts.model} · {seed}",
        f"{sizes} · {horizon} · {rollouts.model} · {seed}",
    ]


def draw_heading(
    canvas: Canvas, page: Box, titles: Sequence[str], subtitles: Sequence[str], room: float
) -> Box:
    """Write a title and a subtitle along the top of a page, each in the wording that fits.

    Args:
        canvas: to draw on.
        page: within whose top and sides they lie, px.
        titles: the longest wording first.
        subtitles: the longest wording first.
        room: for the title, px from the left of the page.

    Returns:
        The box of both, as wide as the page.
    """
    kind = canvas.type
    title = canvas.text(
        (page.left, page.top),
        canvas.fitted(titles, room, kind.title, SEMIBOLD),
        kind.title,
        canvas.theme.ink,
        SEMIBOLD,
        line="top",
    )
    subtitle = canvas.text(
        (page.left, title.bottom + 4 * canvas.unit),
        canvas.fitted(subtitles, page.width, kind.body),
        kind.body,
        canvas.theme.faint,
        line="top",
    )
    return Box(page.left, page.top, page.right, subtitle.bottom)
