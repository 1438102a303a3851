"""The numbers in a recording: of every outcome, of every judgement, and the gap over time."""

from typing import Any

import numpy as np
import rerun as rr

from scenes import FEATURES, Rollouts
from studio.scene.judgements import Judgement
from studio.scene.measures import gap_over_time
from studio.scene.recording import entities
from studio.scene.recording.moving import time_columns
from studio.style.palette import Theme
from studio.style.words import short_label


def log_outcomes(stream: rr.RecordingStream, rollouts: Rollouts) -> None:
    """Keep the numbers of every outcome: one row a rollout, the actions one after another."""
    columns: dict[str, Any] = {
        feature: rollouts.features[..., column].ravel() for column, feature in enumerate(FEATURES)
    }
    columns["person_step"] = rollouts.person_step.ravel()
    columns["wall_step"] = rollouts.wall_step.ravel()
    stream.log(entities.OUTCOMES, rr.AnyValues(**columns), static=True)


def log_judgements(stream: rr.RecordingStream, judgements: tuple[Judgement, ...]) -> None:
    """Keep the value of every action to every teacher."""
    values: dict[str, Any] = {judgement.teacher: judgement.values for judgement in judgements}
    stream.log(entities.JUDGEMENTS, rr.AnyValues(**values), static=True)
    reference = judgements[0].reference if judgements else None
    if reference is not None:
        many = rr.AnyValues(utilities=reference.utilities.ravel())
        stream.log(entities.REFERENCE, many, static=True)


def log_gap(stream: rr.RecordingStream, rollouts: Rollouts, theme: Theme) -> None:
    """Plot the median gap to the nearest person over time, a series an action."""
    medians = np.median(gap_over_time(rollouts), axis=1).T  # (T+1, A)
    stream.send_columns(
        entities.GAP,
        time_columns(rollouts),
        rr.Scalars.columns(scalars=medians.ravel()).partition([medians.shape[1]] * len(medians)),
    )
    stream.log(
        entities.GAP,
        rr.SeriesLines(
            colors=[theme.action_colour(name) for name in rollouts.names],
            widths=2.0,
            names=[short_label(name) for name in rollouts.names],
        ),
        static=True,
    )
