"""The film of a scene: every action played in turn, then the picture that sums them up.

Each action's rollouts run at once, as many ghost robots among ghost people; one of them, the same
for every action, is drawn in full. The people and the robot of one rollout meet the same luck
under every action, so what differs between two actions is never chance.
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from scenes import Rollouts
from studio.arrays import FloatArray, PixelArray
from studio.errors import InputError
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.labels import draw_labels
from studio.painter.lettering import SEMIBOLD
from studio.painter.segments import Segment
from studio.painter.views import View
from studio.scene.judgements import Judgement
from studio.scene.picture.crowd import Crowd
from studio.scene.picture.page import compose_picture
from studio.scene.picture.side import Side
from studio.scene.picture.stage import (
    draw_goal,
    draw_ground,
    draw_scale_bar,
    draw_walls,
    goal_label,
    view_of,
)
from studio.scene.picture.titles import subtitles, titles
from studio.style.palette import LIGHT, Colour, Theme
from studio.style.words import action_label

LONGEST_ACTION = 2.0
"""Playing one action takes no longer than this, s."""

PAUSE = 0.5
"""How long the end of an action stands still, s."""

ENDING = 2.5
"""How long the closing picture is shown, s."""

_SPEEDS = (1, 1.5, 2, 3, 4, 5, 6, 8, 10, 12, 15, 20, 25)  # times real time


def compose_film(
    rollouts: Rollouts,
    judgements: Sequence[Judgement],
    size: tuple[int, int],
    frames_per_second: int,
    theme: Theme = LIGHT,
    span: tuple[float, float] | None = None,
) -> list[Segment]:
    """The film as segments: one an action, and the closing picture.

    A film that does not run to the end of the rollouts has no closing picture.

    Args:
        rollouts: of the scene under each action.
        judgements: the teachers' values of these actions.
        size: width and height, px; even.
        frames_per_second: whole.
        theme: of the page.
        span: from when to when it plays, s of simulated time; all of it if left out.

    Raises:
        InputError: if the size is not allowed, or there is no such span of time.
    """
    page = lay_out(rollouts, size, theme)
    start, end = span or (0.0, rollouts.horizon)
    if not 0.0 <= start < end <= rollouts.horizon:
        raise InputError(
            f"--from, --to: {start:g} to {end:g} s is not allowed: "
            f"within 0 to {rollouts.horizon:g} s"
        )
    times = frame_times(start, end, play_speed(rollouts.horizon), frames_per_second)
    segments = []
    for index in range(len(rollouts.actions)):

        def frames(index: int = index) -> Iterator[PixelArray]:
            return (canvas.pixels for canvas in play(page, rollouts, index, times))

        segments.append(Segment(len(times), frames))
    if end < rollouts.horizon:
        return segments
    held = round(ENDING * frames_per_second)

    def ending() -> Iterator[PixelArray]:
        picture = compose_picture(rollouts, judgements, size, theme).pixels
        return (picture for _ in range(held))

    return [*segments, Segment(held, ending)]


def play_speed(horizon: float) -> float:
    """How many times faster than real time the film runs."""
    return next(
        (speed for speed in _SPEEDS if horizon / speed <= LONGEST_ACTION),
        math.ceil(horizon / LONGEST_ACTION),
    )


def frame_times(start: float, end: float, speed: float, frames_per_second: int) -> FloatArray:
    """The simulated time of each frame of an action, s, and its end once more for the pause.

    Args:
        start: s of simulated time.
        end: s of simulated time.
        speed: how many times faster than real time.
        frames_per_second: of the film.
    """
    steps = max(1, round((end - start) / speed * frames_per_second))
    playing = np.linspace(start, end, steps + 1)
    return np.concatenate([playing, np.full(round(PAUSE * frames_per_second), end)])


# The page


@dataclass(frozen=True)
class Page:
    """What all frames share.

    Attributes:
        canvas: with everything drawn that never changes.
        view: of the scene.
        side: the column beside it.
        clock: the line below it.
        strip: one cell an action, at the foot of the page.
    """

    canvas: Canvas
    view: View
    side: Box
    clock: Box
    strip: tuple[Box, ...]


def lay_out(rollouts: Rollouts, size: tuple[int, int], theme: Theme = LIGHT) -> Page:
    """Draw what all frames share; arguments and errors as for `compose_film`."""
    canvas = Canvas(*size, theme.of(rollouts.names))
    kind, unit = canvas.type, canvas.unit
    page = canvas.page
    title = canvas.fitted(titles(rollouts), page.width, kind.heading, SEMIBOLD)
    written = canvas.text(
        (page.left, page.top), title, kind.heading, canvas.theme.ink, SEMIBOLD, line="top"
    )
    left = written.right + kind.heading
    subtitle = canvas.fitted(subtitles(rollouts), page.right - left, kind.body)
    canvas.text(
        (page.right, written.centre[1]), subtitle, kind.body, canvas.theme.faint, anchor="right"
    )
    strip_height, clock_height = 2.9 * kind.body, 1.8 * kind.body
    top = written.bottom + 14 * unit
    strip = Box(page.left, page.bottom - strip_height, page.right, page.bottom)
    body = Box(page.left, top, page.right, strip.top - 14 * unit)
    scene, side = body.columns((1076, 416), canvas.gap)
    panel = Box(scene.left, scene.top, scene.right, scene.bottom - clock_height)
    view = view_of(rollouts, panel)
    inside = canvas.clipped(panel)
    draw_ground(inside, view)
    draw_walls(inside, view, rollouts.scene)
    goal = draw_goal(inside, view, rollouts.scene.robot.goal)
    label = goal_label(canvas, goal, (1.0, 0.0))
    draw_labels(inside, [label], panel.inset(4 * unit), canvas.theme.panel)
    clock = Box(scene.left, panel.bottom, scene.right, scene.bottom)
    draw_scale_bar(canvas, view, clock.right, clock.centre[1] + 0.35 * kind.small)
    count = len(rollouts.actions)
    return Page(canvas, view, side, clock, strip.columns([1.0] * count, 12 * unit))


# One action


def play(page: Page, rollouts: Rollouts, index: int, times: FloatArray) -> Iterator[Canvas]:
    """Draw the frames of one action.

    Args:
        page: what all frames share.
        rollouts: of the scene under each action.
        index: which action.
        times: the simulated time of each frame, s; equal ones follow one another.

    Yields:
        One and the same canvas, drawn anew for each frame.
    """
    canvas = page.canvas.copy()
    strip = _Strip(canvas, page.strip, rollouts, index)
    side = Side(canvas, page.side, rollouts, index)
    crowd = Crowd(canvas.clipped(page.view.box), page.view, rollouts, index)
    still = canvas.copy()
    shown = -1.0
    for time in times:
        if time != shown:
            shown = float(time)
            # rounded, or the third step of 0.1 s would begin after 0.3 s
            step = round(shown / rollouts.dt, 6)
            canvas.texts[:] = still.texts
            crowd.draw(step)
            side.draw(still, step)
            strip.draw(shown / rollouts.horizon)
            _draw_clock(canvas, still, page.clock, rollouts, shown)
        yield canvas


def _draw_clock(canvas: Canvas, still: Canvas, box: Box, rollouts: Rollouts, time: float) -> None:
    """Write the time, and what it has to do with real time, below the scene."""
    canvas.restore(still, box)
    size, count = canvas.type.small, rollouts.count
    clock = canvas.text(
        (box.left, box.centre[1]),
        f"{time:.1f} s of {rollouts.horizon:g} s",
        canvas.type.body,
        canvas.theme.ink,
        SEMIBOLD,
    )
    speed = f"{play_speed(rollouts.horizon):g}× real time"
    left = box.left + 9.5 * canvas.type.body
    told = f"{count} rollouts at once, one of them in full" if count > 1 else ""
    red = "red: contact" if rollouts.touched.any() else ""
    texts = [
        " · ".join(part for part in parts if part)
        for parts in ((speed, told, red), (speed, told), (speed,))
    ]
    left = max(left, clock.right + size)
    text = canvas.fitted(texts, 0.8 * box.width - (left - box.left), size)
    canvas.text((left, box.centre[1]), text, size, canvas.theme.faint)


class _Strip:
    """All actions at the foot of the page: those that were played, the one that is, the rest."""

    def __init__(
        self, canvas: Canvas, cells: Sequence[Box], rollouts: Rollouts, index: int
    ) -> None:
        colours = [canvas.theme.action_colour(name) for name in rollouts.names]
        self._canvas, self._cell, self._colour = canvas, cells[index], colours[index]
        kind, count = canvas.type, rollouts.count
        for action, (cell, colour) in enumerate(zip(cells, colours, strict=True)):
            self._draw_bar(cell, canvas.theme.grid, 1.0)
            if action < index:
                self._draw_bar(cell, colour, 1.0)
            name = action_label(rollouts.names[action])
            ink = canvas.theme.legible(colour) if action <= index else canvas.theme.faint
            canvas.text(
                (cell.left, cell.top + 1.2 * kind.body),
                canvas.fitted(name, cell.width, kind.body, SEMIBOLD),
                kind.body,
                ink,
                SEMIBOLD,
            )
            if action < index:
                touched = int(rollouts.touched[action].sum())
                told = [f"{touched} of {count} contact", f"{touched} of {count}", f"{touched}"]
                canvas.text(
                    (cell.left, cell.top + 2.4 * kind.body),
                    canvas.fitted(told, cell.width, kind.small),
                    kind.small,
                    canvas.theme.contact if touched else canvas.theme.faint,
                )

    def draw(self, share: float) -> None:
        """Fill the bar of the action that is played up to this share."""
        self._draw_bar(self._cell, self._colour, share)

    def _draw_bar(self, cell: Box, colour: Colour, share: float) -> None:
        right = cell.left + share * cell.width
        self._canvas.fill(Box(cell.left, cell.top, right, cell.top + 4 * self._canvas.unit), colour)
