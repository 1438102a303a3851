"""How the recording of a scene looks when it opens: its tabs and their views."""

import math
from collections.abc import Sequence

import rerun.blueprint as rrb

from scenes import Rollouts
from studio.arrays import Bounds
from studio.recorder.figures import painted_view
from studio.recorder.plots import bars_view, curves_view, states_view, table_view
from studio.recorder.views import drawn_view, opening, page_view
from studio.scene.framing import bounds_to_show
from studio.scene.recording import entities
from studio.scene.recording.outcomes import measured
from studio.scene.recording.world import scale_length
from studio.style.words import action_label, counted, short, short_label

VIEW_SHAPE = (16, 9)
"""Width to height of views of the world on a common screen."""

OVERVIEW, TITLE_HEIGHT = (700.0, 620.0), 28.0  # room for all worlds, and a view's title, px
MOST_COLUMNS, LONGEST_TITLE = 3, 13  # of worlds, and of their titles, for which there is room


def recording_blueprint(
    rollouts: Rollouts, bounds: Bounds, gaps: tuple[float, float], windows: Sequence[Bounds]
) -> rrb.Blueprint:
    """The tabs of a recording: overview, one an action, prospects, minds, about.

    Views of the world show the bounds, those of gaps to people (m) this range, and those of the
    utilities under each action its window (px).
    """
    return opening(
        [
            scene_overview(rollouts),
            *(
                action_tab(rollouts, index, bounds, gaps, window)
                for index, window in enumerate(windows)
            ),
            prospects_tab(),
            minds_tab(),
            page_view(entities.ABOUT, "About"),
        ],
        "sim_time",
    )


def scene_overview(rollouts: Rollouts) -> rrb.Container:
    """The world near the robot under every action side by side, and what is to be seen in it."""
    bounds = bounds_to_show(rollouts)
    worlds = [
        world_view(
            [
                f"{entities.action(name)}/**",
                f"- {entities.pedestrians(name)}",
                f"- {entities.SCALE}",  # it lies in the corner of larger views
            ],
            bounds,
            short(action_label(name), LONGEST_TITLE),
        )
        for name in rollouts.names
    ]
    return rrb.Horizontal(
        rrb.Grid(*worlds, grid_columns=grid_columns(len(worlds), bounds)),
        page_view(entities.SUMMARY, "Summary"),
        column_shares=[11, 9],
        name="Overview",
    )


def grid_columns(worlds: int, bounds: Bounds) -> int:
    """How many of this many worlds stand beside one another, so that they are as large as can be.

    All show the same bounds.
    """
    (x0, y0, x1, y1), (width, height) = bounds, OVERVIEW

    def scale(columns: int) -> float:
        rows = math.ceil(worlds / columns)
        return min(width / columns / (x1 - x0), (height / rows - TITLE_HEIGHT) / (y1 - y0))

    return max(range(1, min(worlds, MOST_COLUMNS) + 1), key=scale)


def action_tab(
    rollouts: Rollouts, index: int, bounds: Bounds, gaps: tuple[float, float], window: Bounds
) -> rrb.Container:
    """One action: its world, how its outcomes are distributed, and every single one of them."""
    name = rollouts.names[index]
    paths = counted(rollouts.paths, "rollout")
    sample = "" if rollouts.paths == rollouts.count else f" of {rollouts.count}"
    title = f"{short_label(name)}: {paths}{sample} (bar: {scale_length(bounds):g} m)"
    plots = [
        bars_view(
            entities.histogram(measure.feature, name),
            measure.title,
            behind=entities.any_action(measure.feature),
        )
        for measure in measured(rollouts)
    ]
    if rollouts.scene.pedestrians:
        plots.append(curves_view(entities.gap(name), "gap to people over time, m", y_range=gaps))
    plots.append(states_view(entities.states(name), "What each robot touches"))
    return rrb.Horizontal(
        rrb.Vertical(
            world_view([f"{entities.action(name)}/**"], bounds, title),
            table_view(entities.outcomes(name), "Outcomes, a row a rollout", "rollout"),
            row_shares=[5, 3],
        ),
        rrb.Vertical(
            painted_view(entities.UTILITIES, "Utility of each rollout", window),
            rrb.Grid(*plots, grid_columns=2),
            row_shares=[1, 3],
        ),
        column_shares=[10, 9],
        name=short_label(name),
    )


def prospects_tab() -> rrb.Container:
    """What the outcomes of all actions are worth, and all that is known of the actions."""
    return rrb.Tabs(
        painted_view(entities.UTILITIES, "What outcomes are worth, and to whom"),
        table_view(entities.ACTIONS, "Actions, a row each", "action"),
        active_tab=0,
        name="Prospects",
    )


def minds_tab() -> rrb.Container:
    """How the teachers weigh probabilities, value gains and losses, and rank the actions."""
    return rrb.Vertical(
        painted_view(entities.MINDS, "How teachers weigh, value and rank"),
        page_view(entities.DISAGREEMENTS, "Where they disagree"),
        row_shares=[2, 1],
        name="Minds",
    )


def world_view(contents: Sequence[str], bounds: Bounds, title: str) -> rrb.View:
    """A view of the world: what does not move, and the given contents; see `drawn_view`."""
    fixed = [entities.WALLS, entities.TASK, entities.SCALE]
    return drawn_view([*fixed, *contents], bounds, title)
