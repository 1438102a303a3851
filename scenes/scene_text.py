"""Scenes as TOML text, and one line that says what is wrong with such a text."""

import re
import tomllib
from dataclasses import asdict
from pathlib import Path
from typing import Any

import tomli_w
from pydantic import TypeAdapter, ValidationError

from scenes.errors import InputError, checked_text
from scenes.scene import Scene

_SCENE = TypeAdapter(Scene)
_SHORT_ARRAY = re.compile(r"\[\n\s*([^\[\]]+),\n\s*\]")
_TRACK = re.compile(r"^track = \[\n\s*(.*?),\n\]", re.MULTILINE | re.DOTALL)
_LINE_BREAK = re.compile(r",\n\s*")


def scene_to_toml(scene: Scene) -> str:
    """The scene as TOML text, ready to edit; `scene_from_toml` reads it back exactly."""
    text = tomli_w.dumps(_without_none(asdict(scene)))
    text = _SHORT_ARRAY.sub(lambda found: f"[{_LINE_BREAK.sub(', ', found[1])}]", text)
    return _TRACK.sub(
        lambda found: f"track = [{_LINE_BREAK.sub(', ', found[1].strip(' ,'))}]", text
    )


def scene_from_toml(text: str, source: str = "scene") -> Scene:
    """Read a scene from TOML text, which messages call by the name of its source.

    Raises:
        InputError: if the text is not TOML, has an unknown or missing key or a value that is not
            allowed, or contradicts itself.
    """
    try:
        return _SCENE.validate_python(tomllib.loads(text))
    except tomllib.TOMLDecodeError as error:
        raise InputError(f"{source}: not TOML: {error}") from None
    except RecursionError:
        raise InputError(f"{source}: not a scene: nested too deep") from None
    except ValidationError as error:
        raise InputError(f"{source}: {one_line(error)}") from None


def scene_from_file(path: Path) -> Scene:
    """Read a scene from a TOML file.

    Raises:
        InputError: if the file cannot be read, or its text is not a scene.
    """
    text = checked_text(path, "utf-8", "cannot be read as a scene")
    return scene_from_toml(text, source=str(path))


def one_line(error: ValidationError) -> str:
    """The first complaint of a failed validation: the field, what is allowed, what was given."""
    first, others = error.errors()[0], error.error_count() - 1
    parts = [f"[{part}]" if isinstance(part, int) else f".{part}" for part in first["loc"]]
    field = "".join(parts).removeprefix(".")  # for example walls[0].start
    message = first["msg"].removeprefix("Value error, ")
    if first["type"] == "value_error":
        said = message
    elif first["type"] in ("unexpected_keyword_argument", "extra_forbidden"):
        said = "unknown key"
    elif first["type"] in ("missing", "missing_argument"):
        said = "missing"
    else:
        said = f"{_short(first['input'])} is not allowed: {message[0].lower()}{message[1:]}"
    more = f" (and {others} more)" if others else ""
    return f"{field}: {said}{more}" if field else f"{said}{more}"


def _short(value: object) -> str:
    """The value as Python writes it, cut off after 60 characters."""
    text = repr(value)
    return text if len(text) <= 60 else text[:57] + "..."


def _without_none(value: Any) -> Any:
    """The value without keys whose value is None, for which TOML has no word."""
    if isinstance(value, dict):
        return {key: _without_none(item) for key, item in value.items() if item is not None}
    if isinstance(value, list | tuple):
        return [_without_none(item) for item in value]
    return value
