"""Recordings of real pedestrians in the EWAP format.

A recording is a folder that holds `obsmat.txt`: a row for each person in each annotated frame, with
the columns frame, person, x, z, y, vx, vz, vy (m and m/s, z up). Beside it there may be
`groups.txt` (a line for each group, the numbers of its members) and `map.xml` (what stands in the
way: lines and circles). `destinations.txt` is not read: it lists places where people went, but not
who went where, which the tracks themselves show.

The format and two recordings are from Pellegrini, Ess, Schindler and van Gool, "You'll never walk
alone: modeling social behavior for multi-target tracking", ICCV 2009; the maps are from Amirian et
al., "OpenTraj", ACCV 2020.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
from pydantic import ValidationError

from scenes.arrays import FloatArray, IntArray
from scenes.errors import InputError, checked_text
from scenes.scene import SHORTEST_WALL, Position, Wall
from scenes.scene_text import one_line

STANDING_SPEED = 0.2
"""A person of a recording who is slower than this stands, m/s."""

ANNOTATION_STEP = 0.4
"""Time between two annotated frames, s."""

_COLUMNS = ("frame", "person", "x", "z", "y", "vx", "vz", "vy")
_MARGIN = 1e-6  # how much longer than the shortest wall a lengthened one is, against rounding, m


@dataclass(frozen=True)
class Tracks:
    """A recording: N annotations, sorted by frame and then by person."""

    name: str
    frames: IntArray  # [N], number of the video frame
    people: IntArray  # [N], number of the person
    positions: FloatArray  # [N, 2], m
    velocities: FloatArray  # [N, 2], m/s
    walls: tuple[Wall, ...]  # they stand for the lines and circles of the map
    groups: tuple[tuple[int, ...], ...]  # numbers of people who belong together, as in the file


def read_tracks(path: Path) -> Tracks:
    """Read a recording.

    Args:
        path: the recording's folder, or its file of annotations.

    Raises:
        InputError: if a file is missing or malformed.
    """
    file = path / "obsmat.txt" if path.is_dir() else path
    table = _read_table(file)
    frames, people = table[:, 0].astype(np.int64), table[:, 1].astype(np.int64)
    order = np.lexsort((people, frames))
    frames, people = frames[order], people[order]
    twice = np.flatnonzero((np.diff(frames) == 0) & (np.diff(people) == 0))
    for row in twice[:1]:
        raise InputError(f"{file}: person {people[row]} is annotated twice at frame {frames[row]}")
    return Tracks(
        name=file.resolve().parent.name if file.name == "obsmat.txt" else file.stem,
        frames=frames,
        people=people,
        positions=table[order][:, (2, 4)],
        velocities=table[order][:, (5, 7)],
        walls=_read_map(file.with_name("map.xml")),
        groups=_read_groups(file.with_name("groups.txt")),
    )


def _read_table(file: Path) -> FloatArray:
    lines = [line for line in checked_text(file, "utf-8-sig").splitlines() if line.strip()]
    if not lines:
        raise InputError(f"{file}: no annotations in it")
    columns = len(lines[0].split())
    if columns != len(_COLUMNS):
        raise InputError(
            f"{file}: {columns} columns: {len(_COLUMNS)} are needed ({', '.join(_COLUMNS)})"
        )
    try:
        table: FloatArray = np.loadtxt(lines, comments=None, ndmin=2)
    except ValueError as error:
        raise InputError(f"{file}: {str(error).split(';')[0]}") from None
    for row, column in np.argwhere(~np.isfinite(table))[:1]:
        raise InputError(
            f"{file}: {_COLUMNS[column]} is {table[row, column]} in row {row + 1}: "
            "a finite number is needed"
        )
    numbers = table[:, :2]
    odd = (numbers != np.floor(numbers)) | (numbers < 0) | (numbers >= 2**31)
    for row, column in np.argwhere(odd)[:1]:
        raise InputError(
            f"{file}: {_COLUMNS[column]} is {numbers[row, column]:g} in row {row + 1}: "
            "a whole number from 0 to 2147483647 is needed"
        )
    return table


def _read_groups(file: Path) -> tuple[tuple[int, ...], ...]:
    """The groups in `groups.txt`, one for each line that is not empty; none without the file."""
    if not file.exists():
        return ()
    groups = []
    for number, line in enumerate(checked_text(file, "utf-8-sig").splitlines(), start=1):
        try:
            groups.append(tuple(int(word) for word in line.split()))
        except ValueError:
            raise InputError(
                f"{file}: line {number} is {line.strip()!r}: numbers of people are needed"
            ) from None
    return tuple(group for group in groups if group)


def _read_map(file: Path) -> tuple[Wall, ...]:
    """The lines of `map.xml` as walls and its circles as polygons; none without the file."""
    if not file.exists():
        return ()
    try:
        root = ElementTree.fromstring(checked_text(file, "utf-8-sig"))
    except ElementTree.ParseError as error:
        raise InputError(f"{file}: not XML: {error}") from None
    try:
        return tuple(_walls(file, root))
    except ValidationError as error:
        raise InputError(f"{file}: a wall's {one_line(error)}") from None


def _walls(file: Path, root: ElementTree.Element) -> Iterator[Wall]:
    # {*} finds elements with and without a namespace.
    for line in root.findall(".//{*}Line"):
        x1, y1, x2, y2 = (_number(file, line, key) for key in ("x1", "y1", "x2", "y2"))
        yield _long_enough((x1, y1), (x2, y2))
    for circle in root.findall(".//{*}Circle"):
        x, y, radius = (_number(file, circle, key) for key in ("x", "y", "radius"))
        yield from _polygon(x, y, radius)


def _number(file: Path, element: ElementTree.Element, key: str) -> float:
    tag, text = element.tag.rpartition("}")[2], element.get(key)
    try:
        value = math.nan if text is None else float(text)
    except ValueError:
        value = math.nan
    least = 0.0 if key == "radius" else -1000.0
    if not least <= value <= 1000.0:
        given = f"no {key}" if text is None else f"{key} {text!r}"
        raise InputError(f"{file}: {tag} has {given}: a number from {least:g} to 1000 is needed")
    return value


def _long_enough(start: Position, end: Position) -> Wall:
    """The wall between two points, lengthened about its middle if it is too short to be one."""
    length = math.dist(start, end)
    if length >= SHORTEST_WALL:
        return Wall(start=start, end=end)
    x, y = 0.5 * (start[0] + end[0]), 0.5 * (start[1] + end[1])
    along = ((end[0] - start[0]) / length, (end[1] - start[1]) / length) if length else (1.0, 0.0)
    half = 0.5 * SHORTEST_WALL + _MARGIN
    return Wall(
        start=(x - half * along[0], y - half * along[1]),
        end=(x + half * along[0], y + half * along[1]),
    )


def _polygon(x: float, y: float, radius: float) -> Iterator[Wall]:
    """A circle as a polygon with corners on it and sides of at least `SHORTEST_WALL`.

    A circle that is too small for a triangle of such sides becomes the smallest such triangle.
    """
    side = SHORTEST_WALL + _MARGIN
    radius = max(radius, side / (2.0 * math.sin(math.pi / 3.0)))
    sides = min(24, int(math.pi / math.asin(0.5 * side / radius) + _MARGIN))
    angles = [math.tau * index / sides for index in range(sides + 1)]
    corners = [(x + radius * math.cos(a), y + radius * math.sin(a)) for a in angles]
    yield from (Wall(start=start, end=end) for start, end in pairwise(corners))
