"""What the file of a recording holds, as arrays: the inverse of logging, for any recording."""

import warnings
from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.compute as pc
from numpy.typing import NDArray
from rerun.chunk import RrdReader
from rerun.error_utils import RerunWarning

from studio.errors import InputError
from studio.files import check_is_recording


@dataclass(frozen=True)
class Contents:
    """What a recording file holds; an `InputError` is raised if it lacks what is asked for."""

    path: Path  # of the file, as the user named it
    application: str  # the id of the application that it belongs to
    batches: dict[str, list[pa.RecordBatch]]  # rows of each entity, in the order of the file

    def has(self, entity: str, component: str) -> bool:
        """Whether an entity has a component."""
        return bool(self._batches_with(entity, component))

    def static(self, entity: str, component: str) -> NDArray[Any]:
        """The values of a component that does not change, [N] or [N, ...]."""
        return _numbers(self._column(entity, component)[-1].values)

    def text(self, entity: str, component: str) -> str:
        """A single text that does not change."""
        return str(self.static(entity, component)[0])

    def over_time(self, entity: str, component: str, timeline: str) -> NDArray[Any]:
        """The values of a component of equal length at all times, in order of time, [T, N, ...].

        Raises:
            InputError: if there is no such component, or the lengths differ.
        """
        rows = self._column(entity, component, timeline)
        values = rows.flatten()
        if len(values) % max(len(rows), 1):
            raise self.damaged(f"{entity} {component} changes its length")
        numbers = _numbers(values)
        return numbers.reshape(len(rows), -1, *numbers.shape[1:])

    def rows(self, entity: str, timeline: str) -> list[dict[str, Any]]:
        """Every row of an entity that stands on a timeline, in order of time.

        Returns:
            A row's time under the name of the timeline, and its components, each a list.
        """
        batches = self._batches_with(entity, timeline)
        rows = [row for batch in batches for row in batch.to_pylist()]
        return sorted(rows, key=lambda row: int(row[timeline]))

    def check_edition(self, entity: str, newest: int) -> None:
        """Make sure that the recording is of an edition that this version of the studio reads.

        An entity tells the edition, as its component `schema_version`. The oldest is 1.

        Raises:
            InputError: if it is of an edition below 1 or above the newest, or tells none.
        """
        told = int(self.static(entity, "schema_version")[0])
        if not 1 <= told <= newest:
            raise InputError(
                f"{self.path}: is of edition {told}: this version of the studio reads 1 to {newest}"
            )

    def damaged(self, what: str) -> InputError:
        """The error to raise where something is not as the studio writes it."""
        return InputError(f"{self.path}: is damaged, or not a recording of the studio: {what}")

    def _batches_with(self, entity: str, *columns: str) -> list[pa.RecordBatch]:
        batches = self.batches.get(entity, [])
        return [batch for batch in batches if set(columns) <= set(batch.schema.names)]

    def _column(self, entity: str, component: str, timeline: str | None = None) -> pa.ListArray:
        """The rows of a component that are there, in the order of the file or of a timeline."""
        batches = self._batches_with(entity, component, *filter(None, [timeline]))
        if not batches:
            raise self.damaged(f"it has no {component} at {entity}")
        parts = [batch.column(component) for batch in batches]
        values = parts[0].type.value_type
        column = pa.concat_arrays([part.cast(pa.list_(values)) for part in parts])
        if timeline:
            times = pa.concat_arrays([batch.column(timeline) for batch in batches])
            column = column.take(pc.sort_indices(times))
        return column.filter(pc.is_valid(column))


def _numbers(values: pa.Array) -> NDArray[Any]:
    """Values, or points of several coordinates, as an array."""
    if pa.types.is_fixed_size_list(values.type):
        inner = _numbers(values.flatten())
        return inner.reshape(len(values), values.type.list_size)
    array: NDArray[Any] = values.to_numpy(zero_copy_only=False)
    return array


def read_contents(path: Path) -> Contents:
    """Read a recording file.

    Raises:
        InputError: if the file cannot be read, or is not a whole recording.
    """
    check_is_recording(path)
    try:
        with warnings.catch_warnings():
            # of a file that is cut off between two messages Rerun only warns that it has no footer
            warnings.simplefilter("error", RerunWarning)
            reader = RrdReader(path)
            recordings = reader.recordings()
            chunks = reader.stream().to_chunks()
    except (RuntimeError, ValueError, RerunWarning):
        raise InputError(f"{path}: is cut off or damaged: a whole recording is needed") from None
    if len(recordings) != 1:
        raise InputError(f"{path}: holds {len(recordings)} recordings: one is needed")
    batches: dict[str, list[pa.RecordBatch]] = defaultdict(list)
    for chunk in chunks:
        batches[chunk.entity_path].append(chunk.to_record_batch())
    return Contents(path, recordings[0].application_id, dict(batches))
