"""Plots in Rerun's own views: bars, curves over time with bands, states over time, and tables.

All lie on the same light paper, whatever the theme of the viewer.
"""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import rerun as rr
import rerun.blueprint as rrb
from numpy.typing import ArrayLike

from studio.arrays import FloatArray
from studio.style.palette import LIGHT, Colour

_PAPER = rrb.archetypes.PlotBackground(color=LIGHT.ground, show_grid=False)  # its grid is black


def log_bars(
    stream: rr.RecordingStream,
    path: str,
    edges: FloatArray,
    heights: ArrayLike,
    colour: Colour,
    *,
    static: bool = True,
) -> None:
    """Add bars of these heights [B], which stand between edges [B + 1], to a recording.

    Of several bars in one view, those whose path comes later in the alphabet lie on top.
    """
    bars = rr.BarChart(heights, color=colour, abscissa=edges[:-1], widths=np.diff(edges))
    stream.log(path, bars, static=static)


def bars_view(path: str, title: str, behind: str | None = None) -> rrb.View:
    """A view of all bars at a path and below it. Its scales hold all of them, and begin at 0.

    The path of further bars may be given that lie behind them, earlier in the alphabet.
    """
    return rrb.BarChartView(
        origin=f"/{path}",
        contents=[f"+ /{path}/**"] + ([f"+ /{behind}"] if behind else []),
        name=title,
        plot_legend=rrb.PlotLegend(visible=False),
        background=_PAPER,
    )


def log_bands(
    stream: rr.RecordingStream,
    path: str,
    times: Sequence[rr.TimeColumn],
    values: FloatArray,
    reaches: FloatArray,
    names: Sequence[str],
    colours: Sequence[Colour],
    *,
    width: float = 2.0,
) -> None:
    """Add N curves with bands around them: values [T, N], and how far bands reach to each side.

    The reaches, [T, N], are in the unit of the values.
    """
    style = rr.Measurements.from_fields(colors=list(colours), names=list(names), widths=width)
    stream.log(path, style, static=True)
    # Rerun draws a band of one standard deviation to each side
    columns = rr.Measurements.columns(values=values.ravel(), variances=np.square(reaches).ravel())
    stream.send_columns(path, times, columns.partition([values.shape[1]] * len(values)))


def curves_view(
    path: str,
    title: str,
    *,
    legend: rrb.Corner2D | None = None,
    y_range: tuple[float, float] | None = None,
    numbers: tuple[int, int] | None = None,
) -> rrb.View:
    """A view of all curves at a path and below it, over time.

    Args:
        path: of the curves.
        title: of the view.
        legend: in which corner the curves are named; nowhere if left out.
        y_range: what the view shows upwards; if left out, all that there is.
        numbers: from where to where it shows a timeline that counts; if left out, all that there
            is, with the first and the last marks half cut off by the edges.
    """
    return rrb.TimeSeriesView(
        origin=f"/{path}",
        name=title,
        axis_x=None if numbers is None else rrb.TimeAxis(view_range=_count_range(*numbers)),
        axis_y=None if y_range is None else rrb.ScalarAxis(range=y_range),
        plot_legend=rrb.PlotLegend(legend, visible=legend is not None),
        background=_PAPER,
    )


def _count_range(first: int, last: int) -> rr.TimeRange:
    start, end = (rr.TimeRangeBoundary.absolute(seq=number) for number in (first, last))
    return rr.TimeRange(start=start, end=end)


def log_states(
    stream: rr.RecordingStream,
    path: str,
    times: Sequence[rr.TimeColumn],
    states: Sequence[Sequence[str]],
    colours: Mapping[str, Colour],
) -> None:
    """Add N things that change their states to a recording, a lane each.

    Args:
        stream: the recording.
        path: of the lanes, which are in one order at all times.
        times: when one of the states changes, [T].
        states: which states the things have from then on, T rows of N.
        colours: of the states, by their names; those of an empty name are not shown.
    """
    look = rr.StateConfiguration(values=list(colours), colors=list(colours.values()))
    stream.log(path, look, static=True)
    columns = rr.StateChange.columns(state=[state for row in states for state in row])
    stream.send_columns(path, times, columns.partition([len(row) for row in states]))


def states_view(path: str, title: str) -> rrb.View:
    """A view of the states of all things at a path and below it, over time."""
    return rrb.StateTimelineView(origin=f"/{path}", name=title)


def log_rows(
    stream: rr.RecordingStream,
    path: str,
    timeline: str,
    columns: Mapping[str, ArrayLike],
    first: int = 0,
) -> None:
    """Add a table to a recording: columns [N] by their names, a row at each number of a timeline.

    Rows are numbered from `first` on. The view shows columns in the order of the alphabet.
    """
    values: dict[str, Any] = {name: np.asarray(column) for name, column in columns.items()}
    count = len(next(iter(values.values())))
    numbers = rr.TimeColumn(timeline, sequence=np.arange(first, first + count))
    stream.send_columns(path, [numbers], rr.AnyValues.columns(**values))


def table_view(
    path: str, title: str, timeline: str, columns: Sequence[str] | None = None
) -> rrb.View:
    """A view of a table whose rows stand on a timeline, and which follows the time that is shown.

    It shows the columns of these names, or all, in the order of the alphabet.
    """
    query = rrb.archetypes.DataframeQuery(
        timeline=timeline,
        select=None if columns is None else [timeline, *(f"/{path}:{name}" for name in columns)],
        auto_scroll=True,
    )
    return rrb.DataframeView(origin=f"/{path}", name=title, query=query)
