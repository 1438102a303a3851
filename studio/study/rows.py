"""Tables of a study, row by row, to be looked at beside the table of its fits."""

from collections.abc import Iterator, Mapping

import numpy as np

from learners import FEATURES, PARAMETER_COLUMNS, CptParameters, Spread, Teacher, unit_vector
from studio.study.fits import Row
from studio.study.links import Links
from studio.study.results import StudyResults
from studio.style.words import action_label, learner_name, number, teacher_name

LEAST_PERCENT = 0.1
"""Regrets of scenes that are smaller, in % of a random action's, are told as less than this."""


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


def last_rows(results: StudyResults) -> list[list[str]]:
    """A row a teacher and learner, in words: mean and interquartile mean of the final regret, %."""
    rows = []
    for teacher in results.teachers:
        for learner in results.learners:
            spread = results.spread("regret_percent", teacher, learner, results.sizes[-1])
            if spread is not None:
                middle = _told(".2f", spread.middle, spread.middle_low, spread.middle_high)
                names = [teacher_name(teacher.name), learner_name(learner)]
                rows.append([*names, _mean_told(".2f", spread), middle])
    return rows


def found_rows(
    results: StudyResults, teacher: Teacher, learner: str, pairs: int
) -> list[list[str]]:
    """What a learner found from so many pairs, in words: a row a number, the truth beside it."""

    def spread(column: str) -> Spread | None:
        return results.spread(column, teacher, learner, pairs)

    least, theta = spread("nll_teacher"), spread("theta_unit")
    shapes = zip(CptParameters.SYMBOLS, PARAMETER_COLUMNS, teacher.parameters.numbers, strict=True)
    rows = [
        [words, truth, _mean_told(form, spread(column), factor)]
        for words, column, truth, form, factor in (
            ("regret, %", "regret_percent", "0", ".2f", 1.0),
            ("best action found, %", "agreement", "100", ".0f", 100.0),
            ("cosine of θ", "theta_cosine", "1", ".3f", 1.0),
            ("log-loss, nats a pair", "nll", f"{least.mean:.3f}" if least else "–", ".3f", 1.0),
        )
    ]
    if theta is not None:
        rows += [
            [f"θ of {FEATURES[place]}", number(truth, ".2f"), _mean_told(".2f", theta.of(place))]
            for place, truth in enumerate(unit_vector(teacher.reward))
        ]
    rows += [
        [symbol, number(truth), _mean_told(".2f", found)]
        for symbol, column, truth in shapes
        if (found := spread(column))
    ]
    return rows


def _mean_told(form: str, spread: Spread | None, factor: float = 1.0) -> str:
    """A mean over seeds times a factor, with its interval."""
    if spread is None:
        return "–"
    return _told(form, factor * spread.mean, factor * spread.low, factor * spread.high)


def _told(form: str, value: float, low: float, high: float) -> str:
    """An estimate with its interval; the interval of a single seed is empty, and is not told."""
    told = number(value, form)
    return told if low == high else f"{told} [{number(low, form)}, {number(high, form)}]"


def telling_rows(
    results: StudyResults, links: Links, teacher: Teacher, pairs: int
) -> list[list[str]]:
    """A row a scene in which the learners differ most: a link, the teacher's pick, and theirs."""
    rows = []
    for scene in results.telling[teacher.name]:
        told, link = results.scenes[scene], links.get(scene)
        name = f"{told.family} {scene}"
        name = f"[{name} ↗](<{link.path}>)" if link else name
        picks = [_pick(results, teacher, learner, scene, pairs) for learner in results.learners]
        rows.append([name, action_label(told.best[teacher.name]), *picks])
    return rows


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
