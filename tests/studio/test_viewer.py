"""Every kind of recording, seen in the real Rerun viewer."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import cv2
import numpy as np
import pytest
import rerun as rr
import rerun.blueprint as rrb

from studio.errors import InputError, RunError
from studio.recorder.stream import recording_to
from tests.headless import HeadlessViewer, NoGraphicsError, headless_viewer

SIZE = (1000, 640)
BLANK = 0.01
"""A view is blank if less than this share of it differs from its ground.

Ours have 4 % and more; an empty plot with the numbers of its axes has 0.5 %, "No data" 0.1 %.
"""


@pytest.fixture
def opened(missing, monkeypatch, tmp_path):
    """Opens a recording in a small viewer, which must leave the user's home alone."""
    home = tmp_path / "home"
    home.mkdir()

    @contextmanager
    def open_it(path: Path) -> Iterator[HeadlessViewer]:
        with monkeypatch.context() as patch:
            patch.setenv("HOME", str(home))
            for kind in ("CONFIG", "DATA", "CACHE", "STATE"):
                patch.setenv(f"XDG_{kind}_HOME", str(home))
            try:
                with headless_viewer(path, SIZE) as viewer:
                    yield viewer
            except NoGraphicsError:
                missing("mesa-vulkan-drivers")
        assert list(home.iterdir()) == []

    return open_it


def inked(png: bytes) -> float:
    """The share of a picture that clearly differs from the commonest colour in it."""
    pixels = decoded(png).astype(int)
    numbers = pixels @ (1 << 16, 1 << 8, 1)
    first, counts = np.unique(numbers, return_index=True, return_counts=True)[1:]
    ground = pixels.reshape(-1, 3)[first[counts.argmax()]]
    return float((np.abs(pixels - ground).max(axis=-1) > 60).mean())


def decoded(png: bytes) -> np.ndarray:
    return cv2.imdecode(np.frombuffer(png, np.uint8), cv2.IMREAD_COLOR_RGB)


def visit(viewer: HeadlessViewer) -> dict[str, float]:
    """How much each view shows, by name, on the tab where it shows least."""
    shown: dict[str, float] = {}
    for tab in viewer.tabs:
        viewer.show(tab)
        for view in viewer.views():
            shown[view.name] = min(inked(view.png), shown.get(view.name, 1.0))
    return shown


def test_every_view_on_every_tab_shows_something_and_none_complains(
    opened, recording, left_running
):
    with opened(recording) as viewer:
        shown = visit(viewer)
        assert set(shown) == {view.name for view in viewer.client.get_state().views}
        assert {name: ink for name, ink in shown.items() if ink < BLANK} == {}
        assert viewer.problems() == ()
        assert left_running(viewer.process.pid) == ["rerun"]
    assert left_running(viewer.process.pid) == []


def test_the_first_picture_shows_the_overview_at_the_time_that_is_set(opened, scene_recording):
    with opened(scene_recording) as viewer:
        pictures = []
        for seconds in (0.5, 3.0, 0.5):
            viewer.client.set_time("sim_time", duration=seconds)
            pictures.append(viewer.screenshot())
        assert decoded(pictures[0]).shape == (SIZE[1], SIZE[0], 3)
        assert pictures[0] == pictures[2] != pictures[1]


@pytest.fixture
def flawed(tmp_path):
    """A recording with a view that is fine, one without data, and one that cannot be drawn."""
    path = tmp_path / "flawed.rrd"
    fine = rrb.Spatial2DView(origin="/fine", name="fine")
    empty = rrb.TimeSeriesView(origin="/nothing", name="empty")
    broken = rrb.Spatial2DView(origin="/broken", name="broken")
    blueprint = rrb.Blueprint(
        rrb.Tabs(fine, rrb.Vertical(rrb.Tabs(empty, broken), name="outer")),
        auto_views=False,
        auto_layout=False,
    )
    with recording_to(path, "flawed", "flawed", blueprint) as stream:
        edge = 10
        noise = np.random.default_rng(0).integers(0, 255, (edge, edge, 3), np.uint8)
        stream.log("fine", rr.Image(noise), static=True)
        short = rr.components.ImageFormat(
            width=edge, height=edge, color_model="RGB", channel_datatype="U8"
        )
        stream.log("broken", rr.Image.from_fields(buffer=b"short", format=short), static=True)
    return path


def test_what_is_wrong_with_a_recording_is_found(opened, flawed):
    with opened(flawed) as viewer:
        assert [tab.name for tab in viewer.tabs] == ["fine", "outer", "empty", "broken"]
        assert viewer.problems() == ()
        shown = visit(viewer)
        assert {name for name, ink in shown.items() if ink < BLANK} == {"empty", "broken"}
        assert set(shown) == {"fine", "empty", "broken"}
        (problem,) = viewer.problems()
        assert problem.startswith("broken: error: Invalid data length")


def test_what_is_no_recording_is_refused(opened, tmp_path):
    with pytest.raises(InputError, match="cannot be read"), opened(tmp_path / "none.rrd"):
        pass
    cut = tmp_path / "cut.rrd"
    cut.write_bytes(b"RRF2 and nothing that follows")
    with pytest.raises(RunError, match="cannot load the recording"), opened(cut):
        pass


def test_without_a_driver_the_message_names_what_to_install(monkeypatch, flawed):
    monkeypatch.setenv("WGPU_BACKEND", "vulkan")
    for variable in ("VK_ICD_FILENAMES", "VK_DRIVER_FILES"):
        monkeypatch.setenv(variable, "/none")
    with pytest.raises(NoGraphicsError, match="mesa-vulkan-drivers"), headless_viewer(flawed):
        pass
