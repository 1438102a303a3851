"""What outcomes are described by, in the units that people read, and how they come about over time.

`scenes.features` has the formulas of gap and progress, and describes whole rollouts by them; here
they are at every step.
"""

from dataclasses import dataclass

import numpy as np

from scenes import FEATURES, Rollouts
from scenes.features import distances_to_goal, gaps
from studio.arrays import BoolArray, FloatArray, IntArray
from studio.style.ticks import round_step

PERSON, WALL, NOTHING = 0, 1, 2
"""What the robot touched in a rollout, the worst first."""

_LEAST_RANGES = {"clearance": 1.0, "deviation": 0.2, "progress": 1.0, "smoothness": 1.0}
"""How far the histogram of a feature reaches from 0 at least, in its unit."""

_MOST_BINS = 25  # of a histogram of values on one side of 0
_ROUNDING = 1e-9  # a value that leaves the bins by this share of one does so by rounding only


@dataclass(frozen=True)
class Measure:
    """One feature of the outcomes, in metres where it is a length."""

    feature: str  # one of `FEATURES`
    unit: str  # of the values; empty if they have none
    values: FloatArray  # [A, K]

    @property
    def title(self) -> str:
        """The feature and its unit, if it has one."""
        return f"{self.feature}, {self.unit}" if self.unit else self.feature

    @property
    def is_counted(self) -> bool:
        """Whether the values are whole numbers; all other features are measured."""
        return self.feature == "collisions"


def measures(rollouts: Rollouts) -> tuple[Measure, ...]:
    """What the outcomes are described by, in the order of `FEATURES`."""
    in_metres = {
        "clearance": rollouts.clearance_m,
        "deviation": rollouts.deviation_m,
        "progress": rollouts.progress_m,
    }
    return tuple(
        Measure(feature, "m", in_metres[feature])
        if feature in in_metres
        else Measure(feature, "", rollouts.features[..., column])
        for column, feature in enumerate(FEATURES)
    )


def gap_over_time(rollouts: Rollouts) -> FloatArray:
    """Gap between the robot and the nearest person, infinite among nobody, [A, K, T+1], m."""
    to_people = gaps(rollouts.robot, rollouts.pedestrians)  # (A, K, T+1, P)
    nearest: FloatArray = to_people.min(axis=-1, initial=np.inf)
    return nearest


def progress_over_time(rollouts: Rollouts) -> FloatArray:
    """How much closer to its goal the robot has come since the start, [A, K, T+1], m."""
    to_goal = distances_to_goal(rollouts.robot, rollouts.scene)
    progress: FloatArray = to_goal[..., :1] - to_goal
    return progress


def touched_by(contact_step: IntArray, step: float | IntArray) -> BoolArray:
    """Whether rollouts with these steps of first contact have touched something by a step."""
    touched: BoolArray = (contact_step >= 0) & (contact_step <= step)
    return touched


def contact_kinds(rollouts: Rollouts, step: float = np.inf) -> IntArray:
    """What the robot has touched by a step, [A, K]: one of `PERSON`, `WALL` and `NOTHING`.

    Who has touched both a person and a wall counts as having touched a person.
    """
    people = touched_by(rollouts.person_step, step)
    walls = touched_by(rollouts.wall_step, step)
    kinds: IntArray = np.where(people, PERSON, np.where(walls, WALL, NOTHING))
    return kinds


def poses_at(rollouts: Rollouts, index: int, steps: IntArray) -> FloatArray:
    """Poses of the robot under an action at a step of each rollout [K], [N, 3], m and rad.

    Rollouts whose step is -1 and those whose paths are not kept are left out.
    """
    own = steps[: rollouts.paths]
    [there] = np.nonzero(own >= 0)
    poses: FloatArray = rollouts.robot[index, there, own[there]]
    return poses


def bin_edges(measure: Measure) -> FloatArray:
    """Edges of the bins of a measure, [B+1]: round ones, 0 among them, which hold all values."""
    values, least = measure.values, _LEAST_RANGES[measure.feature]
    low, high = min(0.0, float(values.min())), max(least, float(values.max()))
    width = round_step((1.0 - _ROUNDING) * max(-low, high), _MOST_BINS)
    first, last = np.floor(low / width + _ROUNDING), np.ceil(high / width - _ROUNDING)
    edges: FloatArray = width * np.arange(first, last + 1.0)
    edges[[0, -1]] += (-_ROUNDING * width, _ROUNDING * width)
    return edges
