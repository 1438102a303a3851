"""What a recording holds, read with Rerun's own reader."""

import subprocess
import sys
from collections import defaultdict
from pathlib import Path
from typing import Any

from rerun.chunk import RrdReader


def read_entities(path: Path) -> dict[str, dict[str, list[Any]]]:
    """Entity path, then component or timeline, to its rows; a static one has one row."""
    entities: dict[str, dict[str, list[Any]]] = defaultdict(dict)
    for chunk in RrdReader(path).stream().to_chunks():
        batch = chunk.to_record_batch()
        for name in batch.schema.names:
            if name != "rerun.controls.RowId":
                entities[str(chunk.entity_path)][name] = batch.column(name).to_pylist()
    return entities


def read_blueprint(path: Path) -> dict[str, list[Any]]:
    """Components of the one blueprint in a recording, to all their values."""
    reader = RrdReader(path)
    (blueprint,) = reader.blueprints()
    components: dict[str, list[Any]] = defaultdict(list)
    for chunk in reader.stream(store=blueprint).to_chunks():
        batch = chunk.to_record_batch()
        for name in (name for name in batch.schema.names if ":" in name):
            components[name] += [value for row in batch.column(name).to_pylist() for value in row]
    return components


def verify(path: Path) -> None:
    """Let Rerun check that a recording is whole."""
    command = [sys.executable, "-m", "rerun", "rrd", "verify", str(path)]
    done = subprocess.run(command, capture_output=True, check=False)
    assert done.returncode == 0, done.stderr
