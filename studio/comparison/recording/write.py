"""Write two actions side by side, their outcomes one at a time, as a Rerun recording.

It holds what the recording of a scene with these two actions holds of world and numbers, and a
story in which one outcome after the other plays on both sides at once. `recordings/README.md` is
its reference.
"""

from pathlib import Path

import rerun as rr
import rerun.blueprint as rrb

from scenes import Rollouts
from studio.arrays import Bounds
from studio.comparison.comparison import QUESTION, SIDES, Comparison
from studio.comparison.recording import entities
from studio.comparison.recording.dots import BOUNDS, log_dots
from studio.comparison.recording.page import comparison_page
from studio.comparison.recording.story import log_story
from studio.recorder.drawing import y_upwards
from studio.recorder.pages import log_page, package_versions
from studio.recorder.stream import recording_to
from studio.recorder.views import drawn_view, gathering, opening, page_view
from studio.scene.framing import bounds_of_shape
from studio.scene.judgements import Judgement
from studio.scene.measures import gap_over_time
from studio.scene.recording import entities as of_scene
from studio.scene.recording.blueprint import VIEW_SHAPE, world_view
from studio.scene.recording.write import identity, log_simulation
from studio.style.palette import LIGHT
from studio.style.words import action_label, counted, short_label


def write_comparison_recording(
    path: Path, comparison: Comparison, judgements: tuple[Judgement, ...]
) -> None:
    """Write a recording (`.rrd`) of two actions side by side, which are the two that are judged.

    Raises:
        OSError: if the file cannot be written.
    """
    rollouts, theme = comparison.rollouts, LIGHT.of(comparison.actions)
    left, right = rollouts.names
    name = f"{identity(rollouts)}-{comparison.seed}"
    bounds = bounds_of_shape(rollouts, *VIEW_SHAPE)
    blueprint = comparison_blueprint(rollouts, bounds)
    with recording_to(path, entities.APPLICATION, name, blueprint) as stream:
        stream.send_recording_name(
            f"{rollouts.scene.name}: {action_label(left)} or {action_label(right)}"
        )
        log_simulation(
            stream, rollouts, judgements, bounds, gap_over_time(rollouts), package_versions(), theme
        )
        stream.send_property(
            "comparison",
            rr.AnyValues(
                left=left, right=right, seed=comparison.seed, actions=list(comparison.actions)
            ),
        )
        stream.log(of_scene.FIGURES, y_upwards(), static=True)
        for side in range(len(SIDES)):
            log_story(stream, rollouts, side, theme)
            log_dots(stream, rollouts, side, theme)
        log_page(stream, of_scene.ABOUT, comparison_page(comparison, judgements))


def comparison_blueprint(rollouts: Rollouts, bounds: Bounds) -> rrb.Blueprint:
    """The tabs: one outcome at a time, all at once, about."""
    named = list(zip(SIDES, rollouts.names, strict=True))
    stories = [story_side(side, name, rollouts.count, bounds) for side, name in named]
    wholes = [whole_side(side, name, bounds) for side, name in named]
    return opening(
        [
            rrb.Horizontal(*stories, name=QUESTION),
            rrb.Horizontal(*wholes, name="All at once"),
            page_view(of_scene.ABOUT, "About"),
        ],
        entities.STORY,
    )


def story_side(side: str, name: str, count: int, bounds: Bounds) -> rrb.Container:
    """The `count` outcomes of one side's action, one at a time, and their dots below."""
    story, dots = entities.story(name), entities.dots(name)
    world = world_view(
        [f"{story}/**"],
        bounds,
        f"{side}: {short_label(name)} (grid of 1 m)",
        gathering([f"{story}/paths"], entities.STORY),
    )
    figure = drawn_view(
        [f"{dots}/**"],
        BOUNDS,
        f"{side}: {counted(count, 'outcome')}, one at a time; a dot: one outcome; red: contact",
        gathering([f"{dots}/outcomes", f"{dots}/contacts"], entities.STORY),
    )
    return rrb.Vertical(world, figure, row_shares=[10, 9])


def whole_side(side: str, name: str, bounds: Bounds) -> rrb.View:
    """All outcomes of one side's action at once."""
    title = f"{side}: {short_label(name)}, all at once; they move along the timeline sim_time"
    return world_view([f"{of_scene.action(name)}/**"], bounds, title)
