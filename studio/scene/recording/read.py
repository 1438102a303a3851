"""Read a scene back from its recording: everything that pictures and films are made of."""

import tomllib
from dataclasses import replace
from typing import Any

import numpy as np

from learners import PROFILES, CptParameters
from scenes import FEATURES, Limits, MetaAction, Noise, Rollouts, Scene, scene_from_toml
from scenes.features import (
    CLEARANCE_SCALE,
    DEVIATION_SCALE,
    PROGRESS_SPEED,
    Outcomes,
    first_step,
    gaps,
)
from scenes.geometry import distance_to_walls
from scenes.scene import ROBOT_RADIUS
from studio.arrays import FloatArray, IntArray
from studio.recorder.contents import Contents
from studio.scene.judgements import Judgement, judge
from studio.scene.recording import entities

IN_METRES = ("clearance_m", "deviation_m", "progress_m")


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
    # before edition 3 the paths of all rollouts were kept
    has_paths = contents.has(entities.SIMULATION, "paths")
    paths = int(contents.static(entities.SIMULATION, "paths")[0]) if has_paths else count
    times = round(float(told["horizon"]) / dt) + 1
    robot, pedestrians = [], []
    for action in actions:
        at = f"/{entities.robots(action.name)}"
        place = contents.over_time(at, "Points2D:positions", "step")
        heading = contents.over_time(at, "heading", "step").reshape(times, paths, 1)
        robot.append(np.concatenate([place, heading], axis=-1).swapaxes(0, 1))
        walks = np.empty((times, 0, 2))
        if people:
            at = f"/{entities.pedestrians(action.name)}"
            walks = contents.over_time(at, "Points2D:positions", "step")
        pedestrians.append(walks.reshape(times, paths, people, 2).swapaxes(0, 1))
    driven = np.array(robot, np.float64).reshape(len(actions), paths, times, 3)
    walked = np.array(pedestrians, np.float64)
    outcomes = _outcomes(contents, actions, count, float(told["horizon"]))
    if outcomes is None:
        outcomes = _old_outcomes(contents, scene, driven, walked, float(told["horizon"]))
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
        robot=driven,
        pedestrians=walked,
        without_robot=_without_robot(contents, times, people),
        **vars(outcomes),
    )


def _outcomes(
    contents: Contents, actions: tuple[MetaAction, ...], count: int, horizon: float
) -> Outcomes | None:
    """What came of the rollouts, from the tables that a recording has since edition 3."""
    tables = [f"/{entities.outcomes(action.name)}" for action in actions]
    if not contents.has(tables[0], "clearance_m"):
        return None
    numbers = {
        name: np.array(
            [contents.over_time(table, name, "rollout") for table in tables], np.float64
        ).reshape(len(actions), count)
        for name in (*IN_METRES, "smoothness", "people_touched", "person_step", "wall_step")
    }
    clearance, deviation, progress = (numbers[name] for name in IN_METRES)
    features = [
        clearance / CLEARANCE_SCALE,
        deviation / DEVIATION_SCALE,
        progress / (PROGRESS_SPEED * horizon),
        numbers["smoothness"],
        numbers["people_touched"] + (numbers["wall_step"] >= 0),
    ]
    return Outcomes(
        features=np.stack(features, axis=-1),
        clearance_m=clearance,
        deviation_m=deviation,
        progress_m=progress,
        person_step=numbers["person_step"].astype(np.int64),
        wall_step=numbers["wall_step"].astype(np.int64),
    )


def _old_outcomes(
    contents: Contents, scene: Scene, robot: FloatArray, pedestrians: FloatArray, horizon: float
) -> Outcomes:
    """What came of the rollouts, from the one table of scaled features of editions 1 and 2."""
    columns = [contents.static(f"/{entities.OUTCOMES}", feature) for feature in FEATURES]
    features = np.stack(columns, axis=-1).reshape(*robot.shape[:2], -1).astype(np.float64)
    table, shape = f"/{entities.OUTCOMES}", robot.shape[:2]
    if contents.has(table, "person_step"):  # of some of edition 2
        person_step, wall_step = (
            contents.static(table, name).astype(np.int64).reshape(shape)
            for name in ("person_step", "wall_step")
        )
    else:
        first = contents.static(table, "contact_step").astype(np.int64).reshape(shape)
        person_step, wall_step = contacts_by_kind(
            scene, robot, pedestrians, first, features[..., -1]
        )
    return Outcomes(
        features=features,
        clearance_m=CLEARANCE_SCALE * features[..., 0],
        deviation_m=DEVIATION_SCALE * features[..., 1],
        progress_m=PROGRESS_SPEED * horizon * features[..., 2],
        person_step=person_step,
        wall_step=wall_step,
    )


def contacts_by_kind(
    scene: Scene,
    robot: FloatArray,
    pedestrians: FloatArray,
    first: IntArray,
    collisions: FloatArray,
) -> tuple[IntArray, IntArray]:
    """The first steps at which people and at which walls are touched, [A, K] each, -1 for never.

    Editions 1 and 2 tell the first step of any contact, [A, K], and how many things are touched. Of
    what kind the contacts are then follows from where everybody is, rounded by some millimetres.
    """
    to_people = gaps(robot, pedestrians).min(axis=-1, initial=np.inf)  # (A, K, T+1)
    to_walls = distance_to_walls(robot[..., :2], scene.wall_segments) - ROBOT_RADIUS
    at_first = np.maximum(first, 0)[..., None]
    nearer = [np.take_along_axis(gap, at_first, axis=-1)[..., 0] for gap in (to_people, to_walls)]
    is_person = nearer[0] <= nearer[1]
    steps = []
    for gap, is_first in ((to_people, is_person), (to_walls, ~is_person)):
        later = first_step(gap < 0.0)
        # of a single contact there is no second kind
        later = np.where((collisions > 1) & (later >= 0), np.maximum(later, first), -1)
        steps.append(np.where(first < 0, -1, np.where(is_first, first, later)))
    return steps[0], steps[1]


def _without_robot(contents: Contents, times: int, people: int) -> FloatArray:
    """The walks without the robot, [K, T+1, P, 2], m; none (K = 0) if they were not recorded."""
    entity = f"/{entities.WITHOUT_ROBOT}"
    if not contents.has(entity, "LineStrips2D:strips"):
        return np.empty((0, times, people, 2))
    strips = contents.static(entity, "LineStrips2D:strips")
    walks = np.array([np.stack(strip) for strip in strips], np.float64)
    return walks.reshape(-1, people, times, 2).swapaxes(1, 2)


def _judgements(contents: Contents, rollouts: Rollouts) -> tuple[Judgement, ...]:
    profiles = PROFILES
    if contents.has(entities.SIMULATION, "teachers"):
        told: dict[str, Any] = tomllib.loads(contents.text(entities.SIMULATION, "teachers"))
        profiles = {name: CptParameters(**numbers) for name, numbers in told.items()}
    judgements = []
    for judged in judge(rollouts, profiles, _reference(contents, len(rollouts.names))):
        values = contents.static(f"/{entities.JUDGEMENTS}", judged.teacher).astype(np.float64)
        if values.shape != judged.values.shape:
            raise contents.damaged(f"{judged.teacher} judges {values.size} actions")
        judgements.append(replace(judged, values=values))
    return tuple(judgements)


def _reference(contents: Contents, actions: int) -> FloatArray | None:
    """Utilities of the many outcomes that values are held against, [A, M], if there are any."""
    entity = f"/{entities.REFERENCE}"
    if not contents.has(entity, "utilities"):
        return None
    return contents.static(entity, "utilities").astype(np.float64).reshape(actions, -1)
