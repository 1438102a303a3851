"""Preferences of real people, read from a table."""

from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.csv
import pyarrow.parquet as pq

from learners.asking.preferences import Preferences
from learners.asking.prospects import Prospects, read_columns
from learners.errors import InputError
from learners.names import check_name

COLUMNS = ("scene", "action_a", "action_b", "preferred")


def read_preferences(path: Path | str, prospects: Prospects) -> Preferences:
    """Read who preferred what from a Parquet or CSV file.

    The columns are `scene` (id in the bank), `action_a`, `action_b` (names of two different
    actions) and `preferred` (the name of one of the two, or `a` or `b`); others are ignored. A file
    whose name ends in .parquet or .pq is read as Parquet, any other as CSV.

    Raises:
        InputError: if the file cannot be read, a column is missing or a row does not make sense
            with this bank.
    """
    try:
        table = read_columns(lambda: _read(Path(path)), COLUMNS, "a Parquet or CSV file")
        return _preferences(table, prospects)
    except InputError as error:
        raise InputError(f"preferences: {path}: {error}") from None


def _read(path: Path) -> pa.Table:
    if path.suffix.lower() in (".parquet", ".pq"):
        return pq.read_table(path)
    nulls = pyarrow.csv.ConvertOptions(strings_can_be_null=True)
    return pyarrow.csv.read_csv(path, convert_options=nulls)


def _preferences(table: pa.Table, prospects: Prospects) -> Preferences:
    if table.num_rows == 0:
        raise InputError("no rows: one row a choice is needed")
    scene_places = {int(scene): place for place, scene in enumerate(prospects.scenes)}
    action_places = {name: place for place, name in enumerate(prospects.actions)}
    scenes, preferred, other = [], [], []
    for row, (scene, a, b, choice) in enumerate(
        zip(*(table[name].to_pylist() for name in COLUMNS), strict=True)
    ):
        if scene not in scene_places:
            raise InputError(f"row {row}: scene {scene!r} is not allowed: a scene of the bank")
        for field, name in (("action_a", a), ("action_b", b)):
            check_name(f"row {row}: {field}", name, prospects.actions)
        if a == b:
            raise InputError(f"row {row}: action_b {b!r} is not allowed: another one than action_a")
        if choice not in (a, b, "a", "b"):
            raise InputError(
                f"row {row}: preferred {choice!r} is not allowed: {a} or {b}, or a or b for short"
            )
        is_a = choice == a or (choice == "a" and choice != b)
        scenes.append(scene_places[scene])
        preferred.append(action_places[a if is_a else b])
        other.append(action_places[b if is_a else a])
    return Preferences(np.array(scenes), np.array(preferred), np.array(other))
