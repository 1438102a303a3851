"""The learner who takes people to judge by cumulative prospect theory."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from learners.arrays import FloatArray
from learners.asking.preferences import Preferences
from learners.asking.prospects import Prospects
from learners.fitting.descent import minimise
from learners.fitting.eu import fit_mean_utility
from learners.fitting.fits import LONGEST_REWARD_STEP, REWARD_DEVIATION, Fit, asked_prospects
from learners.fitting.slopes import feature_planes, value_slopes
from learners.judging.parameters import CptParameters
from learners.judging.teachers import BETA

PARAMETER_DEVIATION = (0.5, 0.5, 1.0, 0.5, 0.5)
"""Standard deviations of the priors of ln α, ln η, ln λ, ln γ, ln δ, around 0.

The priors are centred on 0 because people are taken for maximisers of expected utility until they
show otherwise. They are as wide as this because 95 % of each then lies between 0.37 and 2.7, and
of λ between 0.14 and 7.4, which covers what is found in people (Booij, van Praag and van de Kuilen,
"A Parametric Analysis of Prospect Theory's Functionals", Theory and Decision 68, 2010, table 1).
A hundred choices outweigh them.
"""

STARTS = (
    CptParameters(alpha=0.9, eta=0.9, loss_aversion=1.5, gamma=0.8, delta=0.8),
    CptParameters(alpha=0.7, eta=0.7, loss_aversion=3.5, gamma=0.4, delta=0.4),
)
"""Where searches begin: at a mild and at an extreme person, neither of them one of the profiles.

Their θ is the one that best explains the choices by expected utility. Both starts mostly lead to
the same minimum, but with 100 or 200 choices one may end a few nats above the other.
"""

ROUGHLY = 0.03  # how near its minimum each start is followed before the better goes on alone, nats
MANY_CHOICES = 400  # from here on the starts hardly differ in where they end: the first is enough
LONGEST_LOG_STEP = 0.5  # how far the logarithm of a parameter may move in one step of a fit

# which of ln α, ln η, ln λ, ln γ, ln δ each fitted number moves
UNTIED = np.eye(5)
TIED = np.array([[1, 1, 0, 0, 0], [0, 0, 1, 0, 0], [0, 0, 0, 1, 1]], dtype=np.float64)


def tied_means(ties: FloatArray, numbers: Sequence[float] | FloatArray) -> FloatArray:
    """Five numbers, one for each of α, η, λ, γ, δ, averaged over those that are tied."""
    return np.asarray(ties / ties.sum(axis=1, keepdims=True) @ numbers, dtype=np.float64)


def prior_deviation(linear: int, ties: FloatArray, reward_deviation: float) -> FloatArray:
    """Standard deviations of the priors of the numbers of θ and r, and of the tied logarithms."""
    return np.concatenate(
        [np.full(linear, reward_deviation), tied_means(ties, PARAMETER_DEVIATION)]
    )


@dataclass(frozen=True)
class CptLearner:
    """Fits θ and α, η, λ, γ, δ together, with the weighting of Prelec.

    Loss aversion, the curvatures and the length of θ trade off against one another. Tying α to η
    and γ to δ leaves two numbers fewer to tell apart, and determines the others better.

    Attributes:
        tied: whether α = η and γ = δ.
        learns_reference: whether the reference r is learnt too; otherwise it is 0.
        reward_deviation: standard deviation of the prior of each number of θ, and of r.
    """

    tied: bool = False
    learns_reference: bool = False
    reward_deviation: float = REWARD_DEVIATION

    @property
    def name(self) -> str:
        """What to call it: `cpt`, `cpt-tied`, `cpt-reference` or `cpt-tied-reference`."""
        return "cpt" + "-tied" * self.tied + "-reference" * self.learns_reference

    def description(self) -> dict[str, object]:
        """All that makes the learner, in plain types."""
        return {"name": self.name, "reward_deviation": self.reward_deviation}

    def fit(self, prospects: Prospects, preferences: Preferences, beta: float = BETA) -> Fit:
        """Find the person who best explains the choices.

        Raises:
            InputError: if there is no choice, or β is out of range.
        """
        features, choices = asked_prospects(prospects, preferences, beta)
        planes = feature_planes(features)
        count = len(planes)
        ties = TIED if self.tied else UNTIED
        free_reference = int(self.learns_reference)

        def person(z: FloatArray) -> tuple[FloatArray, float, CptParameters]:
            reference = float(z[count]) if self.learns_reference else 0.0
            logs = (z[count + free_reference :, None] * ties).sum(axis=0)
            return z[:count], reference, CptParameters(*np.exp(logs).tolist())

        def model(z: FloatArray) -> tuple[FloatArray, FloatArray]:
            worth = value_slopes(planes, *person(z))
            by_reference = worth.by_reference[:, None][:, :free_reference]
            by_logs = np.einsum("pi,ji->pj", worth.by_log_parameters, ties)
            return worth.values, np.concatenate([worth.by_theta, by_reference, by_logs], axis=1)

        theta = fit_mean_utility(features.mean(axis=1), choices, self.reward_deviation).z
        linear = count + free_reference  # how many numbers θ and r are
        deviation = prior_deviation(linear, ties, self.reward_deviation)
        longest_step = np.repeat([LONGEST_REWARD_STEP, LONGEST_LOG_STEP], [linear, len(ties)])

        heads = []
        for mind in STARTS[:1] if len(preferences) >= MANY_CHOICES else STARTS:
            logs = tied_means(ties, np.log(mind.numbers))
            start = np.concatenate([theta, np.zeros(free_reference), logs])
            heads.append(minimise(model, choices, deviation, start, longest_step, ROUGHLY))
        best = min(heads, key=lambda head: head.objective)
        found = minimise(model, choices, deviation, best.z, longest_step)
        theta, reference, parameters = person(found.z)
        steps = found.steps + sum(head.steps for head in heads)
        return Fit.of(self, choices, replace(found, steps=steps), theta, parameters, reference)
