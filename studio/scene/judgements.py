"""How the three teachers judge the actions of one scene."""

from dataclasses import dataclass

import numpy as np

from learners import PROFILES, REWARD, CptParameters, prospect_value
from scenes import Rollouts
from studio.arrays import FloatArray


@dataclass(frozen=True)
class Judgement:
    """What one teacher thinks of the actions of a scene.

    Attributes:
        teacher: name of the profile, for example `tk`.
        parameters: the teacher's CPT parameters (all ones is expected utility).
        values: [A], the value V of each action's prospect.
        best: index of the action that the teacher would pick.
    """

    teacher: str
    parameters: CptParameters
    values: FloatArray
    best: int


def utilities(rollouts: Rollouts) -> FloatArray:
    """Utility θ*·φ of every outcome, [A, K]."""
    outcome_utilities: FloatArray = rollouts.features @ np.array(REWARD)
    return outcome_utilities


def judge(rollouts: Rollouts) -> tuple[Judgement, ...]:
    """Let every teacher value every action."""
    outcome_utilities = utilities(rollouts)
    judgements = []
    for teacher, parameters in PROFILES.items():
        values = prospect_value(outcome_utilities, parameters)
        judgements.append(Judgement(teacher, parameters, values, int(np.argmax(values))))
    return tuple(judgements)
