"""Comparisons for tests, usual and unusual."""

import dataclasses

import numpy as np

from scenes import META_ACTIONS, MetaAction, Pedestrian, Robot, Scene, Wall, simulate
from studio.comparison.comparison import side_by_side

SIZE = (640, 360)
NAMES = ("forward", "slow_down")
LONG = "a_long_name_of_an_action_that_goes_on_and_on_and_then_goes_on_for_quite_a_while"


def a_comparison(
    people=3,
    rollouts=5,
    horizon=0.5,
    name="a-scene",
    names=NAMES,
    contact=None,
    named=False,
    paths=None,
):
    starts = [(1.5 + 0.6 * (index % 6), -1.2 + 0.5 * (index // 6)) for index in range(people)]
    scene = Scene(
        name=name,
        robot=Robot(start=(0.0, 0.0), goal=(6.0, 0.5)),
        pedestrians=tuple(Pedestrian(start, (-9.0, start[1])) for start in starts),
        walls=(Wall((-2.0, 3.0), (7.0, 3.0)),),
        groups=((0, 1),) if people > 1 else (),
    )
    actions = (MetaAction(names[0], 1.0, 0.0), *META_ACTIONS[2:4], MetaAction(names[1], 0.5, 0.0))
    simulated = simulate(scene, actions, rollouts=rollouts, horizon=horizon)
    simulated = simulated.keep_paths(paths or rollouts)
    comparison = side_by_side(simulated, *names, seed=1, named=named)
    if contact is None:
        return comparison
    steps = np.where(np.array(contact), min(2, simulated.steps), -1)
    return dataclasses.replace(
        comparison,
        rollouts=dataclasses.replace(
            comparison.rollouts, person_step=steps, wall_step=np.full(steps.shape, -1)
        ),
    )


CASES = {
    "default": {},
    "nobody": {"people": 0},
    "one outcome": {"rollouts": 1, "people": 1},
    "seven outcomes, one step": {"rollouts": 7, "horizon": 0.1},
    "forty people, many outcomes": {"rollouts": 200, "people": 40},
    "very many outcomes": {"rollouts": 1200, "people": 1},
    "paths of some alone": {"rollouts": 600, "people": 2, "paths": 7},
    "long names": {"name": "W" * 64, "names": (LONG, f"{LONG}_and_on"), "named": True},
}
