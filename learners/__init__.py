"""The mind: what people make of prospects, and what can be learned from their choices."""

from learners.errors import InputError
from learners.parameters import PROFILES, REWARD, CptLike, CptParameters
from learners.values import decision_weights, expected_utility, prospect_value, value
from learners.weighting import Weighting, weight

__all__ = [
    "PROFILES",
    "REWARD",
    "CptLike",
    "CptParameters",
    "InputError",
    "Weighting",
    "decision_weights",
    "expected_utility",
    "prospect_value",
    "value",
    "weight",
]
