"""The prospects of many scenes, read from an outcome bank."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq

from learners.arrays import FloatArray, IntArray
from learners.errors import InputError

FEATURES = ("clearance", "deviation", "progress", "smoothness", "collisions")
"""Columns of the bank that describe an outcome, in the order of the reward θ."""

_LABELS = ("family", "pattern", "action")
_NUMBERS = ("scene", "rollout")


@dataclass(frozen=True)
class Prospects:
    """What may come of every action in every scene: S scenes, A actions, K outcomes, D features.

    Scenes are numbered by their place here, 0 to S − 1; the id of a scene is its number in the
    bank.

    Attributes:
        features: [S, A, K, D], φ of every outcome, scaled as in the bank; every outcome of a
            prospect has probability 1/K. A read-only copy of what was given.
        scenes: [S], ids of the scenes, each once.
        families: S names, the kind of each scene.
        patterns: S names, how people meet in it.
        actions: A names.

    Raises:
        InputError: if the shapes do not fit, a number is not finite, there are fewer than two
            actions, or an id stands there twice.
    """

    features: FloatArray
    scenes: IntArray
    families: tuple[str, ...]
    patterns: tuple[str, ...]
    actions: tuple[str, ...]

    def __post_init__(self) -> None:
        features = np.array(self.features, dtype=np.float64)
        scenes = np.array(self.scenes, dtype=np.int64)
        if features.ndim != 4 or 0 in features.shape:
            raise InputError(
                f"features of shape {list(features.shape)} are not allowed: "
                "[scenes, actions, outcomes, features], at least one of each"
            )
        lengths = (len(scenes), len(self.families), len(self.patterns), len(self.actions))
        wanted = (features.shape[0],) * 3 + (features.shape[1],)
        if lengths != wanted:
            raise InputError(
                f"scenes, families, patterns, actions of lengths {list(lengths)} are not allowed: "
                f"{list(wanted)}, as the features have it"
            )
        if not np.isfinite(features).all():
            wrong = features[~np.isfinite(features)][0]
            raise InputError(f"features contain {wrong}: only finite numbers are allowed")
        if features.shape[1] < 2:
            raise InputError(
                f"action: only {self.actions[0]!r} is there: two or more are needed to choose from"
            )
        if len(np.unique(scenes)) != len(scenes):
            raise InputError("scene: an id stands there twice: every scene once is allowed")
        for array in (features, scenes):
            array.setflags(write=False)
        object.__setattr__(self, "features", features)
        object.__setattr__(self, "scenes", scenes)

    def take(self, places: Sequence[int] | IntArray) -> "Prospects":
        """The prospects of the scenes at these places, in that order."""
        chosen = np.asarray(places, dtype=np.int64)
        return Prospects(
            self.features[chosen],
            self.scenes[chosen],
            tuple(self.families[place] for place in places),
            tuple(self.patterns[place] for place in places),
            self.actions,
        )


def read_bank(path: Path | str) -> Prospects:
    """Read the outcome bank, a Parquet file with one row for each rollout.

    Scenes come in the order of their ids, actions in the order of their first rows, and outcomes of
    a prospect in the order of their rollouts. The order of the rows does not matter otherwise.

    Raises:
        InputError: if it cannot be read, a column is missing or of the wrong type, a value is
            missing or not finite, there is one action only, scenes differ in their actions or
            prospects in their numbers of rollouts, or a rollout stands there twice.
    """
    columns = (*_NUMBERS, *_LABELS, *FEATURES)
    try:
        return _prospects(
            read_columns(
                lambda: pq.ParquetFile(Path(path)).read(columns), columns, "a Parquet file"
            )
        )
    except InputError as error:
        raise InputError(f"outcomes: {path}: {error}") from None


def read_columns(read: Callable[[], pa.Table], columns: Sequence[str], kind: str) -> pa.Table:
    """The columns that are needed of a table, in this order.

    Raises:
        InputError: if a column is missing, or the table cannot be read; the message then asks for a
            file of this kind.
    """
    try:
        table = read()
    except (OSError, pa.ArrowException) as error:
        # pyarrow's own message has several lines
        raise InputError(f"{str(error).splitlines()[0]}: {kind} is needed") from None
    for name in columns:
        if name not in table.column_names:
            raise InputError(f"column {name} is missing: {', '.join(columns)} are needed")
    return table.select(columns)


def _prospects(table: pa.Table) -> Prospects:
    _check_columns(table)
    scene, rollout = (table[name].to_numpy() for name in _NUMBERS)
    scenes, scene_place = np.unique(scene, return_inverse=True)
    names = table["action"].combine_chunks().dictionary_encode()
    actions = tuple(names.dictionary.to_pylist())
    prospect_place = scene_place * len(actions) + names.indices.to_numpy()
    order = np.lexsort((rollout, prospect_place))
    counts = np.bincount(prospect_place, minlength=len(scenes) * len(actions))
    if counts.min() != counts.max():
        place = int(np.argmin(counts))
        raise InputError(
            f"scene {scenes[place // len(actions)]} has {counts.min()} rollouts of "
            f"{actions[place % len(actions)]}, others have {counts.max()}: "
            "the same number everywhere is allowed"
        )
    shape = (len(scenes), len(actions), int(counts[0]))
    if (np.diff(rollout[order].reshape(shape), axis=-1) == 0).any():
        raise InputError(
            "a rollout of a scene and an action stands there twice: each once is allowed"
        )
    features = np.stack([table[name].to_numpy() for name in FEATURES], axis=-1)
    first = order.reshape(shape)[:, 0, 0]
    return Prospects(
        features[order].reshape(*shape, len(FEATURES)),
        scenes,
        tuple(table["family"].take(first).to_pylist()),
        tuple(table["pattern"].take(first).to_pylist()),
        actions,
    )


def _check_columns(table: pa.Table) -> None:
    if table.num_rows == 0:
        raise InputError("no rows: one row a rollout is needed")
    kinds = (
        (_NUMBERS, pa.types.is_integer, "integers"),
        (_LABELS, lambda kind: pa.types.is_string(kind) or pa.types.is_large_string(kind), "text"),
        (FEATURES, pa.types.is_floating, "floating point numbers"),
    )
    for names, is_right, allowed in kinds:
        for name in names:
            column = table[name]
            if not is_right(column.type):
                raise InputError(f"column {name} holds {column.type}: {allowed} are allowed")
            if column.null_count:
                raise InputError(
                    f"column {name} has {column.null_count} empty rows: none is allowed"
                )
    for name in FEATURES:
        numbers = table[name].to_numpy()
        wrong = np.flatnonzero(~np.isfinite(numbers))
        if wrong.size:
            raise InputError(
                f"column {name} contains {numbers[wrong[0]]} in row {wrong[0]}: "
                "only finite numbers are allowed"
            )
