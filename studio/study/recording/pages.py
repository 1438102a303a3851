"""The pages of a recording of a study, in Markdown: what one sees, and how to make it again."""

from collections.abc import Mapping

import numpy as np

from learners import FEATURES, PARAMETER_COLUMNS, CptParameters, Spread, Teacher, unit_vector
from studio.recorder.markdown import table
from studio.study.again import study_command
from studio.study.links import Links
from studio.study.results import StudyResults
from studio.study.rows import setting_rows, teacher_rows
from studio.study.words import learner_called, lesson, teacher_called
from studio.style.words import action_label, counted, learner_name, number, teacher_name

LEAST_PERCENT = 0.1
"""Regrets of scenes that are smaller, in % of a random action's, are told as less than this."""

_WHAT_ONE_SEES = """## What one sees

* **Plots over pairs**: a bold line is the mean over seeds, its band the 95 % bootstrap interval of
  that mean, the thin line the interquartile mean, dots are seeds, and black is the teacher. Regrets
  are shown as decimal logarithms: 1 is 10 %, 0 is 1 %, −1 is 0.1 %; a regret of 0 stands at half
  the smallest mean.
* **Weights and values**: how much a probability counts, and how good a utility feels. A line is a
  seed, the dashed one the teacher.
* **Calibration**: how probable choices are where the learner predicts so much. Bars are full up to
  the lower end of the 95 % interval over seeds, pale up to its upper end; the dark one reaches to
  what was predicted.
* **Tables**: the means and their intervals, all fits, and all scenes held out.

Drag the time, or press space to play and stop; double-click a view to set it back.

## Teachers

An outcome with features φ has utility x = θ·φ − r. A teacher values it at x^α as a gain and
−λ(−x)^η as a loss, counts probabilities of gains by w with γ, of losses with δ, and prefers A to B
with probability σ(β(V(A) − V(B))). `prelec` is w(p) = exp(−(−ln p)^γ). All ones is expected
utility (EU). Certainty is the mean probability of what was answered, 0.5 to 1: answers that are all
certain teach little."""


def study_summary_page(results: StudyResults) -> str:
    """What to look at first: how far every learner gets."""
    last, rows = results.sizes[-1], []
    for teacher in results.teachers:
        for learner in results.learners:
            if spread := results.spread("regret_percent", teacher, learner, last):
                middle = _told(".2f", spread.middle, spread.middle_low, spread.middle_high)
                names = [teacher_name(teacher.name), learner_name(learner)]
                rows.append([*names, _mean_told(".2f", spread), middle])
    lessons = [(teacher, lesson(results, teacher)) for teacher in results.teachers]
    return "\n".join(
        [
            f"# What was learned from {counted(last, 'pair')}",
            "",
            *(f"* **{teacher_called(teacher)}**: {said}" for teacher, said in lessons if said),
            "",
            *table(["teacher", "learner", "regret, %", "middle half, %"], "llrr", rows),
            "",
            f"Regret is what the teacher loses by the learner's picks in held-out scenes, in % of "
            f"what picking at random would cost: the mean over {counted(results.seeds, 'seed')}, "
            "and that of their middle half, which no single seed can carry. In brackets: 95 % "
            "intervals.",
            "",
            "Drag the time below, or play, to see minds sharpen with the number of pairs. Point "
            "at a mark to see what it is; click on it for all its numbers.",
        ]
    )


def teacher_page(results: StudyResults, teacher: Teacher, pairs: int) -> str:
    """What was learned from one teacher so far: a table a learner, beside the truth."""
    lines = [f"# {teacher_name(teacher.name)} after {counted(pairs, 'pair')}", ""]
    shapes = zip(CptParameters.SYMBOLS, PARAMETER_COLUMNS, teacher.parameters.numbers, strict=True)
    parameters = [(symbol, column, number(truth), ".2f", 1.0) for symbol, column, truth in shapes]
    for learner in results.learners:
        if not results.fits_of(teacher, learner, pairs):
            continue

        def spread(column: str, learner: str = learner) -> Spread | None:
            return results.spread(column, teacher, learner, pairs)

        least, theta = spread("nll_teacher"), spread("theta_unit")
        rows = [
            [
                words,
                truth,
                _mean_told(form, results.spread(column, teacher, learner, pairs), factor),
            ]
            for words, column, truth, form, factor in (
                ("regret, %", "regret_percent", "0", ".2f", 1.0),
                ("best action found, %", "agreement", "100", ".0f", 100.0),
                ("cosine of θ", "theta_cosine", "1", ".3f", 1.0),
                ("log-loss, nats a pair", "nll", f"{least.mean:.3f}" if least else "–", ".3f", 1.0),
                *(row for row in parameters if spread(row[1])),
            )
        ]
        rows += [
            [f"θ of {FEATURES[place]}", number(truth, ".2f"), _mean_told(".2f", theta.of(place))]
            for place, truth in enumerate(unit_vector(teacher.reward))
            if theta
        ]
        lines += [f"## {learner_called(learner)}", ""]
        lines += [*table(["", "truth", "mean [95 %]"], "lrr", rows), ""]
    return "\n".join(
        [
            *lines,
            "θ is scaled to length 1. Loss aversion, curvature and the length of θ trade off "
            "against one another: single parameters stay wide where choices are predicted well.",
        ]
    )


def _mean_told(form: str, spread: Spread | None, factor: float = 1.0) -> str:
    """A mean over seeds times a factor, with its interval."""
    if spread is None:
        return "–"
    return _told(form, factor * spread.mean, factor * spread.low, factor * spread.high)


def _told(form: str, value: float, low: float, high: float) -> str:
    """An estimate with its interval; the interval of a single seed is empty, and is not told."""
    told = number(value, form)
    return told if low == high else f"{told} [{number(low, form)}, {number(high, form)}]"


def scenes_page(results: StudyResults, links: Links, teacher: Teacher, pairs: int) -> str:
    """The scenes in which learners from a teacher differ most, with links to their recordings."""
    heads = ["scene", "teacher", *map(learner_called, results.learners)]
    rows = []
    for scene in results.telling[teacher.name]:
        told, link = results.scenes[scene], links.get(scene)
        name = f"[{link.name} ↗](<{link.path}>)" if link else f"{told.family}, {scene}"
        picks = [_pick(results, teacher, learner, scene, pairs) for learner in results.learners]
        rows.append([name, action_label(told.best[teacher.name]), *picks])
    tells = table(heads, "l" * len(heads), rows) if rows else ["No learner has regret anywhere."]
    commands = [line for link in links.values() for line in link.commands]
    how = [
        "These scenes have no recordings: the outcome bank does not say how to make them again, or "
        "was made by other versions."
    ]
    if links:
        how = [
            "The name of a scene opens its recording, from this recording's folder, where `studio "
            "view` opens the viewer; the arrow at the top leads back. If a link is dead, make "
            f"the scene again in that folder{':' if commands else ' by `studio learn`.'}",
            "",
            *(["```sh", *commands, "```"] if commands else []),
        ]
    return "\n".join(
        [
            f"# Telling scenes after {counted(pairs, 'pair')}",
            "",
            f"Where the learners' regrets differ most, or else are largest, after "
            f"{counted(results.sizes[-1], 'pair')}: picks and regrets, in % of what a random "
            "action costs in scenes of that family.",
            "",
            *tells,
            "",
            "A pick is that of most seeds that held the scene out, as many as the brackets say, "
            "the regret their mean; the tab *Tables* has every scene.",
            "",
            *how,
        ]
    )


def _pick(results: StudyResults, teacher: Teacher, learner: str, scene: int, pairs: int) -> str:
    """What a learner picks in a scene, the regret, and how many seeds say so."""
    regrets = results.scene_regrets(teacher, learner, pairs)
    if regrets is None or scene not in regrets.scenes:
        return "–"
    at = int(np.flatnonzero(regrets.scenes == scene)[0])
    family = results.scenes[scene].family
    percent = float(results.percents(teacher, family, regrets.regret[at]))
    told = f"{percent:.{0 if percent >= 10.0 else 1}f} %"
    if percent < LEAST_PERCENT:
        told = f"< {number(LEAST_PERCENT)} %" if percent > 0.0 else "0 %"
    return f"{action_label(regrets.picks[at])}, {told} ({regrets.runs[at]})"


def about_study_page(
    results: StudyResults, settings: Mapping[str, object], versions: Mapping[str, str]
) -> str:
    """Everything there is to know about a study."""
    heads = ["teacher", *CptParameters.SYMBOLS, "β", "r", "w", f"θ: {', '.join(FEATURES)}"]
    return "\n".join(
        [
            "# How well learners recover what teachers want",
            "",
            "Synthetic teachers choose between two actions of one scene. Learners are fitted to "
            "these choices alone, and put to the test on scenes that were held out. Every seed "
            "has scenes, pairs and answers of its own; all learners see the same.",
            "",
            _WHAT_ONE_SEES,
            "",
            *table([*heads, "certainty"], "lrrrrrrrllr", teacher_rows(results)),
            "",
            "## Make it again",
            "",
            "```sh",
            study_command(results, settings),
            "```",
            "",
            *table(["setting", "value"], "ll", setting_rows(results, settings, versions)),
        ]
    )
