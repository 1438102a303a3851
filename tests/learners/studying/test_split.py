from collections import Counter
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from learners import InputError, Prospects, split_scenes


def scenes_of(families):
    count = len(families)
    return Prospects(
        np.zeros((count, 2, 1, 5)),
        np.arange(count),
        tuple(families),
        ("mixed",) * count,
        ("a", "b"),
    )


@settings(deadline=None, derandomize=True)
@given(
    st.lists(st.sampled_from("xyz"), min_size=2, max_size=40).filter(
        lambda families: min(Counter(families).values()) > 1
    ),
    st.integers(0, 5),
    st.floats(0.05, 0.95),
)
def test_every_scene_is_on_one_side_and_every_family_on_both(families, seed, share):
    split = split_scenes(scenes_of(families), seed, share)
    both = np.concatenate([split.training, split.held_out])
    assert sorted(both.tolist()) == list(range(len(families)))
    for name, count in Counter(families).items():
        kept_back = sum(families[place] == name for place in split.held_out)
        assert 1 <= kept_back < count
        wanted = min(max(share * count, 1.0), count - 1.0)
        assert abs(kept_back - wanted) <= 0.5 + 1e-9


def test_default_keeps_back_a_third():
    split = split_scenes(scenes_of("wxyz" * 75), 0)
    assert (len(split.training), len(split.held_out)) == (200, 100)


def test_seed_decides():
    there = scenes_of("xy" * 30)
    assert np.array_equal(split_scenes(there, 3).held_out, split_scenes(there, 3).held_out)
    assert not np.array_equal(split_scenes(there, 3).held_out, split_scenes(there, 4).held_out)


def test_too_few_scenes_are_refused(prospects):
    with pytest.raises(InputError) as refusal:
        split_scenes(replace(prospects, families=("alone", *prospects.families[1:])), 0)
    assert str(refusal.value).startswith("scenes: family alone has 1: two or more")


@pytest.mark.parametrize("share", [0.0, 1.0, -1.0, float("nan")])
def test_share_out_of_range(prospects, share):
    with pytest.raises(InputError, match=f"held_out {share} is not allowed"):
        split_scenes(prospects, 0, share)


def test_negative_seed(prospects):
    with pytest.raises(InputError, match="seed -1 is not allowed: 0 or more"):
        split_scenes(prospects, -1)
