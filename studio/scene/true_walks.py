"""Where the people of a real crowd truly walked, and how far from it they are simulated."""

import math

import numpy as np

from scenes import Rollouts
from scenes.scene import TRACK_STEP
from studio.arrays import FloatArray
from studio.scene.certainty import Estimate
from studio.style.words import estimate_told

_NORMAL_QUANTILE = 1.96  # 97.5 % of the standard normal distribution lie below


def true_walks(rollouts: Rollouts) -> FloatArray:
    """Where everybody truly was at every step, [T+1, P, 2], m.

    It is not a number (NaN) for people who are made up, and after the end of a person's track.
    """
    times = np.arange(rollouts.steps + 1) * rollouts.dt
    people = rollouts.scene.pedestrians
    walks: FloatArray = np.full((len(times), len(people), 2), np.nan)
    for index, person in enumerate(people):
        if person.track is not None:
            track = np.array(person.track)
            known = np.arange(len(track)) * TRACK_STEP
            is_known = times <= known[-1] + 1e-9
            for axis in (0, 1):
                walks[is_known, index, axis] = np.interp(times[is_known], known, track[:, axis])
    return walks


def distance_from_true_walks(rollouts: Rollouts) -> Estimate | None:
    """How far people are simulated from where they truly were, m; None for made-up people.

    It is the mean over rollouts, people and all steps of which the truth is known. The people are
    those who are simulated without the robot, since there was none in the real crowd.
    """
    apart = np.linalg.norm(rollouts.without_robot - true_walks(rollouts), axis=-1)  # (M, T+1, P)
    if np.isnan(apart).all():
        return None
    means = np.nanmean(apart, axis=(1, 2))  # (M,)
    mean = float(means.mean())
    error = float(means.std(ddof=1)) / math.sqrt(len(means)) if len(means) > 1 else 0.0
    reach = _NORMAL_QUANTILE * error
    return Estimate(mean, mean - reach, mean + reach)


def true_walks_told(rollouts: Rollouts) -> list[str]:
    """How far people are simulated from their true walks, the longest wording first.

    There are none for made-up people.
    """
    apart = distance_from_true_walks(rollouts)
    if apart is None:
        return []
    far = estimate_told(apart.value, apart.low, apart.high)
    return [
        f"true walks, on average {far} m from where people are simulated without the robot",
        f"true walks, {far} m from those simulated without the robot",
        f"true walks, {far} m off (no robot)",
        f"true walks, {apart.value:.3f} m off (no robot)",
    ]
