"""What is said of a scene in pictures, recordings and the terminal alike."""

from collections.abc import Sequence

import numpy as np

from learners import REWARD
from scenes import Rollouts
from studio.scene.certainty import RESAMPLES, wilson
from studio.scene.judgements import Judgement
from studio.style.words import (
    action_label,
    alternatives,
    counted,
    number,
    rounded_number,
    share_told,
)


def pick_told(judgement: Judgement, names: Sequence[str]) -> str:
    """What a teacher picks among actions of these names: "forward", or "forward or slow down"."""
    return alternatives([action_label(names[index]) for index in judgement.candidates])


def pick_with_shares(judgement: Judgement, names: Sequence[str]) -> str:
    """What a teacher picks, with the shares of draws: "forward (70 %) or slow down (29 %)"."""
    shares = judgement.shares
    return alternatives(
        [
            f"{action_label(names[index])} ({100.0 * shares[index]:.0f} %)"
            for index in judgement.candidates
        ]
    )


def contact_told(rollouts: Rollouts, index: int) -> str:
    """How often there is contact under an action, as a share with its 95 % interval."""
    share = wilson(int(rollouts.touched[index].sum()), rollouts.count)
    return share_told(share.value, share.low, share.high)


def draws_told(judgements: Sequence[Judgement], count: int) -> str:
    """Where the intervals and shares of judgements from `count` rollouts come from."""
    held_against = judgements[0].reference
    source = held_against.rollouts if held_against else count
    drawn = f"{RESAMPLES} draws of {counted(count, 'rollout')} from {source}"
    return f"In brackets: what 95 % of {drawn} give. A pick is picked in 95 % of them."


def bias_told(judgements: Sequence[Judgement], names: Sequence[str], count: int) -> str:
    """By how much values from `count` rollouts are off at worst; empty without a reference."""
    held_against = [(each, each.reference) for each in judgements if each.reference]
    if not held_against:
        return ""
    judgement, worst = max(held_against, key=lambda each: float(np.abs(each[1].bias).max()))
    index = int(np.abs(worst.bias).argmax())
    off = float(worst.bias[index])
    where = f"({judgement.label}, {action_label(names[index])})"
    direction = "too high" if off > 0.0 else "too low"
    return (
        f"On average, {counted(count, 'rollout')} give V {direction} by up to "
        f"{rounded_number(abs(off), 3, '.3f')} {where}, held against "
        f"{counted(worst.rollouts, 'rollout')}."
    )


def rollouts_told(rollouts: Rollouts, index: int) -> list[str]:
    """What came of each of the M rollouts under an action whose paths are kept."""
    columns = zip(
        (rollouts.features[index, : rollouts.paths] @ np.array(REWARD)).tolist(),
        rollouts.clearance_m[index].tolist(),
        rollouts.progress_m[index].tolist(),
        rollouts.deviation_m[index].tolist(),
        strict=False,
    )
    return [
        f"rollout {place}: utility {number(worth, '.3f')}, gap {gap:.2f} m, "
        f"progress {number(progress, '.2f')} m, aside {aside:.2f} m"
        for place, (worth, gap, progress, aside) in enumerate(columns)
    ]
