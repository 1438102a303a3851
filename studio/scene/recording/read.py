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
        ValueError: if something is not as the studio writes it; TypeError, KeyError and IndexError
            mean the same.
    """
    rollouts = _rollouts(contents)
    for array in vars(rollouts).values():
        if isinstance(array, np.ndarray):
            array.setflags(write=False)
    return rollouts, _judgements(contents, rollouts.names)


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
    shape = len(actions), count
    robot, pedestrians = [], []
    for action in actions:
        at = f"/{entities.robots(action.name)}"
        place = contents.over_time(at, "Points2D:positions", "step")
        heading = contents.over_time(at, "heading", "step")[..., None]
        robot.append(np.concatenate([place, heading], axis=-1).swapaxes(0, 1))
        walks = np.empty((times, 0, 2))
        if people:
            at = f"/{entities.pedestrians(action.name)}"
            walks = contents.over_time(at, "Points2D:positions", "step")
        pedestrians.append(walks.reshape(times, count, people, 2).swapaxes(0, 1))
    outcomes = f"/{entities.OUTCOMES}"
    columns = [contents.static(outcomes, feature) for feature in FEATURES]
    features = np.stack(columns, axis=-1).reshape(*shape, len(FEATURES)).astype(np.float64)
    contact_step = contents.static(outcomes, "contact_step")
    return Rollouts(
        scene=scene,
        actions=actions,
        seed=int(told["seed"]),
        noise=Noise(**parts["noise"]),
        limits=Limits(**parts["limits"]),
        model=told["model"],
        engine=told["engine"],
        wrap_angles=bool(told["wrap_angles"]),
        dt=dt,
        robot=np.array(robot, np.float64).reshape(*shape, times, 3),
        pedestrians=np.array(pedestrians, np.float64),
        without_robot=_without_robot(contents, times, people),
        features=features,
        clearance_m=CLEARANCE_SCALE * features[..., 0],
        deviation_m=DEVIATION_SCALE * features[..., 1],
        progress_m=PROGRESS_SPEED * horizon * features[..., 2],
        contact_step=contact_step.astype(np.int64).reshape(shape),
    )


def _without_robot(contents: Contents, times: int, people: int) -> FloatArray:
    """The walks without the robot, [K, T+1, P, 2], m; none (K = 0) if they were not recorded."""
    entity = f"/{entities.WITHOUT_ROBOT}"
    if not contents.has(entity, "LineStrips2D:strips"):
        return np.empty((0, times, people, 2))
    strips = contents.static(entity, "LineStrips2D:strips")
    walks = np.array([np.stack(strip) for strip in strips], np.float64)
    return walks.reshape(-1, people, times, 2).swapaxes(1, 2)


def _judgements(contents: Contents, actions: tuple[str, ...]) -> tuple[Judgement, ...]:
    profiles = PROFILES
    if contents.has(entities.SIMULATION, "teachers"):
        told: dict[str, Any] = tomllib.loads(contents.text(entities.SIMULATION, "teachers"))
        profiles = {name: CptParameters(**numbers) for name, numbers in told.items()}
    judgements = []
    for teacher, parameters in profiles.items():
        values = contents.static(f"/{entities.JUDGEMENTS}", teacher).astype(np.float64)
        if values.shape != (len(actions),):
            raise contents.damaged(f"{teacher} judges {values.size} actions")
        judgements.append(Judgement(teacher, parameters, values))
    return tuple(judgements)
