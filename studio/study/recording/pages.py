"""The pages of a recording of a study, in Markdown: what one sees, and how to make it again."""

import json
import shlex
from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from learners import BETA, FEATURES, TEACHERS, Curve, Teacher, paired_differences, unit_vector
from studio.study.recording import entities
from studio.study.recording.calibration import CALIBRATION
from studio.study.recording.curves import AGREEMENT, LIKELIHOOD, REGRET
from studio.study.recording.families import FAMILIES
from studio.study.recording.minds import (
    GAIN_WEIGHTS,
    LOSS_WEIGHTS,
    PARAMETERS,
    SYMBOLS,
    VALUES,
)
from studio.study.results import CPT_COLUMNS, Results, true_parameters
from studio.style.words import counted, learner_name, number, teacher_name


def summary_page(results: Results) -> str:
    """What to look at first: how far every learner gets, and every regret in a table."""
    last = results.sizes[-1]
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
            "| teacher | learner | regret, % | 95 % of the mean | best action | cos θ |",
            "|:--|:--|--:|--:|--:|--:|",
            *(
                row
                for teacher in results.teachers
                for learner in results.learners
                if (row := _final_row(results, teacher, learner, last))
            ),
            "",
            *_lessons(results, last),
            "",
            *regret_tables(results),
        ]
    )


def teacher_page(results: Results, teacher: Teacher, pairs: int) -> str:
    """What was learned from one teacher so far."""
    learners = [le for le in results.learners if results.runs(teacher, le, pairs)["seed"]]
    names = " | ".join(learner_name(learner) for learner in learners)
    lines = [
        f"# {teacher_name(teacher.name)} after {counted(pairs, 'pair')}",
        "",
        f"| mean ± std, {counted(results.seeds, 'seed')} | truth | {names} |",
        "|:--|--:|" + "--:|" * len(learners),
    ]
    measures = [
        ("regret, %", "0", "regret_percent", 1.0, ".2f"),
        ("best action found, %", "100", "agreement", 100.0, ".0f"),
        ("cosine of θ", "1", "theta_cosine", 1.0, ".3f"),
    ]
    for words, truth, column, factor, form in measures:
        cells = [_cell(results, teacher, le, column, pairs, factor, form) for le in learners]
        lines.append(f"| {words} | {truth} | {' | '.join(cells)} |")
    best = [_cell(results, teacher, le, "nll_teacher", pairs, 1.0, ".3f") for le in learners[:1]]
    cells = [_cell(results, teacher, le, "nll", pairs, 1.0, ".3f") for le in learners]
    lines.append(f"| log-loss, nats a pair | {''.join(best)} | {' | '.join(cells)} |")
    for column, truth_number in zip(CPT_COLUMNS, true_parameters(teacher), strict=True):
        cells = [_cell(results, teacher, le, column, pairs, 1.0, ".2f") for le in learners]
        lines.append(f"| {SYMBOLS[column]} | {number(truth_number)} | {' | '.join(cells)} |")
    lines += [
        "",
        "Regret is in % of a random action's. Curves: means over seeds, over the pairs learned "
        "from; bands: 95 % intervals of the means. Thin lines: single seeds; dashed or dark: the "
        "teacher. Parameters: thick bars are 95 % intervals, thin ones ± std.",
    ]
    return "\n".join(lines)


def regret_tables(results: Results) -> list[str]:
    """Mean ± standard deviation of every regret, a table a teacher."""
    lines = []
    for teacher in results.teachers:
        names = " | ".join(f"{learner_name(learner)} learner" for learner in results.learners)
        lines += [
            f"## Regret, {teacher_name(teacher.name)} teacher",
            "",
            f"| pairs | {names} |",
            "|--:|" + "--:|" * len(results.learners),
        ]
        for pairs in results.sizes:
            cells = [
                _cell(results, teacher, learner, "regret_percent", pairs, 1.0, ".2f")
                for learner in results.learners
            ]
            lines.append(f"| {pairs} | {' | '.join(cells)} |")
        lines.append("")
    lines.append(f"In %: mean ± standard deviation over {counted(results.seeds, 'seed')}.")
    return lines


def about_page(
    results: Results, settings: Mapping[str, object], versions: Mapping[str, str]
) -> str:
    """Everything there is to know about a study."""
    teachers, study = results.teachers, results.study
    first = teachers[0]
    minds = [
        f"| {teacher_name(teacher.name)} | "
        + " | ".join(number(given) for given in true_parameters(teacher))
        + f" | {number(teacher.beta)} | {number(teacher.reference)} | {teacher.weighting} |"
        for teacher in teachers
    ]
    rewards = [
        f"| {feature} | "
        + " | ".join(
            f"{number(teacher.reward[place])} ({number(unit_vector(teacher.reward)[place], '.2f')})"
            for teacher in teachers
        )
        + " |"
        for place, feature in enumerate(FEATURES)
    ]
    columns = results.table.column_names
    unsettled = results.table["converged"].to_pylist().count(False)
    repeated = results.table["repeated"].to_pylist() if "repeated" in columns else [0]
    further: dict[str, object] = {
        **{
            f"learner: {learner_name(name)}": _flat(told)
            for name, told in study.get("learners", {}).items()
            if name in results.learners
        },
        **{name: study[name] for name in ("held_out", "bank") if name in study},
        **settings,
        **{f"version: {name}": given for name, given in versions.items()},
    }
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
            f"* [Regret]({_target(first, REGRET.name)}): what the teacher loses by the learner's "
            "picks, in % of what picking at random would cost. The line is the mean over seeds, "
            "the band the 95 % bootstrap interval of that mean. What leaves the figure is drawn at "
            "its edge. The upright line marks the number of pairs that the other figures show.",
            f"* [Best action found]({_target(first, AGREEMENT.name)}): in how many of the scenes "
            "the learner picks what the teacher would.",
            f"* [w(p) of gains]({_target(first, GAIN_WEIGHTS)}) and [of losses]"
            f"({_target(first, LOSS_WEIGHTS)}): how much a probability counts. Faint lines are "
            "the seeds, the bold one is their mean, the dashed one the teacher. An EU learner "
            "counts every probability as it is.",
            f"* [v(u)]({_target(first, VALUES)}): how good a utility feels, over u = θ·φ/|θ|: "
            "choices tell the length of θ only together with the value function.",
            f"* [Parameters]({_target(first, PARAMETERS)}): the dot is the mean, the thick line "
            "its 95 % interval, the thin one ± one standard deviation, the dark mark the truth. "
            "Loss aversion, curvature and the length of θ trade off against one another, so "
            "that single parameters stay wide where the choices are predicted well.",
            *_families_explained(results, first),
            f"* [Calibration]({_target(first, CALIBRATION)}): how probable the teacher's choices "
            "are where the learner predicts so much; a dot's area is the share of predictions. "
            f"Below, the [likelihood]({_target(first, LIKELIHOOD.name)}) of held-out choices.",
            "",
            "Drag the time, or press space to play and stop; double-click a view to set it back.",
            "",
            *regret_tables(results),
            "",
            "## Teachers",
            "",
            "An outcome with features φ has utility x = θ·φ − r. A teacher values it at x^α as a "
            "gain and −λ(−x)^η as a loss, counts probabilities of gains by w with γ, of losses "
            "with δ, and prefers A to B with probability σ(β(V(A) − V(B))). `prelec` is "
            "w(p) = exp(−(−ln p)^γ). All ones is expected utility (EU).",
            "",
            "| teacher | α | η | λ | γ | δ | β | r | w |",
            "|:--|--:|--:|--:|--:|--:|--:|--:|:--|",
            *minds,
            "",
            "| worth θ (scaled to length 1) | "
            + " | ".join(teacher_name(teacher.name) for teacher in teachers)
            + " |",
            "|:--|" + "--:|" * len(teachers),
            *rewards,
            "",
            "| teacher | " + " | ".join(f"{pairs} pairs" for pairs in results.sizes) + " |",
            "|:--|" + "--:|" * len(results.sizes),
            *(_certainty_row(results, teacher) for teacher in teachers),
            "",
            "Certainty of the answers: the mean probability of what was answered, 0.5 to 1. "
            "Answers that are all certain teach little.",
            "",
            "## Make it again",
            "",
            "```sh",
            command(results, settings),
            "```",
            "",
            "| setting | value |",
            "|:--|:--|",
            f"| teachers | {', '.join(teacher.name for teacher in teachers)} |",
            f"| learners | {', '.join(results.learners)} |",
            f"| pairs | {', '.join(str(pairs) for pairs in results.sizes)} |",
            f"| seeds | {results.seeds} |",
            f"| fits | {results.table.num_rows}, of which {unsettled} did not converge |",
            f"| pairs asked more than once | at most {max(repeated)} of a fit |",
            *(f"| {name} | {given} |" for name, given in further.items()),
        ]
    )


def command(results: Results, settings: Mapping[str, object]) -> str:
    """The command that makes the study again."""
    if "command" in settings:
        return str(settings["command"])
    known, own = [], []
    for teacher in results.teachers:
        standard = TEACHERS.get(teacher.name)
        if standard is not None and replace(standard, beta=teacher.beta) == teacher:
            known.append(teacher.name)
        else:
            numbers = ",".join(f"{given:g}" for given in true_parameters(teacher))
            own.append(f"{teacher.name}={numbers}")
    words = ["studio", "learn"]
    if "outcomes" in settings:
        words += ["--outcomes", str(settings["outcomes"])]
    words += ["--teachers", ",".join(known)]
    for profile in own:
        words += ["--profile", profile]
    betas = {teacher.beta for teacher in results.teachers}
    if betas != {BETA}:
        words += ["--beta", f"{max(betas):g}"]
    words += ["--learners", ",".join(results.learners)]
    words += ["--pairs", ",".join(str(pairs) for pairs in results.sizes)]
    words += ["--seeds", str(results.seeds)]
    return shlex.join(words)


def _families_explained(results: Results, teacher: Teacher) -> list[str]:
    if not results.scenes:
        return []
    return [
        f"* [Families]({_target(teacher, FAMILIES)}): the same regret by kind of scene. A dot is a "
        "scene that was held out, those without regret in a box at the left; the large dot is the "
        "mean of the family over seeds, the line its 95 % interval. All are in % of what a random "
        "action costs in the family, on average over its scenes. Ringed and numbered are the "
        f"scenes that [the page beside](recording://{entities.SCENES}) tells of, with links to "
        "their own recordings."
    ]


def _final_row(results: Results, teacher: Teacher, learner: str, pairs: int) -> str:
    curve = results.curve("regret_percent", teacher, learner)
    at = _place(curve, pairs)
    if curve is None or at is None:
        return ""
    cells = [
        _link(teacher, REGRET.name, teacher_name(teacher.name)),
        learner_name(learner),
        _cell(results, teacher, learner, "regret_percent", pairs, 1.0, ".2f"),
        f"{curve.low[at]:.2f} to {curve.high[at]:.2f}" if curve.runs[at] > 1 else "–",
        _cell(results, teacher, learner, "agreement", pairs, 100.0, ".0f") + " %",
        _cell(results, teacher, learner, "theta_cosine", pairs, 1.0, ".3f"),
    ]
    return f"| {' | '.join(cells)} |"


def _lessons(results: Results, pairs: int) -> list[str]:
    """Which learner has the least regret, and how sure that is, in a sentence a teacher."""
    lines = []
    for teacher in results.teachers:
        regrets: dict[str, float] = {}
        for learner in results.learners:
            curve = results.curve("regret_percent", teacher, learner)
            at = _place(curve, pairs)
            if curve is not None and at is not None:
                regrets[learner] = float(curve.mean[at])
        ranked = sorted(regrets, key=regrets.__getitem__)
        if len(ranked) > 1:
            told = _compared(results, teacher, ranked[0], ranked[-1], pairs)
            lines.append(f"* **{teacher_name(teacher.name)} teacher**: {told}")
    return lines


def _compared(results: Results, teacher: Teacher, best: str, worst: str, pairs: int) -> str:
    """How much less regret one learner has than another, paired by seed."""
    names = (
        f"The {learner_name(best)} learner has less regret than the {learner_name(worst)} learner"
    )
    for comparison in paired_differences(results.table, best, worst):
        if comparison.teacher == teacher.name and pairs in comparison.pairs:
            at = int(np.flatnonzero(comparison.pairs == pairs)[0])
            less, low, high = (
                number(-side[at] + 0.0, ".2f")
                for side in (comparison.difference, comparison.high, comparison.low)
            )
            if comparison.runs[at] == 1:
                return f"{names} in the one seed, by {less} percentage points."
            interval = f"{less} percentage points (95 %: {low} to {high})"
            if comparison.high[at] < 0.0:
                return f"{names}, by {interval}."
            return f"{names} in the mean, though not for sure: {interval}."
    return f"{names} in the mean."


def _certainty_row(results: Results, teacher: Teacher) -> str:
    cells = []
    for pairs in results.sizes:
        certainty = [
            given
            for learner in results.learners
            for given in results.runs(teacher, learner, pairs)["certainty"]
        ]
        cells.append(f"{np.mean(certainty):.2f}" if certainty else "")
    return f"| {teacher_name(teacher.name)} | {' | '.join(cells)} |"


def _cell(
    results: Results,
    teacher: Teacher,
    learner: str,
    column: str,
    pairs: int,
    factor: float,
    form: str,
) -> str:
    """Mean ± standard deviation; the mean alone where there is a single seed."""
    curve = results.curve(column, teacher, learner)
    at = _place(curve, pairs)
    if curve is None or at is None:
        return "–"
    mean = number(factor * curve.mean[at], form)
    return f"{mean} ± {factor * curve.std[at]:{form}}" if curve.runs[at] > 1 else mean


def _place(curve: Curve | None, pairs: int) -> int | None:
    if curve is None or pairs not in curve.pairs:
        return None
    return int(np.flatnonzero(curve.pairs == pairs)[0])


def _flat(told: object) -> str:
    if not isinstance(told, dict):
        return json.dumps(told)
    return ", ".join(f"{name} {given}" for name, given in told.items() if name != "name") or "–"


def _target(teacher: Teacher, figure: str) -> str:
    # Markdown ends a link at a space unless it is in angle brackets, and eats backslashes
    path = entities.figure(teacher.name, figure).replace("\\", "\\\\")
    return f"<recording://{path}>"


def _link(teacher: Teacher, figure: str, words: str) -> str:
    return f"[{words}]({_target(teacher, figure)})"
