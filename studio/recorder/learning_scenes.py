"""The page of a recording of a study that says in which scenes the learners differ most."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import rerun as rr

from learners import Teacher
from studio.naming import counted, learner_name, teacher_name
from studio.recorder import learning_entities as entities
from studio.recorder.learning_results import Results


@dataclass(frozen=True)
class SceneLink:
    """The recording of a scene of a study.

    Attributes:
        name: what the scene is called there.
        path: where the recording is, from the folder of the study's own recording.
        commands: the command lines that make it again in that folder; none if only a study does.
    """

    name: str
    path: str
    commands: tuple[str, ...]


Links = Mapping[int, SceneLink]
"""Recordings by the scene's id in the bank."""


def log_scenes(stream: rr.RecordingStream, results: Results, links: Links) -> None:
    """Add the page of scenes, which changes with the number of pairs."""
    for pairs in results.sizes:
        stream.set_time(entities.TIMELINE, sequence=pairs)
        page = scenes_page(results, links, pairs)
        stream.log(entities.SCENES, rr.TextDocument(page, media_type=rr.MediaType.MARKDOWN))
    stream.reset_time()


def scenes_page(results: Results, links: Links, pairs: int) -> str:
    """The scenes in which learners differ most, with links to the recordings there are."""
    several = len(results.learners) > 1
    chosen = (
        "in which the learners' regrets differ most (or else are largest)"
        if several
        else "of the largest regret"
    )
    return "\n".join(
        [
            f"# Regret by scene after {counted(pairs, 'pair')}",
            "",
            "A dot is a scene that was held out, its place the regret there in % of what a random "
            "action costs in its family, on average; scenes without regret are in the boxes. The "
            "large dot is the mean of the family over seeds, the line its 95 % interval. Ringed "
            f"are the scenes below, those {chosen} after {counted(results.sizes[-1], 'pair')}. "
            + ("The name of a scene opens its recording." if links else ""),
            "",
            *(
                line
                for teacher in results.teachers
                for line in _teacher(results, links, teacher, pairs)
            ),
            "Regret in units of value, and in % of what a random action would cost in that scene: "
            "the mean over the seeds that held the scene out. A pick is that of most of these "
            "seeds.",
            "",
            *_recordings(links),
        ]
    )


def _teacher(results: Results, links: Links, teacher: Teacher, pairs: int) -> list[str]:
    """The table of one teacher's scenes."""
    scenes = results.telling[teacher.name]
    lines = [f"## {teacher_name(teacher.name)} teacher", ""]
    if not scenes:
        return [*lines, "No learner has regret in any scene.", ""]
    seeds = counted(results.seeds, "seed")
    lines += ["| scene | who | picks | regret | of random |", "|:--|:--|:--|--:|--:|"]
    for scene in scenes:
        told, link = results.scenes[scene], links.get(scene)
        name = f"[{link.name} ↗](<{link.path}>)" if link else f"{told.family}, {scene}"
        rows = [
            f"the teacher | {told.best[teacher.name]} | 0 |  |",
            *(_row(results, teacher, learner, scene, pairs) for learner in results.learners),
        ]
        marks = [name, told.pattern, f"{_runs(results, teacher, scene)} of {seeds}"]
        marks += [""] * (len(rows) - len(marks))
        rows += [" |  |  |  |"] * (len(marks) - len(rows))
        lines += [f"| {mark} | {row}" for mark, row in zip(marks, rows, strict=True)]
    return [*lines, ""]


def _row(results: Results, teacher: Teacher, learner: str, scene: int, pairs: int) -> str:
    """What a learner picks in a scene, and the regret."""
    name = f"{learner_name(learner)} learner"
    regrets = results.scene_regrets(teacher, learner, pairs)
    if regrets is None or scene not in regrets.scenes:
        return f"{name} | – | – | – |"
    at = int(np.flatnonzero(regrets.scenes == scene)[0])
    regret = float(regrets.regret[at])
    cost = results.scenes[scene].random_regret[teacher.name]
    if regret <= 0.0:
        return f"{name} | {regrets.picks[at]} | 0 |  |"
    return f"{name} | {regrets.picks[at]} | {regret:.3f} | {100.0 * regret / cost:.0f} % |"


def _runs(results: Results, teacher: Teacher, scene: int) -> int:
    """How many seeds held a scene out."""
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
        "They show all futures of a scene under every action, and what the teachers make of them. "
        "The arrow at the top of the viewer leads back here.",
        "",
        "Links start from this recording's folder, where `studio view` opens the viewer. If a "
        "link is dead, open this recording by `studio view`, or make the scene's again in that "
        "folder" + (":" if commands else " by `studio learn`."),
        "",
        *(["```sh", *commands, "```"] if commands else []),
    ]
