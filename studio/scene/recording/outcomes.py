"""The numbers in a recording, and Rerun's own plots of them: tables, histograms, curves, states."""

from collections.abc import Sequence
from typing import Any

import numpy as np
import rerun as rr

from scenes import FEATURES, Rollouts
from scenes.geometry import distance_to_walls
from scenes.scene import ROBOT_RADIUS
from studio.arrays import FloatArray
from studio.recorder.plots import log_bands, log_bars, log_rows, log_states
from studio.scene.certainty import wilson
from studio.scene.judgements import Judgement, utilities
from studio.scene.measures import NOTHING, PERSON, WALL, Measure, bin_edges, measures
from studio.scene.recording import entities
from studio.scene.recording.moving import time_columns
from studio.style.palette import Theme, blend
from studio.style.words import short_label

STATES = ("person", "wall", "free")
"""What a robot touches, in the order of `PERSON`, `WALL` and `NOTHING`."""

PALE = 0.5  # opacity of the colour of contact where it stands for walls


def log_outcomes(stream: rr.RecordingStream, rollouts: Rollouts) -> None:
    """Keep what came of all K rollouts, a table an action, a row a rollout."""
    columns: dict[str, Any] = {
        "clearance_m": rollouts.clearance_m,
        "deviation_m": rollouts.deviation_m,
        "progress_m": rollouts.progress_m,
        "smoothness": rollouts.features[..., FEATURES.index("smoothness")],
        "people_touched": rollouts.people_touched.astype(np.int32),
        "person_step": rollouts.person_step.astype(np.int32),
        "wall_step": rollouts.wall_step.astype(np.int32),
        "utility": utilities(rollouts).astype(np.float32),
    }
    for index, name in enumerate(rollouts.names):
        own = {column: values[index] for column, values in columns.items()}
        log_rows(stream, entities.outcomes(name), "rollout", own)


def log_actions(
    stream: rr.RecordingStream, rollouts: Rollouts, judgements: Sequence[Judgement]
) -> None:
    """Keep what is known of the actions: a row an action, with the ends of 95 % intervals."""
    columns: dict[str, Any] = {
        "name": list(rollouts.names),
        "rollouts": [rollouts.count] * len(rollouts.names),
    }
    for thing, touched in (
        ("people", rollouts.people_touched > 0),
        ("wall", rollouts.wall_touched),
    ):
        shares = [wilson(int(each.sum()), rollouts.count) for each in touched]
        columns[f"touch_{thing}"] = [share.value for share in shares]
        columns[f"touch_{thing}_low"] = [share.low for share in shares]
        columns[f"touch_{thing}_high"] = [share.high for share in shares]
    for each in judgements:
        columns |= {
            f"V {each.label}": each.values,
            f"V {each.label} low": each.low,
            f"V {each.label} high": each.high,
            f"picked by {each.label}": each.shares,
        }
    log_rows(stream, entities.ACTIONS, "action", columns)


def log_judgements(stream: rr.RecordingStream, judgements: Sequence[Judgement]) -> None:
    """Keep the value of every action to every teacher, and what they are held against."""
    values: dict[str, Any] = {judgement.teacher: judgement.values for judgement in judgements}
    stream.log(entities.JUDGEMENTS, rr.AnyValues(**values), static=True)
    reference = judgements[0].reference if judgements else None
    if reference is not None:
        many = rr.AnyValues(utilities=reference.utilities.ravel())
        stream.log(entities.REFERENCE, many, static=True)


def measured(rollouts: Rollouts) -> list[Measure]:
    """What has a histogram: all but the number of contacts, which the others tell apart."""
    return [measure for measure in measures(rollouts) if not measure.is_counted]


def log_histograms(stream: rr.RecordingStream, rollouts: Rollouts, theme: Theme) -> None:
    """Count the outcomes of every action by each feature, in bins that all actions share.

    Paler bars behind them are the most that any action has in a bin: all views of a feature show
    the same scale.
    """
    people, walls = rollouts.people_touched > 0, rollouts.wall_touched
    pale = blend(theme.contact, theme.ground, PALE)
    for measure in measured(rollouts):
        edges = bin_edges(measure)
        counts = np.stack([np.histogram(values, edges)[0] for values in measure.values])
        path = entities.any_action(measure.feature)
        log_bars(stream, path, edges, counts.max(axis=0), theme.grid)
        for index, name in enumerate(rollouts.names):
            path, values = entities.histogram(measure.feature, name), measure.values[index]
            log_bars(stream, f"{path}/all", edges, counts[index], theme.action_colour(name))
            if (walls & ~people)[index].any():
                own = np.histogram(values[(walls | people)[index]], edges)[0]
                log_bars(stream, f"{path}/touched", edges, own, pale)
            if people[index].any():
                own = np.histogram(values[people[index]], edges)[0]
                log_bars(stream, f"{path}/touched_person", edges, own, theme.contact)


def log_gaps(stream: rr.RecordingStream, rollouts: Rollouts, gap: FloatArray, theme: Theme) -> None:
    """Plot the gap [A, M, T+1] (m) to the nearest person over time: mean and deviation."""
    for index, name in enumerate(rollouts.names):
        mean, deviation = gap[index].mean(axis=0), gap[index].std(axis=0)
        label, colour = [short_label(name)], [theme.action_colour(name)]
        path, times = entities.gap(name), time_columns(rollouts)
        log_bands(stream, path, times, mean[:, None], deviation[:, None], label, colour)


def gap_range(gap: FloatArray) -> tuple[float, float]:
    """What all views of gaps [A, M, T+1] over time show upwards, m."""
    if not np.isfinite(gap).all():  # among nobody
        return 0.0, 1.0
    mean, deviation = gap.mean(axis=1), gap.std(axis=1)
    low, high = min(float((mean - deviation).min()), 0.0), float((mean + deviation).max())
    margin = 0.05 * (high - low)
    return low - margin, high + margin


def log_touching(
    stream: rr.RecordingStream, rollouts: Rollouts, gap: FloatArray, theme: Theme
) -> None:
    """Tell of every robot when it touches a person, when a wall, and when nothing.

    The gap [A, M, T+1] is that to the nearest person, m.
    """
    to_walls = distance_to_walls(rollouts.robot[..., :2], rollouts.scene.wall_segments)
    touching = np.where(gap < 0.0, PERSON, np.where(to_walls < ROBOT_RADIUS, WALL, NOTHING))
    colours = {
        STATES[NOTHING]: theme.grid,
        STATES[PERSON]: theme.contact,
        STATES[WALL]: blend(theme.contact, theme.ground, PALE),
    }
    words = np.array(STATES)
    for index, name in enumerate(rollouts.names):
        own = touching[index].T  # (T+1, M)
        changes = np.append(True, (own[1:] != own[:-1]).any(axis=1))
        [steps] = np.nonzero(changes)
        times = [
            rr.TimeColumn("sim_time", duration=steps * rollouts.dt),
            rr.TimeColumn("step", sequence=steps),
        ]
        log_states(stream, entities.states(name), times, words[own[steps]].tolist(), colours)
