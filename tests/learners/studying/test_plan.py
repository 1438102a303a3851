from dataclasses import replace

import pytest

from learners import TEACHERS, InputError, study_tasks


def test_tasks_are_ordered_by_pairs_teacher_learner_and_seed(study):
    tasks = study_tasks(study)
    assert len(tasks) == len(set(tasks)) == 16
    assert tasks[0] == (10, "eu", "eu", 0)
    assert tasks[1] == (10, "eu", "eu", 1)
    assert tasks[2] == (10, "eu", "cpt", 0)
    assert tasks[4] == (10, "strong", "eu", 0)
    assert tasks[8] == (40, "eu", "eu", 0)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"sizes": (10, 0)}, "pairs 0 is not allowed: 1 or more"),
        ({"sizes": ()}, "pairs: none is given: one or more is needed"),
        ({"sizes": (10, 10)}, r"pairs: \[10, 10\] is not allowed: each once"),
        ({"seeds": 0}, "seeds 0 is not allowed: 1 or more"),
        ({"teachers": ["eu", "eu"]}, "is not allowed: each once"),
        ({"teachers": ["you"]}, "teacher 'you' is not allowed: eu, tk, strong"),
        ({"learners": ["deep"]}, "learner 'deep' is not allowed: eu, cpt"),
        ({"learners": []}, "learners: none is given"),
        ({"held_out": 1.5}, "held_out 1.5 is not allowed: between 0 and 1"),
        ({"teachers": [replace(TEACHERS["eu"], reward=(1.0,))]}, "reward of 1 numbers"),
    ],
)
def test_what_cannot_be_studied(prospects, plan, small, change, message):
    with pytest.raises(InputError, match=message):
        plan(prospects, **small | change)


def test_too_few_scenes(make, plan, small):
    with pytest.raises(InputError, match="scenes: family corridor has 1"):
        plan(make(scenes=3), **small)
