"""How teachers judge the actions of one scene, and how sure that is."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from learners import (
    PROFILES,
    REWARD,
    CptParameters,
    expected_sample_value,
    prospect_value,
    resampled_values,
)
from scenes import Rollouts
from studio.arrays import FloatArray, IntArray
from studio.scene.certainty import COVERAGE, Estimate, interval, resampled_counts
from studio.style.palette import Colour, Pen, teacher_colour, teacher_pen
from studio.style.words import teacher_name


@dataclass(frozen=True)
class Reference:
    """What a teacher would think of A actions if there were many more rollouts of them, M."""

    utilities: FloatArray  # [A, M], of the outcomes of the many rollouts
    values: FloatArray  # [A], the value V of each action's prospect
    bias: FloatArray  # [A], how much too large V from the fewer rollouts is on average

    @property
    def rollouts(self) -> int:
        """How many rollouts there are of each action, M."""
        return int(self.utilities.shape[1])

    def of(self, places: list[int]) -> "Reference":
        """What is said of the actions at these places."""
        return Reference(self.utilities[places], self.values[places], self.bias[places])


@dataclass(frozen=True)
class Judgement:
    """What one teacher thinks of the A actions of a scene, and how sure that is.

    Attributes:
        teacher: name of the profile, for example `tk`.
        parameters: the teacher's CPT parameters (all ones is expected utility).
        values: [A], the value V of each action's prospect.
        resampled: [R, A], what the values would be with other rollouts, as many: draws from the
            reference's, or from the same ones if there is no reference; in each draw all actions
            have the same rollouts.
        reference: what many more rollouts say; None if nobody simulated them.
    """

    teacher: str
    parameters: CptParameters
    values: FloatArray
    resampled: FloatArray
    reference: Reference | None = None

    def __repr__(self) -> str:
        # arrays would fill pages
        values = ", ".join(f"{value:.3f}" for value in self.values)
        return f"<Judgement of {self.label}: V = {values}>"

    @property
    def label(self) -> str:
        """What people call the teacher."""
        return teacher_name(self.teacher)

    @property
    def colour(self) -> Colour:
        """The colour that stands for the teacher."""
        return teacher_colour(self.teacher)

    @property
    def pen(self) -> Pen:
        """How the teacher's curves and marks are drawn."""
        return teacher_pen(self.teacher)

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
        return self._sure_utilities(self.values)

    @property
    def certainty_equivalent_interval(self) -> tuple[FloatArray, FloatArray]:
        """What 95 % of the draws give for the certainty equivalents: both ends, [A] each."""
        return self._sure_utilities(self.low), self._sure_utilities(self.high)

    @property
    def low(self) -> FloatArray:
        """What 2.5 % of the draws of rollouts lie below, for each value V, [A]."""
        return self._interval[0]

    @property
    def high(self) -> FloatArray:
        """What 2.5 % of the draws of rollouts lie above, for each value V, [A]."""
        return self._interval[1]

    @cached_property
    def shares(self) -> FloatArray:
        """In what share of the draws of rollouts the teacher would pick each action, [A]."""
        picks = self.resampled.argmax(axis=1)
        shares: FloatArray = np.bincount(picks, minlength=len(self.values)) / len(picks)
        return shares

    @property
    def candidates(self) -> tuple[int, ...]:
        """Indices of the actions that may be what the teacher picks, the likeliest first.

        They are the fewest that the teacher picks in 95 % of the draws of rollouts, and what the
        reference says is best: weights that bend may make few rollouts agree on what many deny. If
        there is but one, it is the pick; if there are several, it is open which of them.
        """
        shares = self.shares
        order = np.argsort(-shares, kind="stable")
        enough = int(np.searchsorted(np.cumsum(shares[order]), COVERAGE - 1e-9)) + 1
        likely = order[:enough].tolist()
        if self.reference is not None:
            best = int(self.reference.values.argmax())
            likely += [] if best in likely else [best]
        return tuple(likely)

    @property
    def is_sure(self) -> bool:
        """Whether the rollouts tell what the teacher picks."""
        return len(self.candidates) == 1

    def difference(self, one: int, other: int) -> Estimate:
        """By how much the teacher values one action more than another, V − V."""
        low, high = interval(self.resampled[:, one] - self.resampled[:, other])
        value = self.values[one] - self.values[other]
        return Estimate(float(value), float(low), float(high))

    def of(self, places: Sequence[int]) -> "Judgement":
        """What the teacher thinks of the actions at these places, as if there were no others."""
        taken = list(places)
        values, resampled = self.values[taken], self.resampled[:, taken]
        reference = self.reference and self.reference.of(taken)
        return replace(self, values=values, resampled=resampled, reference=reference)

    @cached_property
    def _interval(self) -> tuple[FloatArray, FloatArray]:
        return interval(self.resampled)

    def _sure_utilities(self, values: FloatArray) -> FloatArray:
        own = self.parameters
        gain = np.maximum(values, 0.0) ** (1.0 / own.alpha)
        loss = (np.maximum(-values, 0.0) / own.loss_aversion) ** (1.0 / own.eta)
        return gain - loss

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


def judge(
    rollouts: Rollouts,
    profiles: Mapping[str, CptParameters] = PROFILES,
    reference: FloatArray | None = None,
) -> tuple[Judgement, ...]:
    """Let every teacher value every action.

    Args:
        rollouts: the outcomes of the actions.
        profiles: the teachers, by name.
        reference: [A, M], the utilities of many more outcomes of the same actions, to hold the
            values against; left out, how sure the values are is guessed from the outcomes alone.
    """
    worths = utilities(rollouts)
    pool = worths if reference is None else reference
    counts = resampled_counts(rollouts.count, pool.shape[1])
    resampled = resampled_values(pool, tuple(profiles.values()), counts)
    judgements = []
    for (teacher, parameters), draws in zip(profiles.items(), resampled, strict=True):
        values = prospect_value(worths, parameters)
        many = None if reference is None else _held_against(reference, parameters, rollouts.count)
        judgements.append(Judgement(teacher, parameters, values, draws, many))
    return tuple(judgements)


def _held_against(many: FloatArray, parameters: CptParameters, count: int) -> Reference:
    """What the utilities of many outcomes say of values that come from `count` outcomes."""
    values = prospect_value(many, parameters)
    bias = expected_sample_value(many, parameters, count) - values
    return Reference(many, values, bias)
