"""How the robot drives: a unicycle that obeys its command."""

import math
from dataclasses import dataclass

import numpy as np

from scenes.actions import MetaAction
from scenes.arrays import FloatArray
from scenes.errors import InputError
from scenes.geometry import distance_to_walls, lengths
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

    The robot takes up the commanded speed and turn rate as fast as its limits allow; the noise acts
    on the speed and turn rate that its motors reach. A wall stops the robot for good: it stands
    where its disc first touches one.

    Returns:
        [A, K, T+1, 4]: x and y in m, heading in rad, speed in m/s.
    """
    robot = scene.robot
    time = dt * np.arange(1, disturbance.robot_speed.shape[1] + 1)  # (T,)
    command_v = np.array([[action.speed] for action in actions])  # (A, 1)
    command_w = np.array([[action.turn_rate] for action in actions])
    reach_v, reach_w = limits.acceleration * time, limits.turn_acceleration * time
    v = np.clip(command_v, robot.speed - reach_v, robot.speed + reach_v)[:, None]  # (A, 1, T)
    w = np.clip(command_w, -reach_w, reach_w)[:, None]

    driven = v * np.maximum(1.0 + disturbance.robot_speed, 0.0)  # (A, K, T)
    turned = (w + driven * disturbance.robot_turn) * dt
    heading = robot.start_heading + np.cumsum(turned, axis=-1)
    # The chord of each arc points along the heading halfway through the step.
    x = robot.start[0] + np.cumsum(driven * dt * np.cos(heading - turned / 2), axis=-1)
    y = robot.start[1] + np.cumsum(driven * dt * np.sin(heading - turned / 2), axis=-1)

    free = np.empty((*driven.shape[:2], len(time) + 1, 4))
    free[:, :, 0] = (*robot.start, robot.start_heading, robot.speed)
    free[:, :, 1:] = np.stack([x, y, heading, driven], axis=-1)
    return _stopped_by_walls(free, scene.wall_segments)


def _stopped_by_walls(path: FloatArray, walls: FloatArray) -> FloatArray:
    """The path up to where the robot first touches a wall; there the robot stays.

    Steps longer than the robot's radius are checked in pieces, so that none jumps over a wall.
    """
    if not len(walls):
        return path
    moves = lengths(np.diff(path[..., :2], axis=2)).max(initial=0.0)
    pieces = max(1, math.ceil(moves / ROBOT_RADIUS))
    fine = path
    if pieces > 1:
        share = np.arange(pieces)[:, None] / pieces
        between = path[:, :, :-1, None] * (1.0 - share) + path[:, :, 1:, None] * share
        fine = np.concatenate([between.reshape(*path.shape[:2], -1, 4), path[:, :, -1:]], axis=2)
    touches = distance_to_walls(fine[..., :2], walls) < ROBOT_RADIUS
    last = np.where(touches.any(axis=-1), touches.argmax(axis=-1), fine.shape[2])  # (A, K)
    place = np.minimum(np.arange(path.shape[2]) * pieces, last[..., None])  # (A, K, T+1)
    stopped = np.take_along_axis(fine, place[..., None], axis=2)
    stopped[place == last[..., None], 3] = 0.0
    return stopped
