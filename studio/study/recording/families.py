"""Regret by family in a recording of a study: every held-out scene, and what they come to."""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import rerun as rr

from learners import SceneRegrets, Spread, Teacher
from studio.arrays import Bounds, FloatArray
from studio.recorder.axes import KEY_STEP, LIFT, Scale, draw_key, ratio_scale
from studio.recorder.drawing import Drawing
from studio.study.recording import entities
from studio.study.recording.over_pairs import changing_figure, each_size, sides
from studio.study.results import FAMILY_COLUMNS, StudyResults
from studio.study.words import learner_called
from studio.style.palette import LIGHT, blend, learner_colour
from studio.style.words import counted, short

# lengths on the page, on which 1 is the width of the boxes and the scale together
_TALLEST_STRIP = 0.21  # height of the strip of one learner in one family that looks good
_LEAST_STRIP = 0.09  # height that the words beside a strip need
_ROOM = 2.4  # height that all strips share as long as they need no more
_HEADING = 0.13  # height of the name of a family above its strips
_SCALE_LEFT = 0.31  # where the scale begins
_MEANS = 1.14  # where the means are written
_BESIDE = 0.06  # from the middle of its ring to the number of a scene

NOTHING = 0.24
"""Width of the boxes on the left that hold the scenes without regret."""

LEAST_PERCENT = 0.1
"""The scale begins no lower, and smaller regrets are drawn at this, % of a random action's."""

_SPREADING = (0.7548776662466927, 0.5698402909980532)
"""Steps around the unit square that fill it evenly however many are made (Roberts, "The
Unreasonable Effectiveness of Quasirandom Sequences", 2018)."""


@dataclass(frozen=True)
class FamilyFigure:
    """What the figures of all teachers are drawn on: a strip a family and learner, top to bottom.

    The scale is that of regrets above 0, in % of a random action's.
    """

    families: tuple[str, ...]
    learners: tuple[str, ...]
    scale: Scale

    @property
    def strip_height(self) -> float:
        """Height of the strip of one learner in one family."""
        share = (_ROOM / len(self.families) - _HEADING) / len(self.learners)
        return max(_LEAST_STRIP, min(_TALLEST_STRIP, share))

    @property
    def family_height(self) -> float:
        """Height of all strips of one family with its name."""
        return _HEADING + self.strip_height * len(self.learners)

    @property
    def height(self) -> float:
        """Height from the lowest strip to the name of the highest family."""
        return len(self.families) * self.family_height

    def strip(self, family: str, learner: str) -> float:
        """How high the middle of a strip lies."""
        above = _HEADING / 2.0 + self.strip_height * (self.learners.index(learner) + 0.5)
        return self.heading(family) - above

    def heading(self, family: str) -> float:
        """How high the name of a family lies."""
        return self.height - self.families.index(family) * self.family_height - _HEADING / 2.0

    def across(self, percent: FloatArray) -> FloatArray:
        """Where regrets lie along the page; what is off the scale lies at its end."""
        places: FloatArray = _SCALE_LEFT + (1.0 - _SCALE_LEFT) * self.scale(percent)
        return places

    @property
    def bounds(self) -> Bounds:
        """What a view of the figure must show."""
        return -0.06, -0.3, 1.26, self.height + KEY_STEP * len(self.learners) + 0.06


def family_figure(results: StudyResults) -> FamilyFigure:
    """The figure, large enough for the regrets of all teachers at any time."""
    percents: list[float] = []
    for teacher in results.teachers:
        for learner in results.learners:
            for family in results.families:
                curve = results.family_percents(family, teacher, learner)
                if curve:
                    percents += [*curve.mean.tolist(), *curve.high.tolist()]
            for pairs in results.sizes:
                regrets = results.scene_regrets(teacher, learner, pairs)
                if regrets is not None:
                    percents += scene_percents(results, teacher, regrets).tolist()
    low = max(LEAST_PERCENT, min((each for each in percents if each > 0.0), default=LEAST_PERCENT))
    scale = ratio_scale(low, max([*percents, 10.0 * low]))
    tens = [np.log10(tick).round(6) % 1.0 == 0.0 for tick in scale.ticks]
    words = [word if is_ten else "" for word, is_ten in zip(scale.words, tens, strict=True)]
    return FamilyFigure(results.families, results.learners, replace(scale, words=tuple(words)))


def log_families(stream: rr.RecordingStream, results: StudyResults, teacher: Teacher) -> None:
    """Draw the regret in every scene, and the mean of each family with its 95 % interval."""
    path, figure = entities.figure(teacher.name, entities.FAMILIES), family_figure(results)
    drawing = Drawing(lift=LIFT)
    draw_strips(drawing, results, figure)
    drawing.log(stream, path)
    for pairs, changing in changing_figure(stream, results, path):
        for learner in results.learners:
            regrets = results.scene_regrets(teacher, learner, pairs)
            if regrets is not None:
                draw_scenes(changing, results, figure, teacher, regrets)
        for learner in results.learners:
            for family in results.families:
                curve = results.family_percents(family, teacher, learner)
                spread = curve and curve.at(pairs)
                if spread:
                    draw_mean(changing, figure, family, learner, spread)


def draw_strips(drawing: Drawing, results: StudyResults, figure: FamilyFigure) -> None:
    """Draw the ground of every strip, the scale, the names of families, and the key."""
    ticks = figure.scale.ticks
    for family in figure.families:
        count = sum(scene.family == family for scene in results.scenes.values())
        drawing.text((0.5, figure.heading(family)), f"{short(family)}, {counted(count, 'scene')}")
        top = figure.heading(family) - _HEADING / 2.0
        bottom = top - figure.strip_height * len(figure.learners)
        for tick, x in zip(ticks, figure.across(np.array(ticks)), strict=True):
            drawing.line([(x, bottom), (x, top)], LIGHT.faint if tick == 100.0 else LIGHT.grid, 1.0)
        for place in range(len(figure.learners) + 1):
            y = top - figure.strip_height * place
            drawing.line([(0.0, y), (NOTHING, y)], LIGHT.grid, 1.0)
            drawing.line([(_SCALE_LEFT, y), (1.0, y)], LIGHT.grid, 1.0)
        for x in (0.0, NOTHING):
            drawing.line([(x, bottom), (x, top)], LIGHT.grid, 1.0)
    drawing.text((NOTHING / 2.0, -0.08), "none")
    for words, x in zip(figure.scale.words, figure.across(np.array(ticks)), strict=True):
        if words:
            drawing.text((float(x), -0.08), words)
    drawing.text(((_SCALE_LEFT + 1.0) / 2.0, -0.2), "regret, % of a random action's")
    drawing.text((_MEANS, figure.heading(figure.families[0])), "mean")
    entries = [(learner_called(learner), learner_colour(learner)) for learner in figure.learners]
    draw_key(drawing, entries, 0.0, figure.height + KEY_STEP * (len(entries) - 0.5))


def draw_scenes(
    drawing: Drawing,
    results: StudyResults,
    figure: FamilyFigure,
    teacher: Teacher,
    regrets: SceneRegrets,
) -> None:
    """Draw every scene as a dot, those that tell most ringed and numbered from 1 on."""
    colour = blend(learner_colour(regrets.learner), LIGHT.panel, 0.6)
    percents = scene_percents(results, teacher, regrets)
    aside, along = np.modf(np.outer(np.arange(len(percents)), _SPREADING))[0].T
    x = np.where(percents > 0.0, figure.across(percents), NOTHING * (0.06 + 0.88 * along))
    telling = results.telling[teacher.name]
    ringed = {}
    for scene, percent, across, share in zip(
        regrets.scenes.tolist(), percents, x, aside - 0.5, strict=True
    ):
        middle = figure.strip(results.scenes[scene].family, regrets.learner)
        if scene in telling:
            # so that numbers keep off the names of families and off most dots
            ring = float(across) if percent > 0.0 else 0.8 * NOTHING
            ringed[scene] = (ring, middle + 0.5 * figure.strip_height * share)
        else:
            spot = (float(across), middle + 0.8 * figure.strip_height * share)
            drawing.dot(spot, colour, 4.0)
    for scene, (across, up) in ringed.items():
        drawing.dot((across, up), LIGHT.ink, 9.0)
        drawing.dot((across, up), learner_colour(regrets.learner), 5.5)
        # away from the words at either side of the page
        aside = _BESIDE if across < NOTHING else -_BESIDE
        drawing.text((across + aside, up + 0.02), str(telling.index(scene) + 1))


def draw_mean(
    drawing: Drawing, figure: FamilyFigure, family: str, learner: str, spread: Spread
) -> None:
    """Draw the mean regret of a family, its interval as a thick line, and write it beside."""
    y, colour = figure.strip(family, learner), learner_colour(learner)
    ends = np.array([spread.low, spread.mean, spread.high])
    left, middle, right = figure.across(ends).tolist()
    drawing.line([(left, y), (right, y)], colour, 5.0)
    drawing.dot((middle, y), LIGHT.ink, 15.0)
    drawing.dot((middle, y), colour, 11.0)
    drawing.text((_MEANS, y), f"{spread.mean:.2f} %")


def scene_percents(results: StudyResults, teacher: Teacher, regrets: SceneRegrets) -> FloatArray:
    """Regret in each scene in % of what a random action costs in its family, on average."""
    return np.array(
        [
            results.percents(teacher, results.scenes[scene].family, regret)
            for scene, regret in zip(regrets.scenes.tolist(), regrets.regret, strict=True)
        ]
    )


def log_family_numbers(stream: rr.RecordingStream, results: StudyResults, teacher: Teacher) -> None:
    """Keep the regret by family: mean, std and interval over seeds, NaN where there is no curve."""
    for pairs in each_size(stream, results):
        for learner in results.learners:
            if not results.fits_of(teacher, learner, pairs):
                continue
            numbers: dict[str, Any] = {"family": list(results.families)}
            for column in FAMILY_COLUMNS:
                curves = [
                    results.family_curve(column, family, teacher, learner)
                    for family in results.families
                ]
                spreads = [curve and curve.at(pairs) for curve in curves]
                told = [sides(spread) if spread else (np.nan,) * 4 for spread in spreads]
                numbers[column] = np.array(told).T.ravel()
            stream.log(entities.families(teacher.name, learner), rr.AnyValues(**numbers))
