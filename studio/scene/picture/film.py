"""The film of a scene: every action played in turn, then the picture that sums them up.

Each action's rollouts run at once, as many ghost robots among ghost people; one of them, the same
for every action, is drawn in full. The people and the robot of one rollout meet the same luck
under every action, so what differs between two actions is never chance. Actions on which teachers
disagree come first, then those with most contacts. The first contact of an action stands still for
a moment.
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
from studio.scene.picture.crowd import FirstContact, MovingScene
from studio.scene.picture.page import compose_picture
from studio.scene.picture.scenery import (
    draw_goal,
    draw_ground,
    draw_people_beyond,
    draw_scale_bar,
    draw_true_walks,
    draw_walls,
    goal_label,
    view_of,
)
from studio.scene.picture.so_far import Course, OutcomesSoFar, courses
from studio.scene.picture.strip import ActionStrip
from studio.scene.picture.titles import draw_heading_in_line, joined, subtitles, titles
from studio.scene.selection import only
from studio.style.palette import LIGHT, Theme

# lengths of time in the film, s
_LONGEST_ACTION = 2.0  # playing one action takes no longer
_PAUSE = 0.5  # the end of an action stands still
_FIRST_CONTACT = 0.7  # the first contact of an action stands still
_CLOSING_PICTURE = 6.0

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

    Width and height (px) are even. The span is from when to when the film plays, in s of simulated
    time; without one it plays all of it. A film that does not run to the end of the rollouts has no
    closing picture.

    Raises:
        InputError: if the size is not allowed, or there is no such span of time.
    """
    order = telling_order(rollouts, judgements)
    theme = theme.of(rollouts.names)
    ordered = only(rollouts, [rollouts.names[index] for index in order])
    page = lay_out_film(ordered, size, theme, [judgement.of(order) for judgement in judgements])
    start, end = span or (0.0, rollouts.horizon)
    if not 0.0 <= start < end <= rollouts.horizon:
        raise InputError(
            f"--from, --to: {start:g} to {end:g} s is not allowed: "
            f"within 0 to {rollouts.horizon:g} s"
        )
    speed = play_speed(rollouts.horizon)

    def segment(index: int) -> Segment:
        contact = FirstContact.of(page.shown, index)
        halt = contact.time if contact else None
        times = frame_times(start, end, speed, frames_per_second, halt)

        def frames() -> Iterator[PixelArray]:
            return (canvas.pixels for canvas in play_action(page, index, times))

        return Segment(len(times), frames)

    segments = [segment(index) for index in range(len(rollouts.actions))]
    if end < rollouts.horizon:
        return segments
    held = round(_CLOSING_PICTURE * frames_per_second)

    def ending() -> Iterator[PixelArray]:
        picture = compose_picture(rollouts, judgements, size, theme).pixels
        return (picture for _ in range(held))

    return [*segments, Segment(held, ending)]


def telling_order(rollouts: Rollouts, judgements: Sequence[Judgement]) -> list[int]:
    """Indices of the actions, those that tell most about the scene first.

    First come actions that some teachers may pick and others would not, then those that teachers
    rank differently, then those with most contacts.
    """
    count = len(rollouts.actions)
    picking = np.array([np.isin(np.arange(count), each.candidates) for each in judgements])
    ranks = np.array([each.ranks for each in judgements])
    if not len(judgements):
        picking, ranks = np.zeros((1, count), dtype=bool), np.zeros((1, count), dtype=int)
    disputed = picking.any(axis=0) & ~picking.all(axis=0)
    apart = ranks.max(axis=0) - ranks.min(axis=0)
    contacts = rollouts.touched.sum(axis=1)
    # the last key counts most; of equals, the earlier comes first
    order: list[int] = np.lexsort((-contacts, -apart, ~disputed)).tolist()
    return order


def play_speed(horizon: float) -> float:
    """How many times faster than real time the film runs."""
    return next(
        (speed for speed in _SPEEDS if horizon / speed <= _LONGEST_ACTION),
        math.ceil(horizon / _LONGEST_ACTION),
    )


def frame_times(
    start: float, end: float, speed: float, frames_per_second: int, halt: float | None = None
) -> FloatArray:
    """The simulated time of each frame of an action, s; the frames of the pause are at its end.

    The action plays from start to end (s), at this many times the speed of real time. At one moment
    between them, if any (`halt`, s), it stands still.
    """
    steps = max(1, round((end - start) / speed * frames_per_second))
    playing = np.linspace(start, end, steps + 1)
    if halt is not None and start <= halt < end:
        held = np.full(round(_FIRST_CONTACT * frames_per_second), halt)
        playing = np.insert(playing, np.searchsorted(playing, halt), held)
    return np.concatenate([playing, np.full(round(_PAUSE * frames_per_second), end)])


# The page


@dataclass(frozen=True)
class FilmPage:
    """What all frames share."""

    canvas: Canvas  # with everything drawn that never changes
    view: View  # of the scene
    side: Box  # the column beside the scene
    clock: Box  # the line below the scene
    strip: tuple[Box, ...]  # one cell an action, at the foot of the page
    courses: tuple[Course, ...]  # what develops beside the scene
    judgements: tuple[Judgement, ...]  # of the actions in the order in which they are played
    rollouts: Rollouts  # all of them
    shown: Rollouts  # those whose paths are kept, which move in the film


def lay_out_film(
    rollouts: Rollouts,
    size: tuple[int, int],
    theme: Theme = LIGHT,
    judgements: Sequence[Judgement] = (),
) -> FilmPage:
    """Draw what all frames share; raises what `compose_film` raises.

    The actions are played in their order.
    """
    canvas = Canvas(*size, theme.of(rollouts.names))
    kind, unit, page = canvas.type, canvas.unit, canvas.page
    # as high as the title that is written once the view is known
    title = canvas.text_box((page.left, page.top), "", kind.heading, line="top")
    strip_height, clock_height = 2.9 * kind.body, 1.8 * kind.body
    top = title.bottom + 14 * unit
    strip = Box(page.left, page.bottom - strip_height, page.right, page.bottom)
    body = Box(page.left, top, page.right, strip.top - 14 * unit)
    scene, side = body.columns((1076, 416), canvas.gap)
    panel = Box(scene.left, scene.top, scene.right, scene.bottom - clock_height)
    view = view_of(rollouts, panel)
    told = subtitles(rollouts, view.bounds)
    draw_heading_in_line(canvas, titles(rollouts), told, kind.heading, 0.0)
    inside = canvas.clipped(panel)
    draw_ground(inside, view)
    draw_true_walks(inside, view, rollouts)
    draw_walls(inside, view, rollouts.scene)
    goal = draw_goal(inside, view, rollouts.scene.robot.goal)
    labels = [
        goal_label(canvas, goal, (1.0, 0.0)),
        *draw_people_beyond(inside, view, rollouts.scene),
    ]
    draw_labels(inside, labels, panel.inset(4 * unit), canvas.theme.panel)
    clock = Box(scene.left, panel.bottom, scene.right, scene.bottom)
    draw_scale_bar(canvas, view, clock.right, clock.centre[1] + 0.35 * kind.small)
    count = len(rollouts.actions)
    cells = strip.columns([1.0] * count, 12 * unit)
    shown, judged = rollouts.with_paths(), tuple(judgements)
    return FilmPage(canvas, view, side, clock, cells, courses(shown), judged, rollouts, shown)


# One action


def play_action(page: FilmPage, index: int, times: FloatArray) -> Iterator[Canvas]:
    """Draw the frames of one action at times (s) that never go back.

    Yields:
        One and the same canvas, drawn anew for each frame.
    """
    canvas, rollouts = page.canvas.copy(), page.shown
    strip = ActionStrip(canvas, page.strip, page.rollouts, page.judgements, index)
    so_far = OutcomesSoFar(canvas, page.side, page.rollouts, index, page.courses)
    scene = MovingScene(canvas.clipped(page.view.box), page.view, rollouts, index)
    contact = FirstContact.of(rollouts, index)
    still = canvas.copy()
    shown = -1.0
    for time in times:
        if time != shown:
            shown = float(time)
            # rounded, or the third step of 0.1 s would begin after 0.3 s
            step = round(shown / rollouts.dt, 6)
            canvas.texts[:] = still.texts
            scene.draw(step)
            if contact and shown == contact.time:
                scene.draw_first_contact(contact)
            so_far.draw(still, step)
            strip.draw(shown / rollouts.horizon)
            _draw_clock(canvas, still, page, shown)
        yield canvas


def _draw_clock(canvas: Canvas, still: Canvas, page: FilmPage, time: float) -> None:
    """Write the time, and what it has to do with real time, below the scene."""
    box, rollouts = page.clock, page.shown
    canvas.restore(still, box)
    size, count, faint = canvas.type.small, rollouts.count, canvas.theme.faint
    at, told_time = (box.left, box.centre[1]), f"{time:.1f} s of {rollouts.horizon:g} s"
    clock = canvas.text(at, told_time, canvas.type.body, canvas.theme.ink, SEMIBOLD)
    speed = f"{play_speed(rollouts.horizon):g}× real time"
    told = f"{count} rollouts at once, one of them in full" if count > 1 else ""
    if count < page.rollouts.count:
        told = f"a sample, {count} of {page.rollouts.count} rollouts, one of them in full"
    people = (rollouts.person_step >= 0).any()
    touched = ["× a person"] * bool(people) + ["□ a wall"] * bool(rollouts.wall_touched.any())
    marks = f"touched: {', '.join(touched)}" if touched else ""
    is_real = any(person.track for person in rollouts.scene.pedestrians)
    dashed = "dashed: true walks" if is_real else ""
    left = max(box.left + 9.5 * canvas.type.body, clock.right + size)
    room, at = 0.8 * box.width - (left - box.left), (left, box.centre[1])
    wordings = joined((speed, told, marks, dashed), (speed, marks, dashed), (speed, told), (speed,))
    canvas.fit(at, wordings, room, size, faint)
