"""What the tests of recordings, viewers and browsers share."""

import lzma
import os
from collections.abc import Callable, Iterator
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import NoReturn

import psutil
import pytest
import rerun as rr

from studio.kinds import KINDS

DATA = Path(__file__).parent / "data"
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
def example(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Path]:
    """Makes a recording of the kind at home in `studio.<room>.kind`, once."""

    @cache
    def made(room: str) -> Path:
        maker = import_module(f"tests.studio.{room}.example")
        path: Path = maker.make(tmp_path_factory.mktemp(room))
        return path

    return made


@pytest.fixture(scope="session")
def scene_recording(example: Callable[[str], Path]) -> Path:
    return example("scene")


@pytest.fixture(scope="session")
def comparison_recording(example: Callable[[str], Path]) -> Path:
    return example("comparison")


@pytest.fixture(scope="session")
def study_recording(example: Callable[[str], Path]) -> Path:
    return example("study")


@pytest.fixture(scope="session", params=[place.split(".")[1] for place in KINDS.values()])
def recording(request: pytest.FixtureRequest, example: Callable[[str], Path]) -> Path:
    """A recording of each kind in turn; a new kind joins by an `example.py` beside its tests."""
    return example(request.param)


@pytest.fixture
def old(tmp_path: Path) -> Callable[[str], Path]:
    """Unpacks a recording that an older version of the studio has written."""

    def unpack(name: str) -> Path:
        path = tmp_path / f"{name}.rrd"
        path.write_bytes(lzma.decompress((DATA / f"{name}.rrd.xz").read_bytes()))
        return path

    return unpack


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
