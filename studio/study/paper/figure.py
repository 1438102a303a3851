"""The study's figure for a paper: learning curves in vector form, as wide as one column.

One panel a teacher, one above the other on shared axes. Learners are named beside the ends of their
curves and differ in marks and dashes as well as in colour, so that the figure can be read in grey
and by people who see colours differently. What else a reader needs to know is for the caption:
`study.words` suggests one, and it is kept in the file's metadata.

The type of a PDF is embedded as TrueType (type 42). SVG has no way to embed fonts that all programs
heed, so letters are outlines there. Files bear no date: with one version of matplotlib, the same
table gives the same bytes.
"""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FixedFormatter, FixedLocator, NullLocator

from learners import Curve
from studio.painter.axes import LogAxis
from studio.study.paper.page import (
    EDGE,
    PAD,
    POINT,
    SAMPLE,
    SMALL_TYPE,
    STEP,
    TYPE,
    PaperPage,
    measure,
    points,
    rgb,
    settings,
    shortened,
    with_room,
    write,
)
from studio.study.results import StudyResults
from studio.study.words import NO_FITS, panel_titles, paper_caption, parameters_told
from studio.style.palette import LIGHT, Marker, learner_pen
from studio.style.places import spread_apart
from studio.style.words import learner_name, number

_MARK = 3.2  # size of marks, pt
_DOT = 1.5  # diameter of the dot of a seed, pt
_ASIDE = 3.4  # from the seeds of one learner to those of the next, pt
_BAND = 0.17  # how opaque a band is


_MARKS: dict[Marker, str] = {
    "circle": "o",
    "square": "s",
    "triangle": "^",
    "diamond": "D",
    "triangle_down": "v",
    "plus": "P",
    "pentagon": "p",
    "star": "*",
}
"""Matplotlib's names of the palette's markers."""


def write_paper_figure(path: Path, results: StudyResults) -> str:
    """Write the figure of a study as a PDF or SVG file, and give the caption that it holds."""
    is_pdf, caption = path.suffix.lower() == ".pdf", paper_caption(results)
    about = {
        "Title": "Learning curves",
        "Creator": "prospect-studio",
        "Subject" if is_pdf else "Description": caption,
        "CreationDate" if is_pdf else "Date": None,
    }
    figure = compose_paper_figure(results)
    with settings():
        figure.savefig(path, metadata=about)
    return caption


def compose_paper_figure(results: StudyResults) -> Figure:
    """Draw the figure of a study."""
    with settings():
        page = PaperPage.of(results)
        figure = Figure((page.width / POINT, page.height / POINT), dpi=POINT)
        _write_titles(figure, page)
        for index, teacher in enumerate(results.teachers):
            axes = _add_panel(figure, page, index)
            curves = results.curves_of("regret_percent", teacher)
            _draw_curves(axes, page, curves)
            _name_curves(figure, page, index, curves)
            if not curves:
                middle = (page.left + page.across / 2.0, page.bottom(index) + page.panel / 2.0)
                write(figure, *middle, NO_FITS, SMALL_TYPE, ha="center", va="center")
        across = page.left + page.across / 2.0
        write(figure, across, EDGE + 0.25 * TYPE, "Preference pairs", TYPE, ha="center")
        up_page = (page.foot + page.top(0)) / 2.0
        name = "Held-out regret (% of a random action's)"
        write(figure, EDGE, up_page, name, TYPE, va="center", rotation="vertical")
    return figure


def _write_titles(figure: Figure, page: PaperPage) -> None:
    """Write titles above panels, and the teachers' parameters if all of them have room."""
    titles = panel_titles(page.results)
    remarks = [parameters_told(teacher) for teacher in page.results.teachers]
    room = page.width - EDGE - page.left
    fit = all(
        measure(title, TYPE, "bold") + 2.0 * TYPE + measure(remark, SMALL_TYPE) <= room
        for title, remark in zip(titles, remarks, strict=True)
    )
    for index, (title, remark) in enumerate(zip(titles, remarks, strict=True)):
        line = page.top(index) + 0.5 * TYPE
        text = shortened(title, room, TYPE, "bold")
        write(figure, page.left, line, text, TYPE, weight="bold")
        if fit:
            write(figure, page.left + room, line, remark, SMALL_TYPE, ha="right")


def _add_panel(figure: Figure, page: PaperPage, index: int) -> Axes:
    """Add a panel with its axes; only the lowest has numbers under it."""
    wide, high, sizes, up = page.width, page.height, page.results.sizes, page.up
    axes = figure.add_axes(
        (page.left / wide, page.bottom(index) / high, page.across / wide, page.panel / high)
    )
    first, last = (sizes[0], sizes[-1]) if sizes else (1, 10)
    margin = (last / first) ** 0.04 if last > first else 4.0
    ends = (first / margin, last * margin)
    axes.set(xscale="log", yscale="log", xlim=ends, ylim=up.ends)
    below = [str(size) for size in sizes]
    lengths = [measure(text, SMALL_TYPE) for text in below]
    shown = with_room(_along(page, sizes, ends), lengths, 0.5 * SMALL_TYPE)
    _set_ticks(axes.xaxis, [float(size) for size in sizes], below, shown)
    marks = up.marks()
    heights = [page.panel * up.share(mark) for mark in marks]
    shown = with_room(heights, [SMALL_TYPE] * len(marks), 0.2 * SMALL_TYPE)
    _set_ticks(axes.yaxis, up.along(marks).tolist(), [number(mark) for mark in marks], shown)
    length = 0.7 * PAD
    axes.tick_params(length=length, width=0.5, pad=PAD - length, color=rgb(LIGHT.faint))
    axes.tick_params(labelcolor=rgb(LIGHT.ink), labelsize=SMALL_TYPE)
    axes.tick_params(axis="x", labelbottom=index == page.panels - 1)
    axes.grid(color=rgb(LIGHT.grid), linewidth=0.4)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)
    axes.spines[["left", "bottom"]].set(linewidth=0.5, color=rgb(LIGHT.faint))
    return axes


def _set_ticks(
    axis: Axis, places: Sequence[float], labels: Sequence[str], shown: Sequence[int]
) -> None:
    """Put ticks at these places, with those labels that are shown."""
    texts = [label if index in shown else "" for index, label in enumerate(labels)]
    axis.set_major_locator(FixedLocator(places))
    axis.set_major_formatter(FixedFormatter(texts))
    axis.set_minor_locator(NullLocator())


def _along(page: PaperPage, sizes: Sequence[int], ends: tuple[float, float]) -> list[float]:
    """Where numbers of pairs lie in a panel, pt."""
    places: list[float] = LogAxis(*ends, 0.0, page.across, 0.0).along(sizes).tolist()
    return places


def _draw_curves(axes: Axes, page: PaperPage, curves: Sequence[Curve]) -> None:
    """Draw curves with the bands of their intervals; a single interval is a bar."""
    for curve in curves:
        look = _look(curve.learner)
        low, high = page.up.along(curve.low), page.up.along(curve.high)
        if len(curve.pairs) == 1:
            axes.vlines(curve.pairs, low, high, color=look["color"], linewidth=0.8)
            continue
        several = curve.runs > 1
        axes.fill_between(
            curve.pairs, low, high, where=several, color=look["color"], alpha=_BAND, linewidth=0.0
        )
        for edge in (low, high):
            axes.plot(
                curve.pairs,
                np.where(several, edge, np.nan),
                **look | {"linewidth": 0.4, "marker": ""},
            )
    for index, curve in enumerate(curves):
        places = _along(page, curve.pairs.tolist(), axes.get_xlim())
        marked = with_room(places, [_MARK] * len(places), 0.5 * _MARK)
        look = _look(curve.learner)
        axes.plot(curve.pairs, page.up.along(curve.mean), markevery=marked, zorder=3, **look)
        first, last = axes.get_xlim()
        aside = (last / first) ** (_ASIDE * (index - (len(curves) - 1) / 2.0) / page.across)
        _draw_seeds(axes, page, curve, marked, aside)


def _draw_seeds(
    axes: Axes, page: PaperPage, curve: Curve, marked: Sequence[int], aside: float
) -> None:
    """Draw a dot for every seed, and the interquartile mean with its interval, where it is marked.

    They stand beside the mean: at so many times its number of pairs.
    """
    colour = rgb(learner_pen(curve.learner).colour)
    for place in marked:
        samples, pairs = curve.samples[place], aside * float(curve.pairs[place])
        if len(samples) < 2:
            continue
        dots = page.up.along(samples)
        beside = np.full(len(samples), pairs)
        axes.scatter(beside, dots, s=_DOT**2, color=colour, alpha=0.55, linewidths=0.0, zorder=2.5)
        ends = page.up.along([curve.middle_low[place], curve.middle_high[place]])
        axes.vlines([pairs], *ends, color=colour, linewidth=0.5, zorder=2.5)
        middle = page.up.along([curve.middle[place]])
        axes.plot([pairs], middle, "_", color=colour, markersize=_ASIDE, zorder=2.6)


def _name_curves(figure: Figure, page: PaperPage, index: int, curves: Sequence[Curve]) -> None:
    """Write learners' names beside the ends of their curves, each after a piece of its line."""
    low, top = page.bottom(index), page.top(index)
    ends = sorted(
        (low + page.panel * page.up.share(float(curve.mean[-1])), curve.learner) for curve in curves
    )
    heights = spread_apart([y for y, _ in ends], STEP, low + STEP / 2.0, top - STEP / 2.0)
    start = page.left + page.across + PAD
    end = start + SAMPLE
    for y, (_, learner) in zip(heights, ends, strict=True):
        look = _look(learner)
        line = Line2D([start, (start + end) / 2.0, end], [y, y, y], **look)
        line.set(transform=points(figure), markevery=[1])
        figure.add_artist(line)
        room = page.width - EDGE - end - PAD
        name = shortened(learner_name(learner), room, SMALL_TYPE)
        write(figure, end + PAD, y, name, SMALL_TYPE, va="center_baseline")


def _look(learner: str) -> dict[str, Any]:
    """What a learner's line looks like, as matplotlib's properties of lines."""
    pen = learner_pen(learner)
    colour = rgb(pen.colour)
    return {
        "color": colour,
        "linewidth": 1.0,
        "linestyle": (0, pen.dashes) if pen.dashes else "solid",
        "marker": _MARKS[pen.marker],
        "markersize": _MARK,
        "markeredgewidth": 0.7,
        "markerfacecolor": colour if pen.filled else rgb(LIGHT.ground),
    }
