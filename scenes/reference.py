"""The reference engine: pysocialforce itself, one rollout after another.

It is slow, and the batched engine is measured by it. Where the library's arithmetic is wrong (see
`scenes.simulate`), subclasses here put it right if `wrap_angles` asks for it; the rest is the
library's own code.
"""

import logging
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np

from scenes.arrays import FloatArray
from scenes.crowd import Crowd, ForceSet, Surroundings
from scenes.forces import MAX_SPEED_FACTOR, SMALLEST_ANGLE


@contextmanager
def _unheard() -> Iterator[None]:
    """Keep the side effects of importing pysocialforce away from the user.

    Its import sets the root logger to DEBUG, adds two handlers to it, opens `file.log` in the
    working directory and loads matplotlib, which is not needed here.
    """
    root = logging.getLogger()
    level, handlers, open_file = root.level, list(root.handlers), logging.FileHandler
    hidden = [name for name in ("matplotlib", "matplotlib.pyplot") if name not in sys.modules]
    logging.FileHandler = lambda *_args, **_keywords: logging.NullHandler()  # type: ignore[assignment, misc]
    sys.modules.update(dict.fromkeys(hidden))  # type: ignore[arg-type]  # None hides a module
    try:
        yield
    finally:
        logging.FileHandler = open_file  # type: ignore[misc]
        root.setLevel(level)
        root.handlers[:] = handlers
        for name in hidden:
            del sys.modules[name]


with _unheard():
    import pysocialforce
    from pysocialforce import forces as library
    from pysocialforce.fieldofview import FieldOfView
    from pysocialforce.potentials import PedPedPotential, PedSpacePotential
    from pysocialforce.utils import stateutils


class Fluctuation(library.Force):  # type: ignore[misc]
    """The recorded noise of one rollout, as one more force."""

    def __init__(self, accelerations: FloatArray) -> None:
        """Take [T, agents, 2], m/s²."""
        super().__init__()
        self.steps = iter(accelerations)

    def _get_force(self) -> FloatArray:
        return next(self.steps)


class SocialForce(library.SocialForce):  # type: ignore[misc]
    """The library's social force with the angle taken from cross and dot product."""

    def _get_force(self) -> FloatArray:
        apart = stateutils.each_diff(self.peds.pos())  # own position minus the other's
        towards, distance = stateutils.normalize(apart)
        closing = -1.0 * stateutils.each_diff(self.peds.vel())
        interaction = self.config("lambda_importance") * closing + towards
        direction, length = stateutils.normalize(interaction)
        cross = towards[:, 0] * direction[:, 1] - towards[:, 1] * direction[:, 0]
        angle = np.arctan2(cross, np.sum(towards * direction, axis=1))
        angle[np.abs(angle) <= SMALLEST_ANGLE] = 0.0
        reach = self.config("gamma") * length
        brake = np.exp(-distance / reach - np.square(self.config("n_prime") * reach * angle))
        turn = np.exp(-distance / reach - np.square(self.config("n") * reach * angle))
        turn = (np.sign(angle) * turn)[:, None] * stateutils.left_normal(direction)
        force = brake[:, None] * direction - turn
        total: FloatArray = np.sum(force.reshape((self.peds.size(), -1, 2)), axis=1) * self.factor
        return total


class GroupCoherenceForceAlt(library.GroupCoherenceForceAlt):  # type: ignore[misc]
    """The library's coherence force, softened by the distance to the group's centre.

    The library takes that distance from columns of its state that are not there, and gets 0.
    """

    def _get_force(self) -> FloatArray:
        forces = np.zeros((self.peds.size(), 2))
        for group in self.peds.groups:
            places = self.peds.pos()[group, :]
            to_centre = places.mean(axis=0) - places
            distance = np.linalg.norm(to_centre, axis=-1, keepdims=True)
            forces[group] += to_centre * (np.tanh(distance - (len(group) - 1) / 2) + 1) / 2
        total: FloatArray = forces * self.factor
        return total


class MendedPotential(PedPedPotential):  # type: ignore[misc]
    """The library's potential, given only directions where the library also gives distances."""

    def value_r_ab(self, r_ab: FloatArray, speeds: FloatArray, directions: Any) -> Any:
        """Potential at each r_ab; `directions` is the library's pair of directions, distances."""
        return super().value_r_ab(r_ab, speeds, directions[0])


class SmoothPotential(MendedPotential):
    """The mended potential with its analytic gradient in place of one-sided differences."""

    def grad_r_ab(self, state: FloatArray, delta: float = 0.0) -> FloatArray:  # noqa: ARG002
        """Gradient with respect to r_ab, [agents, agents, 2]; see `scenes.forces.pair`."""
        r = self.r_ab(state)
        directions = stateutils.desired_directions(state)
        step = self.delta_t * stateutils.speeds(state)[None, :, None] * directions[0][None]
        near = np.linalg.norm(r, axis=-1, keepdims=True)
        far = np.linalg.norm(r - step, axis=-1, keepdims=True)
        b = self.b(r, stateutils.speeds(state), directions[0])[..., None]
        with np.errstate(invalid="ignore"):
            outward = np.nan_to_num(r / near) + np.nan_to_num((r - step) / far)
        slope = -self.v0 / self.sigma * np.exp(-b / self.sigma)
        gradient: FloatArray = slope * (near + far) / (4.0 * np.maximum(b, 1e-9)) * outward
        gradient[np.diag_indices(len(gradient))] = 0.0
        return gradient


class PedRepulsiveForce(library.PedRepulsiveForce):  # type: ignore[misc]
    """The library's force between people, on a potential that works."""

    def __init__(self, potential: type[PedPedPotential]) -> None:
        """Take the potential whose gradient is the force."""
        super().__init__()
        self.potential = potential

    def _get_force(self) -> FloatArray:
        potential = self.potential(
            self.peds.step_width, v0=self.config("v0"), sigma=self.config("sigma")
        )
        force = -1.0 * potential.grad_r_ab(self.peds.state)
        view = FieldOfView(phi=self.config("fov_phi"), out_of_view_factor=self.config("fov_factor"))
        weight = np.expand_dims(view(self.peds.desired_directions(), -force), -1)
        total: FloatArray = np.sum(weight * force, axis=1) * self.factor
        return total


class SmoothSpacePotential(PedSpacePotential):  # type: ignore[misc]
    """The potential of walls with its analytic gradient."""

    def grad_r_aB(self, state: FloatArray, delta: float = 0.0) -> FloatArray:  # noqa: ARG002, N802
        """Gradient with respect to r_aB, [agents, walls, 2]; see `scenes.forces.wall_gradient`."""
        r = self.r_aB(state)
        distance = np.linalg.norm(r, axis=-1, keepdims=True)
        gradient: FloatArray = -self.u0 / self.r * np.exp(-distance / self.r) * r / distance
        return gradient


class SpaceRepulsiveForce(library.SpaceRepulsiveForce):  # type: ignore[misc]
    """The library's force of walls on the smooth potential."""

    def _get_force(self) -> FloatArray:
        potential = SmoothSpacePotential(
            self.scene.get_obstacles(), u0=self.config("u0"), r=self.config("r")
        )
        force = -1.0 * potential.grad_r_aB(self.peds.state)
        total: FloatArray = np.sum(force, axis=1) * self.factor
        return total


def _force_set(model: ForceSet, wrap_angles: bool) -> list[Any]:
    # A force reads its settings from the section that has the name of its class, so the classes
    # above bear the library's names.
    if model == "extended":
        return [
            library.DesiredForce(),
            SocialForce() if wrap_angles else library.SocialForce(),
            library.ObstacleForce(),
            GroupCoherenceForceAlt() if wrap_angles else library.GroupCoherenceForceAlt(),
            library.GroupRepulsiveForce(),
            library.GroupGazeForceAlt(),
        ]
    return [
        library.GoalAttractiveForce(),
        PedRepulsiveForce(SmoothPotential if wrap_angles else MendedPotential),
        SpaceRepulsiveForce() if wrap_angles else library.SpaceRepulsiveForce(),
    ]


def walk(
    crowd: Crowd,
    surroundings: Surroundings,
    robots: FloatArray,
    model: ForceSet,
    wrap_angles: bool,
    dt: float,
) -> FloatArray:
    """Let the crowd walk, once for each robot path; see `scenes.batched.walk`."""
    paths = np.empty((*robots.shape[:2], crowd.steps + 1, crowd.people, 2))
    if crowd.people == 0:
        return paths
    for action, rollout in np.ndindex(*robots.shape[:2]):
        paths[action, rollout] = _walk_once(
            crowd, rollout, surroundings, robots[action, rollout], model, wrap_angles, dt
        )
    return paths


def _walk_once(
    crowd: Crowd,
    rollout: int,
    surroundings: Surroundings,
    robots: FloatArray,
    model: ForceSet,
    wrap_angles: bool,
    dt: float,
) -> FloatArray:
    people, agents = crowd.people, crowd.people + robots.shape[1]
    state = np.zeros((agents, 6))
    state[:people, 0:2] = crowd.starts[rollout]
    state[:people, 2:4] = crowd.velocities[rollout]
    state[:people, 4:6] = crowd.goals[rollout]
    state[people:] = _robot_rows(robots[0])
    simulator = pysocialforce.Simulator(state, groups=[list(g) for g in surroundings.groups])
    simulator.env._obstacles = list(surroundings.wall_points)

    # The library takes people's initial speed, or 1.3 times it, for their desired speed; here
    # people have a desired speed of their own and may set out at another.
    desired = np.concatenate([crowd.desired_speeds[rollout], np.zeros(agents - people)])
    drawn_to_cap = model == "extended"
    simulator.peds.initial_speeds = desired / MAX_SPEED_FACTOR if drawn_to_cap else desired
    simulator.peds.max_speeds = MAX_SPEED_FACTOR * simulator.peds.initial_speeds
    simulator.peds.step_width = dt

    shaken = np.zeros((crowd.steps, agents, 2))
    shaken[:, :people] = crowd.accelerations[rollout]
    simulator.forces = [*_force_set(model, wrap_angles), Fluctuation(shaken)]
    for force in simulator.forces:
        force.init(simulator, simulator.config)

    path = np.empty((crowd.steps + 1, people, 2))
    path[0] = crowd.starts[rollout]
    # For a person who stands still, the library divides zero by zero.
    with np.errstate(divide="ignore", invalid="ignore"):
        for step in range(crowd.steps):
            simulator.step_once()
            simulator.peds.state[people:, :6] = _robot_rows(robots[step + 1])
            path[step + 1] = simulator.peds.state[:people, 0:2]
    return path


def _robot_rows(robots: FloatArray) -> FloatArray:
    """The library's state of robots, [R, 6]; a robot's goal is always one metre ahead of it."""
    ahead = np.stack([np.cos(robots[:, 2]), np.sin(robots[:, 2])], axis=-1)
    return np.concatenate([robots[:, :2], robots[:, 3:4] * ahead, robots[:, :2] + ahead], axis=-1)
