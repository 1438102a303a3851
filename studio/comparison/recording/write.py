"""Write two actions side by side, their outcomes one at a time, as a Rerun recording.

It holds what the recording of a scene with these two actions holds of world and numbers, and a
story in which one outcome after the other plays on both sides at once. `recordings/README.md` is
its reference.
"""

from pathlib import Path

import rerun as rr
import rerun.blueprint as rrb

from studio.comparison.comparison import QUESTION, SIDES, Comparison
from studio.comparison.recording.dots import BOUNDS, log_dots
from studio.comparison.recording.page import comparison_page
from studio.comparison.recording.story import log_story
from studio.recorder.drawing import y_upwards
from studio.recorder.pages import log_page, package_versions
from studio.recorder.stream import recording_to
from studio.recorder.views import drawn_view, gathering, opening, page_view
from studio.scene.framing import bounds_of_shape
from studio.scene.judgements import Judgement
from studio.scene.recording import entities
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
    rollouts = comparison.rollouts
    left, right = comparison.left.name, comparison.right.name
    theme = LIGHT.of(comparison.actions)
    name = f"{identity(rollouts)}-{comparison.seed}"
    blueprint = comparison_blueprint(comparison)
    with recording_to(path, entities.COMPARISON_APPLICATION, name, blueprint) as stream:
        stream.send_recording_name(
            f"{rollouts.scene.name}: {action_label(left)} or {action_label(right)}"
        )
        log_simulation(stream, rollouts, judgements, package_versions(), theme)
        stream.send_property(
            "comparison",
            rr.AnyValues(
                left=left, right=right, seed=comparison.seed, actions=list(comparison.actions)
            ),
        )
        stream.log(entities.FIGURES, y_upwards(), static=True)
        for side in range(len(SIDES)):
            log_story(stream, rollouts, side, theme)
            log_dots(stream, rollouts, side, theme)
        log_page(stream, entities.ABOUT, comparison_page(comparison, judgements))


def comparison_blueprint(comparison: Comparison) -> rrb.Blueprint:
    """The tabs: one outcome at a time, all at once, about."""
    sides = range(len(SIDES))
    return opening(
        [
            rrb.Horizontal(*(story_side(comparison, side) for side in sides), name=QUESTION),
            rrb.Horizontal(*(whole_side(comparison, side) for side in sides), name="All at once"),
            page_view(entities.ABOUT, "About"),
        ],
        entities.STORY,
    )


def story_side(comparison: Comparison, side: int) -> rrb.Container:
    """One side's outcomes, one at a time, and their dots below."""
    rollouts = comparison.rollouts
    name, count = rollouts.names[side], rollouts.count
    story, dots = entities.story(name), entities.dots(name)
    fixed = [entities.GRID, entities.WALLS, entities.TASK]
    world = drawn_view(
        [*fixed, f"{story}/**"],
        bounds_of_shape(rollouts, *VIEW_SHAPE),
        f"{SIDES[side]}: {short_label(name)} (grid of 1 m)",
        gathering([f"{story}/paths"], entities.STORY),
    )
    dot = "a dot: one outcome; red: contact"
    told = f"{SIDES[side]}: {counted(count, 'outcome')}, one at a time; {dot}"
    figure = drawn_view(
        [f"{dots}/**"],
        BOUNDS,
        told,
        gathering([f"{dots}/outcomes", f"{dots}/contacts"], entities.STORY),
    )
    return rrb.Vertical(world, figure, row_shares=[10, 9])


def whole_side(comparison: Comparison, side: int) -> rrb.View:
    """All outcomes of one side at once."""
    rollouts = comparison.rollouts
    name = rollouts.names[side]
    title = (
        f"{SIDES[side]}: {short_label(name)}, all at once; they move along the timeline sim_time"
    )
    return world_view(
        [f"{entities.action(name)}/**"], bounds_of_shape(rollouts, *VIEW_SHAPE), title
    )
