from pathlib import Path

import pytest
import rerun as rr
import rerun.blueprint as rrb

from studio.recorder.stream import recording_to


def test_what_cannot_be_logged_is_an_error_even_if_rerun_is_lenient(tmp_path: Path) -> None:
    rr.set_strict_mode(False)
    path = tmp_path / "test.rrd"
    with (
        pytest.raises(ValueError, match="arrow"),
        recording_to(path, "test", "test", rrb.Blueprint()) as stream,
    ):
        stream.log("thing", rr.AnyValues(unloggable=object()))
    assert not path.exists()
