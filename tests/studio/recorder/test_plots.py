"""What plots hold is what was given: read back with Rerun's own reader."""

from pathlib import Path

import numpy as np
import pytest
import rerun as rr
import rerun.blueprint as rrb

from studio.recorder.contents import Contents, read_contents
from studio.recorder.plots import log_bands, log_bars, log_rows, log_states
from studio.recorder.stream import recording_to
from studio.style.palette import ACTION_COLOURS, LIGHT
from tests.entities import read_entities

TIMES = [rr.TimeColumn("step", sequence=[0, 1, 2])]
VALUES = np.array([(0.0, 1.0), (0.5, 1.5), (2.0, -1.0)])


@pytest.fixture
def path(tmp_path: Path) -> Path:
    path = tmp_path / "plots.rrd"
    with recording_to(path, "plots", "plots", rrb.Blueprint()) as stream:
        edges = np.array([0.0, 0.5, 1.5])
        log_bars(stream, "bars", edges, [3, 4], LIGHT.contact)
        log_bands(stream, "bands", TIMES, VALUES, 0.5 + 0.0 * VALUES, "ab", ACTION_COLOURS[:2])
        states = [("free", "wall"), ("person", "free"), ("free", "free")]
        log_states(stream, "states", TIMES, states, {"free": LIGHT.grid, "wall": LIGHT.wall})
        rows = {"clearance_m": VALUES[:, 1], "touched": np.array([True, False, True])}
        log_rows(stream, "table", "rollout", rows)
    return path


@pytest.fixture
def contents(path: Path) -> Contents:
    return read_contents(path)


def test_bars_stand_between_their_edges(path: Path) -> None:
    bars = read_entities(path)["/bars"]
    assert bars["BarChart:widths"] == [[0.5, 1.0]]
    (abscissa,) = bars["BarChart:abscissa"][0]
    assert abscissa["buffer"] == [0.0, 0.5]
    (values,) = bars["BarChart:values"][0]
    assert values["buffer"] == [3, 4]


def test_bands_reach_as_far_as_was_said(contents: Contents) -> None:
    values = contents.over_time("/bands", "Measurements:values", "step")
    variances = contents.over_time("/bands", "Measurements:variances", "step")
    np.testing.assert_array_equal(values, VALUES)
    np.testing.assert_allclose(np.sqrt(variances), 0.5)


def test_states_are_in_one_order_at_all_times(contents: Contents) -> None:
    states = contents.over_time("/states", "StateChange:state", "step")
    assert states.tolist() == [["free", "wall"], ["person", "free"], ["free", "free"]]


def test_tables_have_a_row_at_each_number(contents: Contents) -> None:
    rows = contents.rows("/table", "rollout")
    assert [row["rollout"] for row in rows] == [0, 1, 2]
    assert [row["clearance_m"] for row in rows] == [[1.0], [1.5], [-1.0]]
    assert [row["touched"] for row in rows] == [[True], [False], [True]]
