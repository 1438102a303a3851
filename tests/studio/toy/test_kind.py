"""A new kind of recording is a folder with a file `kind.py`, and one line in `KINDS`."""

from pathlib import Path

import av
import cv2
import pytest
from click.testing import CliRunner

from studio.cli import main
from studio.errors import InputError
from studio.kinds import KINDS, read_recording
from studio.orchestrator import Studio
from tests.studio.toy import kind


@pytest.fixture(autouse=True)
def registered(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(KINDS, kind.APPLICATION, "tests.studio.toy.kind")


@pytest.fixture
def recording(tmp_path: Path) -> Path:
    path = tmp_path / "toy.rrd"
    kind.write(str(path), length=5)
    return path


def test_it_is_read(recording: Path) -> None:
    assert read_recording(recording) == kind.ToyRecording(5)


def test_it_is_stilled_and_filmed(recording: Path) -> None:
    still, film = Studio().render(recording)
    assert cv2.imread(str(still)).mean() == 200 - 20 * 4
    with av.open(str(film)) as container:
        greys = [frame.to_ndarray(format="gray").mean() for frame in container.decode(video=0)]
    assert len(greys) == 5
    assert greys == sorted(greys, reverse=True)


def test_the_command_line_cuts_it_and_has_its_words(recording: Path) -> None:
    film = recording.with_suffix(".gif")
    arguments = ["render", str(recording), "--gif", str(film), "--from", "1", "--to", "3"]
    assert CliRunner().invoke(main, arguments).exit_code == 0
    with av.open(str(film)) as container:
        assert len(list(container.decode(video=0))) == 3
    told = CliRunner().invoke(main, ["render", "--help"], terminal_width=200).stdout
    assert "pairs of a study, frames of a toy." in told


def test_what_it_refuses_is_refused(recording: Path, tmp_path: Path) -> None:
    result = CliRunner().invoke(
        main, ["render", str(recording), "--png", str(tmp_path / "x.png"), "--actions", "stop"]
    )
    assert (result.exit_code, result.stderr) == (
        2,
        "studio: --actions: goes with the recording of a scene, not of a toy\n",
    )


def test_without_its_line_it_is_no_recording_of_the_studio(
    recording: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delitem(KINDS, kind.APPLICATION)
    with pytest.raises(InputError, match="is a recording of 'toy', not one of the studio"):
        read_recording(recording)
