"""Write what was simulated, and what the teachers make of it, as a Rerun recording.

`recordings/README.md` is the reference of what a recording holds; `SCHEMA_VERSION` counts its
editions.
"""

import hashlib
from dataclasses import asdict
from pathlib import Path

import rerun as rr
import tomli_w

from scenes import Rollouts, scene_to_toml
from studio.arrays import Bounds, FloatArray
from studio.recorder.figures import log_figure
from studio.recorder.pages import log_page, package_versions
from studio.recorder.stream import recording_to
from studio.scene.framing import bounds_of_shape
from studio.scene.judgements import Judgement
from studio.scene.measures import gap_over_time
from studio.scene.recording import entities
from studio.scene.recording.actions import log_action
from studio.scene.recording.blueprint import VIEW_SHAPE, recording_blueprint
from studio.scene.recording.figures import (
    log_dots_that_answer,
    paint_minds,
    paint_utilities,
    window_on,
)
from studio.scene.recording.outcomes import (
    gap_range,
    log_actions,
    log_gaps,
    log_histograms,
    log_judgements,
    log_outcomes,
    log_touching,
)
from studio.scene.recording.pages import disagreements_page, scene_page, scene_summary
from studio.scene.recording.world import log_world
from studio.style.palette import LIGHT, Theme

SCHEMA_VERSION = 3
"""Edition of the layout that `recordings/README.md` describes."""


MOST_PATHS = 100
"""Of how many rollouts the paths are kept; more are too many to look at, and to keep."""


def write_recording(path: Path, rollouts: Rollouts, judgements: tuple[Judgement, ...]) -> None:
    """Write a recording (`.rrd`) of one scene under all its actions.

    Where there are many rollouts, it holds the outcomes of all and the paths of the first hundred.

    Raises:
        OSError: if the file cannot be written.
    """
    rollouts = rollouts.keep_paths(MOST_PATHS)
    versions, theme = package_versions(), LIGHT.of(rollouts.names)
    bounds, gap = bounds_of_shape(rollouts, *VIEW_SHAPE), gap_over_time(rollouts)
    worths, drawn = paint_utilities(rollouts, judgements, theme)
    windows = [window_on(drawn, index) for index in range(len(rollouts.actions))]
    blueprint = recording_blueprint(rollouts, bounds, gap_range(gap), windows)
    with recording_to(path, entities.APPLICATION, identity(rollouts), blueprint) as stream:
        stream.send_recording_name(f"{rollouts.scene.name}, seed {rollouts.seed}")
        log_simulation(stream, rollouts, judgements, bounds, gap, versions, theme)
        log_actions(stream, rollouts, judgements)
        log_histograms(stream, rollouts, theme)
        log_touching(stream, rollouts, gap, theme)
        if rollouts.scene.pedestrians:
            log_gaps(stream, rollouts, gap, theme)
        log_figure(stream, entities.UTILITIES, worths)
        log_dots_that_answer(stream, rollouts, drawn, theme)
        log_figure(stream, entities.MINDS, paint_minds(rollouts, judgements, theme))
        log_page(stream, entities.SUMMARY, scene_summary(rollouts, judgements))
        log_page(stream, entities.DISAGREEMENTS, disagreements_page(rollouts, judgements))
        log_page(stream, entities.ABOUT, scene_page(rollouts, judgements, versions))


def log_simulation(
    stream: rr.RecordingStream,
    rollouts: Rollouts,
    judgements: tuple[Judgement, ...],
    bounds: Bounds,
    gap: FloatArray,
    versions: dict[str, str],
    theme: Theme,
) -> None:
    """Keep what was simulated and judged: all that a scene is read back from.

    Views of the world show these bounds. The gap [A, M, T+1] is that to the nearest person, m.
    """
    log_simulation_properties(stream, rollouts, judgements, versions)
    log_world(stream, rollouts, bounds, theme)
    for index in range(len(rollouts.actions)):
        log_action(stream, rollouts, index, gap[index], theme)
    log_outcomes(stream, rollouts)
    log_judgements(stream, judgements)


def log_simulation_properties(
    stream: rr.RecordingStream,
    rollouts: Rollouts,
    judgements: tuple[Judgement, ...],
    versions: dict[str, str],
) -> None:
    """Say what is needed to make the recording again."""
    actions = {"actions": [asdict(action) for action in rollouts.actions]}
    teachers = {each.teacher: asdict(each.parameters) for each in judgements}
    # a component costs a kilobyte however little it holds, hence text where there are many
    stream.send_property("scene", rr.AnyValues(toml=scene_to_toml(rollouts.scene)))
    stream.send_property(
        "simulation",
        rr.AnyValues(
            schema_version=SCHEMA_VERSION,
            seed=rollouts.seed,
            rollouts=rollouts.count,
            paths=rollouts.paths,
            dt=rollouts.dt,
            horizon=rollouts.horizon,
            model=rollouts.model,
            engine=rollouts.engine,
            wrap_angles=rollouts.wrap_angles,
            noise=tomli_w.dumps(asdict(rollouts.noise)),
            limits=tomli_w.dumps(asdict(rollouts.limits)),
            actions=tomli_w.dumps(actions),
            teachers=tomli_w.dumps(teachers),
            versions=tomli_w.dumps(versions),
        ),
    )


def identity(rollouts: Rollouts) -> str:
    """An id that is the same for the same simulation: opened twice, it is one recording."""
    made_of = (
        scene_to_toml(rollouts.scene),
        rollouts.actions,
        rollouts.seed,
        rollouts.noise,
        rollouts.limits,
        rollouts.model,
        rollouts.engine,
        rollouts.wrap_angles,
        rollouts.dt,
        rollouts.count,
        rollouts.steps,
    )
    digest = hashlib.sha256(repr(made_of).encode()).hexdigest()
    return f"{rollouts.scene.name}-{digest[:12]}"
