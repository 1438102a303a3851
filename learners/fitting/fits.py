"""What a learner is, and what it hands back.

To add a learner, write a class that has a `name`, a `fit` and a `description` in a file of its own.
Its `fit` returns a `Fit`, or a subclass with its own `values` if it values prospects otherwise.
"""

import os
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import NamedTuple, Protocol

import numpy as np

from learners.arrays import FloatArray
from learners.asking.preferences import Preferences
from learners.asking.prospects import Prospects
from learners.errors import InputError
from learners.fitting.descent import Optimum
from learners.fitting.likelihood import Choices
from learners.judging.parameters import CptParameters
from learners.judging.teachers import BETA, check_beta
from learners.judging.values import expected_utility, prospect_value

REWARD_DEVIATION = 1.0
"""Standard deviation of the prior of each number of θ, around 0.

Features are of the order of 1, so with β = 20 the prior only says that one unit of a feature shifts
the log-odds of a choice by some tens at most. It keeps θ finite where some θ explains every single
choice (separable choices).
"""

LONGEST_REWARD_STEP = 0.5
"""How far a number of θ may move in one step of a fit."""


@dataclass(frozen=True)
class Fit:
    """What was learned from N choices.

    Attributes:
        learner: name of the learner.
        theta: [D], θ. Choices tell β‖θ‖^α only, so its length trades off with β and the exponents.
        parameters: α, η, λ, γ, δ; None for expected utility.
        reference: r, in units of utility.
        beta: β that the choices were taken to have.
        pairs: N.
        nll: mean negative log-likelihood of the N choices, nats a choice.
        converged: whether the fit ended because there was nothing left to gain.
        steps: how many steps the search took.
        expected_decrease: by how much a further step promised to lower the objective of all N
            choices together, nats, see `descent`.
    """

    learner: str
    theta: FloatArray
    parameters: CptParameters | None
    reference: float
    beta: float
    pairs: int
    nll: float
    converged: bool
    steps: int
    expected_decrease: float

    @classmethod
    def of(
        cls,
        learner: "Learner",
        choices: Choices,
        found: Optimum,
        theta: FloatArray,
        parameters: CptParameters | None = None,
        reference: float = 0.0,
    ) -> "Fit":
        """The fit that the optimum of a search means: θ, the parameters and r found there."""
        pairs = len(choices.preferred)
        return cls(
            learner=learner.name,
            theta=theta,
            parameters=parameters,
            reference=reference,
            beta=choices.beta,
            pairs=pairs,
            nll=found.nll / pairs,
            converged=found.converged,
            steps=found.steps,
            expected_decrease=found.expected_decrease,
        )

    @property
    def unit_theta(self) -> FloatArray:
        """θ/‖θ‖, [D]: its direction, in which different learners can be compared."""
        return unit_vector(self.theta)

    def values(self, features: FloatArray) -> FloatArray:
        """Learnt value V of prospects whose features are [..., K, D], as [...]."""
        utilities = features @ self.theta
        if self.parameters is None:
            return expected_utility(utilities)
        return prospect_value(utilities, self.parameters, reference=self.reference)


class Learner(Protocol):
    """A model of people that can be fitted to their choices."""

    @property
    def name(self) -> str:
        """What to call it."""

    def fit(self, prospects: Prospects, preferences: Preferences, beta: float = BETA) -> Fit:
        """Find the person who best explains the choices; β fixes the scale of θ."""

    def description(self) -> dict[str, object]:
        """All that makes the learner, in plain types."""


class Problem(NamedTuple):
    """One thing to fit: the arguments of `Learner.fit`."""

    learner: Learner
    prospects: Prospects
    preferences: Preferences
    beta: float = BETA


def unit_vector(theta: Sequence[float] | FloatArray) -> FloatArray:
    """θ/‖θ‖, [D]; zeros if there is no direction."""
    array = np.asarray(theta, dtype=np.float64)
    length = float(np.sqrt((array**2).sum()))
    return array / length if length > 0.0 else array


def fit_many(problems: Sequence[Problem], workers: int | None = None) -> list[Fit]:
    """Fit a batch of problems side by side; the fits come in the order of the problems.

    The arrays of one problem fit into a processor's cache, so problems are handed out one by one.
    Stacked into larger arrays they would take longer, and the rounding of one fit would depend on
    the rest of the batch. As it is, a fit is the same bits alone and in company. As many fits are
    done at a time as there are workers; one per processor if their number is left out.
    """
    with ThreadPoolExecutor(workers or os.cpu_count()) as pool:
        return list(pool.map(lambda p: p.learner.fit(p.prospects, p.preferences, p.beta), problems))


def asked_prospects(
    prospects: Prospects, preferences: Preferences, beta: float
) -> tuple[FloatArray, Choices]:
    """The P different prospects that the choices are about, [P, K, D], and the choices among them.

    Raises:
        InputError: if there is no choice, or β is out of range.
    """
    check_beta(beta)
    if len(preferences) == 0:
        raise InputError("preferences: none is there: one choice or more is needed")
    scenes, actions, outcomes, count = prospects.features.shape
    sides = preferences.scenes * actions + np.stack([preferences.preferred, preferences.other])
    asked, places = np.unique(sides, return_inverse=True)
    features = prospects.features.reshape(scenes * actions, outcomes, count)[asked]
    preferred, other = places.reshape(sides.shape)
    return features, Choices(preferred, other, beta)
