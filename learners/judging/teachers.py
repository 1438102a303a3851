"""Teachers: people of known taste, whom learners learn from and are measured against."""

from collections.abc import Iterable
from dataclasses import asdict, dataclass

import numpy as np

from learners.arrays import FloatArray
from learners.errors import InputError
from learners.judging.parameters import PROFILES, REWARD, CptParameters
from learners.judging.values import prospect_value
from learners.judging.weighting import Weighting, curvature
from learners.names import find

BETA = 20.0
"""Inverse temperature of choices: how decided people are, per unit of value."""


def check_beta(beta: float) -> None:
    """Raise `InputError` if an inverse temperature is not a finite number above 0."""
    if not (np.isfinite(beta) and beta > 0.0):
        raise InputError(f"beta {beta} is not allowed: a finite number above 0")


@dataclass(frozen=True)
class Teacher:
    """Someone who judges prospects by cumulative prospect theory.

    Attributes:
        parameters: α, η, λ, γ, δ; all ones is expected utility.
        reward: θ, what one unit of each feature is worth.
        beta: β, how decided the choices are, per unit of value.
        reference: r, what counts as neither gain nor loss, in units of utility.
        weighting: how probabilities are weighted, see `weight`.

    Raises:
        InputError: if a number is not finite, β is not above 0, or a curvature is one for which
            the weighting is not monotone.
    """

    name: str
    parameters: CptParameters
    reward: tuple[float, ...] = REWARD
    beta: float = BETA
    reference: float = 0.0
    weighting: Weighting = "prelec"

    def __post_init__(self) -> None:
        if not self.name:
            raise InputError("teacher '' is not allowed: a name")
        check_beta(self.beta)
        for field, numbers in (("reward", self.reward), ("reference", [self.reference])):
            wrong = [number for number in numbers if not np.isfinite(number)]
            if wrong:
                raise InputError(f"{field} contains {wrong[0]}: only finite numbers are allowed")
        for field in ("gamma", "delta"):
            curvature(field, getattr(self.parameters, field), self.weighting)
        object.__setattr__(self, "reward", tuple(float(number) for number in self.reward))

    def values(self, features: FloatArray) -> FloatArray:
        """Value V of prospects whose features are [..., K, D], as [...].

        Raises:
            InputError: if there are not as many features as the reward has numbers.
        """
        if features.shape[-1] != len(self.reward):
            raise InputError(
                f"reward of {len(self.reward)} numbers is not allowed: "
                f"{features.shape[-1]}, one for each feature"
            )
        utilities: FloatArray = features @ np.array(self.reward)
        return prospect_value(
            utilities, self.parameters, weighting=self.weighting, reference=self.reference
        )

    def description(self) -> dict[str, object]:
        """All that makes the teacher, in plain types."""
        return asdict(self) | {"reward": list(self.reward)}


TEACHERS: dict[str, Teacher] = {name: Teacher(name, people) for name, people in PROFILES.items()}
"""The three teachers of the study, see `PROFILES`."""


def find_teachers(names: Iterable[Teacher | str]) -> tuple[Teacher, ...]:
    """The teachers of these names, see `find`."""
    return find("teacher", names, TEACHERS)
