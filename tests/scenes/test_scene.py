"""Scenes: what they may be."""

import pytest
from pydantic import ValidationError

from scenes import Robot, Scene


def test_a_scene_cannot_be_changed() -> None:
    scene = Scene("mine", Robot((0.0, 0.0), (8.0, 0.0)))
    with pytest.raises(AttributeError):
        scene.name = "other"  # type: ignore[misc]


def test_a_scene_made_in_python_is_checked_too() -> None:
    with pytest.raises(ValidationError, match="names pedestrian 3"):
        Scene("wrong", Robot((0.0, 0.0), (8.0, 0.0)), groups=((3, 4),))
