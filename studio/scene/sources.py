"""Where a scene comes from: a family's name, a scene file, or the tracks of a real crowd."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from studio.errors import InputError

if TYPE_CHECKING:
    from scenes import Scene
    from scenes.scene import Position


@dataclass(frozen=True)
class Source:
    """A scene as a person names it.

    Attributes:
        scene: a family's name, or the path of a scene (`.toml`) or of tracks in EWAP format.
        pattern: how people meet, for a family; left out, its first pattern.
        seed: of the series of generated scenes.
        number: which scene of the series, for a family; left out, 0.
        frame: which frame, for tracks; left out, the busiest.
        robot_start: (x, y) in m, for tracks; left out, a telling place.
        robot_goal: (x, y) in m, for tracks; left out, a telling place.
    """

    scene: str
    pattern: str | None = None
    seed: int = 0
    number: int | None = None
    frame: int | None = None
    robot_start: Position | None = None
    robot_goal: Position | None = None


def find_scene(source: Source) -> Scene:
    """The scene that is meant.

    Raises:
        InputError: if there is none, or an option does not go with it.
    """
    from scenes import FAMILIES, busiest_frames, load_scene, scene_from_file, scene_from_tracks

    for_families = {"--pattern": source.pattern, "--number": source.number}
    for_tracks = {
        "--frame": source.frame,
        "--robot-start": source.robot_start,
        "--robot-goal": source.robot_goal,
    }
    path = Path(source.scene)
    if source.scene in FAMILIES:
        _refuse(for_tracks, "recorded tracks", f"the family {source.scene}")
        return load_scene(source.scene, source.pattern, source.seed, source.number or 0)
    if path.suffix == ".toml":
        _refuse(for_families | for_tracks, "families or tracks", "a scene file")
        return scene_from_file(path)
    if is_file(source.scene):
        _refuse(for_families, "families", "recorded tracks")
        frame = busiest_frames(path, 1)[0][0] if source.frame is None else source.frame
        return scene_from_tracks(path, frame, source.robot_start, source.robot_goal)
    raise InputError(
        f"--scene: {source.scene!r} is neither a family ({', '.join(FAMILIES)}) nor a file "
        "(a scene ending in .toml, or the obsmat.txt of recorded tracks)"
    )


def numbered_scene(family: str, pattern: str | None, seed: int, number: int) -> Scene:
    """A generated scene under a name of its own, which none of its family shares.

    Recorded, it does not replace the family's own recording. People meet in the family's first
    pattern if none is given.

    Raises:
        InputError: if there is no such scene (`scenes.InputError`).
    """
    from scenes import load_scene

    scene = load_scene(family, pattern, seed, number)
    return replace(scene, name=f"{family}-{seed}-{number}")


def is_file(name: str) -> bool:
    """Whether there is a file or folder of this name."""
    try:
        return bool(name) and Path(name).exists()
    except OSError:  # a name that no file can have
        return False


def _refuse(options: dict[str, Any], goes_with: str, given: str) -> None:
    for option, value in options.items():
        if value is not None:
            raise InputError(f"{option}: goes with {goes_with}, not with {given}")
