"""Two actions of one scene side by side, for a person to choose between."""

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from scenes import MetaAction, Rollouts
from scenes.errors import LARGEST_SEED
from studio.arrays import FloatArray, IntArray
from studio.errors import InputError
from studio.scene.selection import only, places_of
from studio.style.palette import Theme

QUESTION = "Which would you rather the robot did?"
"""What a comparison asks the person who watches it."""

SIDES = ("A", "B")
"""What the left and the right are called."""

OPENING = 1.0
"""How long both scenes are shown at rest before anything moves, s."""

CLOSING = 6.0
"""How long the end is shown, s."""

_SLOW = 3  # outcomes at the beginning that play slowly enough to follow everybody
_TIMES_REAL = 2.5  # how much faster than in reality these play
_SLOW_MOVING = (0.8, 6.0)  # how long they move at least and at most, s
_SLOW_STANDING = 0.5  # how long the end of each stands still, s
_PLAYING = 20.0  # how long all others together take, unless they are very few or very many, s
_SHORTEST_OUTCOME = 0.1  # how long each of these takes at least, s
_MOVING = 0.8  # share of that time in which it moves; after that its end stands still


@dataclass(frozen=True)
class Comparison:
    """Two prospects: the outcomes of one action on the left, those of another on the right.

    It is blind unless told otherwise: who is to choose sees outcomes, not what the robot was told
    to do, nor what others think of it.

    Attributes:
        rollouts: of the scene under these two actions, left then right.
        actions: names of all actions of the scene in their order, which gives them their colours.
        seed: seed that chose the sides.
        named: whether whoever watches is told which action is on which side.
    """

    rollouts: Rollouts
    actions: tuple[str, ...]
    seed: int
    named: bool = False

    @property
    def left(self) -> MetaAction:
        """The action on the left, called A."""
        return self.rollouts.actions[0]

    @property
    def right(self) -> MetaAction:
        """The action on the right, called B."""
        return self.rollouts.actions[1]

    @property
    def shown(self) -> Rollouts:
        """The rollouts under the names that are shown: those of the sides if it is blind."""
        if self.named:
            return self.rollouts
        sides = zip(self.rollouts.actions, SIDES, strict=True)
        actions = tuple(replace(action, name=side) for action, side in sides)
        return replace(self.rollouts, actions=actions)

    def coloured(self, theme: Theme) -> Theme:
        """The theme with the colours of what is shown, which tell no action if it is blind."""
        return theme.of(self.actions) if self.named else theme.of_sides(SIDES)


def check_two(one: str, other: str, known: Sequence[str]) -> None:
    """Make sure that two names are those of two actions.

    Raises:
        InputError: if there is no such action, or both are the same.
    """
    places_of((one, other), known)
    if one == other:
        raise InputError(f"actions: {one!r} twice: two different ones are needed")


def words_of_pair(one: str, other: str, named: bool) -> tuple[str, ...]:
    """What the files of a comparison are named by, after the words of the scene.

    Where the names of the actions must not be told, a digest of the two stands for them, whichever
    comes first: two comparisons of one scene have two names.
    """
    if named:
        return one, other
    digest = hashlib.sha256(repr(sorted((one, other))).encode()).hexdigest()
    return "compare", digest[:6]


def side_by_side(
    rollouts: Rollouts, one: str, other: str, seed: int = 0, *, named: bool = False
) -> Comparison:
    """Put two actions of a scene side by side, and say whether whoever watches is told their names.

    Which one comes to the left is random, so that no preference for a side passes for one for an
    action. It depends on the seed and on the two names, whichever of them is given first.

    Raises:
        InputError: if there is no such action, both are the same, or the seed is not allowed.
    """
    check_two(one, other, rollouts.names)
    if not 0 <= seed <= LARGEST_SEED:
        raise InputError(f"seed: {seed} is not allowed: 0 to {LARGEST_SEED}")
    sides = only(rollouts, _shuffled(sorted((one, other)), seed))
    return Comparison(sides, rollouts.names, seed, named)


def _shuffled(names: list[str], seed: int) -> list[str]:
    # the length of the first name tells it from the second
    entropy = [seed, len(names[0].encode()), *"".join(names).encode()]
    generator = np.random.Generator(np.random.Philox(np.random.SeedSequence(entropy)))
    return [names[index] for index in generator.permutation(2)]


def ended_after(rollouts: Rollouts) -> IntArray:
    """How many of K outcomes have ended once 0, 1 to M of those with paths have played, [M + 1].

    Where there are more outcomes than paths, several are counted with each that plays.
    """
    ended: IntArray = np.arange(rollouts.paths + 1) * rollouts.count // rollouts.paths
    return ended


@dataclass(frozen=True)
class Timetable:
    """When each of N outcomes plays, one after the other, s.

    The first three play at 2.5 times the pace of reality. Fifty others take 0.4 s each, a pace at
    which people read such animations well (Hullman et al., "Hypothetical outcome plots outperform
    error bars and violin plots", PLoS ONE 2015; Kale et al., "Hypothetical outcome plots help
    untrained observers judge trends in ambiguous data", IEEE TVCG 2019).
    """

    moving: FloatArray  # [N], how long each moves
    lengths: FloatArray  # [N], how long its turn takes: having moved, its end stands still

    @classmethod
    def of(cls, count: int, horizon: float) -> "Timetable":
        """The timetable of `count` outcomes of a horizon, s."""
        least, most = _SLOW_MOVING
        slow = min(max(horizon / _TIMES_REAL, least), most)
        slow_length = slow + _SLOW_STANDING
        others = max(count - _SLOW, 0)
        each = min(max(_PLAYING / max(others, 1), _SHORTEST_OUTCOME), slow_length)
        is_slow = np.arange(count) < _SLOW
        return cls(np.where(is_slow, slow, _MOVING * each), np.where(is_slow, slow_length, each))

    @property
    def starts(self) -> FloatArray:
        """When each begins to move, [N]."""
        starts: FloatArray = OPENING + np.cumsum(self.lengths) - self.lengths
        return starts

    @property
    def ends(self) -> FloatArray:
        """When each comes to its end, [N]."""
        return self.starts + self.moving

    @property
    def over(self) -> float:
        """When all have played."""
        return OPENING + float(self.lengths.sum())
