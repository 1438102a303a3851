"""How the three teachers judge the actions of one scene."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from learners import PROFILES, REWARD, CptParameters, prospect_value
from scenes import Rollouts
from studio.arrays import FloatArray, IntArray
from studio.style.palette import Colour, teacher_colour
from studio.style.words import teacher_name


@dataclass(frozen=True)
class Judgement:
    """What one teacher thinks of the A actions of a scene.

    Attributes:
        teacher: name of the profile, for example `tk`.
        parameters: the teacher's CPT parameters (all ones is expected utility).
        values: [A], the value V of each action's prospect.
    """

    teacher: str
    parameters: CptParameters
    values: FloatArray

    @property
    def label(self) -> str:
        """What people call the teacher."""
        return teacher_name(self.teacher)

    @property
    def colour(self) -> Colour:
        """The colour that stands for the teacher."""
        return teacher_colour(self.teacher)

    @property
    def best(self) -> int:
        """Index of the action that the teacher would pick; of equally good ones the first."""
        return int(np.argmax(self.values))

    @property
    def ranks(self) -> IntArray:
        """Rank of each action, [A], 0 for the best; of equally good ones the earlier is first."""
        return np.argsort(np.argsort(-self.values, kind="stable"))

    @property
    def certainty_equivalents(self) -> FloatArray:
        """The sure utility that the teacher values as much as each action's prospect, [A].

        Inverts the value function v(x) = x^α of gains and −λ(−x)^η of losses (Tversky and Kahneman,
        "Advances in Prospect Theory", J. Risk and Uncertainty 5, 1992).
        """
        own = self.parameters
        gain = np.maximum(self.values, 0.0) ** (1.0 / own.alpha)
        loss = (np.maximum(-self.values, 0.0) / own.loss_aversion) ** (1.0 / own.eta)
        return gain - loss

    def of(self, places: Sequence[int]) -> "Judgement":
        """What the teacher thinks of the actions at these places, as if there were no others."""
        return replace(self, values=self.values[list(places)])

    def discordant_pairs(self, other: "Judgement") -> list[tuple[int, int]]:
        """Pairs of actions that the two teachers prefer the other way round, as indices.

        The first action of a pair is what this teacher prefers. Two actions that either teacher
        finds equally good are no such pair. Pairs come in the order of this teacher's preference.
        """
        order = np.argsort(-self.values, kind="stable").tolist()
        return [
            (better, worse)
            for place, better in enumerate(order)
            for worse in order[place + 1 :]
            if self.values[better] > self.values[worse]
            and other.values[better] < other.values[worse]
        ]


def utilities(rollouts: Rollouts) -> FloatArray:
    """Utility θ*·φ of every outcome, [A, K]."""
    outcome_utilities: FloatArray = rollouts.features @ np.array(REWARD)
    return outcome_utilities


def judge(rollouts: Rollouts) -> tuple[Judgement, ...]:
    """Let every teacher value every action."""
    worths = utilities(rollouts)
    return tuple(
        Judgement(teacher, parameters, prospect_value(worths, parameters))
        for teacher, parameters in PROFILES.items()
    )
