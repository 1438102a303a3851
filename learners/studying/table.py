"""The table of a study: its columns, its metadata, and which of its rows are missing."""

import json
from collections.abc import Sequence

import pyarrow as pa

from learners.errors import InputError
from learners.studying.plan import Study, StudyScene, Task, study_tasks

METADATA = b"prospect_study"
"""Key of a study's table's metadata, JSON, that says what was studied."""


# lists as Parquet files give them back
_NUMBERS = pa.list_(pa.field("element", pa.float64()))
_COUNTS = pa.list_(pa.field("element", pa.int64()))
_NAMES = pa.list_(pa.field("element", pa.string()))

PARAMETER_COLUMNS = ("alpha", "eta", "lambda", "gamma", "delta")
"""Columns of the parameters of prospect theory, in the order of `CptParameters.SYMBOLS`."""

STUDY_SCHEMA = pa.schema(
    [
        pa.field("teacher", pa.string(), nullable=False),
        pa.field("learner", pa.string(), nullable=False),
        pa.field("pairs", pa.int64(), nullable=False),
        pa.field("seed", pa.int64(), nullable=False),
        pa.field("regret", pa.float64(), nullable=False),
        pa.field("regret_percent", pa.float64(), nullable=False),
        pa.field("nll", pa.float64(), nullable=False),
        pa.field("certainty", pa.float64(), nullable=False),
        pa.field("theta", _NUMBERS, nullable=False),
        pa.field("alpha", pa.float64()),
        pa.field("eta", pa.float64()),
        pa.field("lambda", pa.float64()),
        pa.field("gamma", pa.float64()),
        pa.field("delta", pa.float64()),
        pa.field("reference", pa.float64(), nullable=False),
        pa.field("theta_unit", _NUMBERS, nullable=False),
        pa.field("theta_cosine", pa.float64(), nullable=False),
        pa.field("agreement", pa.float64(), nullable=False),
        pa.field("nll_teacher", pa.float64(), nullable=False),
        pa.field("nll_training", pa.float64(), nullable=False),
        pa.field("repeated", pa.int64(), nullable=False),
        pa.field("converged", pa.bool_(), nullable=False),
        pa.field("steps", pa.int64(), nullable=False),
        pa.field("expected_decrease", pa.float64(), nullable=False),
        pa.field("calibration_count", _COUNTS, nullable=False),
        pa.field("calibration_predicted", _NUMBERS, nullable=False),
        pa.field("calibration_preferred", _NUMBERS, nullable=False),
        pa.field("held_out_scenes", _COUNTS, nullable=False),
        pa.field("scene_regret", _NUMBERS, nullable=False),
        pa.field("scene_picks", _NAMES, nullable=False),
    ]
)
"""Columns of the table, one row a fit.

`regret`, `regret_percent`, `agreement`, `nll`, `nll_teacher` and the `calibration_` lists are those
of `Evaluation`, on held-out scenes; `nll_training` is that of the fit. `certainty` is that of the
answers learned from, `repeated` how many of their questions had been asked before. `theta_unit` is
θ/‖θ‖ and `theta_cosine` the cosine between θ and the teacher's. `alpha` to `delta` are empty for
learners of expected utility, calibration empty (null) in bins without predictions.
`held_out_scenes` are the ids of the scenes that were kept back, ascending; `scene_regret` is the
regret in each of them, in units of value, and `scene_picks` the action picked there. What these
scenes are stands in the metadata, see `study_scenes`.
"""


def study_scenes(table: pa.Table) -> dict[int, StudyScene]:
    """The scenes of a study, those to learn from too, by their ids in the bank.

    Args:
        table: rows of a study with its metadata.

    Raises:
        InputError: if the table does not say what its scenes are.
    """
    try:
        told = json.loads((table.schema.metadata or {})[METADATA])["scenes"]
        return {scene["scene"]: StudyScene(**scene) for scene in told}
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


def study_schema(study: Study) -> pa.Schema:
    """The columns of a study's table, with what is studied as their metadata."""
    return STUDY_SCHEMA.with_metadata({METADATA: json.dumps(study.metadata, sort_keys=True)})


def _tasks_of(table: pa.Table) -> list[Task]:
    return [
        Task(*values) for values in zip(*(table[n].to_pylist() for n in Task._fields), strict=True)
    ]


def _check_same_study(study: Study, table: pa.Table) -> None:
    try:
        theirs = json.loads((table.schema.metadata or {})[METADATA])
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
