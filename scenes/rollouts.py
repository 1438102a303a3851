"""Rollouts: a scene simulated many times under each action."""

import math
from dataclasses import dataclass, fields, replace
from functools import partial
from typing import Literal, get_args

import numpy as np

from scenes.actions import META_ACTIONS, MetaAction
from scenes.arrays import FloatArray
from scenes.crowd import ForceSet, Walk, surroundings_of
from scenes.errors import LARGEST_SEED, InputError, check_whole
from scenes.features import Outcomes, describe
from scenes.noise import Noise, disturb
from scenes.robot import Limits, drive
from scenes.scene import Pedestrian, Robot, Scene

Engine = Literal["batched", "pysocialforce"]
"""`batched` is compiled; `pysocialforce` is the library itself, the slow reference."""

DEFAULT_STEP = 0.1
"""Length of a step, s."""

MOST_ROLLOUTS = 10_000
"""Most rollouts of one action."""

MOST_POSITIONS = 100_000_000
"""Most positions of people in one simulation; with all they lead to, they fill about 5 GB."""

LONGEST_HORIZON = 60.0
"""Longest simulated time, s: no robot holds one command for longer."""


@dataclass(frozen=True, kw_only=True)
class Rollouts(Outcomes):
    """K rollouts of one scene under each of A actions, over T steps, among P pedestrians.

    They have the `features` and all else that `scenes.features.Outcomes` describes, and what
    `simulate` was given. The paths may be kept of the first M rollouts only, since thousands of
    them can neither be looked at nor kept in a small file; M is K unless `keep_paths` says so.

    Attributes:
        robot: [A, M, T+1, 3]: x and y in m, heading in rad.
        pedestrians: [A, M, T+1, P, 2], m.
        without_robot: [M, T+1, P, 2], m: the same people under the same noise without the robot.
    """

    scene: Scene
    actions: tuple[MetaAction, ...]
    seed: int
    noise: Noise
    limits: Limits
    model: ForceSet
    engine: Engine
    wrap_angles: bool
    dt: float
    robot: FloatArray
    pedestrians: FloatArray
    without_robot: FloatArray

    def __repr__(self) -> str:
        # arrays would fill pages
        sizes = f"{len(self.actions)} actions × {self.count} rollouts × {self.steps} steps"
        people = f"{len(self.scene.pedestrians)} pedestrians"
        return f"<Rollouts of {self.scene.name}: {sizes}, {people}, seed {self.seed}>"

    @property
    def paths(self) -> int:
        """Of how many rollouts of each action the paths are kept, M."""
        return int(self.robot.shape[1])

    @property
    def steps(self) -> int:
        """How many steps a rollout has, T."""
        return int(self.robot.shape[2]) - 1

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the A actions, in the order of axis A."""
        return tuple(action.name for action in self.actions)

    @property
    def horizon(self) -> float:
        """Simulated time, s."""
        return float(self.steps * self.dt)

    def keep_paths(self, count: int) -> "Rollouts":
        """The same rollouts, of which only the first `count` of each action keep their paths."""
        return replace(
            self,
            robot=self.robot[:, :count],
            pedestrians=self.pedestrians[:, :count],
            without_robot=self.without_robot[:count],
        )

    def with_paths(self) -> "Rollouts":
        """The rollouts whose paths are kept, as if there were no others: K is M in them."""
        if self.paths == self.count:
            return self
        kept = {each.name: getattr(self, each.name)[:, : self.paths] for each in fields(Outcomes)}
        return replace(self, **kept)


def simulate(
    scene: Scene,
    actions: tuple[MetaAction, ...] = META_ACTIONS,
    rollouts: int = 50,
    seed: int = 0,
    engine: Engine = "batched",
    noise: Noise = Noise(),  # noqa: B008  # frozen
    *,
    model: ForceSet = "extended",
    horizon: float = 4.0,
    dt: float = DEFAULT_STEP,
    wrap_angles: bool = True,
    limits: Limits = Limits(),  # noqa: B008  # frozen
    threads: int | None = None,
) -> Rollouts:
    """Simulate a scene under each action, and once more without the robot.

    The people follow the social force model and see the robot as one more person; the robot obeys
    its command. Both engines give the same rollouts from the same noise.

    Args:
        scene: what to simulate.
        actions: the commands to try.
        rollouts: K, for each action; the k-th rollout of every action has the same noise.
        seed: seed of the noise.
        engine: who computes.
        noise: how strongly everything is shaken.
        model: force set of the social force model.
        horizon: simulated time, s.
        dt: length of a step, s.
        wrap_angles: True is right physics: angles between directions are taken around the circle,
            gradients are exact, and a group pulls more on a member who has strayed further, so a
            rotated or mirrored scene gives rotated or mirrored paths. False repeats pysocialforce
            1.1.2 digit for digit: it subtracts two arctangents without wrapping, takes gradients by
            one-sided differences of 1 mm, and softens coherence by a distance that is always 0.
        limits: what the robot's motors can do.
        threads: how many the batched engine uses; None is one per processor. The result is the
            same.

    Raises:
        InputError: if an argument is out of range.
    """
    steps = _check(scene, actions, rollouts, seed, engine, model, horizon, dt, threads)
    disturbance = disturb(scene, noise, rollouts, steps, dt, seed)
    driven = drive(scene, actions, disturbance, limits, dt)  # (A, K, T+1, 4)
    no_robot = np.empty((1, rollouts, steps + 1, 0, 4))
    crowd, surroundings, walk = disturbance.crowd, surroundings_of(scene), _walk_of(engine, threads)
    pedestrians = walk(crowd, surroundings, driven[:, :, :, None], model, wrap_angles, dt)
    without_robot = walk(crowd, surroundings, no_robot, model, wrap_angles, dt)[0]
    robot = driven[..., :3]
    outcomes = describe(scene, robot, pedestrians, without_robot, dt)
    for array in (robot, pedestrians, without_robot, *vars(outcomes).values()):
        array.setflags(write=False)
    return Rollouts(
        scene=scene,
        actions=actions,
        seed=seed,
        noise=noise,
        limits=limits,
        model=model,
        engine=engine,
        wrap_angles=wrap_angles,
        dt=dt,
        robot=robot,
        pedestrians=pedestrians,
        without_robot=without_robot,
        **vars(outcomes),
    )


def warm_up(engine: Engine) -> None:
    """Compile an engine, which takes seconds on its first use, by simulating a tiny scene."""
    person = Pedestrian(start=(2.0, 1.0), goal=(-9.0, 1.0))
    scene = Scene("warm_up", Robot(start=(0.0, 0.0), goal=(9.0, 0.0)), (person,))
    simulate(scene, rollouts=1, engine=engine, horizon=0.1)


def _walk_of(engine: Engine, threads: int | None) -> Walk:
    """How an engine lets people walk.

    Engines are imported here, because whoever only draws or reads scenes needs no compiler.
    """
    if engine == "batched":
        from scenes import batched

        return partial(batched.walk, threads=threads)
    from scenes import reference

    return reference.walk


def _check(
    scene: Scene,
    actions: tuple[MetaAction, ...],
    rollouts: int,
    seed: int,
    engine: str,
    model: str,
    horizon: float,
    dt: float,
    threads: int | None,
) -> int:
    """Check what `simulate` was given, and return the number of steps."""
    if not actions:
        raise InputError("actions: none given, at least one is needed")
    names = [action.name for action in actions]
    if len(set(names)) < len(names):
        raise InputError(f"actions: {', '.join(names)}: every action needs a name of its own")
    check_whole("rollouts", rollouts, 1, MOST_ROLLOUTS)
    check_whole("seed", seed, 0, LARGEST_SEED)
    if threads is not None:
        check_whole("threads", threads, 1, 1024)
    if engine not in get_args(Engine):
        raise InputError(f"engine: {engine!r} is not known: {', '.join(get_args(Engine))}")
    if model not in get_args(ForceSet):
        raise InputError(f"model: {model!r} is not known: {', '.join(get_args(ForceSet))}")
    if not (math.isfinite(dt) and 0.001 <= dt <= 0.5):
        raise InputError(f"dt: {dt} s is not allowed: 0.001 to 0.5 s")
    if not (math.isfinite(horizon) and dt <= horizon <= LONGEST_HORIZON):
        raise InputError(f"horizon: {horizon} s is not allowed: {dt:g} to {LONGEST_HORIZON:g} s")
    steps = round(horizon / dt)
    if abs(steps * dt - horizon) > 1e-6:
        raise InputError(f"horizon: {horizon} s is not allowed: a multiple of the step, {dt:g} s")
    positions = len(actions) * rollouts * (steps + 1) * len(scene.pedestrians)
    if positions > MOST_POSITIONS:
        raise InputError(
            f"actions × rollouts × steps × pedestrians: {positions:,} is not allowed: at most "
            f"{MOST_POSITIONS:,}; take fewer rollouts or a shorter horizon"
        )
    return steps
