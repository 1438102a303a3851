"""The pages of a recording of a study, in Markdown: what one sees, and how to make it again."""

from collections.abc import Mapping

from learners import FEATURES, CptParameters, Teacher
from studio.recorder.markdown import table
from studio.study.again import study_command
from studio.study.links import Links
from studio.study.results import StudyResults
from studio.study.rows import found_rows, last_rows, setting_rows, teacher_rows, telling_rows
from studio.study.words import learner_called, lesson, teacher_called
from studio.style.words import counted, teacher_name

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
    last, heads = results.sizes[-1], ["teacher", "learner", "regret, %", "middle half, %"]
    lessons = [(teacher, lesson(results, teacher)) for teacher in results.teachers]
    return "\n".join(
        [
            f"# What was learned from {counted(last, 'pair')}",
            "",
            *(f"* **{teacher_called(teacher)}**: {said}" for teacher, said in lessons if said),
            "",
            *table(heads, "llrr", last_rows(results)),
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
    for learner in results.learners:
        if results.fits_of(teacher, learner, pairs):
            rows = found_rows(results, teacher, learner, pairs)
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
    rows = telling_rows(results, links, teacher, pairs)
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
