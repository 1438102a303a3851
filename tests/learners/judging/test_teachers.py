from dataclasses import replace

import numpy as np
import pytest

from learners import PROFILES, REWARD, TEACHERS, InputError, Teacher, find_teachers, prospect_value

TK = TEACHERS["tk"]


def test_the_three_of_the_study():
    assert list(TEACHERS) == ["eu", "tk", "strong"]
    for name, teacher in TEACHERS.items():
        assert teacher == Teacher(name, PROFILES[name], REWARD, beta=20.0)


def test_values_are_those_of_prospect_theory(prospects):
    teacher = replace(TK, reference=0.1, weighting="tversky-kahneman")
    expected = prospect_value(
        prospects.features @ np.array(REWARD),
        PROFILES["tk"],
        reference=0.1,
        weighting="tversky-kahneman",
    )
    assert np.array_equal(teacher.values(prospects.features), expected)


def test_find_by_name():
    assert find_teachers(["strong", "eu"]) == (TEACHERS["strong"], TEACHERS["eu"])
    with pytest.raises(InputError, match=r"^teacher 'me' is not allowed: eu, tk, strong$"):
        find_teachers(["eu", "me"])


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"beta": 0.0}, "beta 0.0 is not allowed: a finite number above 0"),
        ({"beta": float("nan")}, "beta nan is not allowed: a finite number above 0"),
        ({"reward": (1.0, float("inf"))}, "reward contains inf: only finite numbers are allowed"),
        ({"reference": float("nan")}, "reference contains nan: only finite numbers are allowed"),
        ({"weighting": "linear"}, "weighting 'linear' is not allowed: prelec or tversky-kahneman"),
        ({"name": ""}, "teacher '' is not allowed: a name"),
    ],
)
def test_what_makes_no_sense_is_refused(change, message):
    with pytest.raises(InputError) as refusal:
        replace(TK, **change)
    assert str(refusal.value) == message


def test_weighting_that_is_not_monotone_is_refused():
    people = replace(PROFILES["tk"], gamma=0.25)
    Teacher("me", people)
    with pytest.raises(InputError, match=r"gamma 0.25 is not allowed with the tversky-kahneman"):
        Teacher("me", people, weighting="tversky-kahneman")


def test_reward_of_the_wrong_length_is_refused(prospects):
    with pytest.raises(InputError, match="reward of 2 numbers is not allowed: 5"):
        replace(TK, reward=(1.0, 2.0)).values(prospects.features)
