"""The world: scenes, rollouts, features and the outcome bank."""

from scenes.actions import META_ACTIONS, MetaAction
from scenes.errors import InputError
from scenes.features import FEATURES
from scenes.noise import NO_NOISE, Noise
from scenes.robot import Limits
from scenes.rollouts import Rollouts, simulate
from scenes.scene import Pedestrian, Robot, Scene, Wall, scene_from_toml, scene_to_toml

__all__ = [
    "FEATURES",
    "META_ACTIONS",
    "NO_NOISE",
    "InputError",
    "Limits",
    "MetaAction",
    "Noise",
    "Pedestrian",
    "Robot",
    "Rollouts",
    "Scene",
    "Wall",
    "scene_from_toml",
    "scene_to_toml",
    "simulate",
]
