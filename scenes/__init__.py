"""The world: scenes, rollouts, features and the outcome bank."""

from scenes.actions import META_ACTIONS, MetaAction
from scenes.errors import InputError
from scenes.features import FEATURES
from scenes.rollouts import Rollouts
from scenes.scene import Pedestrian, Robot, Scene, Wall, scene_from_toml, scene_to_toml

__all__ = [
    "FEATURES",
    "META_ACTIONS",
    "InputError",
    "MetaAction",
    "Pedestrian",
    "Robot",
    "Rollouts",
    "Scene",
    "Wall",
    "scene_from_toml",
    "scene_to_toml",
]
