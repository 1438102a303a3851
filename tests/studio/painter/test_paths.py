import numpy as np
import pytest

from studio.painter.paths import FaintPaths, draw_faint_paths
from tests.canvases import a_canvas

WHITE, BLACK = (255, 255, 255), (0, 0, 0)


@pytest.mark.parametrize("count", [1, 2, 5, 50])
def test_overlapping_faint_paths_grow_darker_as_if_laid_on_one_another(count):
    canvas = a_canvas()
    path = np.array([[50.0, 100.5], [250.0, 100.5]])
    draw_faint_paths(canvas, np.array([path] * count), BLACK, 5.0, 0.08)
    expected = 255.0 * (1.0 - 0.08) ** count
    assert canvas.pixels[100, 150, 0] == pytest.approx(expected, abs=1.5)


def test_a_path_that_runs_back_over_itself_counts_once():
    canvas = a_canvas()
    there_and_back = np.array([[50.0, 100.5], [250.0, 100.5], [50.0, 100.5]])
    draw_faint_paths(canvas, there_and_back[None], BLACK, 5.0, 0.5)
    assert canvas.pixels[100, 150, 0] == pytest.approx(127.5, abs=1.5)


def test_paths_outside_of_the_page_leave_it_empty():
    canvas = a_canvas()
    draw_faint_paths(canvas, np.array([[[-500.0, -500.0], [-100.0, -9e9]]]), BLACK, 5.0, 0.5)
    assert (canvas.pixels == WHITE).all()


def test_paths_look_the_same_whether_they_come_as_wholes_or_piece_by_piece():
    canvas, corners = a_canvas(), np.random.default_rng(0).uniform(20.0, 340.0, (6, 5, 2))
    whole, pieces = (FaintPaths(canvas, BLACK, 2.0, 0.1) for _ in range(2))
    whole.add(corners)
    traces = pieces.traces(corners)
    for step in range(4):
        pieces.add(corners[:, step : step + 2], traces)
    once, bit_by_bit = whole.over(canvas.pixels), pieces.over(canvas.pixels)
    assert (once != bit_by_bit).any(axis=-1).mean() < 1e-3


def test_nothing_changes_outside_of_the_part_that_new_paths_change():
    canvas = a_canvas()
    paths = FaintPaths(canvas, BLACK, 3.0, 0.5)
    part = paths.add(np.array([[[100.0, 50.0], [200.0, 90.0]]]))
    drawn = paths.over(canvas.pixels)
    assert (drawn[part] != 255).any()
    drawn[part] = 255
    assert (drawn == 255).all()
    nothing = paths.add(np.empty((0, 2, 2)))
    assert canvas.pixels[nothing].size == 0
