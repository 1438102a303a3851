"""The learner who takes people for maximisers of expected utility."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from learners.arrays import FloatArray
from learners.asking.preferences import Preferences
from learners.asking.prospects import Prospects
from learners.fitting.descent import Optimum, minimise
from learners.fitting.fits import LONGEST_REWARD_STEP, REWARD_DEVIATION, Fit, asked_prospects
from learners.fitting.likelihood import Choices
from learners.judging.teachers import BETA


@dataclass(frozen=True)
class EuLearner:
    """Fits V = θ·(mean φ): θ, and nothing else.

    Attributes:
        reward_deviation: standard deviation of the prior of each number of θ.
    """

    name: ClassVar[str] = "eu"
    reward_deviation: float = REWARD_DEVIATION

    def description(self) -> dict[str, object]:
        """All that makes the learner, in plain types."""
        return {"name": self.name, "reward_deviation": self.reward_deviation}

    def fit(self, prospects: Prospects, preferences: Preferences, beta: float = BETA) -> Fit:
        """Find the θ that best explains the choices; the minimum is unique.

        Raises:
            InputError: if there is no choice, or β is out of range.
        """
        features, choices = asked_prospects(prospects, preferences, beta)
        found = fit_mean_utility(features.mean(axis=1), choices, self.reward_deviation)
        return Fit.of(self, choices, found, theta=found.z)


def fit_mean_utility(means: FloatArray, choices: Choices, deviation: float) -> Optimum:
    """Fit θ to choices between prospects of mean features [P, D]; the search begins at θ = 0."""
    count = means.shape[1]
    return minimise(
        lambda theta: ((theta * means).sum(axis=1), means),
        choices,
        deviation=np.full(count, deviation),
        start=np.zeros(count),
        longest_step=np.full(count, LONGEST_REWARD_STEP),
    )
