"""Questions and answers: pairs of prospects, and the choices between them."""

from dataclasses import dataclass

import numpy as np

from learners.arrays import FloatArray, IntArray
from learners.asking.prospects import Prospects
from learners.errors import InputError
from learners.judging.teachers import Teacher
from learners.seeds import Stream, generator


@dataclass(frozen=True)
class Pairs:
    """N questions: which of two actions of a scene is better?"""

    scenes: IntArray  # [N], places of the scenes
    first: IntArray  # [N], places of the one action
    second: IntArray  # [N], places of the other action
    repeated: int = 0  # how many of the questions had been asked before in this series


@dataclass(frozen=True)
class Preferences:
    """N answers.

    Attributes:
        scenes: [N], places of the scenes.
        preferred: [N], places of the actions that were preferred.
        other: [N], places of the actions that were not.
        certainty: mean probability, 0.5 to 1, of the likelier of the teacher's two answers; None
            for people, of whom it is not known. Answers that are all certain teach little: they
            give no measure of how much better something is.
        repeated: how many of the questions had been asked before in this series.
    """

    scenes: IntArray
    preferred: IntArray
    other: IntArray
    certainty: float | None = None
    repeated: int = 0

    def __len__(self) -> int:
        return len(self.scenes)


def all_pairs(scenes: int, actions: int) -> Pairs:
    """Every pair of different actions of every scene, once."""
    first, second = np.triu_indices(actions, k=1)
    return Pairs(
        scenes=np.repeat(np.arange(scenes), len(first)),
        first=np.tile(first, scenes),
        second=np.tile(second, scenes),
    )


def sample_pairs(
    prospects: Prospects, count: int, seed: int, scenes: IntArray | None = None
) -> Pairs:
    """Draw pairs of different actions of one scene.

    No pair is drawn a second time before all pairs were drawn once. If more pairs are asked for
    than there are, all are drawn again in another order, and `Pairs.repeated` counts the
    repetitions. A longer series of the same seed begins with the shorter one. Only the scenes at
    the places `scenes`, such as `Split.training`, are asked about; all if they are left out.

    Raises:
        InputError: if the count or the seed is out of range.
    """
    if count < 1:
        raise InputError(f"pairs {count} is not allowed: 1 or more")
    if scenes is None:
        scenes = np.arange(len(prospects.scenes))
    there = all_pairs(len(scenes), len(prospects.actions))
    distinct = len(there.scenes)
    random = generator(seed, Stream.PAIRS)
    rounds = [random.permutation(distinct) for _ in range(-(-count // distinct))]
    drawn = np.concatenate(rounds)[:count]
    first, second = there.first[drawn], there.second[drawn]
    is_swapped = generator(seed, Stream.SIDES).random(count) < 0.5
    return Pairs(
        scenes=scenes[there.scenes[drawn]],
        first=np.where(is_swapped, second, first),
        second=np.where(is_swapped, first, second),
        repeated=max(count - distinct, 0),
    )


def first_log_odds(values: FloatArray, pairs: Pairs, beta: float) -> FloatArray:
    """Logarithm of the odds that the first of two is preferred, β(V_first − V_second), [N].

    This is the model of Bradley and Terry ("Rank Analysis of Incomplete Block Designs",
    Biometrika 39, 1952) with merits exp(βV); `values` are V of every prospect, [S, A].
    """
    return beta * (values[pairs.scenes, pairs.first] - values[pairs.scenes, pairs.second])


def probability(log_odds: FloatArray) -> FloatArray:
    """Probability of something whose odds have this logarithm."""
    # the hyperbolic tangent neither overflows nor loses the symmetry of the two sides
    return np.asarray(0.5 + 0.5 * np.tanh(0.5 * log_odds), dtype=np.float64)


def ask(teacher: Teacher, prospects: Prospects, pairs: Pairs, seed: int) -> Preferences:
    """Let a teacher answer.

    The answer to question n depends on the teacher, the question, the seed and n only. So a longer
    series begins with the answers of the shorter one, and teachers who think alike answer alike.
    """
    return answer(teacher.values(prospects.features), pairs, teacher.beta, seed)


def answer(values: FloatArray, pairs: Pairs, beta: float, seed: int) -> Preferences:
    """The answers of someone to whom the prospects have these values [S, A], see `ask`."""
    of_first = probability(first_log_odds(values, pairs, beta))
    is_first = generator(seed, Stream.LABELS).random(len(pairs.scenes)) < of_first
    return Preferences(
        scenes=pairs.scenes,
        preferred=np.where(is_first, pairs.first, pairs.second),
        other=np.where(is_first, pairs.second, pairs.first),
        certainty=float(np.maximum(of_first, 1.0 - of_first).mean()),
        repeated=pairs.repeated,
    )
