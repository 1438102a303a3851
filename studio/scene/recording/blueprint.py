"""How the recording of a scene looks when it opens: its tabs and their views."""

import rerun.blueprint as rrb

from scenes import Rollouts
from studio.arrays import Bounds
from studio.recorder.views import Overrides, drawn_view, figure_view, opening, page_view
from studio.scene.recording import entities
from studio.scene.recording.action_table import action_table_bounds
from studio.scene.recording.distributions import distributions_bounds
from studio.scene.recording.minds import CURVES_BOUNDS
from studio.scene.recording.prospects import prospects_bounds
from studio.scene.recording.ranks import ranks_bounds
from studio.style.palette import LIGHT
from studio.style.words import action_label, counted, short_label

VIEW_SHAPE = (16, 9)
"""Width to height of views of the world on a common screen."""


def recording_blueprint(rollouts: Rollouts, teachers: int, bounds: Bounds) -> rrb.Blueprint:
    """The tabs of a recording: overview, one an action, prospects, minds, about."""
    return opening(
        [
            scene_overview(rollouts, teachers, bounds),
            *(action_tab(rollouts, index, bounds) for index in range(len(rollouts.actions))),
            prospects_tab(rollouts.names, teachers),
            minds_tab(rollouts.names, teachers),
            page_view(entities.ABOUT, "About"),
        ],
        "sim_time",
    )


def scene_overview(rollouts: Rollouts, teachers: int, bounds: Bounds) -> rrb.Container:
    """All actions in one world, what came of them, and what the teachers make of it."""
    names = rollouts.names
    contents = [entities.LABELS, *(f"{entities.action(name)}/**" for name in names)]
    title = f"All actions, {counted(rollouts.count, 'rollout')} each (grid of 1 m)"
    return rrb.Horizontal(
        rrb.Vertical(
            world_view(contents, bounds, title),
            action_table_view(names, teachers),
            row_shares=[3, 2],
        ),
        rrb.Vertical(
            page_view(entities.SUMMARY, "Summary"),
            *([gap_view()] if rollouts.scene.pedestrians else []),
            row_shares=[5, 2] if rollouts.scene.pedestrians else [1],
        ),
        column_shares=[5, 3],
        name="Overview",
    )


def action_tab(rollouts: Rollouts, index: int, bounds: Bounds) -> rrb.Container:
    """One action: its world, and how its outcomes are distributed."""
    name, contacts = rollouts.names[index], int(rollouts.touched[index].sum())
    label, count = action_label(name), counted(rollouts.count, "rollout")
    title = f"{label}: {count}, {contacts} with contact (grid of 1 m)"
    return rrb.Vertical(
        world_view([f"{entities.action(name)}/**"], bounds, title),
        figure_view(
            entities.distributions(name),
            distributions_bounds(rollouts),
            f"{label}: outcomes by feature (red: with contact), and the gap to the nearest person "
            "(median, 10 to 90 %) over time",
        ),
        row_shares=[5, 2],
        name=short_label(name),
    )


def prospects_tab(names: tuple[str, ...], teachers: int) -> rrb.Container:
    """The outcomes of all actions side by side, and how much each counts to the teachers."""
    return rrb.Vertical(
        action_table_view(names, teachers),
        figure_view(
            entities.PROSPECTS,
            prospects_bounds(names),
            "Outcomes from the worst to the best. Dots: utility; marks at the right: certainty "
            "equivalents (the sure utility that a teacher would take instead). Below: how much "
            "each outcome counts",
        ),
        row_shares=[4, 5],
        name="Prospects",
    )


def minds_tab(names: tuple[str, ...], teachers: int) -> rrb.Container:
    """How the teachers weigh probabilities, value gains and losses, and rank the actions."""
    return rrb.Vertical(
        drawn_view(
            entities.CURVES,
            CURVES_BOUNDS,
            "How much probabilities p count, and 50 outcomes from the worst loss to the best gain; "
            "how good the utility x feels",
        ),
        rrb.Horizontal(
            figure_view(
                entities.RANKS,
                ranks_bounds(names, teachers),
                "Actions by their value V, the best on top (bold: the next teacher ranks it "
                "differently)",
            ),
            page_view(entities.DISAGREEMENTS, "Where they disagree"),
            column_shares=[5, 2],
        ),
        row_shares=[4, 5],
        name="Minds",
    )


def world_view(
    contents: list[str], bounds: Bounds, title: str, overrides: Overrides | None = None
) -> rrb.View:
    """A view of the world: what does not move, and the given contents; see `drawn_view`."""
    fixed = [entities.GRID, entities.WALLS, entities.TASK]
    return drawn_view([*fixed, *contents], bounds, title, overrides)


def action_table_view(names: tuple[str, ...], teachers: int) -> rrb.View:
    """The action table."""
    title = "All outcomes (large dot: median) and their values V (ringed: what the teacher picks)"
    return figure_view(entities.ACTION_TABLE, action_table_bounds(names, teachers), title)


def gap_view() -> rrb.View:
    """The median gap to the nearest person over time under every action."""
    return rrb.TimeSeriesView(
        origin=f"/{entities.GAP}",
        name="median gap to the nearest person, m (colours as on the left)",
        plot_legend=rrb.PlotLegend(visible=False),
        # Rerun's grid is black on light ground
        background=rrb.archetypes.PlotBackground(color=LIGHT.panel, show_grid=False),
    )
