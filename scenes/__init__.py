"""The world: scenes, rollouts, features and the outcome bank."""

from scenes.actions import META_ACTIONS, MetaAction
from scenes.errors import InputError
from scenes.families import FAMILIES, PATTERNS, load_scene, sample_scene
from scenes.features import FEATURES
from scenes.noise import NO_NOISE, Noise
from scenes.robot import Limits
from scenes.rollouts import Rollouts, simulate, warm_up
from scenes.scene import Pedestrian, Robot, Scene, Wall
from scenes.scene_text import scene_from_file, scene_from_toml, scene_to_toml
from scenes.tracks import busiest_frames, scene_from_tracks

__all__ = [
    "FAMILIES",
    "FEATURES",
    "META_ACTIONS",
    "NO_NOISE",
    "PATTERNS",
    "InputError",
    "Limits",
    "MetaAction",
    "Noise",
    "Pedestrian",
    "Robot",
    "Rollouts",
    "Scene",
    "Wall",
    "busiest_frames",
    "load_scene",
    "sample_scene",
    "scene_from_file",
    "scene_from_toml",
    "scene_from_tracks",
    "scene_to_toml",
    "simulate",
    "warm_up",
]
