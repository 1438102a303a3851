"""The table of a study: its columns, its metadata, and which of its rows are missing."""

import json
from collections.abc import Sequence
from typing import Any

import pyarrow as pa

from learners.errors import InputError
from learners.studying.plan import Study, StudyScene, Task, study_tasks

METADATA = b"prospect_study"
"""Key under which a table keeps, as JSON, what was studied: `Study.metadata`."""

TASK_COLUMNS = ("teacher", "learner", "pairs", "seed")
"""Columns that say which fit a row is: the fields of `Task`."""

PARAMETER_COLUMNS = ("alpha", "eta", "lambda", "gamma", "delta")
"""Columns of the parameters of prospect theory, in the order of `CptParameters.SYMBOLS`."""

SCENE_COLUMNS = ("held_out_scenes", "scene_regret", "scene_picks")
"""Columns of lists with one entry for each scene that was held out."""

# lists as Parquet files give them back
_NUMBERS = pa.list_(pa.field("element", pa.float64()))
_COUNTS = pa.list_(pa.field("element", pa.int64()))
_NAMES = pa.list_(pa.field("element", pa.string()))


def _filled(kind: pa.DataType, *names: str) -> list[pa.Field]:
    """Columns that have a value in every row."""
    return [pa.field(name, kind, nullable=False) for name in names]


STUDY_SCHEMA = pa.schema(
    [
        *_filled(pa.string(), "teacher", "learner"),
        *_filled(pa.int64(), "pairs", "seed"),
        *_filled(pa.float64(), "regret", "regret_percent", "nll", "certainty"),
        *_filled(_NUMBERS, "theta"),
        *(pa.field(name, pa.float64()) for name in PARAMETER_COLUMNS),
        *_filled(pa.float64(), "reference"),
        *_filled(_NUMBERS, "theta_unit"),
        *_filled(pa.float64(), "theta_cosine", "agreement", "nll_teacher", "nll_training"),
        *_filled(pa.int64(), "repeated"),
        *_filled(pa.bool_(), "converged"),
        *_filled(pa.int64(), "steps"),
        *_filled(pa.float64(), "expected_decrease"),
        *_filled(_COUNTS, "calibration_count"),
        *_filled(_NUMBERS, "calibration_predicted", "calibration_preferred"),
        *_filled(_COUNTS, "held_out_scenes"),
        *_filled(_NUMBERS, "scene_regret"),
        *_filled(_NAMES, "scene_picks"),
    ]
)
"""Columns of the table, one row a fit.

`regret`, `regret_percent`, `agreement`, `nll`, `nll_teacher` and the `calibration_` lists are those
of `Evaluation`, on held-out scenes; `nll_training` is the `nll` of the `Fit`. `certainty` and
`repeated` are those of the `Preferences` that were learned from. `theta_unit` is θ/‖θ‖, and
`theta_cosine` the cosine between θ and the teacher's. The `PARAMETER_COLUMNS` are empty (null) for
learners of expected utility, the calibration is empty in bins without predictions.
`held_out_scenes` are the ids of the scenes that were kept back, ascending; `scene_regret` is the
regret in each of them, in units of value, and `scene_picks` the action that the learner picks
there. The scenes themselves are described in the metadata, see `study_scenes`.
"""


def study_schema(study: Study) -> pa.Schema:
    """The columns of a study's table, with what is studied as their metadata."""
    return STUDY_SCHEMA.with_metadata({METADATA: json.dumps(study.metadata, sort_keys=True)})


def study_scenes(table: pa.Table) -> dict[int, StudyScene]:
    """The scenes of a study, those to learn from too, by their ids in the bank.

    Raises:
        InputError: if the table does not say what its scenes are.
    """
    try:
        return {scene["scene"]: StudyScene(**scene) for scene in _studied(table)["scenes"]}
    except (KeyError, TypeError, ValueError):
        raise InputError(
            "table: rows without a description of their scenes are not allowed: rows of a study"
        ) from None


def missing_tasks(study: Study, table: pa.Table | None) -> tuple[Task, ...]:
    """Tasks of a study that have no row in a table yet, in the order of `study_tasks`.

    Raises:
        InputError: if the table is not of this study: of another bank, another split, or of
            teachers or learners who bear the same names but are others.
    """
    if table is None:
        return study_tasks(study)
    _check_same_study(study, table)
    done = set(_tasks_of(table))
    return tuple(task for task in study_tasks(study) if task not in done)


def whole_table(study: Study, parts: Sequence[pa.Table]) -> pa.Table:
    """The rows of a study from several tables in one, in the order of `study_tasks`.

    Rows that do not belong to the study, of further seeds for example, are left out.

    Raises:
        InputError: if a table is of another study.
    """
    for part in parts:
        _check_same_study(study, part)
    schema = study_schema(study)
    # metadata differ where a part is of a larger or smaller study
    rows = pa.concat_tables([part.select(schema.names).cast(schema) for part in parts])
    places = {task: place for place, task in enumerate(_tasks_of(rows))}
    wanted = [places[task] for task in study_tasks(study) if task in places]
    return rows.take(pa.array(wanted, pa.int64()))


def _studied(table: pa.Table) -> Any:
    """What the metadata of a table say; `KeyError` or `ValueError` if they are not of a study."""
    return json.loads((table.schema.metadata or {})[METADATA])


def _tasks_of(table: pa.Table) -> list[Task]:
    return list(map(Task, *(table[name].to_pylist() for name in Task._fields)))


def _check_same_study(study: Study, table: pa.Table) -> None:
    try:
        theirs = _studied(table)
    except (KeyError, ValueError):
        raise InputError("table: rows without a study are not allowed: rows of a study") from None
    for name in STUDY_SCHEMA.names:
        if name not in table.column_names:
            raise InputError(f"table: rows without {name!r} are not allowed: rows of this edition")
    ours = json.loads(json.dumps(study.metadata))
    for field in ("bank", "held_out"):
        if theirs.get(field) != ours[field]:
            raise InputError(
                f"table: rows of {field} {theirs.get(field)} are not allowed: {ours[field]}"
            )
    for field in ("teachers", "learners"):
        for name in ours[field].keys() & theirs.get(field, {}).keys():
            if theirs[field][name] != ours[field][name]:
                raise InputError(
                    f"table: rows of {field} with another {name!r} are not allowed: "
                    f"{ours[field][name]}"
                )
