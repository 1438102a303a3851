from pathlib import Path

import pytest

from scenes import Rollouts
from studio.scene.judgements import judge
from studio.scene.recording.write import write_recording
from tests.studio.scene.made_up import make_rollouts


@pytest.fixture(scope="module")
def rollouts() -> Rollouts:
    return make_rollouts()


@pytest.fixture(scope="module")
def recording(rollouts: Rollouts, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("recording") / "test.rrd"
    write_recording(path, rollouts, judge(rollouts))
    return path
