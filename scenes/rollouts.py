"""Simulate a scene under each action, many times."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from scenes.actions import MetaAction
from scenes.geometry import FloatArray
from scenes.scene import Scene

Model = Literal["extended", "helbing-molnar"]
Engine = Literal["batched", "pysocialforce"]


@dataclass(frozen=True)
class Rollouts:
    """K rollouts of one scene under each of A actions, over T steps, among P pedestrians.

    Attributes:
        scene: what was simulated.
        actions: the A actions, in the order of axis A.
        seed: seed of the noise.
        model: force set.
        engine: which engine ran.
        wrap_angles: whether angles between directions were wrapped.
        dt: length of a step, s.
        robot: [A, K, T+1, 3]: x and y in m, heading in rad.
        pedestrians: [A, K, T+1, P, 2], m.
        without_robot: [K, T+1, P, 2], m: the same people under the same noise had the robot not
            been there.
        features: [A, K, 5], scaled, in the order of `FEATURES`.
        clearance_m: [A, K]: smallest gap between robot and any pedestrian, m.
        deviation_m: [A, K]: mean distance of the pedestrians from their paths without the robot, m.
        progress_m: [A, K]: how much closer the robot got to its goal, m.
        contact_step: [A, K]: first step at which the robot touches a pedestrian or a wall;
            -1 if it never does.
    """

    scene: Scene
    actions: tuple[MetaAction, ...]
    seed: int
    model: Model
    engine: Engine
    wrap_angles: bool
    dt: float
    robot: FloatArray
    pedestrians: FloatArray
    without_robot: FloatArray
    features: FloatArray
    clearance_m: FloatArray
    deviation_m: FloatArray
    progress_m: FloatArray
    contact_step: NDArray[np.int64]
