"""The recording of a scene in the real Rerun viewer, at the size of a small screen."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from learners import PROFILES, CptParameters
from scenes import MetaAction, load_scene, simulate
from studio.scene.judgements import judge
from studio.scene.recording.write import write_recording
from tests.headless import HeadlessViewer, NoGraphicsError, headless_viewer
from tests.studio.test_viewer import BLANK, inked

SIZE = (1280, 720)
NAMES = [f"veer_slowly_towards_the_left_{number}" for number in range(12)]
OPENED = ("Overview", "veer slowl…the left 0", "veer slowl…he left 11", "Prospects", "Minds")


@pytest.fixture(scope="module")
def crowded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A recording of twelve actions with long names and of four teachers."""
    actions = tuple(
        MetaAction(name, 0.2 + 0.07 * turn, 0.06 * (turn - 5)) for turn, name in enumerate(NAMES)
    )
    rollouts = simulate(load_scene("intersection", number=4), actions, rollouts=8, horizon=3.0)
    teachers = {**PROFILES, "my aunt Gertrude": CptParameters(0.7, 0.7, 2.5, 0.6, 0.6)}
    path = tmp_path_factory.mktemp("views") / "crowded.rrd"
    write_recording(path, rollouts, judge(rollouts, teachers))
    return path


@pytest.fixture(scope="module")
def viewer(crowded: Path, missing) -> Iterator[HeadlessViewer]:
    try:
        with headless_viewer(crowded, SIZE) as viewer:
            yield viewer
    except NoGraphicsError:
        missing("mesa-vulkan-drivers")


def show(viewer: HeadlessViewer, name: str) -> dict[str, bytes]:
    """Pictures of the views on a tab, by their names."""
    viewer.show(next(tab for tab in viewer.tabs if tab.name == name))
    return {view.name: view.png for view in viewer.views()}


@pytest.mark.parametrize("tab", OPENED)
def test_no_tab_opens_with_an_empty_view(viewer: HeadlessViewer, tab: str) -> None:
    viewer.client.set_time("sim_time", duration=0.0)
    shown = show(viewer, tab)
    assert {name: inked(png) for name, png in shown.items() if inked(png) < BLANK} == {}
    assert viewer.problems() == ()


def test_every_tab_is_named_and_tells_its_action_from_the_others(viewer: HeadlessViewer) -> None:
    names = [tab.name for tab in viewer.tabs]
    assert set(OPENED) <= set(names)
    assert len(set(names)) == len(names)


def test_one_rollout_at_a_time_is_shown_in_the_world_among_the_dots_and_in_the_table(
    viewer: HeadlessViewer,
) -> None:
    pictures = []
    for place in (1, 6, 1):
        viewer.client.set_time("rollout", sequence=place)
        pictures.append(show(viewer, OPENED[1]))
    first, other, again = pictures
    moved = {name for name in first if first[name] != other[name]}
    # the table may have been scrolled meanwhile
    table = "Outcomes, a row a rollout"
    assert first | {table: b""} == again | {table: b""}
    world = next(name for name in first if "8 rollouts" in name)
    assert {world, "Utility of each rollout", table} <= moved
    # histograms are of all rollouts
    assert not moved & {"clearance, m", "deviation, m", "progress, m", "smoothness"}
    assert inked(first[world]) > BLANK
