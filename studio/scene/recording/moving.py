"""What moves in a recording, and how: shared by all that is shown over time.

Marks answer when hovered. The viewer then shows up to three components of a mark, and nothing but a
count of more than that; those with a single value for all marks are left out. So a mark tells
everything in one text, `told`, of which 75 letters are shown; its action stands in the entity's
path. The same in numbers is a row of the table of outcomes.
"""

from collections.abc import Iterable, Sequence
from typing import cast

import numpy as np
import rerun as rr

from scenes import Rollouts
from scenes.scene import ROBOT_RADIUS
from studio.arrays import FloatArray, IntArray
from studio.scene.groups import shortest_links

RESOLUTION = 1.0 / 128.0
"""Positions are rounded to this, about 8 mm: they are at most 4 mm off.

Being a power of two it leaves the last bytes of each number empty and makes many numbers equal,
so that they pack into 0.6 of their size; rounded to 1 cm they would pack into 0.8.
"""

HEADING_RESOLUTION = 1.0 / 64.0
"""Headings are rounded to this, about 0.9°, rad."""

CONTACT_CLASS = 0
"""Class of a robot that has touched something; until then it is 1 + the index of its action."""

PATH_STRIDE = 4
"""A path is drawn through every fourth step: its corners stay within a centimetre of the truth."""

ARROWHEAD = ROBOT_RADIUS * np.array([(-0.35, 0.5), (0.6, 0.0), (-0.35, -0.5)])  # facing along x, m
CROSS = np.array([(-1, -1), (1, 1), (0, 0), (-1, 1), (1, -1)])
SQUARE = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1)])


def log_over_time(
    stream: rr.RecordingStream,
    path: str,
    times: Iterable[rr.TimeColumn],
    look: Iterable[rr.AsComponents],
    columns: Iterable[rr.ComponentColumn],
) -> None:
    """Say how an entity looks at any time, and what it is at each moment."""
    stream.log(path, *look, static=True)
    stream.send_columns(path, times, columns)


def rounded(values: FloatArray, resolution: float = RESOLUTION) -> FloatArray:
    """The nearest multiples of the resolution."""
    near: FloatArray = np.round(values / resolution) * resolution
    return near


def arrowheads(poses: FloatArray) -> FloatArray:
    """Where the corners of the arrowhead are on a robot at poses [N, 3], [N, 3, 2], m."""
    x, y, heading = poses.T[..., None]  # (N, 1) each
    ahead, left = ARROWHEAD.T
    cos, sin = np.cos(heading), np.sin(heading)
    corners = [x + ahead * cos - left * sin, y + ahead * sin + left * cos]
    return np.stack(corners, axis=-1)


def group_bars(people: FloatArray, groups: tuple[tuple[int, ...], ...]) -> FloatArray:
    """Ends of the bars that join the people [N, P, 2] of each group, [N, bars, 2, 2], m."""
    every = np.arange(len(people))[:, None, None]
    bars = [people[:, group][every, shortest_links(people[:, group])] for group in groups]
    return np.concatenate(bars, axis=1)


def strips(corners: FloatArray) -> list[FloatArray]:
    """Lines [N, M, 2] of M corners each in the type that Rerun asks for, though it takes arrays."""
    return cast("list[FloatArray]", corners)  # as an array they are not converted one by one


def time_columns(rollouts: Rollouts) -> tuple[rr.TimeColumn, ...]:
    """The two timelines that everything moves along."""
    steps = np.arange(rollouts.steps + 1)
    return (
        rr.TimeColumn("sim_time", duration=steps * rollouts.dt),
        rr.TimeColumn("step", sequence=steps),
    )


def turn_column(rollouts: Rollouts) -> rr.TimeColumn:
    """The timeline along which one rollout is shown after the other."""
    return rr.TimeColumn("rollout", sequence=np.arange(rollouts.paths))


def path_corners(rollouts: Rollouts, stride: int = PATH_STRIDE) -> IntArray:
    """The steps through which a path is drawn, the first and the last among them."""
    return np.unique([*range(0, rollouts.steps, stride), rollouts.steps])


def clear_rollouts_from(stream: rr.RecordingStream, path: str, first: int) -> None:
    """Show nothing of the rollouts from this one on, whose paths are not kept."""
    stream.set_time("rollout", sequence=first)
    stream.log(path, rr.Clear(recursive=True))
    stream.reset_time()


def people_told(told: Sequence[str], people: int) -> list[str]:
    """What the people of each rollout tell, those of the first one first."""
    rollouts = [words.split(":")[0] for words in told]
    return [f"person {person} in {each}" for each in rollouts for person in range(people)]


def told_by_row(rows: Sequence[Sequence[str]]) -> list[rr.ComponentColumn]:
    """What marks tell row by row; a single mark tells it twice, or it would not be shown."""
    doubled = [[*row, *row] if len(row) == 1 else row for row in rows]
    words = rr.AnyValues.columns(told=[word for row in doubled for word in row])
    return list(words.partition([len(row) for row in doubled]))
