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
    Teacher,
    unit_vector,
)
from studio.recorder.markdown import link, table
from studio.study.recording import entities
from studio.study.results import StudyResults
from studio.study.words import learner_called, lesson, teacher_called
from studio.style.words import counted, learner_name, number, teacher_name


@dataclass(frozen=True)
class _Column:
    """How pages write a column of the study's table."""

    name: str
    form: str  # of its numbers, as Python formats them
    factor: float = 1.0  # what its numbers are multiplied by


_REGRET = _Column("regret_percent", ".2f")
_AGREEMENT = _Column("agreement", ".0f", 100.0)
_COSINE = _Column("theta_cosine", ".3f")
_LOSS, _LEAST_LOSS = _Column("nll", ".3f"), _Column("nll_teacher", ".3f")


def study_summary_page(results: StudyResults) -> str:
    """What to look at first: how far every learner gets, and every regret in a table."""
    last = results.sizes[-1]
    lessons = [(teacher, lesson(results, teacher)) for teacher in results.teachers]
    return "\n".join(
        [
            "# What was learned",
            "",
            f"Teachers chose between {counted(last, 'pair')} of actions or fewer; learners were "
            "fitted to the choices and then picked an action in every scene that was held out. "
            "Regret is what the teacher loses by these picks, in % of what picking at random "
            "would cost.",
            "",
            "Drag the time below, or play, to see minds sharpen with the number of pairs.",
            "",
            f"## After {counted(last, 'pair')}",
            "",
            *table(
                ["teacher", "learner", "regret, %", "95 % of the mean", "best action", "cos θ"],
                "llrrrr",
                _final_rows(results),
            ),
            "",
            *(f"* **{teacher_called(teacher)}**: {said}" for teacher, said in lessons if said),
            "",
            *regret_tables(results),
        ]
    )


def teacher_page(results: StudyResults, teacher: Teacher, pairs: int) -> str:
    """What was learned from one teacher so far."""
    learners = [le for le in results.learners if results.fits_of(teacher, le, pairs)]

    def cells(column: _Column, learners: list[str] = learners) -> list[str]:
        return [_cell(results, teacher, learner, column, pairs) for learner in learners]

    parameters = zip(
        CptParameters.SYMBOLS, PARAMETER_COLUMNS, teacher.parameters.numbers, strict=True
    )
    rows = [
        ["regret, %", "0", *cells(_REGRET)],
        ["best action found, %", "100", *cells(_AGREEMENT)],
        ["cosine of θ", "1", *cells(_COSINE)],
        ["log-loss, nats a pair", "".join(cells(_LEAST_LOSS, learners[:1])), *cells(_LOSS)],
        *(
            [symbol, number(truth), *cells(_Column(column, ".2f"))]
            for symbol, column, truth in parameters
        ),
    ]
    heads = [f"mean ± std, {counted(results.seeds, 'seed')}", "truth"]
    return "\n".join(
        [
            f"# {teacher_name(teacher.name)} after {counted(pairs, 'pair')}",
            "",
            *table([*heads, *map(learner_name, learners)], "lr" + "r" * len(learners), rows),
            "",
            "Regret is in % of a random action's. Curves: means over seeds, over the pairs learned "
            "from; bands: 95 % intervals of the means. Thin lines: single seeds; dashed or dark: "
            "the teacher. Parameters: thick bars are 95 % intervals, thin ones ± std.",
        ]
    )


def regret_tables(results: StudyResults) -> list[str]:
    """Mean ± standard deviation of every regret, a table a teacher."""
    learners = results.learners
    lines = []
    for teacher in results.teachers:
        rows = [
            [str(pairs), *(_cell(results, teacher, le, _REGRET, pairs) for le in learners)]
            for pairs in results.sizes
        ]
        heads = ["pairs", *map(learner_called, learners)]
        title = f"## Regret, {teacher_called(teacher)}"
        lines += [title, "", *table(heads, "r" * len(heads), rows), ""]
    return [*lines, f"In %: mean ± standard deviation over {counted(results.seeds, 'seed')}."]


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
            *_what_one_sees(results),
            "",
            "Drag the time, or press space to play and stop; double-click a view to set it back.",
            "",
            *regret_tables(results),
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


def _what_one_sees(results: StudyResults) -> list[str]:
    """The figures of the recording, with links to those of the first teacher."""

    def shown(figure: str, words: str) -> str:
        return link(words, entities.figure(results.teachers[0].name, figure))

    families = [
        f"* {shown(entities.FAMILIES, 'Families')}: the same regret by kind of "
        "scene. A dot is a scene that was held out, those without regret in a box at the left; the "
        "large dot is the mean of the family over seeds, the line its 95 % interval. All are in % "
        "of what a random action costs in the family, on average over its scenes. Ringed and "
        f"numbered are the scenes that {link('the page beside', entities.SCENES)} tells of, with "
        "links to their own recordings."
    ]
    return [
        f"* {shown(entities.REGRET, 'Regret')}: what the teacher loses by the "
        "learner's picks, in % of what picking at random would cost. The line is the mean over "
        "seeds, the band the 95 % bootstrap interval of that mean. What leaves the figure is drawn "
        "at its edge. The upright line marks the number of pairs that the other figures show.",
        f"* {shown(entities.AGREEMENT, 'Best action found')}: in how many of the "
        "scenes the learner picks what the teacher would.",
        f"* {shown(entities.GAIN_WEIGHTS, 'w(p) of gains')} and "
        f"{shown(entities.LOSS_WEIGHTS, 'of losses')}: how much a probability "
        "counts. Faint lines are the seeds, the bold one is their mean, the dashed one the "
        "teacher. An EU learner counts every probability as it is.",
        f"* {shown(entities.VALUES, 'v(u)')}: how good a utility feels, over "
        "u = θ·φ/|θ|: choices tell the length of θ only together with the value function.",
        f"* {shown(entities.PARAMETERS, 'Parameters')}: the dot is the mean, the "
        "thick line its 95 % interval, the thin one ± one standard deviation, the dark mark the "
        "truth. Loss aversion, curvature and the length of θ trade off against one another, so "
        "that single parameters stay wide where the choices are predicted well.",
        *(families if results.scenes else []),
        f"* {shown(entities.CALIBRATION, 'Calibration')}: how probable the teacher's "
        "choices are where the learner predicts so much; a dot's area is the share of predictions. "
        f"Below, the {shown(entities.LIKELIHOOD, 'likelihood')} of held-out choices.",
    ]


def _about_teachers(results: StudyResults) -> list[str]:
    """Who the teachers are, what outcomes are worth to them, and how certain their answers were."""
    teachers = results.teachers
    names = [teacher_name(teacher.name) for teacher in teachers]
    minds = [
        [
            name,
            *map(number, (*teacher.parameters.numbers, teacher.beta, teacher.reference)),
            teacher.weighting,
        ]
        for name, teacher in zip(names, teachers, strict=True)
    ]
    units = [unit_vector(teacher.reward) for teacher in teachers]
    rewards = [
        [feature, *(f"{number(teacher.reward[place])} ({number(unit[place], '.2f')})"
                    for teacher, unit in zip(teachers, units, strict=True))]
        for place, feature in enumerate(FEATURES)
    ]  # fmt: skip
    certainties = [
        [name, *(_certainty(results, teacher, pairs) for pairs in results.sizes)]
        for name, teacher in zip(names, teachers, strict=True)
    ]
    sizes = [f"{pairs} pairs" for pairs in results.sizes]
    return [
        "An outcome with features φ has utility x = θ·φ − r. A teacher values it at x^α as a "
        "gain and −λ(−x)^η as a loss, counts probabilities of gains by w with γ, of losses "
        "with δ, and prefers A to B with probability σ(β(V(A) − V(B))). `prelec` is "
        "w(p) = exp(−(−ln p)^γ). All ones is expected utility (EU).",
        "",
        *table(["teacher", *CptParameters.SYMBOLS, "β", "r", "w"], "lrrrrrrrl", minds),
        "",
        *table(["worth θ (scaled to length 1)", *names], "l" + "r" * len(names), rewards),
        "",
        *table(["teacher", *sizes], "l" + "r" * len(sizes), certainties),
        "",
        "Certainty of the answers: the mean probability of what was answered, 0.5 to 1. "
        "Answers that are all certain teach little.",
    ]


def _setting_rows(
    results: StudyResults, settings: Mapping[str, object], versions: Mapping[str, str]
) -> list[list[str]]:
    """Everything that the study depends on, a row each."""
    study = results.study
    told: dict[str, object] = {
        "teachers": ", ".join(teacher.name for teacher in results.teachers),
        "learners": ", ".join(results.learners),
        "pairs": ", ".join(map(str, results.sizes)),
        "seeds": results.seeds,
        "fits": f"{len(results.fits)}, of which {results.unsettled} did not converge",
        "pairs asked more than once": f"at most {results.repeated} of a fit",
        **{
            f"learner: {learner_name(name)}": _flat(description)
            for name, description in study.get("learners", {}).items()
            if name in results.learners
        },
        **{name: study[name] for name in ("held_out", "bank") if name in study},
        **settings,
        **{f"version: {name}": version for name, version in versions.items()},
    }
    return [[name, str(given)] for name, given in told.items()]


def _final_rows(results: StudyResults) -> list[list[str]]:
    """How far every learner got with the most pairs."""
    pairs, rows = results.sizes[-1], []
    for teacher in results.teachers:
        for curve in results.curves_of("regret_percent", teacher):
            learner, spread = curve.learner, curve.at(pairs)
            if spread is None:
                continue
            interval = f"{spread.low:.2f} to {spread.high:.2f}" if spread.runs > 1 else "–"
            rows.append(
                [
                    link(
                        teacher_name(teacher.name), entities.figure(teacher.name, entities.REGRET)
                    ),
                    learner_name(learner),
                    _cell(results, teacher, learner, _REGRET, pairs),
                    interval,
                    _cell(results, teacher, learner, _AGREEMENT, pairs) + " %",
                    _cell(results, teacher, learner, _COSINE, pairs),
                ]
            )
    return rows


def _certainty(results: StudyResults, teacher: Teacher, pairs: int) -> str:
    """Mean certainty of a teacher's answers; nothing if nobody learned from so few."""
    fits = [fit for le in results.learners for fit in results.fits_of(teacher, le, pairs)]
    return f"{np.mean([fit['certainty'] for fit in fits]):.2f}" if fits else ""


def _cell(
    results: StudyResults, teacher: Teacher, learner: str, column: _Column, pairs: int
) -> str:
    """Mean ± standard deviation; the mean alone where there is a single seed."""
    spread = results.spread(column.name, teacher, learner, pairs)
    if not spread:
        return "–"
    mean = number(column.factor * spread.mean, column.form)
    return f"{mean} ± {column.factor * spread.std:{column.form}}" if spread.runs > 1 else mean


def _flat(description: dict[str, object]) -> str:
    """A learner's description in one line."""
    told = [f"{name} {given}" for name, given in description.items() if name != "name"]
    return ", ".join(told) or "–"
