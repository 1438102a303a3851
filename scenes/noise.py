"""Everything random about a rollout, drawn from one seed.

Each rollout has a random stream of its own: Philox, a counter-based generator (Salmon et al.,
"Parallel random numbers: as easy as 1, 2, 3", SC 2011), keyed by seed, scene and rollout. What a
rollout draws therefore depends on nothing else: not on how many rollouts there are, in what
order, on how many threads, or under which action. The actions of a scene share it (common random
numbers), so a difference between two actions is never a difference of luck. A longer horizon only
adds to the end of the stream.
"""

import math
from dataclasses import dataclass, fields
from statistics import NormalDist

import numpy as np

from scenes.arrays import FloatArray
from scenes.crowd import Crowd
from scenes.errors import InputError
from scenes.scene import Scene

TRUNCATION = 2.0
"""Desired speeds and starts stay within this many standard deviations, dimensionless."""

SLOWEST_WALK = 0.1
"""A person who walks never wants to be slower than this, m/s."""

NOISE_STEP = 0.1
"""Step for which the sd of the acceleration fluctuation is given, s."""

_STANDARD = NormalDist()


@dataclass(frozen=True)
class Noise:
    """How strongly each thing is shaken: standard deviations, 0 for not at all.

    Attributes:
        start: of each coordinate of a pedestrian's start, m; truncated at two sd.
        desired_speed: of a walker's desired speed, m/s; truncated at two sd (Helbing and Molnár
            1995, section III: 0.26 m/s about a mean of 1.34 m/s).
        goal: of each coordinate of a walker's goal, m.
        acceleration: of each component of a walker's acceleration, anew each step of 0.1 s, m/s²:
            the fluctuation term of the social force model. Other steps scale it so that the
            paths spread alike. At 0.5 m/s² one person in a thousand brushes against a robot
            that stands in plain view; at 1 m/s², one in forty.
        robot_speed: of the robot's speed relative to the speed it tries to drive, dimensionless.
        robot_turn: of the robot's turn rate while it drives at 1 m/s, rad/s; in proportion at other
            speeds, so a robot that stands does not turn.
        robot_memory: time over which the robot's errors stay alike, s; they are
            Ornstein-Uhlenbeck processes.

    Raises:
        InputError: if a value is negative or not finite.
    """

    start: float = 0.05
    desired_speed: float = 0.26
    goal: float = 0.5
    acceleration: float = 0.5
    robot_speed: float = 0.1
    robot_turn: float = 0.1
    robot_memory: float = 1.0

    def __post_init__(self) -> None:
        for field in fields(self):
            value = getattr(self, field.name)
            if not (math.isfinite(value) and 0.0 <= value <= 100.0):
                raise InputError(f"noise {field.name}: {value!r} is not allowed: 0 to 100")


NO_NOISE = Noise(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Disturbance:
    """The random numbers of K rollouts over T steps, in physical units.

    Attributes:
        crowd: how the people set out, and their fluctuations.
        robot_speed: [K, T], relative error of the robot's speed, dimensionless.
        robot_turn: [K, T], error of its turn rate at 1 m/s, rad/s.
    """

    crowd: Crowd
    robot_speed: FloatArray
    robot_turn: FloatArray


def disturb(
    scene: Scene, noise: Noise, rollouts: int, steps: int, dt: float, seed: int
) -> Disturbance:
    """Draw the noise of all rollouts of a scene.

    Args:
        scene: what is shaken; its number keys the noise.
        noise: how strongly.
        rollouts: K.
        steps: T.
        dt: length of a step, s.
        seed: 0 to 2⁶³ - 1.
    """
    people = len(scene.pedestrians)
    starts = np.empty((rollouts, people, 2))  # standard deviations, for now
    goals = np.empty((rollouts, people, 2))
    speeds = np.empty((rollouts, people))
    fluctuations = np.empty((rollouts, steps, people, 2))
    errors = np.empty((rollouts, steps, 2))
    for k in range(rollouts):
        stream = rollout_stream(seed, scene.number, k)
        starts[k] = stream.standard_normal((people, 2))
        goals[k] = stream.standard_normal((people, 2))
        speeds[k] = _truncated_normal(stream.random(people))
        each_step = stream.standard_normal((steps, people + 1, 2))
        errors[k], fluctuations[k] = each_step[:, 0], each_step[:, 1:]

    crowd = _set_out(scene, noise, starts, goals, speeds)
    shake = noise.acceleration * math.sqrt(NOISE_STEP / dt) * (crowd.desired_speeds > 0.0)
    errors = _correlate(errors, dt, noise.robot_memory)
    return Disturbance(
        crowd=Crowd(
            crowd.starts,
            crowd.velocities,
            crowd.goals,
            crowd.desired_speeds,
            shake[:, None, :, None] * fluctuations,
        ),
        robot_speed=noise.robot_speed * errors[..., 0],
        robot_turn=noise.robot_turn * errors[..., 1],
    )


def rollout_stream(seed: int, scene_number: int, rollout: int) -> np.random.Generator:
    """The random stream of one rollout of one scene."""
    key = np.array([seed, scene_number << 32 | rollout], dtype=np.uint64)
    return np.random.Generator(np.random.Philox(key=key))


def _set_out(
    scene: Scene, noise: Noise, starts: FloatArray, goals: FloatArray, speeds: FloatArray
) -> Crowd:
    """The crowd at time 0, from standardised random numbers; no fluctuation yet."""
    people = scene.pedestrians
    rollouts = len(starts)
    nominal_start = scene.starts
    nominal_goal = np.array([person.goal for person in people]).reshape(-1, 2)
    nominal_speed = np.array([person.desired_speed for person in people])
    walks = nominal_speed > 0.0

    start = nominal_start + noise.start * np.clip(starts, -TRUNCATION, TRUNCATION)
    speed = np.maximum(nominal_speed + noise.desired_speed * speeds, SLOWEST_WALK)
    speed = np.where(walks, speed, 0.0)
    # Where a person who stands would like to go means nothing, but it must not be where the person
    # is: a direction of length zero is not a number in pysocialforce.
    goal = np.where(
        walks[:, None], nominal_goal + noise.goal * goals, nominal_start + np.array([1.0, 0.0])
    )
    towards = goal - start
    towards = towards / np.maximum(np.linalg.norm(towards, axis=-1, keepdims=True), 1e-12)
    velocity = speed[..., None] * towards
    for index, person in enumerate(people):
        if person.velocity is not None and walks[index]:
            velocity[:, index] = _faster_by(
                np.array(person.velocity), speed[:, index] - nominal_speed[index]
            )
    nothing = np.zeros((rollouts, 0, len(people), 2))
    return Crowd(start, velocity, goal, speed, nothing)


def _faster_by(recorded: FloatArray, difference: FloatArray) -> FloatArray:
    """A recorded velocity, [2], faster by each difference, [K], in the same direction, [K, 2]."""
    pace = float(np.hypot(*recorded))
    faster = np.maximum(pace + difference, 0.0) / pace if pace > 0.0 else np.zeros(len(difference))
    return faster[:, None] * recorded


def _truncated_normal(uniform: FloatArray) -> FloatArray:
    """Standard normal numbers within `TRUNCATION`, by inversion of the distribution."""
    lowest = _STANDARD.cdf(-TRUNCATION)
    within = lowest + (1.0 - 2.0 * lowest) * uniform
    return np.array([_STANDARD.inv_cdf(p) for p in within])


def _correlate(white: FloatArray, dt: float, memory: float) -> FloatArray:
    """Ornstein-Uhlenbeck processes of unit variance from white noise, [K, T, ...]."""
    kept = math.exp(-dt / memory) if memory > 0.0 else 0.0
    process = np.array(white)
    for step in range(1, white.shape[1]):
        process[:, step] = kept * process[:, step - 1] + math.sqrt(1.0 - kept**2) * white[:, step]
    return process
