"""Write two actions side by side, their outcomes one at a time, as a Rerun recording.

It holds the world and numbers of a scene's recording, and a story in which one outcome after the
other plays on both sides at once. `recordings/README.md` is its reference.
"""

from pathlib import Path
from typing import Any

import rerun as rr
import rerun.blueprint as rrb

from scenes import Rollouts
from studio.arrays import Bounds
from studio.comparison.comparison import QUESTION, SIDES, Comparison
from studio.comparison.picture.figure import FIGURE_SIZE
from studio.comparison.recording import entities
from studio.comparison.recording.page import comparison_page
from studio.comparison.recording.story import Story
from studio.comparison.words import crowd_told, dots_told
from studio.painter.quantile_dots import MOST_DOTS
from studio.recorder.figures import painted_view
from studio.recorder.pages import log_page, package_versions
from studio.recorder.plots import bars_view, table_view
from studio.recorder.stream import recording_to
from studio.recorder.views import opening, page_view
from studio.scene.framing import bounds_of_shape
from studio.scene.judgements import Judgement
from studio.scene.measures import gap_over_time
from studio.scene.recording import entities as of_scene
from studio.scene.recording.blueprint import VIEW_SHAPE, world_view
from studio.scene.recording.outcomes import log_histograms, measured
from studio.scene.recording.world import scale_length
from studio.scene.recording.write import MOST_PATHS, identity, log_simulation
from studio.style.palette import LIGHT
from studio.style.words import action_label, counted, short_label

COLUMNS = ("clearance_m", "progress_m", "deviation_m", "people_touched", "person_step", "wall_step")
"""What the tables of outcomes show: nothing that says what an outcome is worth to anybody."""


def write_comparison_recording(
    path: Path, comparison: Comparison, judgements: tuple[Judgement, ...]
) -> None:
    """Write a recording (`.rrd`) of two actions side by side, which are the two that are judged.

    Raises:
        OSError: if the file cannot be written.
    """
    rollouts = comparison.shown.keep_paths(MOST_PATHS)
    theme, bounds = comparison.coloured(LIGHT), bounds_of_shape(rollouts, *VIEW_SHAPE)
    name = f"{identity(comparison.rollouts)}-{comparison.seed}-{comparison.named}"
    left, right = comparison.rollouts.names
    blueprint = comparison_blueprint(rollouts, bounds, comparison.named)
    with recording_to(path, entities.APPLICATION, name, blueprint) as stream:
        told = f"{action_label(left)} or {action_label(right)}" if comparison.named else QUESTION
        stream.send_recording_name(f"{rollouts.scene.name}: {told}")
        gap, versions = gap_over_time(rollouts), package_versions()
        log_simulation(stream, rollouts, judgements, bounds, gap, versions, theme)
        log_histograms(stream, rollouts, theme)
        sides: dict[str, Any] = {"left": left, "right": right, "named": comparison.named}
        sides |= {"seed": comparison.seed, "actions": list(comparison.actions)}
        stream.send_property("comparison", rr.AnyValues(**sides))
        for side in range(len(SIDES)):
            story = Story(stream, rollouts, side, theme)
            story.log_world()
            story.log_dots()
        log_page(stream, of_scene.ABOUT, comparison_page(comparison, judgements))


def comparison_blueprint(rollouts: Rollouts, bounds: Bounds, named: bool) -> rrb.Blueprint:
    """The tabs: one outcome at a time, all at once, all numbers, and what is told afterwards."""
    sides = [
        (f"{side}: {short_label(name)}" if named else side, name)
        for side, name in zip(SIDES, rollouts.names, strict=True)
    ]
    tables = [
        table_view(of_scene.outcomes(name), f"{title}: a row an outcome", "rollout", COLUMNS)
        for title, name in sides
    ]
    stories = [story_side(rollouts, title, name, bounds) for title, name in sides]
    wholes = [whole_side(rollouts, title, name, bounds) for title, name in sides]
    tabs: list[rrb.Container | rrb.View] = [
        rrb.Horizontal(*stories, name=QUESTION),
        rrb.Horizontal(*wholes, name="All at once"),
        rrb.Horizontal(*tables, name="Outcomes"),
        page_view(of_scene.ABOUT, "About" if named else "Which is which"),
    ]
    return opening(tabs, entities.STORY)


def story_side(rollouts: Rollouts, title: str, name: str, bounds: Bounds) -> rrb.Container:
    """The outcomes of one side's action, one at a time, and below them the dots."""
    crowd = crowd_told(rollouts.scene, bounds) or "nobody"
    told = f"{title}: the robot, {crowd} (bar: {scale_length(bounds):g} m)"
    dots, stands_for = entities.dots(name), dots_told(rollouts.count, MOST_DOTS)
    return rrb.Vertical(
        world_view([f"{entities.story(name)}/**"], bounds, told),
        page_view(f"{dots}/so_far", f"{title}: so far"),
        painted_view(dots, f"{title} · {stands_for}", (0.0, 0.0, *FIGURE_SIZE)),
        row_shares=[20, 4, 17],
    )


def whole_side(rollouts: Rollouts, title: str, name: str, bounds: Bounds) -> rrb.Container:
    """All paths under one side's action at once, and how its outcomes are distributed."""
    sample = "" if rollouts.paths == rollouts.count else f", a sample of {rollouts.count}"
    title = f"{title}: {counted(rollouts.paths, 'path')}{sample}"
    shown = [(each.feature, each.title) for each in measured(rollouts) if each.unit]
    plots = [
        bars_view(of_scene.histogram(feature, name), heading, of_scene.any_action(feature))
        for feature, heading in shown
    ]
    world = world_view([f"{of_scene.action(name)}/**"], bounds, title)
    return rrb.Vertical(world, rrb.Horizontal(*plots), row_shares=[2, 1])
