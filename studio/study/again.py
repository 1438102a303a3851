"""The command line that makes a study again."""

import shlex
from collections.abc import Mapping
from dataclasses import replace

from learners import BETA, TEACHERS
from studio.study.results import StudyResults


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
