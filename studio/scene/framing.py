"""Which part of the world a view shows, and who is in it."""

import math
from dataclasses import dataclass

import numpy as np

from scenes import Rollouts
from studio.arrays import BoolArray, Bounds, FloatArray

SURROUNDINGS = 1.6  # beyond everywhere the robot gets, where there is anything to see, m
MARGIN = 0.4  # from the outermost thing in the view to its edge, m
NEAR = 3.0  # who comes closer to a path of the robot than this is in view at the start, m

_EVERY = 4  # of the steps of a path, enough to tell who comes near: 1 cm too far away at most


@dataclass(frozen=True)
class Beyond:
    """People who start out of a view, all beyond the same edge of it."""

    count: int  # how many there are
    place: tuple[float, float]  # on the edge, where they are on average (x, y), m
    direction: tuple[float, float]  # out of the view (x, y): a unit vector along x or y


def comes_near(rollouts: Rollouts) -> BoolArray:
    """Who comes within `NEAR` of a path of the robot in any rollout under any action, [P].

    What counts is the whole path, whenever the robot is where: somebody who crosses it before the
    robot comes is part of what happens.
    """
    robot, people = rollouts.robot[..., :2], rollouts.pedestrians
    # most come near while the robot is there, which is quick to tell
    near = _any_near(robot[:, :, ::_EVERY, None], people[:, :, ::_EVERY])
    paths = robot[:, :, ::_EVERY, None, None]  # (A, M, T', 1, 1, 2)
    for person in np.flatnonzero(~near):
        near[person] = _any_near(paths, people[:, :, None, ::2, person : person + 1])[0]
    return near


def _any_near(robot: FloatArray, people: FloatArray) -> BoolArray:
    """Which people [..., P, 2] are ever within `NEAR` of the robot, [..., 1, 2], m, [P]."""
    squares = np.sum((people - robot) ** 2, axis=-1)  # (..., P)
    near: BoolArray = np.any(squares < NEAR**2, axis=tuple(range(squares.ndim - 1)))
    return near


def bounds_to_show(rollouts: Rollouts) -> Bounds:
    """The least that a view of a scene shows under all actions of the rollouts.

    It shows everywhere the robot gets, what of the scene lies near to that, and where everybody
    starts who comes near a path of the robot. Where there are people, one of them is in view at the
    end of every rollout.
    """
    paths = rollouts.robot[..., :2].reshape(-1, 2)
    low, high = paths.min(axis=0), paths.max(axis=0)
    x0, y0, x1, y1 = rollouts.scene.bounds
    low = np.maximum(np.minimum(low, (x0, y0)), low - SURROUNDINGS) - MARGIN
    high = np.minimum(np.maximum(high, (x1, y1)), high + SURROUNDINGS) + MARGIN
    bounds = _grown((*low.tolist(), *high.tolist()), rollouts.scene.starts[comes_near(rollouts)])
    return _grown(bounds, _lonely_ends(rollouts, bounds))


def bounds_of_shape(rollouts: Rollouts, width: float, height: float) -> Bounds:
    """The bounds to show, grown in one direction until they have the shape of width to height.

    They grow towards the robot's goal and towards where the other people start.
    """
    x0, y0, x1, y1 = bounds_to_show(rollouts)
    low, high = np.array([x0, y0]), np.array([x1, y1])
    shape = np.array([width, height])
    half = shape * ((high - low) / shape).max() / 2
    scene = rollouts.scene
    telling = np.concatenate([scene.starts, [scene.robot.goal]])
    wanted_low = np.minimum(low, telling.min(axis=0) - MARGIN)
    wanted_high = np.maximum(high, telling.max(axis=0) + MARGIN)
    # whatever else is in view, the bounds to show are
    centre = np.clip((wanted_low + wanted_high) / 2, high - half, low + half)
    (x0, y0), (x1, y1) = centre - half, centre + half
    return float(x0), float(y0), float(x1), float(y1)


def in_view(places: FloatArray, bounds: Bounds) -> BoolArray:
    """Which places [..., 2], m, lie within bounds, [...]."""
    inside: BoolArray = np.all((places >= bounds[:2]) & (places <= bounds[2:]), axis=-1)
    return inside


def beyond_edges(starts: FloatArray, bounds: Bounds) -> tuple[Beyond, ...]:
    """Who of the people that start at these places [P, 2], m, is out of view, edge by edge."""
    low, high = np.array(bounds[:2]), np.array(bounds[2:])
    outside = starts[~in_view(starts, bounds)]
    past = np.stack([low - outside, outside - high], axis=1).reshape(-1, 4)  # left, down, right, up
    edges = past.argmax(axis=1)
    found = []
    for edge in np.unique(edges).tolist():
        there = np.clip(outside[edges == edge], low, high)
        axis, sign = edge % 2, 1.0 if edge >= 2 else -1.0
        direction = (sign, 0.0) if axis == 0 else (0.0, sign)
        x, y = there.mean(axis=0).tolist()
        found.append(Beyond(len(there), (x, y), direction))
    return tuple(found)


def _lonely_ends(rollouts: Rollouts, bounds: Bounds) -> FloatArray:
    """Where those end who are nearest to the robot of an action that ends alone in view, [N, 2], m.

    An action ends alone if in any of its rollouts nobody is within the bounds at the end.
    """
    ends = rollouts.pedestrians[:, :, -1]  # (A, M, P, 2)
    if not ends.shape[2]:
        return np.empty((0, 2))
    lonely = ~in_view(ends, bounds).any(axis=-1).all(axis=-1)  # (A,)
    away = np.linalg.norm(ends - rollouts.robot[:, :, -1, None, :2], axis=-1).mean(axis=1)
    nearest = away.argmin(axis=-1)  # (A,)
    return ends[lonely, :, nearest[lonely]].reshape(-1, 2)


def _grown(bounds: Bounds, places: FloatArray) -> Bounds:
    """The bounds with room for people at these places [N, 2], m."""
    low = np.min(places - MARGIN, axis=0, initial=math.inf)
    high = np.max(places + MARGIN, axis=0, initial=-math.inf)
    (x0, y0), (x1, y1) = np.minimum(bounds[:2], low), np.maximum(bounds[2:], high)
    return float(x0), float(y0), float(x1), float(y1)
