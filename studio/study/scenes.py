"""The scenes of a study that tell most, simulated again: the bank's rollouts, now to look at."""

import shlex
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from learners import Prospects
from scenes import InputError, Rollouts
from scenes.bank import BankPlan, planned_scene, simulate_planned
from studio.files import replacing
from studio.progress import Progress
from studio.recorder.replaced import check_same_recording
from studio.scene.again import record_command
from studio.scene.judgements import judge
from studio.scene.recording.write import write_recording
from studio.scene.sources import numbered_name
from studio.study.links import Links, SceneLink


def record_scenes(
    folder: Path,
    plan: BankPlan,
    prospects: Prospects,
    numbers: Sequence[int],
    progress: Progress,
    *,
    force: bool = False,
) -> Links:
    """Record scenes of a bank, as far as they can be made again.

    Args:
        folder: where they go, a folder in that of the study's own recording.
        plan: how the bank says it was sampled.
        prospects: what the bank holds.
        numbers: ids of scenes in the bank.
        progress: told after every recording how many of how many are done.
        force: whether they may replace recordings of something else.

    Raises:
        studio.errors.InputError: if a recording cannot be written there, or would replace one of
            something else.
    """
    links: Links = {}
    for number, rollouts in scenes_again(plan, prospects, numbers):
        name = rollouts.scene.name
        file = folder / f"{name}.rrd"
        with replacing(file) as [part]:
            write_recording(part, rollouts, judge(rollouts))
            if not force:
                check_same_recording([file], part)
        path = f"{folder.name}/{file.name}"
        links[number] = SceneLink(name, path, record_commands(plan, rollouts, folder.name))
        progress(len(links), len(numbers))
    return links


def scenes_again(
    plan: BankPlan, prospects: Prospects, numbers: Iterable[int]
) -> Iterator[tuple[int, Rollouts]]:
    """Simulate scenes of a bank again, and give their ids with the very rollouts of the bank.

    A scene of which the simulation gives other outcomes than the bank holds is left out: such
    a bank was not made by this plan, or it was by other versions than those that are installed.
    """
    actions = tuple(action.name for action in plan.actions)
    if (actions, plan.rollouts) != (prospects.actions, prospects.features.shape[2]):
        return
    places = {int(number): place for place, number in enumerate(prospects.scenes)}
    for number in numbers:
        try:
            scene = planned_scene(plan, number)
            # the name that `studio scenes` gives it, so that no two scenes share a file
            scene = replace(scene, name=numbered_name(scene, plan.seed))
            rollouts = simulate_planned(plan, scene)
        except InputError:
            continue
        if np.array_equal(rollouts.features, prospects.features[places[number]]):
            yield number, rollouts


def record_commands(plan: BankPlan, rollouts: Rollouts, folder: str) -> tuple[str, ...]:
    """The command lines that make the recording of a scene again, in the study's folder.

    They print the scene, then record it into a folder there. There are none if the command line
    cannot say what the robot does.
    """
    record = record_command(rollouts)
    if record is None:
        return ()
    scene = rollouts.scene
    shown = ["studio", "scenes", scene.family, "--pattern", scene.pattern]
    shown += ["--seed", str(plan.seed), "--number", str(scene.number)]
    printed = f"{shlex.join(shown)} > {scene.name}.toml"
    return printed, f"{record} --no-png --no-mp4 --out {folder} --name {scene.name}"
