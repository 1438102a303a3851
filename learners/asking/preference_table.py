"""Preferences of real people, read from a table."""

from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.csv
import pyarrow.parquet as pq

from learners.asking.preferences import Preferences
from learners.asking.prospects import Prospects
from learners.errors import InputError
from learners.names import check_name

COLUMNS = ("scene", "action_a", "action_b", "preferred")


def read_preferences(path: Path | str, prospects: Prospects) -> Preferences:
    """Read who preferred what from a Parquet or CSV file.

    Args:
        path: a file with the columns `scene` (id in the bank), `action_a`, `action_b` (names of
            two different actions) and `preferred` (the name of one of the two, or `a` or `b`);
            other columns are ignored. A file whose name ends in .parquet or .pq is read as
            Parquet, any other as CSV.
        prospects: the bank that the preferences are about.

    Raises:
        InputError: if the file cannot be read, a column is missing or a row does not make sense
            with this bank.
    """
    table = _read_columns(Path(path))
    if table.num_rows == 0:
        raise InputError(f"preferences: {path}: no rows: one row a choice is needed")
    scene_places = {int(scene): place for place, scene in enumerate(prospects.scenes)}
    action_places = {name: place for place, name in enumerate(prospects.actions)}
    scenes, preferred, other = [], [], []
    for row, (scene, a, b, choice) in enumerate(
        zip(*(table[name].to_pylist() for name in COLUMNS), strict=True)
    ):
        where = f"preferences: {path}: row {row}"
        if scene not in scene_places:
            raise InputError(f"{where}: scene {scene!r} is not allowed: a scene of the bank")
        for field, name in (("action_a", a), ("action_b", b)):
            check_name(f"{where}: {field}", name, prospects.actions)
        if a == b:
            raise InputError(f"{where}: action_b {b!r} is not allowed: another one than action_a")
        if choice not in (a, b, "a", "b"):
            raise InputError(
                f"{where}: preferred {choice!r} is not allowed: {a} or {b}, or a or b for short"
            )
        is_a = choice == a or (choice == "a" and choice != b)
        scenes.append(scene_places[scene])
        preferred.append(action_places[a if is_a else b])
        other.append(action_places[b if is_a else a])
    return Preferences(np.array(scenes), np.array(preferred), np.array(other))


def _read_columns(path: Path) -> pa.Table:
    try:
        if path.suffix.lower() in (".parquet", ".pq"):
            table = pq.read_table(path)
        else:
            table = pyarrow.csv.read_csv(
                path, convert_options=pyarrow.csv.ConvertOptions(strings_can_be_null=True)
            )
    except (OSError, pa.ArrowException) as error:
        raise InputError(
            f"preferences: {path}: {str(error).splitlines()[0]}: a Parquet or CSV file is needed"
        ) from None
    for name in COLUMNS:
        if name not in table.column_names:
            raise InputError(
                f"preferences: {path}: column {name} is missing: {', '.join(COLUMNS)} are needed"
            )
    return table.select(COLUMNS)
