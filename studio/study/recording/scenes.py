"""The page of a recording of a study that says in which scenes the learners differ most."""

from itertools import chain

import numpy as np

from learners import Teacher
from studio.recorder.markdown import table
from studio.study.links import Links
from studio.study.recording.families import LEAST_PERCENT, family_figure, scene_percents
from studio.study.results import StudyResults
from studio.study.words import learner_called, teacher_called
from studio.style.words import action_label, counted, number


def scenes_page(results: StudyResults, links: Links, pairs: int) -> str:
    """The scenes in which learners differ most, with links to the recordings there are."""
    chosen = "of the largest regret"
    if len(results.learners) > 1:
        chosen = "in which the learners' regrets differ most (or else are largest)"
    least = family_figure(results).scale.ticks[0]
    return "\n".join(
        [
            f"# Regret by scene after {counted(pairs, 'pair')}",
            "",
            "A dot is a scene that was held out, its place the regret there; scenes without regret "
            f"are in the boxes, and regrets below {number(least)} % at the left edge. The large "
            "dot is the mean of the family over seeds, the line its 95 % interval. Rings with "
            f"numbers, one a learner, are the scenes below: those {chosen} after "
            f"{counted(results.sizes[-1], 'pair')}. "
            + ("The name of a scene opens its recording." if links else ""),
            "",
            "All regrets, drawn and written, are in % of what a random action costs the teacher in "
            "scenes of that family, on average.",
            "",
            *chain(*(_teacher(results, links, teacher, pairs) for teacher in results.teachers)),
            "Regret is the mean over the seeds that held the scene out, so many as the tables say; "
            "a pick is that of most of these seeds.",
            "",
            *_recordings(links),
        ]
    )


def _teacher(results: StudyResults, links: Links, teacher: Teacher, pairs: int) -> list[str]:
    """The table of one teacher's scenes."""
    scenes = results.telling[teacher.name]
    title = [f"## {teacher_called(teacher)}", ""]
    if not scenes:
        return [*title, "No learner has regret in any scene.", ""]
    rows = []
    for place, scene in enumerate(scenes, start=1):
        told, link = results.scenes[scene], links.get(scene)
        name = f"[{link.name} ↗](<{link.path}>)" if link else f"{told.family}, {scene}"
        rows.append(
            [
                f"{place}: {name}",
                told.pattern,
                f"{_runs(results, teacher, scene)} of {results.seeds}",
                action_label(told.best[teacher.name]),
                *(_pick(results, teacher, learner, scene, pairs) for learner in results.learners),
            ]
        )
    heads = ["scene", "pattern", "seeds", "teacher", *map(learner_called, results.learners)]
    return [*title, *table(heads, "l" * len(heads), rows), ""]


def _pick(results: StudyResults, teacher: Teacher, learner: str, scene: int, pairs: int) -> str:
    """What a learner picks in a scene, and the regret."""
    regrets = results.scene_regrets(teacher, learner, pairs)
    if regrets is None or scene not in regrets.scenes:
        return "–"
    at = int(np.flatnonzero(regrets.scenes == scene)[0])
    pick = action_label(regrets.picks[at])
    percent = float(scene_percents(results, teacher, regrets)[at])
    if percent <= 0.0:
        return f"{pick}, 0 %"
    if percent < LEAST_PERCENT:
        return f"{pick}, < {number(LEAST_PERCENT)} %"
    return f"{pick}, {percent:.{0 if percent >= 10.0 else 1}f} %"


def _runs(results: StudyResults, teacher: Teacher, scene: int) -> int:
    """How many seeds kept a scene back for the test."""
    return max(
        int(each.runs[each.scenes == scene].sum())
        for learner in results.learners
        for pairs in results.sizes
        if (each := results.scene_regrets(teacher, learner, pairs)) is not None
    )


def _recordings(links: Links) -> list[str]:
    """What the links open, and what to do where they do not."""
    if not links:
        return [
            "These scenes have no recordings: the outcome bank does not say how to make them "
            "again, or was made by other versions."
        ]
    commands = [line for link in links.values() for line in link.commands]
    return [
        "## The recordings",
        "",
        "They show all rollouts of a scene under every action, and what the teachers make of them. "
        "The arrow at the top of the viewer leads back here.",
        "",
        "Links start from this recording's folder, where `studio view` opens the viewer. If a "
        "link is dead, open this recording by `studio view`, or make the scene's again in that "
        "folder" + (":" if commands else " by `studio learn`."),
        "",
        *(["```sh", *commands, "```"] if commands else []),
    ]
