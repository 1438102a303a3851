"""Tables of a study, row by row, to be looked at beside the table of its fits."""

from collections.abc import Iterator, Mapping

import numpy as np

from studio.study.fits import Row
from studio.study.results import StudyResults
from studio.style.words import learner_name, number, teacher_name


def learner_rows(results: StudyResults) -> Iterator[Row]:
    """A row a teacher, learner and number of pairs: means, and the ends of their intervals."""
    for curve in results.curves("regret_percent"):
        for place, pairs in enumerate(curve.pairs.tolist()):
            row: Row = {"teacher": curve.teacher, "learner": curve.learner, "pairs": pairs}
            for name, side in (("", "mean"), ("_low", "low"), ("_high", "high")):
                row[f"regret_percent{name}"] = float(getattr(curve, side)[place])
                row[f"middle{name}"] = float(getattr(curve, f"middle{name}")[place])
                for other in results.curves("agreement"):
                    if (other.teacher, other.learner) == (curve.teacher, curve.learner):
                        row[f"agreement{name}"] = float(getattr(other.at(pairs), side))
            yield row


def scene_rows(results: StudyResults) -> Iterator[Row]:
    """A row a teacher, learner and held-out scene, after the most pairs."""
    for teacher in results.teachers:
        for learner in results.learners:
            regrets = results.scene_regrets(teacher, learner, results.sizes[-1])
            if regrets is None or not results.scenes:
                continue
            for place, scene_id in enumerate(regrets.scenes.tolist()):
                scene = results.scenes[scene_id]
                percents = results.percents(teacher, scene.family, regrets.regret[place])
                yield {
                    "teacher": teacher.name,
                    "learner": learner,
                    "scene": scene_id,
                    "family": scene.family,
                    "pattern": scene.pattern,
                    "teacher_picks": scene.best[teacher.name],
                    "learner_picks": regrets.picks[place],
                    "seeds": int(regrets.runs[place]),
                    "regret_percent": float(percents),
                }


def teacher_rows(results: StudyResults) -> list[list[str]]:
    """A row a teacher, in words: name, parameters, β, r, w, θ, and how certain the answers were."""
    rows = []
    for teacher in results.teachers:
        fits = [fit for fit in results.fits if fit["teacher"] == teacher.name]
        known = [fit["certainty"] for fit in fits if fit["certainty"] is not None]
        numbers = (*teacher.parameters.numbers, teacher.beta, teacher.reference)
        reward, certainty = ", ".join(map(number, teacher.reward)), "–"
        if known:
            certainty = f"{np.mean(known):.2f}"
        name = teacher_name(teacher.name)
        rows.append([name, *map(number, numbers), teacher.weighting, reward, certainty])
    return rows


def setting_rows(
    results: StudyResults, settings: Mapping[str, object], versions: Mapping[str, str]
) -> list[list[str]]:
    """Everything else that a study depends on, in words: a row a setting."""
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
