"""Results as a person meets them at the end of a cell."""

import re
from base64 import b64decode
from html import unescape

import cv2
import numpy as np
import pytest
from IPython.core.interactiveshell import InteractiveShell
from rerun_notebook import Viewer

from scenes import Rollouts, load_scene, simulate
from scenes.bank import BankPlan, write_bank
from studio import open_recording
from studio.errors import InputError
from studio.made.notebook import SHOWN_SIZE, register_pictures
from studio.made.results import Compared, Learned, Made, Recorded
from studio.orchestrator import Studio

QUICK = {"png": False, "mp4": False, "rollouts": 5, "horizon": 1.0}


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Recorded:
    return Studio(tmp_path_factory.mktemp("recorded")).record("doorway", **QUICK)


@pytest.fixture(scope="module")
def compared(tmp_path_factory: pytest.TempPathFactory) -> Compared:
    return Studio(tmp_path_factory.mktemp("compared")).compare(
        "doorway", "stop", "forward", **QUICK
    )


@pytest.fixture(scope="module")
def learned(tmp_path_factory: pytest.TempPathFactory) -> Learned:
    folder = tmp_path_factory.mktemp("learned")
    write_bank(folder / "bank.parquet", BankPlan(scenes=8, rollouts=4))
    return Studio(folder).learn(folder / "bank.parquet", ("eu",), pairs=(10,), seeds=1)


@pytest.fixture(params=["recorded", "compared", "learned"])
def made(request: pytest.FixtureRequest) -> Made:
    result: Made = request.getfixturevalue(request.param)
    return result


def shown(html: str) -> tuple[np.ndarray, str]:
    """The picture on a page, and its text."""
    [picture] = re.findall(r'src="data:image/png;base64,([^"]+)"', html)
    text = unescape(" ".join(re.findall(r"<div>(.*?)</div>", html)))
    pixels = cv2.imdecode(np.frombuffer(b64decode(picture), np.uint8), cv2.IMREAD_COLOR)
    return cv2.cvtColor(pixels, cv2.COLOR_BGR2RGB), text


def test_a_result_is_a_picture_and_a_few_lines(made: Made) -> None:
    html = made._repr_html_()
    pixels, text = shown(html)
    assert pixels.shape == (SHOWN_SIZE[1], SHOWN_SIZE[0], 3)
    assert len(np.unique(pixels.reshape(-1, 3), axis=0)) > 20
    assert made.told[0] in text
    assert str(made.files[0]) in text
    assert len(text) < 1000


def test_printed_a_result_is_short(made: Made) -> None:
    assert len(repr(made)) < 500
    assert made.files[0].name in repr(made)


def test_a_result_tells_what_is_in_it(recorded: Recorded, learned: Learned) -> None:
    assert recorded.told[0] == "doorway, seed 0: 7 actions × 5 rollouts"
    assert "T&K picks " in recorded.told[1]
    assert learned.told[0].startswith("2 fits: 1 teacher × 2 learners × 10 pairs × 1 seed")


def test_a_comparison_does_not_say_which_action_is_where(compared: Compared) -> None:
    assert not set(compared.comparison.actions) & set(re.findall(r"\w+", compared.told[0]))


def test_a_result_is_data_too(recorded: Recorded) -> None:
    table = recorded.recording.to_arrow()
    np.testing.assert_array_equal(table["progress_m"], recorded.rollouts.progress_m.ravel())


def test_scenes_rollouts_and_recordings_are_pictures_in_a_notebook(recorded: Recorded) -> None:
    scene = load_scene("intersection", number=11)
    rollouts: Rollouts = simulate(scene, rollouts=3, horizon=1.0)
    assert repr(scene) == (
        "<Scene intersection: intersection, crossing, number 11, 7 pedestrians, 8 walls>"
    )
    assert repr(rollouts) == (
        "<Rollouts of intersection: 7 actions × 3 rollouts × 10 steps, 7 pedestrians, seed 0>"
    )
    shell = InteractiveShell.instance()
    try:
        register_pictures()
        for thing in (scene, rollouts, open_recording(recorded.files[0])):
            data, _ = shell.display_formatter.format(thing)
            pixels, _ = shown(data["text/html"])
            assert pixels.shape == (SHOWN_SIZE[1], SHOWN_SIZE[0], 3)
            assert data["text/plain"] == repr(thing)
    finally:
        InteractiveShell.clear_instance()


def test_the_viewer_in_a_notebook_gets_the_recording(
    made: Made, monkeypatch: pytest.MonkeyPatch
) -> None:
    viewers: list[Viewer] = []
    monkeypatch.setattr("IPython.display.display", viewers.append)
    made.show()
    [viewer] = viewers
    [(_, [sent])] = viewer._event_queue
    assert sent == next(file for file in made.files if file.suffix == ".rrd").read_bytes()


def test_without_the_viewer_one_line_says_what_to_install(
    made: Made, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("studio.made.notebook.find_spec", lambda _name: None)
    with pytest.raises(InputError, match=r"rerun-notebook is not installed: .*\[notebook\]"):
        made.show()
