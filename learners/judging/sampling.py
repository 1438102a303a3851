"""What a value is worth that comes from few outcomes: how it scatters, and by how much it is off.

The outcomes of a prospect are a sample of what may happen. Another sample would have had another
value; and since the weights of rare outcomes bend, a sample's value is off on average, too.
"""

from collections.abc import Iterator, Sequence

import numpy as np

from learners.arrays import FloatArray, IntArray
from learners.judging.parameters import CptParameters
from learners.judging.values import value
from learners.judging.weighting import weight

_MOST_AT_ONCE = 2_000_000  # numbers in the largest array


def resampled_values(
    utilities: FloatArray, people: Sequence[CptParameters], counts: IntArray
) -> FloatArray:
    """Values of prospects in which every outcome is there as often as it was drawn.

    The value of each draw is what `prospect_value` says of the outcomes drawn. The bootstrap (Efron
    and Tibshirani, "An Introduction to the Bootstrap", 1993, chapter 6) takes the scatter of these
    values for that of the value itself.

    Args:
        utilities: [A, K], one utility per outcome.
        people: the parameters of N people who value them.
        counts: [R, K], how often each of the K outcomes was drawn in each of R draws, for all
            prospects alike; all draws are of the same size, above 0.

    Returns:
        [N, R, A].
    """
    size = int(counts[0].sum())
    # a draw cuts the ranked outcomes at multiples of 1/size, so there are few weights to know
    shares = np.arange(size + 1) / size
    weights = [(weight(shares, each.delta), weight(shares, each.gamma)[::-1]) for each in people]
    by_outcome = np.ascontiguousarray(counts.T, dtype=np.int32)  # (K, R)
    values = np.empty((len(people), len(counts), len(utilities)))
    for index, outcomes in enumerate(utilities):
        order = np.argsort(outcomes, kind="stable")
        ranked = outcomes[order]
        losses = int((ranked < 0.0).sum())
        for draws in _slices(len(counts), len(ranked) + 1):
            worse = np.zeros((len(ranked) + 1, len(counts[draws])), dtype=np.int32)
            np.cumsum(by_outcome[order, draws], axis=0, out=worse[1:])
            for place, (person, (of_losses, of_gains)) in enumerate(
                zip(people, weights, strict=True)
            ):
                felt = value(ranked, person)
                lost = felt[:losses] @ np.diff(of_losses[worse[: losses + 1]], axis=0)
                gained = -felt[losses:] @ np.diff(of_gains[worse[losses:]], axis=0)
                values[place, draws, index] = lost + gained
    return values


def expected_sample_value(
    utilities: FloatArray, parameters: CptParameters, size: int
) -> FloatArray:
    """The value that samples of the outcomes have on average.

    Of `size` outcomes drawn independently, a share that has the binomial distribution is worse than
    a given one. In the average over samples a weight w(p) therefore becomes E[w(n/size)], n being
    binomial: the Bernstein polynomial of w (Lorentz, "Bernstein Polynomials", 1953, section 1.1).

    Args:
        utilities: [A, K], one utility per outcome, all equally likely.
        parameters: of the person who values them.
        size: how many outcomes a sample has, above 0.

    Returns:
        [A]: what `prospect_value` says of a sample, on average over all samples.
    """
    shares = np.arange(size + 1) / size
    number = utilities.shape[-1]
    cuts = np.arange(number + 1) / number
    chances = binomial_chances(size, cuts)  # (K+1, size+1)
    of_losses = np.diff(chances @ weight(shares, parameters.delta))
    of_gains = np.diff(chances @ weight(shares, parameters.gamma))[::-1]
    felt = value(np.sort(utilities, axis=-1), parameters)
    expected: FloatArray = (np.where(felt < 0.0, of_losses, of_gains) * felt).sum(axis=-1)
    return expected


def binomial_chances(size: int, probabilities: FloatArray) -> FloatArray:
    """How likely 0, 1, ..., `size` successes are at each probability [N], [N, size + 1]."""
    number = np.arange(size + 1)
    log_factorials = np.append(0.0, np.log(number[1:]).cumsum())
    log_ways = log_factorials[-1] - log_factorials - log_factorials[::-1]
    inside = np.clip(probabilities, 1e-300, 1.0 - 1e-16)[:, None]
    chances: FloatArray = np.exp(
        log_ways + number * np.log(inside) + (size - number) * np.log1p(-inside)
    )
    chances[probabilities == 0.0] = number == 0
    chances[probabilities == 1.0] = number == size
    return chances


def _slices(rows: int, width: int) -> Iterator[slice]:
    """Slices that cover rows of this width, each of a size that memory and caches bear."""
    step = max(1, _MOST_AT_ONCE // width)
    return (slice(start, start + step) for start in range(0, rows, step))
