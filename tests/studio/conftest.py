"""What the tests of recordings, viewers and browsers share."""

import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NoReturn

import psutil
import pytest
import rerun as rr

from scenes.bank import BankPlan, write_bank
from studio.orchestrator import Studio

Missing = Callable[[str], NoReturn]


@pytest.fixture
def strict_rerun() -> Iterator[None]:
    """Rerun raises errors instead of warning of them."""
    before = rr.strict_mode()
    rr.set_strict_mode(True)
    yield
    rr.set_strict_mode(before)


@pytest.fixture(scope="session")
def missing() -> Missing:
    """Skips a test for want of a Debian package; fails it where viewers are required."""

    def end(package: str) -> NoReturn:
        message = f"needs the Debian package {package}: apt-get install {package}"
        if os.environ.get("STUDIO_REQUIRE_VIEWERS"):
            pytest.fail(message)
        pytest.skip(message)

    return end


@pytest.fixture(scope="session")
def scene_recording(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("scene")
    return Studio(folder).record("doorway", rollouts=5, png=False, mp4=False).files[0]


@pytest.fixture(scope="session")
def study_recording(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("study")
    bank = folder / "bank.parquet"
    write_bank(bank, BankPlan(scenes=16, rollouts=8))
    return Studio(folder).learn(bank, ("eu", "tk"), pairs=(10, 30), seeds=2).files[2]


@pytest.fixture(scope="session")
def comparison_recording(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("comparison")
    studio = Studio(folder)
    compared = studio.compare("doorway", "forward", "stop", rollouts=5, png=False, mp4=False)
    return compared.files[0]


# a further kind of recording is a fixture like those above, and its name here
@pytest.fixture(
    scope="session", params=["scene_recording", "comparison_recording", "study_recording"]
)
def recording(request: pytest.FixtureRequest) -> Path:
    """A recording of each kind in turn."""
    path: Path = request.getfixturevalue(request.param)
    return path


@pytest.fixture(scope="session")
def left_running() -> Callable[[int], list[str]]:
    """Tells what still runs of a process group, by name."""

    def names(group: int) -> list[str]:
        found = []
        for process in psutil.process_iter(["name", "status"]):
            try:
                theirs = os.getpgid(process.pid)
            except ProcessLookupError:
                continue
            if theirs == group and process.info["status"] != psutil.STATUS_ZOMBIE:
                found.append(process.info["name"])
        return found

    return names
