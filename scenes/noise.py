"""Everything random about a rollout, drawn from one seed.

Each rollout has a random stream of its own, keyed by seed, scene and rollout. What a rollout draws
therefore depends on nothing else: not on the number of rollouts, their order, the threads or the
action. The actions of a scene share the stream (common random numbers), so two actions never differ
by luck. A longer horizon only adds to the end of the stream.
"""

import math
from dataclasses import dataclass, fields
from statistics import NormalDist

import numpy as np

from scenes.arrays import FloatArray
from scenes.crowd import Crowd
from scenes.errors import InputError
from scenes.scene import Scene
from scenes.streams import rollout_stream

_TRUNCATION = 2.0  # how many standard deviations desired speeds and starts stray at most
_SLOWEST_WALK = 0.1  # least desired speed of a person who walks, m/s
_NOISE_STEP = 0.1  # step for which the standard deviation of the fluctuation is given, s
_STANDARD = NormalDist()


@dataclass(frozen=True)
class Noise:
    """How strongly each thing is shaken, as standard deviations; 0 leaves it undisturbed.

    Attributes:
        start: of each coordinate of a pedestrian's start, m; truncated at twice that.
        desired_speed: of a walker's desired speed, m/s; truncated at twice that (Helbing and Molnár
            1995, section III: 0.26 m/s about a mean of 1.34 m/s).
        goal: of each coordinate of a walker's goal, m.
        acceleration: of each component of a walker's acceleration, drawn anew for each step, m/s²:
            the fluctuation term of the social force model. It holds for steps of 0.1 s; for other
            steps it is scaled so that paths spread alike. At 0.5 m/s² one person in a thousand
            brushes against a robot that stands in plain view; at 1 m/s², one in forty.
        robot_speed: of the robot's speed relative to the speed it tries to drive, dimensionless.
        robot_turn: of the robot's turn rate while it drives at 1 m/s, rad/s; at other speeds it is
            proportional to the speed, so a robot that stands does not turn.
        robot_memory: correlation time of the robot's two errors, which are Ornstein-Uhlenbeck
            processes, s.

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
    """The random numbers of K rollouts over T steps, in physical units."""

    crowd: Crowd
    robot_speed: FloatArray  # [K, T], relative error of the robot's speed, dimensionless
    robot_turn: FloatArray  # [K, T], error of its turn rate at 1 m/s, rad/s


def disturb(
    scene: Scene, noise: Noise, rollouts: int, steps: int, dt: float, seed: int
) -> Disturbance:
    """Draw the noise of K rollouts of a scene over T steps of dt s; its number keys the noise."""
    people = len(scene.pedestrians)
    starts = np.empty((rollouts, people, 2))  # in standard deviations, until `_set_out`
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
    shake = noise.acceleration * math.sqrt(_NOISE_STEP / dt) * (crowd.desired_speeds > 0.0)
    errors = _correlate(errors, dt, noise.robot_memory)
    return Disturbance(
        crowd=crowd._replace(accelerations=shake[:, None, :, None] * fluctuations),
        robot_speed=noise.robot_speed * errors[..., 0],
        robot_turn=noise.robot_turn * errors[..., 1],
    )


def _set_out(
    scene: Scene, noise: Noise, starts: FloatArray, goals: FloatArray, speeds: FloatArray
) -> Crowd:
    """The crowd at time 0, from standardised random numbers; its fluctuations are still missing."""
    people = scene.pedestrians
    nominal_start = scene.starts
    nominal_goal = np.array([person.goal for person in people]).reshape(-1, 2)
    nominal_speed = np.array([person.desired_speed for person in people])
    walks = nominal_speed > 0.0

    start = nominal_start + noise.start * np.clip(starts, -_TRUNCATION, _TRUNCATION)
    speed = np.maximum(nominal_speed + noise.desired_speed * speeds, _SLOWEST_WALK)
    speed = np.where(walks, speed, 0.0)
    # The goal of a person who stands means nothing, but it must not be where the person is:
    # pysocialforce divides by the distance to the goal.
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
    return Crowd(start, velocity, goal, speed, np.zeros((len(starts), 0, len(people), 2)))


def _faster_by(recorded: FloatArray, difference: FloatArray) -> FloatArray:
    """A recorded velocity, [2], made faster by each difference, [K], in its direction: [K, 2]."""
    pace = float(np.hypot(*recorded))
    faster = np.maximum(pace + difference, 0.0) / pace if pace > 0.0 else np.zeros(len(difference))
    return faster[:, None] * recorded


def _truncated_normal(uniform: FloatArray) -> FloatArray:
    """Standard normal numbers within `_TRUNCATION`, by inversion of the distribution."""
    lowest = _STANDARD.cdf(-_TRUNCATION)
    within = lowest + (1.0 - 2.0 * lowest) * uniform
    return np.array([_STANDARD.inv_cdf(p) for p in within])


def _correlate(white: FloatArray, dt: float, memory: float) -> FloatArray:
    """Ornstein-Uhlenbeck processes of unit variance from white noise, [K, T, ...]."""
    kept = math.exp(-dt / memory) if memory > 0.0 else 0.0
    process = np.array(white)
    for step in range(1, white.shape[1]):
        process[:, step] = kept * process[:, step - 1] + math.sqrt(1.0 - kept**2) * white[:, step]
    return process
