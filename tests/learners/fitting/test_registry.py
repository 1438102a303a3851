import pytest

from learners import CptLearner, EuLearner, InputError, find_learners


def test_find_by_name():
    assert find_learners(["cpt-tied", "eu"]) == (CptLearner(tied=True), EuLearner())
    assert [CptLearner(learns_reference=True).name] == ["cpt-reference"]
    with pytest.raises(InputError, match=r"^learner 'me' is not allowed: eu, cpt, cpt-tied, "):
        find_learners(["me"])
