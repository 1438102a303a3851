"""How the robot drives: a unicycle that obeys its command."""

import math
from dataclasses import dataclass

import numpy as np

from scenes.actions import MetaAction
from scenes.errors import InputError
from scenes.geometry import FloatArray, distance_to_segments
from scenes.noise import Disturbance
from scenes.scene import ROBOT_RADIUS, Scene


@dataclass(frozen=True)
class Limits:
    """What the motors can do.

    Attributes:
        acceleration: of the speed, m/s².
        turn_acceleration: of the turn rate, rad/s².

    Raises:
        InputError: if a limit is not positive.
    """

    acceleration: float = 1.0
    turn_acceleration: float = 2.0

    def __post_init__(self) -> None:
        for name in ("acceleration", "turn_acceleration"):
            value = getattr(self, name)
            if not (math.isfinite(value) and value > 0.0):
                raise InputError(f"limits {name}: {value!r} is not allowed: more than 0")


def drive(
    scene: Scene,
    actions: tuple[MetaAction, ...],
    disturbance: Disturbance,
    limits: Limits,
    dt: float,
) -> FloatArray:
    """Drive each action in each rollout.

    The robot takes up the commanded speed and turn rate within its limits; the noise acts on what
    the wheels make of it. A wall stops it for good: it stands where its disc first touches one.

    Returns:
        [A, K, T+1, 4]: x and y in m, heading in rad, speed in m/s.
    """
    rollouts, steps = disturbance.robot_speed.shape
    walls = scene.wall_segments
    command_v = np.array([action.speed for action in actions])[:, None]
    command_w = np.array([action.turn_rate for action in actions])[:, None]
    x, y = (np.full((len(actions), rollouts), coordinate) for coordinate in scene.robot.start)
    heading = np.full_like(x, scene.robot.start_heading)
    v, w = np.full_like(x, scene.robot.speed), np.zeros_like(x)
    blocked = np.zeros(x.shape, dtype=bool)
    path = np.empty((len(actions), rollouts, steps + 1, 4))
    path[:, :, 0] = np.stack([x, y, heading, v], axis=-1)
    for step in range(steps):
        v = np.clip(command_v, v - limits.acceleration * dt, v + limits.acceleration * dt)
        w = np.clip(command_w, w - limits.turn_acceleration * dt, w + limits.turn_acceleration * dt)
        driven = np.where(blocked, 0.0, v * np.maximum(1.0 + disturbance.robot_speed[:, step], 0.0))
        turned = np.where(blocked, 0.0, (w + driven * disturbance.robot_turn[:, step]) * dt)
        # The chord of the arc points along the heading halfway through the step.
        x = x + driven * dt * np.cos(heading + turned / 2)
        y = y + driven * dt * np.sin(heading + turned / 2)
        heading = heading + turned
        if len(walls):
            gap = distance_to_segments(np.stack([x, y], axis=-1), walls).min(axis=-1)
            blocked = blocked | (gap < ROBOT_RADIUS)
        path[:, :, step + 1] = np.stack([x, y, heading, np.where(blocked, 0.0, driven)], axis=-1)
    return path
