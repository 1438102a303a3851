"""The mind: what people make of prospects, and what can be learned from their choices."""

from learners.cpt import CptLearner
from learners.curves import Comparison, Curve, compare_learners, learning_curves
from learners.errors import InputError
from learners.eu import EuLearner
from learners.evaluation import Calibration, Evaluation, evaluate
from learners.fits import Fit, Learner, Problem, fit_many, unit_vector
from learners.parameters import PROFILES, REWARD, CptLike, CptParameters
from learners.precision import Precision, attainable_precision
from learners.preference_table import read_preferences
from learners.preferences import Pairs, Preferences, all_pairs, ask, sample_pairs
from learners.prospects import FEATURES, Prospects, read_bank
from learners.registry import LEARNERS, find_learners
from learners.regrets import (
    SceneRegrets,
    StudyScene,
    family_curves,
    family_table,
    scene_regrets,
    study_scenes,
    telling_scenes,
)
from learners.split import Split, split_scenes
from learners.study import (
    STUDY_SCHEMA,
    Study,
    Task,
    missing_tasks,
    run_study,
    study_batches,
    study_tasks,
    whole_table,
)
from learners.teachers import BETA, TEACHERS, Teacher, find_teachers
from learners.values import decision_weights, expected_utility, prospect_value, value
from learners.weighting import Weighting, weight

__all__ = [
    "BETA",
    "FEATURES",
    "LEARNERS",
    "PROFILES",
    "REWARD",
    "STUDY_SCHEMA",
    "TEACHERS",
    "Calibration",
    "Comparison",
    "CptLearner",
    "CptLike",
    "CptParameters",
    "Curve",
    "EuLearner",
    "Evaluation",
    "Fit",
    "InputError",
    "Learner",
    "Pairs",
    "Precision",
    "Preferences",
    "Problem",
    "Prospects",
    "SceneRegrets",
    "Split",
    "Study",
    "StudyScene",
    "Task",
    "Teacher",
    "Weighting",
    "all_pairs",
    "ask",
    "attainable_precision",
    "compare_learners",
    "decision_weights",
    "evaluate",
    "expected_utility",
    "family_curves",
    "family_table",
    "find_learners",
    "find_teachers",
    "fit_many",
    "learning_curves",
    "missing_tasks",
    "prospect_value",
    "read_bank",
    "read_preferences",
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
