"""Studies of every kind, for tests of pictures and films."""

from learners import PARAMETER_COLUMNS, PROFILES, TEACHERS, Teacher
from studio.study.results import StudyResults
from tests.studio.study.tables import THREE, study_of, study_table

NOTHING = StudyResults(study_table().slice(0, 0), THREE)


OWN = tuple(
    Teacher(f"a-teacher-of-my-own-with-a-long-name-{index}", PROFILES["tk"], reward=(0.3,) * 8)
    for index in range(6)
)
EVERYBODY = ("eu", "cpt", "cpt-tied", "cpt-reference", "cpt-tied-reference", "a-learner-of-my-own")

CASES = {
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

FOUR = (*THREE, Teacher("grandmother", PROFILES["tk"]))
