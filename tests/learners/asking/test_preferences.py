from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from learners import TEACHERS, InputError, Pairs, all_pairs, ask, sample_pairs

EU, TK, STRONG = TEACHERS.values()
ALL = 24 * 6


def keys(pairs):
    low, high = np.minimum(pairs.first, pairs.second), np.maximum(pairs.first, pairs.second)
    return list(zip(pairs.scenes.tolist(), low.tolist(), high.tolist(), strict=True))


def test_all_pairs_are_each_once(prospects):
    there = all_pairs(24, 4)
    assert len(set(keys(there))) == len(there.scenes) == ALL


@settings(deadline=None, derandomize=True, max_examples=30)
@given(st.integers(1, 3 * ALL), st.integers(0, 4))
def test_no_pair_comes_again_before_all_have_come(make, count, seed):
    pairs = sample_pairs(make(), count, seed)
    assert (pairs.first != pairs.second).all()
    asked = keys(pairs)
    for start in range(0, count, ALL):
        assert len(set(asked[start : start + ALL])) == len(asked[start : start + ALL])
    assert pairs.repeated == max(0, count - ALL) == count - len(set(asked))


@pytest.mark.parametrize("longer", [60, 400])
def test_longer_series_begins_with_the_shorter(prospects, longer):
    short, long = (sample_pairs(prospects, count, 1) for count in (50, longer))
    answers, more = (ask(TK, prospects, pairs, 1) for pairs in (short, long))
    for field in ("scenes", "first", "second"):
        assert np.array_equal(getattr(short, field), getattr(long, field)[:50])
    for field in ("scenes", "preferred", "other"):
        assert np.array_equal(getattr(answers, field), getattr(more, field)[:50])


def test_only_the_scenes_asked_about(prospects):
    places = np.array([2, 5, 11])
    pairs = sample_pairs(prospects, 40, 0, places)
    assert set(pairs.scenes.tolist()) == {2, 5, 11}
    assert pairs.repeated == 40 - 3 * 6


def test_sides_are_even(prospects):
    pairs = sample_pairs(prospects, 1000, 0)
    assert 0.4 < (pairs.first < pairs.second).mean() < 0.6


def test_seeds_differ(prospects):
    one, other = (sample_pairs(prospects, 50, seed) for seed in (0, 1))
    assert keys(one) != keys(other)
    assert not np.array_equal(
        ask(EU, prospects, one, 0).preferred, ask(EU, prospects, one, 1).preferred
    )


def test_answers_come_as_often_as_bradley_and_terry_say(prospects):
    count = 4000
    pair = Pairs(*(np.full(count, place) for place in (3, 0, 2)))
    values = STRONG.values(prospects.features)
    expected = 1.0 / (1.0 + np.exp(-20.0 * (values[3, 0] - values[3, 2])))
    answers = ask(STRONG, prospects, pair, 0)
    assert (answers.preferred == 0).mean() == pytest.approx(expected, abs=0.03)
    assert answers.certainty == pytest.approx(max(expected, 1.0 - expected))


def test_a_decided_teacher_is_certain_and_right(prospects):
    pairs = sample_pairs(prospects, 100, 0)
    answers = ask(replace(TK, beta=1e9), prospects, pairs, 0)
    values = TK.values(prospects.features)
    assert (values[pairs.scenes, answers.preferred] >= values[pairs.scenes, answers.other]).all()
    assert answers.certainty == 1.0
    assert ask(replace(TK, beta=1e-9), prospects, pairs, 0).certainty == pytest.approx(0.5)


@pytest.mark.parametrize("count", [0, -3])
def test_no_pairs_are_refused(prospects, count):
    with pytest.raises(InputError, match=f"pairs {count} is not allowed: 1 or more"):
        sample_pairs(prospects, count, 0)
