"""Many more rollouts of a scene, to tell how sure is what few of them say."""

from scenes import Rollouts, simulate
from studio.arrays import FloatArray
from studio.scene.judgements import utilities

REFERENCE_ROLLOUTS = 1000
"""How many rollouts of each action are enough to hold fewer ones against."""

_MOST_POSITIONS = 30_000_000  # of people; more would take seconds and gigabytes


def reference_utilities(rollouts: Rollouts) -> FloatArray | None:
    """Utilities of 1000 outcomes of every action, [A, 1000], the given ones among them.

    The compiled engine simulates them, whichever engine the given rollouts are from: it gives the
    same rollouts.

    Returns:
        None if the given rollouts are as many themselves, or so many more would take too long.
    """
    actions, _, times, people = rollouts.pedestrians.shape[:4]
    is_large = actions * REFERENCE_ROLLOUTS * times * people > _MOST_POSITIONS
    if rollouts.count >= REFERENCE_ROLLOUTS or is_large:
        return None
    many = simulate(
        rollouts.scene,
        rollouts.actions,
        REFERENCE_ROLLOUTS,
        rollouts.seed,
        noise=rollouts.noise,
        model=rollouts.model,
        horizon=rollouts.horizon,
        dt=rollouts.dt,
        wrap_angles=rollouts.wrap_angles,
        limits=rollouts.limits,
    )
    return utilities(many)
