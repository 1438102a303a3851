"""A small quadratic programme: the best mixture of a few things, such as gradients."""

import numpy as np

from learners.arrays import FloatArray

_TOLERANCE = 1e-10


def lowest_mixture(quadratic: FloatArray, linear: FloatArray) -> FloatArray:
    """Minimise ½ λ·Q λ + e·λ over mixtures, λ ≥ 0 and Σ λ = 1.

    The method is that of active sets (Nocedal and Wright, "Numerical Optimization", 2006, section
    16.5): find the minimum over the things in use, leave out those whose share would have to be
    negative, take in the one that lowers the objective most, until none lowers it.

    Args:
        quadratic: [J, J], Q, positive semidefinite.
        linear: [J], e.

    Returns:
        [J], λ.
    """
    count = len(linear)
    # a touch of curvature, because more gradients than dimensions make Q singular
    quadratic = quadratic + np.eye(count) * (1e-12 * np.trace(quadratic) / count + 1e-300)
    used = np.array([np.argmin(0.5 * np.diagonal(quadratic) + linear)])
    mixture = np.zeros(count)
    mixture[used] = 1.0
    for _ in range(10 * count):
        wanted, level = _stationary(quadratic[np.ix_(used, used)], linear[used])
        too_low = wanted <= 0.0
        if too_low.any():
            now = mixture[used]
            reach = np.where(too_low, now / np.where(too_low, now - wanted, 1.0), np.inf)
            share = float(reach.min())
            mixture[used] = np.maximum(now + share * (wanted - now), 0.0)
            mixture[used[reach <= share]] = 0.0
            used = used[reach > share]
            continue
        mixture[used] = wanted
        slopes = quadratic @ mixture + linear
        best = int(np.argmin(slopes))
        if best in used or slopes[best] >= level - _TOLERANCE * abs(level):
            break
        used = np.append(used, best)
    shares: FloatArray = mixture / mixture.sum()
    return shares


def _stationary(quadratic: FloatArray, linear: FloatArray) -> tuple[FloatArray, float]:
    """The λ with Σ λ = 1 at which every slope of ½ λ·Q λ + e·λ is the same, and that slope."""
    count = len(linear)
    system = np.ones((count + 1, count + 1))
    system[:count, :count] = quadratic
    system[count, count] = 0.0
    solution = np.linalg.solve(system, np.append(-linear, 1.0))
    return solution[:count], -float(solution[count])
