"""Tables of what a study found, row by row, to be looked at beside the table of its fits."""

from collections.abc import Iterator

from studio.study.fits import Row
from studio.study.results import StudyResults


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
            for place, number in enumerate(regrets.scenes.tolist()):
                scene = results.scenes[number]
                percents = results.percents(teacher, scene.family, regrets.regret[place])
                yield {
                    "teacher": teacher.name,
                    "learner": learner,
                    "scene": number,
                    "family": scene.family,
                    "pattern": scene.pattern,
                    "teacher_picks": scene.best[teacher.name],
                    "learner_picks": regrets.picks[place],
                    "seeds": int(regrets.runs[place]),
                    "regret_percent": float(percents),
                }
