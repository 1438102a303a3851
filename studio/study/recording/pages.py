"""The pages of a recording of a study, in Markdown: what one sees, and how to make it again."""

import shlex
from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from learners import (
    BETA,
    FEATURES,
    PARAMETER_COLUMNS,
    TEACHERS,
    CptParameters,
    Spread,
    Teacher,
    unit_vector,
)
from studio.recorder.markdown import table
from studio.study.links import Links
from studio.study.results import StudyResults
from studio.study.words import learner_called, lesson, teacher_called
from studio.style.words import action_label, counted, learner_name, number, teacher_name

LEAST_PERCENT = 0.1
"""Regrets of scenes that are smaller, in % of a random action's, are told as less than this."""


@dataclass(frozen=True)
class _Column:
    """How pages write a column of the study's table."""

    words: str
    name: str
    form: str  # of its numbers, as Python formats them
    factor: float = 1.0  # what its numbers are multiplied by

    def told(self, spread: Spread | None) -> str:
        """The mean over seeds, and its 95 % interval if there is more than one."""
        if spread is None:
            return "–"
        return self._told(spread.runs, spread.mean, spread.low, spread.high)

    def middle_told(self, spread: Spread | None) -> str:
        """The interquartile mean of the seeds, and its interval likewise."""
        if spread is None:
            return "–"
        return self._told(spread.runs, spread.middle, spread.middle_low, spread.middle_high)

    def _told(self, runs: int, *numbers: float) -> str:
        value, low, high = (number(self.factor * each, self.form) for each in numbers)
        return f"{value} [{low}, {high}]" if runs > 1 else value


_REGRET = _Column("regret, %", "regret_percent", ".2f")
_QUALITIES = (
    (_REGRET, "0"),
    (_Column("best action found, %", "agreement", ".0f", 100.0), "100"),
    (_Column("cosine of θ", "theta_cosine", ".3f"), "1"),
)
"""What is told of every learner, and what it is at best."""


def study_summary_page(results: StudyResults) -> str:
    """What to look at first: how far every learner gets."""
    last = results.sizes[-1]
    rows = [
        [
            teacher_name(teacher.name),
            learner_name(learner),
            _REGRET.told(spread),
            _REGRET.middle_told(spread),
        ]
        for teacher in results.teachers
        for learner in results.learners
        if (spread := results.spread(_REGRET.name, teacher, learner, last))
    ]
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
            "and that of their middle half, which no single seed can carry. In brackets stand 95 % "
            "intervals.",
            "",
            "Drag the time below, or play, to see minds sharpen with the number of pairs. Point "
            "at a mark to see what it is; click on it for all its numbers.",
        ]
    )


def teacher_page(results: StudyResults, teacher: Teacher, pairs: int) -> str:
    """What was learned from one teacher so far: a table a learner, beside the truth."""
    lines = [f"# {teacher_name(teacher.name)} after {counted(pairs, 'pair')}", ""]
    for learner in results.learners:
        if not results.fits_of(teacher, learner, pairs):
            continue

        def spread(column: str, learner: str = learner) -> Spread | None:
            return results.spread(column, teacher, learner, pairs)

        least = _Column("", "nll_teacher", ".3f").told(spread("nll_teacher"))
        rows = [[each.words, best, each.told(spread(each.name))] for each, best in _QUALITIES]
        loss = _Column("log-loss, nats a pair", "nll", ".3f")
        rows.append([loss.words, least.split(" ")[0], loss.told(spread("nll"))])
        theta, form = spread("theta_unit"), _Column("", "", ".2f")
        for place, truth in enumerate(unit_vector(teacher.reward)):
            told = form.told(theta and theta.of(place))
            rows.append([f"θ of {FEATURES[place]}", number(truth, ".2f"), told])
        for symbol, column, truth in zip(
            CptParameters.SYMBOLS, PARAMETER_COLUMNS, teacher.parameters.numbers, strict=True
        ):
            if found := spread(column):
                rows.append([symbol, number(truth), form.told(found)])
        lines += [f"## {learner_called(learner)}", ""]
        lines += [*table(["", "truth", "mean [95 %]"], "lrr", rows), ""]
    return "\n".join(
        [
            *lines,
            "θ is scaled to length 1. Loss aversion, curvature and the length of θ trade off "
            "against one another: single parameters stay wide where choices are predicted well.",
        ]
    )


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
    return "\n".join(
        [
            "# How well learners recover what teachers want",
            "",
            "Synthetic teachers choose between two actions of one scene. Learners are fitted to "
            "these choices alone, and put to the test on scenes that were held out. Every seed "
            "has scenes, pairs and answers of its own; all learners see the same.",
            "",
            "## What one sees",
            "",
            "* **Plots over pairs**: a bold line is the mean over seeds, its band the 95 % "
            "bootstrap interval of that mean, the thin line the interquartile mean, dots are "
            "seeds, and black is the teacher. Regrets are shown as decimal logarithms: 1 is 10 %, "
            "0 is 1 %, −1 is 0.1 %; a regret of 0 stands at half the smallest mean.",
            "* **Weights and values**: how much a probability counts, and how good a utility "
            "feels. A line is a seed, the dashed one the teacher.",
            "* **Calibration**: how probable choices are where the learner predicts so much. Bars "
            "are full up to the lower end of the 95 % interval over seeds, pale up to its upper "
            "end; the dark one reaches to what was predicted.",
            "* **Tables**: the means and their intervals, all fits, and all scenes held out.",
            "",
            "Drag the time, or press space to play and stop; double-click a view to set it back.",
            "",
            "## Teachers",
            "",
            *_about_teachers(results),
            "",
            "## Make it again",
            "",
            "```sh",
            study_command(results, settings),
            "```",
            "",
            *table(["setting", "value"], "ll", _setting_rows(results, settings, versions)),
        ]
    )


def study_command(results: StudyResults, settings: Mapping[str, object]) -> str:
    """The command that makes the study again."""
    known, own = [], []
    for teacher in results.teachers:
        standard = TEACHERS.get(teacher.name)
        if standard is not None and replace(standard, beta=teacher.beta) == teacher:
            known.append(teacher.name)
        else:
            numbers = ",".join(f"{given:g}" for given in teacher.parameters.numbers)
            own += ["--profile", f"{teacher.name}={numbers}"]
    words = ["studio", "learn"]
    if "outcomes" in settings:
        words += ["--outcomes", str(settings["outcomes"])]
    words += ["--teachers", ",".join(known), *own]
    betas = {teacher.beta for teacher in results.teachers}
    if betas != {BETA}:
        words += ["--beta", f"{max(betas):g}"]
    words += ["--learners", ",".join(results.learners)]
    words += ["--pairs", ",".join(map(str, results.sizes)), "--seeds", str(results.seeds)]
    return shlex.join(words)


def _about_teachers(results: StudyResults) -> list[str]:
    """Who the teachers are, and how certain their answers were."""
    rows = [
        [
            teacher_name(teacher.name),
            *map(number, (*teacher.parameters.numbers, teacher.beta, teacher.reference)),
            teacher.weighting,
            ", ".join(map(number, teacher.reward)),
            _certainty(results, teacher),
        ]
        for teacher in results.teachers
    ]
    heads = ["teacher", *CptParameters.SYMBOLS, "β", "r", "w", "θ", "certainty"]
    return [
        "An outcome with features φ has utility x = θ·φ − r. A teacher values it at x^α as a "
        "gain and −λ(−x)^η as a loss, counts probabilities of gains by w with γ, of losses "
        "with δ, and prefers A to B with probability σ(β(V(A) − V(B))). `prelec` is "
        "w(p) = exp(−(−ln p)^γ). All ones is expected utility (EU).",
        "",
        *table(heads, "lrrrrrrrllr", rows),
        "",
        f"θ weighs {', '.join(FEATURES)}. Certainty is the mean probability of what was "
        "answered, 0.5 to 1: answers that are all certain teach little.",
    ]


def _certainty(results: StudyResults, teacher: Teacher) -> str:
    """Mean certainty of a teacher's answers."""
    known = [
        fit["certainty"]
        for fit in results.fits
        if fit["teacher"] == teacher.name and fit["certainty"] is not None
    ]
    return f"{np.mean(known):.2f}" if known else "–"


def _setting_rows(
    results: StudyResults, settings: Mapping[str, object], versions: Mapping[str, str]
) -> list[list[str]]:
    """Everything that the study depends on, a row each."""
    study = results.study
    told: dict[str, object] = {
        "fits": f"{len(results.fits)}, of which {results.unsettled} did not converge",
        "pairs asked more than once": f"at most {results.repeated} of a fit",
        **{
            f"learner: {learner_name(name)}": ", ".join(
                f"{key} {given}" for key, given in description.items() if key != "name"
            )
            for name, description in study.get("learners", {}).items()
            if name in results.learners
        },
        **{name: study[name] for name in ("held_out", "bank") if name in study},
        **settings,
        **{f"version: {name}": version for name, version in versions.items()},
    }
    return [[name, str(given) or "–"] for name, given in told.items()]
