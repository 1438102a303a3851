"""How much faster the batched engine is than pysocialforce, measured side by side.

The workload: a doorway with 8 pedestrians in two groups, 7 actions and a run without the robot, 50
rollouts each, 40 steps. Both engines do the same work from the same noise, with the library's own
arithmetic (`wrap_angles=False`), and the results are compared before the times are.
"""

import os
import time
from itertools import count
from statistics import median

import numpy as np

from scenes import META_ACTIONS, Rollouts, Scene, load_scene, simulate, warm_up
from scenes.rollouts import Engine

ROLLOUTS, STEPS, PAIRS = 50, 40, 5


def workload() -> Scene:
    """The first doorway of the series of seed 0 that has 8 pedestrians in two groups."""
    for number in count():
        scene = load_scene("doorway", seed=0, number=number)
        if len(scene.pedestrians) == 8 and len(scene.groups) == 2:
            return scene
    raise AssertionError


def timed(scene: Scene, engine: Engine, rollouts: int) -> tuple[float, Rollouts]:
    """Seconds that a simulation takes, and its result."""
    start = time.perf_counter()
    result = simulate(scene, META_ACTIONS, rollouts, engine=engine, wrap_angles=False)
    return time.perf_counter() - start, result


def main() -> None:
    """Measure in turn, peer and product, and print the ratio of each pair."""
    scene = workload()
    for engine in ("batched", "pysocialforce"):
        warm_up(engine)
    print(
        f"doorway number {scene.number}: {len(scene.pedestrians)} pedestrians, "
        f"{len(scene.groups)} groups, {len(scene.walls)} walls; {os.cpu_count()} processors"
    )
    ratios = []
    for pair in range(PAIRS):
        theirs, reference = timed(scene, "pysocialforce", ROLLOUTS)
        tries = sorted((timed(scene, "batched", ROLLOUTS) for _ in range(5)), key=lambda t: t[0])
        ours, result = tries[len(tries) // 2]
        apart = np.abs(result.pedestrians - reference.pedestrians).max()
        ratios.append(theirs / ours)
        per_step = 1e6 / ((len(META_ACTIONS) + 1) * ROLLOUTS * STEPS)
        print(
            f"pair {pair + 1}: pysocialforce {theirs:6.2f} s ({theirs * per_step:5.0f} µs a "
            f"rollout-step), batched {ours * 1e3:5.1f} ms ({ours * per_step:4.2f} µs): "
            f"{ratios[-1]:4.0f} times faster; paths agree to {apart:.0e} m"
        )
    print(f"median: {median(ratios):.0f} times faster (wanted: 200)")


if __name__ == "__main__":
    main()
