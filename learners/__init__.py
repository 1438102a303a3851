"""The mind: what people make of prospects, and what can be learned from their choices."""

from learners.asking.preference_table import read_preferences
from learners.asking.preferences import Pairs, Preferences, all_pairs, ask, sample_pairs
from learners.asking.prospects import FEATURES, Prospects, read_bank
from learners.errors import InputError
from learners.fitting.cpt import CptLearner
from learners.fitting.eu import EuLearner
from learners.fitting.fits import Fit, Learner, Problem, fit_many, unit_vector
from learners.fitting.precision import Precision, attainable_precision
from learners.fitting.registry import LEARNERS, find_learners
from learners.judging.parameters import PROFILES, REWARD, CptLike, CptParameters
from learners.judging.sampling import expected_sample_value, resampled_values
from learners.judging.teachers import BETA, TEACHERS, Teacher, find_teachers
from learners.judging.values import decision_weights, expected_utility, prospect_value, value
from learners.judging.weighting import Weighting, weight
from learners.studying.curves import (
    Curve,
    Difference,
    PairedDifference,
    Spread,
    learning_curves,
    paired_differences,
)
from learners.studying.evaluation import Calibration, Evaluation, evaluate
from learners.studying.plan import Study, StudyScene, Task, study_tasks
from learners.studying.regrets import (
    SceneRegrets,
    family_curves,
    family_table,
    scene_regrets,
    telling_scenes,
)
from learners.studying.split import Split, split_scenes
from learners.studying.study import run_study, study_batches
from learners.studying.table import (
    PARAMETER_COLUMNS,
    STUDY_SCHEMA,
    missing_tasks,
    study_scenes,
    whole_table,
)

__all__ = [
    "BETA",
    "FEATURES",
    "LEARNERS",
    "PARAMETER_COLUMNS",
    "PROFILES",
    "REWARD",
    "STUDY_SCHEMA",
    "TEACHERS",
    "Calibration",
    "CptLearner",
    "CptLike",
    "CptParameters",
    "Curve",
    "Difference",
    "EuLearner",
    "Evaluation",
    "Fit",
    "InputError",
    "Learner",
    "PairedDifference",
    "Pairs",
    "Precision",
    "Preferences",
    "Problem",
    "Prospects",
    "SceneRegrets",
    "Split",
    "Spread",
    "Study",
    "StudyScene",
    "Task",
    "Teacher",
    "Weighting",
    "all_pairs",
    "ask",
    "attainable_precision",
    "decision_weights",
    "evaluate",
    "expected_sample_value",
    "expected_utility",
    "family_curves",
    "family_table",
    "find_learners",
    "find_teachers",
    "fit_many",
    "learning_curves",
    "missing_tasks",
    "paired_differences",
    "prospect_value",
    "read_bank",
    "read_preferences",
    "resampled_values",
    "run_study",
    "sample_pairs",
    "scene_regrets",
    "split_scenes",
    "study_batches",
    "study_scenes",
    "study_tasks",
    "telling_scenes",
    "unit_vector",
    "value",
    "weight",
    "whole_table",
]
