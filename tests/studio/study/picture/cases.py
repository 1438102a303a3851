"""Studies of all kinds, for the tests of pictures and films."""

from collections.abc import Callable

from learners import PARAMETER_COLUMNS, PROFILES, TEACHERS, Teacher
from studio.study.results import StudyResults
from tests.studio.study.tables import THREE, study_of, study_table

NOTHING = StudyResults(study_table().slice(0, 0), THREE)

OWN = tuple(
    Teacher(f"a-teacher-of-my-own-with-a-long-name-{index}", PROFILES["tk"], reward=(0.3,) * 8)
    for index in range(6)
)
EVERYBODY = ("eu", "cpt", "cpt-tied", "cpt-reference", "cpt-tied-reference", "a-learner-of-my-own")

CASES: dict[str, Callable[[], StudyResults]] = {
    "default": study_of,
    "one of everything": lambda: study_of((TEACHERS["tk"],), sizes=(100,), seeds=1),
    "one teacher": lambda: study_of((TEACHERS["strong"],)),
    "only eu": lambda: study_of(learners=("eu",)),
    "only cpt": lambda: study_of(learners=("cpt",)),
    "many learners": lambda: study_of(learners=EVERYBODY),
    "own teachers": lambda: study_of(OWN[:4]),
    "more teachers than there is room for": lambda: study_of(OWN),
    "zero regret": lambda: study_of(regret=0.0, regret_percent=0.0),
    "huge regret": lambda: study_of(regret_percent=12345.6),
    "many sizes": lambda: study_of(sizes=tuple(range(100, 3100, 100)), seeds=1),
    "nothing fitted": lambda: NOTHING,
    "one teacher fitted": lambda: StudyResults(study_table((TEACHERS["eu"],)), THREE),
    "nothing converged": lambda: study_of(converged=False),
    "nothing known": lambda: study_of(
        **dict.fromkeys(PARAMETER_COLUMNS),
        certainty=None,
        converged=None,
        calibration_count=[],
        calibration_predicted=None,
        calibration_preferred=None,
    ),
}


def incomplete() -> StudyResults:
    """The last size is known of one learner of one teacher only; one teacher has none at all."""
    table = study_table(THREE[:2])
    rows = table.to_pylist()
    kept = [
        row["pairs"] < 2000 or (row["teacher"], row["learner"]) == ("tk", "cpt") for row in rows
    ]
    return StudyResults(table.filter(kept), THREE)


FOUR = (*THREE, Teacher("averse-to-losses", PROFILES["tk"], reward=TEACHERS["tk"].reward))
"""As many teachers as a page has room for."""


def four_by_three() -> StudyResults:
    """A study of four teachers and three learners of seven sizes and five seeds."""
    sizes = (25, 50, 100, 200, 500, 1000, 2000)
    return study_of(FOUR, learners=("eu", "cpt", "cpt-tied"), sizes=sizes, seeds=5)


FILMED: dict[str, Callable[[], StudyResults]] = {
    "default": study_of,
    "one size": lambda: study_of(sizes=(100,), seeds=1),
    "one teacher": lambda: study_of((TEACHERS["tk"],)),
    "six teachers": lambda: study_of(OWN),
    "only eu": lambda: study_of(learners=("eu",)),
    "zero regret": lambda: study_of(regret=0.0, regret_percent=0.0),
    "incomplete": incomplete,
}
