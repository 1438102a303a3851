"""How a recording of a study looks when it opens: its tabs, views, and where its time stands."""

from collections.abc import Sequence

import rerun.blueprint as rrb

from learners import Teacher
from studio.arrays import Bounds
from studio.recorder.axes import Axes, linear
from studio.recorder.views import figure_view, opening, page_view
from studio.study.recording import entities
from studio.study.recording.curves import (
    AGREEMENT_CURVES,
    LIKELIHOOD_CURVES,
    REGRET_CURVES,
    CurveFigure,
)
from studio.study.recording.families import family_figure
from studio.study.recording.minds import parameter_bounds
from studio.study.results import StudyResults
from studio.study.words import short_teacher_called, short_teacher_name

_PLAYING_TIME = 12.0  # that the whole study takes when it is played, s
_SQUARE = Axes(linear((0.0, 1.0)), linear((0.0, 1.0))).bounds  # of square axes, whatever they show


def study_blueprint(results: StudyResults) -> rrb.Blueprint:
    """The tabs: overview, one a teacher, families, calibration, about."""
    return opening(
        [
            study_overview_tab(results),
            *(teacher_tab(results, teacher) for teacher in results.teachers),
            *([families_tab(results)] if results.scenes else []),
            calibration_tab(results),
            page_view(entities.ABOUT, "About"),
        ],
        entities.TIMELINE,
        # the latest is the best that was learned; play begins anew from the first
        play_state="following",
        loop_mode="off",
        frames_per_second=max(1.0, results.sizes[-1] / _PLAYING_TIME),
    )


def study_overview_tab(results: StudyResults) -> rrb.Container:
    """All teachers side by side: regret above, the weights of losses below; the summary beside."""
    columns = [
        rrb.Vertical(
            curve_view(results, teacher, REGRET_CURVES),
            mind_view(teacher, entities.LOSS_WEIGHTS, "w(p) of losses"),
        )
        for teacher in results.teachers
    ]
    summary = page_view(entities.SUMMARY, "Summary")
    beside = _beside_one_another(columns)
    return rrb.Horizontal(beside, summary, column_shares=[2, 1], name="Overview")


def teacher_tab(results: StudyResults, teacher: Teacher) -> rrb.Container:
    """One teacher: curves above, the minds below, numbers and parameters beside."""
    curves = [curve_view(results, teacher, kind) for kind in (REGRET_CURVES, AGREEMENT_CURVES)]
    minds = [
        mind_view(teacher, entities.GAIN_WEIGHTS, "w(p) of gains"),
        mind_view(teacher, entities.LOSS_WEIGHTS, "w(p) of losses"),
        mind_view(teacher, entities.VALUES, "v over θ·φ/|θ|"),
    ]
    numbers = page_view(entities.page(teacher.name), "Numbers")
    title = "θ/|θ| and parameters (dark mark: truth)"
    bounds = parameter_bounds(results)
    parameters = study_figure_view(teacher, entities.PARAMETERS, bounds, title)
    return rrb.Horizontal(
        rrb.Vertical(rrb.Horizontal(*curves), rrb.Horizontal(*minds)),
        rrb.Vertical(numbers, parameters, row_shares=[18, 19]),
        column_shares=[2, 1],
        name=short_teacher_name(teacher),
    )


def families_tab(results: StudyResults) -> rrb.Container:
    """All teachers side by side: regret by family and scene; beside, the scenes that tell most."""
    bounds = family_figure(results).bounds
    columns = []
    for teacher in results.teachers:
        title = f"{short_teacher_name(teacher)}: regret by family"
        columns.append(study_figure_view(teacher, entities.FAMILIES, bounds, title))
    scenes = page_view(entities.SCENES, "Scenes")
    beside = _beside_one_another(columns)
    return rrb.Horizontal(beside, scenes, column_shares=[3, 2], name="Families")


def calibration_tab(results: StudyResults) -> rrb.Container:
    """Predicted preferences on held-out scenes: calibration above, likelihood below."""
    columns = [
        rrb.Vertical(
            mind_view(teacher, entities.CALIBRATION, "choices over predictions"),
            curve_view(results, teacher, LIKELIHOOD_CURVES),
            row_shares=[6, 5],
        )
        for teacher in results.teachers
    ]
    return _beside_one_another(columns, "Calibration")


def curve_view(results: StudyResults, teacher: Teacher, kind: CurveFigure) -> rrb.View:
    """A learning curve."""
    title = f"{short_teacher_called(teacher)}: {kind.title}"
    return study_figure_view(teacher, kind.name, kind.axes(results).bounds, title)


def mind_view(teacher: Teacher, name: str, title: str) -> rrb.View:
    """A square figure: learnt functions beside the teacher's, or choices over predictions."""
    return study_figure_view(teacher, name, _SQUARE, f"{short_teacher_called(teacher)}: {title}")


def study_figure_view(teacher: Teacher, name: str, bounds: Bounds, title: str) -> rrb.View:
    """A drawn figure about what was learned from a teacher."""
    return figure_view(entities.figure(teacher.name, name), bounds, title)


def _beside_one_another(
    columns: Sequence[rrb.Container | rrb.View], name: str | None = None
) -> rrb.Container:
    """Columns side by side, in two rows if there are more than four."""
    if len(columns) > 4:
        return rrb.Grid(*columns, grid_columns=(len(columns) + 1) // 2, name=name)
    return rrb.Horizontal(*columns, name=name)
