"""Two actions of one scene side by side, for a person to choose between."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from scenes import MetaAction, Rollouts
from scenes.errors import LARGEST_SEED
from studio.errors import InputError
from studio.scene.selection import only, places_of

QUESTION = "Which would you rather the robot did?"
"""What a comparison asks the person who watches it."""

SIDES = ("A", "B")
"""What the left and the right are called."""

OPENING = 0.6
"""How long both scenes are shown at rest before anything moves, s."""

MOVING = 0.8
"""Share of an outcome's time in which it moves; after that its end stands still."""

CLOSING = 3.0
"""How long the end is shown, s."""

# how long outcomes play, s
_PLAYING = 20.0  # all of them together, unless they are very few or very many
_SHORTEST_OUTCOME, _LONGEST_OUTCOME = 0.1, 2.0  # at least and at most


@dataclass(frozen=True)
class Comparison:
    """Two prospects: the outcomes of one action on the left, those of another on the right.

    Attributes:
        rollouts: of the scene under these two actions, left then right.
        actions: names of all actions of the scene in their order, which gives them their colours.
        seed: seed that chose the sides.
    """

    rollouts: Rollouts
    actions: tuple[str, ...]
    seed: int

    @property
    def left(self) -> MetaAction:
        """The action on the left, called A."""
        return self.rollouts.actions[0]

    @property
    def right(self) -> MetaAction:
        """The action on the right, called B."""
        return self.rollouts.actions[1]


def check_two(one: str, other: str, known: Sequence[str]) -> None:
    """Make sure that two names are those of two actions.

    Raises:
        InputError: if there is no such action, or both are the same.
    """
    places_of((one, other), known)
    if one == other:
        raise InputError(f"actions: {one!r} twice: two different ones are needed")


def side_by_side(rollouts: Rollouts, one: str, other: str, seed: int = 0) -> Comparison:
    """Put two actions of a scene side by side.

    Which one comes to the left is random, so that no preference for a side passes for one for an
    action. It depends on the seed and on the two names, whichever of them is given first.

    Raises:
        InputError: if there is no such action, both are the same, or the seed is not allowed.
    """
    check_two(one, other, rollouts.names)
    if not 0 <= seed <= LARGEST_SEED:
        raise InputError(f"seed: {seed} is not allowed: 0 to {LARGEST_SEED}")
    sides = only(rollouts, _shuffled(sorted((one, other)), seed))
    return Comparison(sides, rollouts.names, seed)


def _shuffled(names: list[str], seed: int) -> list[str]:
    # the length of the first name tells it from the second
    entropy = [seed, len(names[0].encode()), *"".join(names).encode()]
    generator = np.random.Generator(np.random.Philox(np.random.SeedSequence(entropy)))
    return [names[index] for index in generator.permutation(2)]


def seconds_each(count: int) -> float:
    """How long each of `count` outcomes takes to play, s.

    Fifty take 0.4 s each, a pace at which people read such animations well (Hullman et al.,
    "Hypothetical outcome plots outperform error bars and violin plots", PLoS ONE 2015; Kale et
    al., "Hypothetical outcome plots help untrained observers judge trends in ambiguous data", IEEE
    TVCG 2019).
    """
    return min(max(_PLAYING / count, _SHORTEST_OUTCOME), _LONGEST_OUTCOME)
