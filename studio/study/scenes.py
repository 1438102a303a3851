"""Scenes of an outcome bank, made again: the same futures, this time to look at."""

from __future__ import annotations

import shlex
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from studio.scene.again import record_command

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from learners import Prospects
    from scenes import Rollouts
    from scenes.bank import BankPlan

FOLDER = "scenes"
"""Where recordings of a bank's scenes are kept, beside that of the study."""


@dataclass(frozen=True)
class BankScene:
    """A scene of a bank, simulated again.

    Attributes:
        number: its id in the bank.
        rollouts: the very rollouts that the bank describes.
        commands: the command lines that record it, in the folder that `FOLDER` lies in; none if
            the command line cannot say what the robot does.
    """

    number: int
    rollouts: Rollouts
    commands: tuple[str, ...]


def scenes_again(
    plan: BankPlan, prospects: Prospects, numbers: Iterable[int]
) -> Iterator[BankScene]:
    """Simulate scenes of a bank again; those that do not come out as they were are left out.

    They come out so if the bank is what the plan gives, with the versions that are installed.

    Args:
        plan: how the bank says it was sampled.
        prospects: what the bank holds.
        numbers: ids of scenes in the bank.
    """
    from scenes import InputError
    from scenes.bank import planned_scene, simulate_planned

    actions = tuple(action.name for action in plan.actions)
    if (actions, plan.rollouts) != (prospects.actions, prospects.features.shape[2]):
        return
    places = {int(number): place for place, number in enumerate(prospects.scenes)}
    for number in numbers:
        try:
            scene = planned_scene(plan, number)
            # the name that `studio scenes` gives it, so that no two scenes share a file
            scene = replace(scene, name=f"{scene.name}-{plan.seed}-{number}")
            rollouts = simulate_planned(plan, scene)
        except InputError:
            continue
        if np.array_equal(rollouts.features, prospects.features[places[number]]):
            yield BankScene(number, rollouts, record_commands(plan, rollouts))


def record_commands(plan: BankPlan, rollouts: Rollouts) -> tuple[str, ...]:
    """The command lines that print the scene and record it."""
    record = record_command(rollouts)
    if record is None:
        return ()
    scene = rollouts.scene
    shown = ["studio", "scenes", scene.family, "--pattern", scene.pattern]
    shown += ["--seed", str(plan.seed), "--number", str(scene.number)]
    printed = f"{shlex.join(shown)} > {scene.name}.toml"
    return printed, f"{record} --no-png --no-mp4 --out {FOLDER}"
