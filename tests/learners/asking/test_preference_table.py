import pyarrow as pa
import pyarrow.csv
import pyarrow.parquet as pq
import pytest

from learners import InputError, read_preferences

GOOD = {
    "scene": [100, 103, 103, 104],
    "action_a": ["stop", "left", "forward", "forward"],
    "action_b": ["left", "right", "stop", "left"],
    "preferred": ["left", "left", "a", "b"],
    "who": ["ann", "ben", "ben", "cat"],
}


@pytest.fixture(params=["parquet", "csv"])
def write(tmp_path, request):
    def write(columns):
        path = tmp_path / f"preferences.{request.param}"
        if request.param == "csv":
            pa.csv.write_csv(pa.table(columns), path)
        else:
            pq.write_table(pa.table(columns), path)
        return path

    return write


def test_reads_names_and_sides(write, prospects):
    read = read_preferences(write(GOOD), prospects)
    assert read.scenes.tolist() == [0, 3, 3, 4]
    assert [prospects.actions[i] for i in read.preferred] == ["left", "left", "forward", "left"]
    assert [prospects.actions[i] for i in read.other] == ["stop", "right", "stop", "forward"]
    assert read.certainty is None
    assert len(read) == 4


@pytest.mark.parametrize(
    ("column", "wrong", "message"),
    [
        ("scene", 3, "row 1: scene 3 is not allowed: a scene of the bank"),
        ("action_a", "fly", "row 1: action_a 'fly' is not allowed: forward, stop, left, right"),
        ("action_b", "left", "row 1: action_b 'left' is not allowed: another one than action_a"),
        ("preferred", "stop", "row 1: preferred 'stop' is not allowed: left or right, or a or b"),
        ("preferred", None, "row 1: preferred None is not allowed: left or right, or a or b"),
    ],
)
def test_a_row_that_makes_no_sense_is_refused(write, prospects, column, wrong, message):
    cells = [*GOOD[column][:1], wrong, *GOOD[column][2:]]
    with pytest.raises(InputError) as refusal:
        read_preferences(write(GOOD | {column: cells}), prospects)
    assert message in str(refusal.value)
    assert "\n" not in str(refusal.value)


@pytest.mark.parametrize("name", ["scene", "action_a", "action_b", "preferred"])
def test_missing_column(write, prospects, name):
    columns = {key: cells for key, cells in GOOD.items() if key != name}
    with pytest.raises(InputError, match=f"column {name} is missing: scene, action_a"):
        read_preferences(write(columns), prospects)


def test_no_rows(write, prospects):
    empty = pa.table(GOOD).slice(0, 0)
    with pytest.raises(InputError, match="no rows"):
        read_preferences(write({name: empty[name] for name in empty.column_names}), prospects)


@pytest.mark.parametrize("name", ["none.csv", "none.parquet"])
def test_no_file(tmp_path, prospects, name):
    with pytest.raises(InputError, match="a Parquet or CSV file is needed"):
        read_preferences(tmp_path / name, prospects)


def test_not_parquet(tmp_path, prospects):
    path = tmp_path / "text.parquet"
    path.write_text("scene\n")
    with pytest.raises(InputError) as refusal:
        read_preferences(path, prospects)
    assert "\n" not in str(refusal.value)
