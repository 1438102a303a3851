from dataclasses import replace

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from learners import FEATURES, InputError, Prospects, read_bank

SCENES, ACTIONS, OUTCOMES = 3, 2, 4


def columns():
    rows = SCENES * ACTIONS * OUTCOMES
    there = {
        "scene": np.repeat([7, 8, 12], ACTIONS * OUTCOMES),
        "family": np.repeat(["open", "doorway", "open"], ACTIONS * OUTCOMES),
        "pattern": ["mixed"] * rows,
        "action": np.tile(np.repeat(["stop", "forward"], OUTCOMES), SCENES),
        "rollout": np.tile(np.arange(OUTCOMES), SCENES * ACTIONS),
    }
    for place, name in enumerate(FEATURES):
        there[name] = np.arange(rows) + 1000.0 * place
    return there


@pytest.fixture
def write(tmp_path):
    def write(there):
        path = tmp_path / "bank.parquet"
        pq.write_table(pa.table(there), path)
        return path

    return write


def refusal(path):
    with pytest.raises(InputError) as refused:
        read_bank(path)
    message = str(refused.value)
    assert "\n" not in message
    assert message.startswith("outcomes: ")
    return message


class TestReadBank:
    def test_axes_are_scene_action_rollout_feature(self, write):
        bank = read_bank(write(columns()))
        assert bank.features.shape == (SCENES, ACTIONS, OUTCOMES, len(FEATURES))
        assert bank.features[2, 1, 3].tolist() == [23.0, 1023.0, 2023.0, 3023.0, 4023.0]
        assert bank.scenes.tolist() == [7, 8, 12]
        assert bank.families == ("open", "doorway", "open")
        assert bank.patterns == ("mixed",) * 3
        assert bank.actions == ("stop", "forward")

    def test_order_of_rows_does_not_matter_but_for_the_names_of_actions(self, write):
        there = columns()
        order = np.concatenate([[0], 1 + np.random.default_rng(0).permutation(23)])
        shuffled = read_bank(write({k: np.array(v)[order] for k, v in there.items()}))
        straight = read_bank(write(there))
        swap = [shuffled.actions.index(name) for name in straight.actions]
        assert np.array_equal(shuffled.features[:, swap], straight.features)
        assert shuffled.families == straight.families

    @pytest.mark.parametrize("name", ["scene", "family", "action", "rollout", "collisions"])
    def test_missing_column(self, write, name):
        there = columns()
        del there[name]
        assert f"column {name} is missing" in refusal(write(there))

    @pytest.mark.parametrize("wrong", [np.nan, np.inf])
    def test_not_finite(self, write, wrong):
        there = columns()
        there["progress"][5] = wrong
        assert f"column progress contains {wrong} in row 5" in refusal(write(there))

    def test_empty_cell(self, write):
        there = columns()
        there["action"] = pa.array([None, *there["action"][1:].tolist()])
        assert "column action has 1 empty rows" in refusal(write(there))

    def test_wrong_type(self, write):
        there = columns()
        there["clearance"] = ["near"] * 24
        assert "column clearance holds string: floating point" in refusal(write(there))

    def test_one_action_only(self, write):
        there = columns()
        keep = there["action"] == "stop"
        message = refusal(write({k: np.array(v)[keep] for k, v in there.items()}))
        assert "only 'stop' is there" in message

    @pytest.mark.parametrize("gone", [slice(9, 10), slice(4, 8)])
    def test_unequal_numbers_of_rollouts(self, write, gone):
        keep = np.ones(24, dtype=bool)
        keep[gone] = False
        message = refusal(write({k: np.array(v)[keep] for k, v in columns().items()}))
        assert "the same number everywhere" in message

    def test_rollout_twice(self, write):
        there = columns()
        there["rollout"][1] = 0
        assert "stands there twice" in refusal(write(there))

    def test_no_rows(self, write):
        assert "no rows" in refusal(write({k: np.array(v)[:0] for k, v in columns().items()}))

    def test_no_file(self, tmp_path):
        refusal(tmp_path / "nothing.parquet")

    def test_not_parquet(self, tmp_path):
        path = tmp_path / "text.parquet"
        path.write_text("scene,family\n")
        assert "a Parquet file is needed" in refusal(path)


class TestProspects:
    def test_is_a_copy_that_cannot_be_changed(self):
        features = np.zeros((1, 2, 3, 5))
        bank = Prospects(features, np.array([1]), ("open",), ("mixed",), ("a", "b"))
        features[:] = 1.0
        assert bank.features.max() == 0.0
        with pytest.raises(ValueError, match="read-only"):
            bank.features[:] = 1.0

    def test_take_keeps_everything_together(self, prospects):
        some = prospects.take([4, 1])
        assert some.scenes.tolist() == [104, 101]
        assert some.families == (prospects.families[4], prospects.families[1])
        assert np.array_equal(some.features, prospects.features[[4, 1]])

    def test_shapes_that_do_not_fit(self, prospects):
        with pytest.raises(InputError, match="lengths"):
            replace(prospects, families=("open",))
        with pytest.raises(InputError, match="features of shape"):
            replace(prospects, features=np.zeros((24, 4, 0, 5)))
        with pytest.raises(InputError, match="twice"):
            replace(prospects, scenes=np.zeros(24))
