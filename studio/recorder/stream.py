"""Where a recording goes while it is made: memory first, then, whole, a file."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import rerun as rr
import rerun.blueprint as rrb
from rerun.error_utils import catch_and_log_exceptions


@contextmanager
def recording_to(
    path: Path, application: str, identity: str, blueprint: rrb.Blueprint
) -> Iterator[rr.RecordingStream]:
    """A stream whose recording is written to a file when the block has succeeded.

    Rerun's own file sink only warns when a disk is full and leaves a file cut short; bytes that
    Python writes are there, or raise.

    Args:
        path: the `.rrd` file to write.
        application: application id; blueprints belong to it.
        identity: recording id; recordings of one id are one recording to the viewer.
        blueprint: how the recording opens.

    Raises:
        OSError: if the file cannot be written.
    """
    stream = rr.RecordingStream(application, recording_id=identity, send_properties=False)
    stream.set_log_time_enabled(False)
    memory = stream.memory_recording()
    try:
        # Rerun drops what it cannot log and warns; a recording that lacks something must not pass.
        with catch_and_log_exceptions("recording_to", strict=True):
            stream.send_blueprint(blueprint)
            yield stream
        stream.flush()
        content = memory.drain_as_bytes()
    finally:
        stream.disconnect()
    path.write_bytes(content)
