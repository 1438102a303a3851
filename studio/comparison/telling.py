"""Which outcomes of a comparison tell most: the worst and the typical one of each side."""

from dataclasses import dataclass

from scenes import Rollouts
from studio.scene.judgements import utilities


@dataclass(frozen=True)
class TellingOutcome:
    """An outcome of each side that stands for something."""

    name: str  # what it stands for
    places: tuple[int, ...]  # which outcome that is on each side


def telling_outcomes(rollouts: Rollouts) -> tuple[TellingOutcome, ...]:
    """The worst and the typical outcome of each action, of those whose paths are kept.

    They are told by their utility θ·φ, which no teacher has bent: the worst has the lowest one, and
    the typical one lies in the middle of all. A single outcome stands for nothing.
    """
    order = utilities(rollouts.with_paths()).argsort(axis=1, kind="stable")  # (A, M)
    count = order.shape[1]
    if count < 2:
        return ()
    named = {"worst": 0, "typical": (count - 1) // 2}
    return tuple(
        TellingOutcome(name, tuple(order[:, rank].tolist())) for name, rank in named.items()
    )
