"""One block of rollouts, from its first step to its last: the compiled loops over lanes."""

import math
from collections.abc import Callable
from typing import Any, NamedTuple, TypeVar, cast

import numpy as np
from numba import njit

from scenes import forces
from scenes.crowd import Crowd
from scenes.forces import Extended, HelbingMolnar, Vector
from scenes.lanes import lane as inlined

LANES = 32
"""How many rollouts a block has: enough to fill several registers, few enough for the cache."""

Lanes = Any  # float64 [LANES]; numba infers the types inside compiled code by itself
Loop = TypeVar("Loop", bound=Callable[..., Any])


def compiled(function: Loop) -> Loop:
    """Compile a loop over lanes.

    Of fast-math only the fusing of multiply and add is allowed. It is the same in every lane and
    reorders no sum, so a lane gives the same bits whatever its neighbours are.
    """
    jit = njit(error_model="numpy", cache=True, nogil=True, fastmath={"contract"})
    return cast(Loop, jit(function))


class Block(NamedTuple):
    """State of the agents of one block, each field [agents, LANES]; people first, then robots.

    Positions, goals and `distance`, which is that to the goal, are in m, speeds in m/s; (ex, ey) is
    the unit vector to the goal, and for a robot its heading.
    """

    x: Any
    y: Any
    vx: Any
    vy: Any
    ex: Any
    ey: Any
    distance: Any
    goal_x: Any
    goal_y: Any
    desired_speed: Any
    max_speed: Any


@compiled
def _face_goals(block: Block, people: int) -> None:
    """Set everybody's direction and distance to the goal."""
    for i in range(people):
        for lane in range(LANES):
            block.ex[i, lane], block.ey[i, lane], block.distance[i, lane] = forces.unit(
                block.goal_x[i, lane] - block.x[i, lane], block.goal_y[i, lane] - block.y[i, lane]
            )


@inlined
def _drive_to_goal(block: Block, i: int, lane: int, relaxation_time: float) -> Vector:
    """The force that drives person i of one lane."""
    return forces.drive_to_goal(
        block.ex[i, lane],
        block.ey[i, lane],
        block.desired_speed[i, lane],
        block.vx[i, lane],
        block.vy[i, lane],
        relaxation_time,
    )


@inlined
def _apart(x: Any, y: Any, i: int, j: int, lane: int) -> Vector:
    """The vector (x, y) of agent i minus that of agent j in one lane."""
    return x[i, lane] - x[j, lane], y[i, lane] - y[j, lane]


@compiled
def _add_extended(
    block: Block, i: int, fx: Lanes, fy: Lanes, points: Any, group_of: Any, wrap: bool, p: Extended
) -> None:
    """Add to (fx, fy) what person i feels under the `extended` model."""
    sx, sy = np.zeros(LANES), np.zeros(LANES)
    for j in range(block.x.shape[0]):
        if j == i:
            continue
        # Inside the loop over lanes, this choice would cost a fifth of the speed.
        if wrap:
            for lane in range(LANES):
                rx, ry = _apart(block.x, block.y, i, j, lane)
                wx, wy = _apart(block.vx, block.vy, j, i, lane)
                ax, ay = forces.social(rx, ry, wx, wy, p)
                sx[lane] += ax
                sy[lane] += ay
        else:
            for lane in range(LANES):
                rx, ry = _apart(block.x, block.y, i, j, lane)
                wx, wy = _apart(block.vx, block.vy, j, i, lane)
                ax, ay = forces.social_as_in_library(rx, ry, wx, wy, p)
                sx[lane] += ax
                sy[lane] += ay
    for lane in range(LANES):
        ax, ay = _drive_to_goal(block, i, lane, p.relaxation_time)
        fx[lane] += ax + p.social_factor * sx[lane]
        fy[lane] += ay + p.social_factor * sy[lane]
    _add_wall_points(block, i, fx, fy, points, p)
    if i < group_of.shape[0] and group_of[i] >= 0:
        _add_group(block, i, fx, fy, group_of, wrap, p)


@compiled
def _add_wall_points(block: Block, i: int, fx: Lanes, fy: Lanes, points: Any, p: Extended) -> None:
    """Add the push of every wall point that person i can feel in some lane."""
    reach = p.wall_threshold + 2.0 * p.body_radius
    left, right = block.x[i].min(), block.x[i].max()
    below, above = block.y[i].min(), block.y[i].max()
    scale = p.wall_factor * math.exp(p.body_radius / p.wall_range)
    for k in range(points.shape[0]):
        px, py = points[k, 0], points[k, 1]
        across, along = max(left - px, px - right, 0.0), max(below - py, py - above, 0.0)
        if across * across + along * along > reach * reach:
            continue
        for lane in range(LANES):
            ax, ay = forces.wall_point(block.x[i, lane] - px, block.y[i, lane] - py, p)
            fx[lane] += scale * ax
            fy[lane] += scale * ay


@compiled
def _add_group(
    block: Block, i: int, fx: Lanes, fy: Lanes, group_of: Any, wrap: bool, p: Extended
) -> None:
    """Add what ties person i to the group: coherence, repulsion and gaze."""
    others_x, others_y, others = np.zeros(LANES), np.zeros(LANES), 0
    for j in range(group_of.shape[0]):
        if j == i or group_of[j] != group_of[i]:
            continue
        others += 1
        for lane in range(LANES):
            rx, ry = _apart(block.x, block.y, i, j, lane)
            ax, ay = forces.repulsion(rx, ry, p)
            fx[lane] += p.repulsion_factor * ax
            fy[lane] += p.repulsion_factor * ay
            others_x[lane] -= rx
            others_y[lane] -= ry
    for lane in range(LANES):
        cx, cy = others_x[lane], others_y[lane]
        size = others + 1.0
        if wrap:
            ax, ay = forces.coherence(cx / size, cy / size, size)
        else:
            ax, ay = forces.coherence_as_in_library(cx / size, cy / size, size)
        bx, by = forces.gaze(
            block.ex[i, lane], block.ey[i, lane], block.distance[i, lane], cx / others, cy / others
        )
        fx[lane] += p.coherence_factor * ax + p.gaze_factor * bx
        fy[lane] += p.coherence_factor * ay + p.gaze_factor * by


@compiled
def _add_helbing_molnar(
    block: Block, i: int, fx: Lanes, fy: Lanes, dt: float, wrap: bool, p: HelbingMolnar
) -> None:
    """Add to (fx, fy) what person i feels of goal and people under the `helbing-molnar` model."""
    for j in range(block.x.shape[0]):
        if j == i:
            continue
        for lane in range(LANES):
            rx, ry = _apart(block.x, block.y, i, j, lane)
            vx, vy = block.vx[j, lane], block.vy[j, lane]
            pace = math.sqrt(vx * vx + vy * vy) * dt
            sx, sy = pace * block.ex[j, lane], pace * block.ey[j, lane]
            if wrap:
                ax, ay = forces.pair(rx, ry, sx, sy, p)
            else:
                ax, ay = forces.pair_as_in_library(rx, ry, sx, sy, p)
            ax, ay = forces.in_sight(block.ex[i, lane], block.ey[i, lane], ax, ay, p)
            fx[lane] += p.pair_factor * ax
            fy[lane] += p.pair_factor * ay
    for lane in range(LANES):
        ax, ay = _drive_to_goal(block, i, lane, p.relaxation_time)
        fx[lane] += ax
        fy[lane] += ay


@compiled
def _add_wall_gradient(
    block: Block, i: int, fx: Lanes, fy: Lanes, points: Any, wrap: bool, p: HelbingMolnar
) -> None:
    """Add the push of one wall, from its point nearest to person i."""
    nearest_x, nearest_y = np.empty(LANES), np.empty(LANES)
    least = np.full(LANES, np.inf)
    for k in range(points.shape[0]):
        px, py = points[k, 0], points[k, 1]
        for lane in range(LANES):
            rx, ry = block.x[i, lane] - px, block.y[i, lane] - py
            square = rx * rx + ry * ry
            nearer = square < least[lane]
            nearest_x[lane] = rx if nearer else nearest_x[lane]
            nearest_y[lane] = ry if nearer else nearest_y[lane]
            least[lane] = square if nearer else least[lane]
    for lane in range(LANES):
        if wrap:
            ax, ay = forces.wall_gradient(nearest_x[lane], nearest_y[lane], p)
        else:
            ax, ay = forces.wall_gradient_as_in_library(nearest_x[lane], nearest_y[lane], p)
        fx[lane] += ax
        fy[lane] += ay


@compiled
def _advance(block: Block, people: int, fx: Any, fy: Any, dt: float) -> None:
    """Take a semi-implicit Euler step: cap the new velocity, then move. Who has arrived stands."""
    for i in range(people):
        for lane in range(LANES):
            vx = block.vx[i, lane] + dt * fx[i, lane]
            vy = block.vy[i, lane] + dt * fy[i, lane]
            speed = math.sqrt(vx * vx + vy * vy)
            cap = block.max_speed[i, lane] / (speed if speed > 0.0 else 1.0)
            cap = cap if cap < 1.0 else 1.0
            cap = cap if block.distance[i, lane] >= forces.ARRIVAL_DISTANCE else 0.0
            block.vx[i, lane] = cap * vx
            block.vy[i, lane] = cap * vy
            block.x[i, lane] += cap * vx * dt
            block.y[i, lane] += cap * vy * dt


@compiled
def walk_block(
    block: Block,
    lane_of: Any,
    rollout_of: Any,
    crowd: Crowd,
    robots: Any,
    points: Any,
    wall_ends: Any,
    group_of: Any,
    extended: bool,
    wrap: bool,
    dt: float,
    paths: Any,
) -> None:
    """Simulate one block, which comes empty, and write its paths from step 1 on."""
    people = crowd.starts.shape[1]
    fx, fy = np.empty((people, LANES)), np.empty((people, LANES))
    for i in range(people):
        # number by number: whole arrays would take the compiler a third longer
        for lane in range(LANES):
            k = rollout_of[lane]
            block.x[i, lane], block.y[i, lane] = crowd.starts[k, i, 0], crowd.starts[k, i, 1]
            block.vx[i, lane] = crowd.velocities[k, i, 0]
            block.vy[i, lane] = crowd.velocities[k, i, 1]
            block.goal_x[i, lane] = crowd.goals[k, i, 0]
            block.goal_y[i, lane] = crowd.goals[k, i, 1]
            block.desired_speed[i, lane] = crowd.desired_speeds[k, i]
            block.max_speed[i, lane] = crowd.desired_speeds[k, i] * (
                1.0 if extended else forces.MAX_SPEED_FACTOR
            )
    for step in range(crowd.accelerations.shape[1]):
        for i in range(people, block.x.shape[0]):
            for lane in range(LANES):
                pose = robots[lane_of[lane], step, i - people]
                block.x[i, lane], block.y[i, lane] = pose[0], pose[1]
                block.ex[i, lane], block.ey[i, lane] = math.cos(pose[2]), math.sin(pose[2])
                block.vx[i, lane] = pose[3] * block.ex[i, lane]
                block.vy[i, lane] = pose[3] * block.ey[i, lane]
        _face_goals(block, people)
        for i in range(people):
            for lane in range(LANES):
                fx[i, lane] = crowd.accelerations[rollout_of[lane], step, i, 0]
                fy[i, lane] = crowd.accelerations[rollout_of[lane], step, i, 1]
            if extended:
                _add_extended(block, i, fx[i], fy[i], points, group_of, wrap, forces.EXTENDED)
            else:
                _add_helbing_molnar(block, i, fx[i], fy[i], dt, wrap, forces.HELBING_MOLNAR)
                for w in range(wall_ends.shape[0] - 1):
                    wall = points[wall_ends[w] : wall_ends[w + 1]]
                    _add_wall_gradient(block, i, fx[i], fy[i], wall, wrap, forces.HELBING_MOLNAR)
        _advance(block, people, fx, fy, dt)
        for i in range(people):
            for lane in range(LANES):
                paths[lane_of[lane], step + 1, i, 0] = block.x[i, lane]
                paths[lane_of[lane], step + 1, i, 1] = block.y[i, lane]
