"""The batched engine: many rollouts of one scene at once, compiled.

Rollouts lie side by side in lanes: every quantity is an array [agent, lane], and the innermost loop
always runs over the lanes, so that one instruction moves several rollouts. A block of lanes is
simulated from its first step to its last while it stays in the fastest cache; threads share the
blocks. A lane never looks at another lane, so a result does not depend on which rollouts share a
block, or which blocks a thread.
"""

import os
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from scenes.arrays import FloatArray
from scenes.blocks import LANES, Block, walk_block
from scenes.crowd import Crowd, ForceSet, Surroundings


def walk(
    crowd: Crowd,
    surroundings: Surroundings,
    robots: FloatArray,
    model: ForceSet,
    wrap_angles: bool,
    dt: float,
    threads: int | None = None,
) -> FloatArray:
    """Let the crowd walk, once for each robot path.

    Args:
        crowd: how the people of K rollouts set out.
        surroundings: walls and groups.
        robots: [A, K, T+1, R, 4]: x, y in m, heading in rad, speed in m/s of R robots; R = 0 is a
            walk without a robot.
        model: the force set.
        wrap_angles: as for `scenes.simulate`.
        dt: length of a step, s.
        threads: how many to use; None is one per processor. The result is the same.

    Returns:
        Paths of the people, [A, K, T+1, P, 2], m.
    """
    actions, rollouts = robots.shape[:2]
    lanes, agents = actions * rollouts, crowd.people + robots.shape[3]
    paths = np.empty((lanes, crowd.steps + 1, crowd.people, 2))
    paths[:, 0] = np.tile(crowd.starts, (actions, 1, 1))
    points = np.concatenate([np.empty((0, 2)), *surroundings.wall_points])
    wall_ends = np.cumsum([0, *map(len, surroundings.wall_points)])
    robot_of = np.ascontiguousarray(robots).reshape(lanes, *robots.shape[2:])

    def run(first: int) -> None:
        # A last block that is not full repeats its last lane, so that every lane of every block
        # runs through the same instructions.
        lane_of = np.minimum(np.arange(first, first + LANES), lanes - 1)
        walk_block(
            Block(*np.zeros((len(Block._fields), agents, LANES))),
            lane_of,
            lane_of % rollouts,
            crowd,
            robot_of,
            points,
            wall_ends,
            surroundings.group_of,
            model == "extended",
            wrap_angles,
            dt,
            paths,
        )

    with ThreadPoolExecutor(os.cpu_count() if threads is None else threads) as pool:
        list(pool.map(run, range(0, lanes, LANES)))
    return paths.reshape(actions, rollouts, *paths.shape[1:])
