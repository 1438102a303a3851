"""What pictures and films say in words, and how they fit it into their room."""

from collections.abc import Sequence

from scenes import Rollouts
from studio.arrays import Bounds
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.lettering import SEMIBOLD
from studio.scene.framing import in_view
from studio.scene.judgements import Judgement
from studio.style.words import LONGEST_NAME, action_label, alternatives, counted, listed


def titles(rollouts: Rollouts) -> list[str]:
    """What the scene is called, the longest wording first."""
    scene = rollouts.scene
    if scene.family == "tracks":
        place = scene.name.removesuffix(f"-{scene.number}").replace("_", " ")
        return [f"{place} · a real crowd at frame {scene.number}", scene.name]
    silent = (scene.name, "custom")  # words that would repeat the name, or say nothing
    words = [scene.name, *(word for word in (scene.family, scene.pattern) if word not in silent)]
    return [" · ".join(word.replace("_", " ") for word in words), scene.name]


def subtitles(rollouts: Rollouts, bounds: Bounds) -> list[str]:
    """What was simulated in one line, the longest wording first, of which bounds are shown."""
    scene, actions = rollouts.scene, counted(len(rollouts.actions), "action")
    crowd = counted(len(scene.pedestrians), "pedestrian")
    if scene.groups:
        in_groups = sum(map(len, scene.groups))
        joint = ", " if in_groups < len(scene.pedestrians) else " in "
        crowd += joint + counted(len(scene.groups), "group")
    outside = int((~in_view(scene.starts, bounds)).sum())
    if outside:
        crowd += f" ({len(scene.pedestrians) - outside} in view, {outside} not)"
    horizon, model = f"horizon {rollouts.horizon:g} s", rollouts.model
    sizes = f"{actions} × {counted(rollouts.count, 'rollout')}"
    seed = f"seed {rollouts.seed}"
    if scene.number:
        seed += f", {'frame' if scene.family == 'tracks' else 'number'} {scene.number}"
    return joined(
        (sizes, crowd, horizon, f"social force model: {model}", seed),
        (sizes, crowd, horizon, model, seed),
        (sizes, crowd, seed),
        (sizes, seed),
    )


def findings(judgements: Sequence[Judgement], names: Sequence[str]) -> list[str]:
    """What every teacher picks among actions of these names, the longest wording first."""
    alike: dict[tuple[int, ...], list[Judgement]] = {}
    for judgement in judgements:
        alike.setdefault(tuple(sorted(judgement.candidates)), []).append(judgement)
    told = []
    for candidates, those in alike.items():
        who = listed([judgement.label for judgement in those])
        if len(candidates) == 1:
            verb = "picks" if len(those) == 1 else "pick"
            told.append(f"{who} {verb} {_brief(names[candidates[0]])}")
        elif len(candidates) < 4:
            likely = [_brief(names[index]) for index in those[0].candidates]
            told.append(f"{who}: {alternatives(likely)}, it is open which")
        else:
            told.append(f"{who}: open between {len(candidates)} of {len(names)} actions")
    brief = [part.replace(", it is open which", " (open)") for part in told]
    return [" · ".join(told), " · ".join(brief)]


def _brief(name: str) -> str:
    """The label of an action, cut in the middle if it is long: long names differ at their ends."""
    label, kept = action_label(name), LONGEST_NAME // 2
    return label if len(label) <= LONGEST_NAME else f"{label[:kept].rstrip()}…{label[-kept + 1 :]}"


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
