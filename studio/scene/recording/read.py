"""Read a scene back from its recording: everything that pictures and films are made of."""

import tomllib
from typing import Any

import numpy as np

from learners import PROFILES, CptParameters
from scenes import FEATURES, Limits, MetaAction, Noise, Rollouts, scene_from_toml
from scenes.features import CLEARANCE_SCALE, DEVIATION_SCALE, PROGRESS_SPEED
from studio.arrays import FloatArray
from studio.recorder.contents import Contents
from studio.scene.judgements import Judgement
from studio.scene.recording import entities


def read_scene(contents: Contents) -> tuple[Rollouts, tuple[Judgement, ...]]:
    """Read back from a recording what was simulated, and what each teacher thinks of the actions.

    Positions and headings are rounded as the recording is.

    Recordings of edition 1 do not tell how people walk without the robot, so `without_robot` has no
    walks then, nor what the teachers are like, who then were those of `PROFILES`.

    Raises:
        InputError: if something is missing.
        ValueError: if something is not as the studio writes it; so do TypeError, KeyError and
            IndexError say.
    """
    rollouts = _rollouts(contents)
    return rollouts, _judgements(contents, rollouts)


def _rollouts(contents: Contents) -> Rollouts:
    told = {
        name: contents.static(entities.SIMULATION, name)[0]
        for name in ("seed", "rollouts", "dt", "horizon", "model", "engine", "wrap_angles")
    }
    parts = {
        name: tomllib.loads(contents.text(entities.SIMULATION, name))
        for name in ("noise", "limits", "actions")
    }
    scene = scene_from_toml(contents.text(entities.SCENE, "toml"))
    actions = tuple(MetaAction(**action) for action in parts["actions"]["actions"])
    count, people, dt = int(told["rollouts"]), len(scene.pedestrians), float(told["dt"])
    horizon = float(told["horizon"])
    times = round(horizon / dt) + 1
    robot, pedestrians = [], []
    for action in actions:
        at = f"/{entities.robots(action.name)}"
        place = contents.over_time(at, "Points2D:positions", "step")
        heading = contents.over_time(at, "heading", "step")[..., None]
        robot.append(np.concatenate([place, heading], axis=-1).swapaxes(0, 1))
        if people:
            at = f"/{entities.pedestrians(action.name)}"
            moved = contents.over_time(at, "Points2D:positions", "step").reshape(
                times, count, people, 2
            )
            pedestrians.append(moved.swapaxes(0, 1))
        else:
            pedestrians.append(np.empty((count, times, 0, 2)))
    features = np.stack(
        [contents.static(f"/{entities.OUTCOMES}", feature) for feature in FEATURES], axis=-1
    ).reshape(len(actions), count, len(FEATURES))
    contact_step = contents.static(f"/{entities.OUTCOMES}", "contact_step")
    return _frozen(
        Rollouts(
            scene=scene,
            actions=actions,
            seed=int(told["seed"]),
            noise=Noise(**parts["noise"]),
            limits=Limits(**parts["limits"]),
            model=told["model"],
            engine=told["engine"],
            wrap_angles=bool(told["wrap_angles"]),
            dt=dt,
            robot=np.array(robot, np.float64).reshape(len(actions), count, times, 3),
            pedestrians=np.array(pedestrians, np.float64),
            without_robot=_without_robot(contents, times, people),
            features=features.astype(np.float64),
            clearance_m=CLEARANCE_SCALE * features[..., 0].astype(np.float64),
            deviation_m=DEVIATION_SCALE * features[..., 1].astype(np.float64),
            progress_m=PROGRESS_SPEED * horizon * features[..., 2].astype(np.float64),
            contact_step=contact_step.astype(np.int64).reshape(len(actions), count),
        )
    )


def _without_robot(contents: Contents, times: int, people: int) -> FloatArray:
    """The walks without the robot, [K, T+1, P, 2], m; none (K = 0) if they were not recorded."""
    entity = f"/{entities.WITHOUT_ROBOT}"
    if not contents.has(entity, "LineStrips2D:strips"):
        return np.empty((0, times, people, 2))
    strips = contents.static(entity, "LineStrips2D:strips")
    walks = np.array([np.stack(strip) for strip in strips], np.float64)
    return walks.reshape(-1, people, times, 2).swapaxes(1, 2)


def _judgements(contents: Contents, rollouts: Rollouts) -> tuple[Judgement, ...]:
    people = PROFILES
    if contents.has(entities.SIMULATION, "teachers"):
        told: dict[str, Any] = tomllib.loads(contents.text(entities.SIMULATION, "teachers"))
        people = {name: CptParameters(**numbers) for name, numbers in told.items()}
    judgements = []
    for teacher, parameters in people.items():
        values = contents.static(f"/{entities.JUDGEMENTS}", teacher).astype(np.float64)
        if values.shape != (len(rollouts.actions),):
            raise contents.damaged(f"{teacher} judges {values.size} actions")
        judgements.append(Judgement(teacher, parameters, values))
    return tuple(judgements)


def _frozen(rollouts: Rollouts) -> Rollouts:
    for array in vars(rollouts).values():
        if isinstance(array, np.ndarray):
            array.setflags(write=False)
    return rollouts
