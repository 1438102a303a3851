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
    """A generated scene under a name of its own, which no other one has, see `numbered_name`.

    People meet in the family's first pattern if none is given.

    Raises:
        InputError: if there is no such scene (`scenes.InputError`).
    """
    from scenes import load_scene

    scene = load_scene(family, pattern, seed, number)
    return replace(scene, name=numbered_name(scene, seed))


def numbered_name(scene: Scene, seed: int) -> str:
    """The name of a generated scene that tells it from all others, given the seed of its series.

    For example `doorway-0-3`, or `doorway-mixed-0-3` where the pattern is not the family's first.
    """
    return "-".join([scene.family, *_unusual_pattern(scene), str(seed), str(scene.number)])


def words_of(scene: Scene, seed: int) -> tuple[str, ...]:
    """What the files of a scene are named by, so that no two scenes share them.

    Args:
        scene: of whose name they have the name; if it is that of its family, they tell the pattern
            and the number, too, unless these are the family's first.
        seed: of the noise, told unless it is 0.
    """
    words = [scene.name]
    if scene.name == scene.family:
        words += [*_unusual_pattern(scene), *([str(scene.number)] if scene.number else [])]
    return (*words, *([f"seed{seed}"] if seed else []))


def _unusual_pattern(scene: Scene) -> list[str]:
    """The pattern of a scene, unless it is the one that its family has if none is asked for."""
    from scenes import FAMILIES

    family = FAMILIES.get(scene.family)
    is_usual = family is not None and scene.pattern == family.patterns[0]
    return [] if is_usual else [scene.pattern]


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
