"""Rollouts that nobody simulated, for tests."""

import numpy as np

from scenes import (
    FEATURES,
    META_ACTIONS,
    Limits,
    MetaAction,
    Noise,
    Pedestrian,
    Robot,
    Rollouts,
    Scene,
    Wall,
)


def make_rollouts(
    actions: tuple[MetaAction, ...] = META_ACTIONS[:2],
    rollouts: int = 3,
    steps: int = 5,
    people: int = 2,
    centre: tuple[float, float] = (0.0, 0.0),
) -> Rollouts:
    """Robots that drive their commands and people who walk straight on, all a bit shaken."""
    rng = np.random.default_rng(0)
    x, y = centre
    scene = Scene(
        name="test",
        robot=Robot(start=(x - 2.0, y), goal=(x + 4.0, y)),
        pedestrians=tuple(
            Pedestrian(start=(x + 1.0 + 0.5 * row, y + 0.1), goal=(x - 5.0, y))
            for row in range(people)
        ),
        walls=(Wall((x, y + 1.0), (x, y + 3.0)),),
        groups=((0, 1),) if people > 1 else (),
    )
    times = np.arange(steps + 1) * 0.1
    speed = np.array([action.speed for action in actions])[:, None, None]
    turn = np.array([action.turn_rate for action in actions])[:, None, None]
    shaken = 1.0 + 0.1 * rng.standard_normal((1, rollouts, 1))
    heading = turn * shaken * times
    ahead = speed * shaken * times
    robot = np.stack(
        [x - 2.0 + ahead * np.cos(heading), y + ahead * np.sin(heading), heading], axis=-1
    )
    walk = np.cumsum(0.1 * rng.standard_normal((rollouts, steps + 1, people, 2)), axis=1)
    walk[..., 0] -= 1.3 * times[:, None]
    pedestrians = np.broadcast_to(
        scene.starts + walk, (len(actions), rollouts, steps + 1, people, 2)
    )
    shape = (len(actions), rollouts)
    person_step = np.full(shape, -1)
    person_step[0, 0] = min(2, steps)
    features = rng.uniform(0.0, 1.0, (*shape, len(FEATURES)))
    features[..., FEATURES.index("collisions")] = person_step >= 0
    return Rollouts(
        scene=scene,
        actions=actions,
        seed=7,
        noise=Noise(),
        limits=Limits(),
        model="extended",
        engine="batched",
        wrap_angles=True,
        dt=0.1,
        robot=robot,
        pedestrians=pedestrians,
        without_robot=pedestrians[0],
        features=features,
        clearance_m=rng.uniform(0.0, 2.0, shape),
        deviation_m=rng.uniform(0.0, 0.5, shape),
        progress_m=rng.uniform(0.0, 4.0, shape),
        person_step=person_step,
        wall_step=np.full(shape, -1),
    )
