"""How a recording of a study looks when it opens: its tabs, views, and where its time stands."""

from collections.abc import Sequence

import rerun.blueprint as rrb

from learners import Teacher
from studio.recorder.figures import painted_view
from studio.recorder.plots import bars_view, curves_view, table_view
from studio.recorder.views import opening, page_view
from studio.study.recording import entities
from studio.study.results import StudyResults
from studio.study.series import (
    AGREEMENT,
    LIKELIHOOD,
    PARAMETERS,
    REGRET,
    THETA,
    Plots,
    family_plot,
    plot_range,
)
from studio.study.words import short_teacher_name
from studio.style.words import learner_name

_PLAYING_TIME = 12.0  # that the whole study takes when it is played, s
_MOST_COLUMNS = 3  # of the overview, or the titles of its views would be cut off
_MARGIN = 0.1  # of plots over pairs, at either side, in shares of their width

_HOW_TO_READ = (
    "How often was chosen what is predicted so often: full bars to the lower, pale ones to the "
    "upper end of the 95 % interval; dark: predicted"
)

Part = rrb.Container | rrb.View


def study_blueprint(results: StudyResults, plots: Plots) -> rrb.Blueprint:
    """The tabs: overview, one a teacher, parameters, families, calibration, tables, about."""
    return opening(
        [
            overview_tab(results, plots),
            *(teacher_tab(results, plots, teacher) for teacher in results.teachers),
            parameters_tab(results, plots),
            *([families_tab(results, plots)] if results.scenes else []),
            calibration_tab(results, plots),
            tables_tab(results),
            page_view(entities.ABOUT, "About"),
        ],
        entities.TIMELINE,
        # the latest is the best that was learned; play begins anew from the first
        play_state="following",
        loop_mode="off",
        frames_per_second=max(1.0, results.sizes[-1] / _PLAYING_TIME),
    )


def overview_tab(results: StudyResults, plots: Plots) -> rrb.Container:
    """Regret, a column a teacher, above how often the best action is found; the summary beside.

    Of more than three teachers it shows regret alone, in two rows.
    """
    names = [REGRET, AGREEMENT] if len(results.teachers) <= _MOST_COLUMNS else [REGRET]
    views = [view for name in names for view in plot_views(results, plots, [name])]
    across = len(views) if len(views) < _MOST_COLUMNS else -(-len(views) // 2)
    page = page_view(entities.SUMMARY, "Summary")
    return _beside(rrb.Grid(*views, grid_columns=across), page, "Overview")


def teacher_tab(results: StudyResults, plots: Plots, teacher: Teacher) -> rrb.Container:
    """One teacher: curves above, weights and values below, numbers beside."""
    views = plot_views(results, plots, [REGRET, AGREEMENT], teacher)
    parts: list[Part] = [rrb.Horizontal(*views)]
    if results.shaped:
        title = "Weights and values: learnt, and the teacher's (dashed)"
        parts.append(painted_view(entities.shapes(teacher.name), title))
    page = page_view(entities.page(teacher.name), "Numbers")
    return _beside(rrb.Vertical(*parts), page, short_teacher_name(teacher))


def parameters_tab(results: StudyResults, plots: Plots) -> rrb.Container:
    """θ/‖θ‖ and the parameters of prospect theory beside the truth, a tab a teacher."""
    tabs = []
    for teacher in results.teachers:
        views = plot_views(results, plots, [*THETA, *PARAMETERS], teacher)
        name = f"Parameters of {short_teacher_name(teacher)}"
        tabs.append(rrb.Grid(*views, grid_columns=len(THETA), name=name))
    return rrb.Tabs(*tabs, active_tab=0, name="Parameters")


def families_tab(results: StudyResults, plots: Plots) -> rrb.Container:
    """Regret by family, a tab a teacher; beside, the scenes that tell most."""
    tabs, names = [], [family_plot(family) for family in results.families]
    for teacher in results.teachers:
        grid = rrb.Grid(*plot_views(results, plots, names, teacher), grid_columns=2)
        page = page_view(entities.scenes_about(teacher.name), "Scenes")
        tabs.append(_beside(grid, page, f"Families of {short_teacher_name(teacher)}"))
    return rrb.Tabs(*tabs, active_tab=0, name="Families")


def calibration_tab(results: StudyResults, plots: Plots) -> rrb.Container:
    """Predicted preferences on held-out scenes, a column a teacher: a row a learner, log-loss."""
    bars = []
    for learner in results.learners:
        for teacher in results.teachers:
            title = f"{short_teacher_name(teacher)}: {learner_name(learner)}"
            bars.append(bars_view(entities.calibration(teacher.name, learner), title))
    losses = plot_views(results, plots, [LIKELIHOOD])
    grid = rrb.Grid(*bars, *losses, grid_columns=len(results.teachers), name=_HOW_TO_READ)
    return rrb.Tabs(grid, active_tab=0, name="Calibration")


def tables_tab(results: StudyResults) -> rrb.Container:
    """Means with their intervals, all fits, and all scenes that were held out."""
    tables = [(entities.LEARNER_TABLE, "Learners"), (entities.FIT_TABLE, "Fits")]
    if results.scenes:
        tables.append((entities.SCENE_TABLE, "Scenes held out"))
    views = [table_view(path, title, entities.ROWS) for path, title in tables]
    return rrb.Tabs(*views, active_tab=0, name="Tables")


def plot_views(
    results: StudyResults, plots: Plots, names: Sequence[str], teacher: Teacher | None = None
) -> list[rrb.View]:
    """Views of the plots of these names, of one or all teachers, as far as there are any.

    Plots of one name have one scale, and those of families have one together.
    """
    first, last = results.sizes[0], results.sizes[-1]
    margin = max(1, round(_MARGIN * (last - first)))
    families = [family_plot(family) for family in results.families]
    return [
        curves_view(
            entities.curves(each.name, name),
            plot.title,
            y_range=plot_range(plots, families if name in families else [name]),
            numbers=(first - margin, last + margin),
        )
        for name in names
        for each in (results.teachers if teacher is None else [teacher])
        if (plot := plots.get((name, each.name)))
    ]


def _beside(part: Part, page: rrb.View, name: str) -> rrb.Container:
    """A part of a tab with a page at its right, above which stands what marks mean."""
    right = rrb.Vertical(painted_view(entities.KEY, "Marks"), page, row_shares=[1, 3])
    return rrb.Horizontal(part, right, column_shares=[5, 3], name=name)
