import itertools
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from studio.errors import InputError
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.paths import draw_faint_paths
from studio.painter.pixels import disc_coverage
from studio.painter.views import View
from studio.style.palette import LIGHT
from tests.canvases import a_canvas

WHITE, BLACK, RED = (255, 255, 255), (0, 0, 0), (255, 0, 0)


def ink(canvas):
    """How much was drawn, in black pixels."""
    return (255.0 - canvas.pixels.mean(axis=-1)).sum() / 255.0


@pytest.mark.parametrize("size", [(639, 360), (640, 359), (10_000, 900), (0, 0)])
def test_sizes_that_cannot_be_drawn_are_refused_in_one_line(size):
    with pytest.raises(InputError, match=f"size: {size[0]}x{size[1]} pixels is not allowed") as e:
        Canvas(*size, LIGHT)
    assert "\n" not in str(e.value)


@pytest.mark.parametrize("radius", [1.5, 4.0, 25.0])
def test_a_disc_covers_its_area_wherever_its_centre_lies_in_a_pixel(radius):
    for x, y in itertools.product((100.0, 100.3, 100.7), repeat=2):
        canvas = a_canvas()
        canvas.disc((x, y), radius, BLACK)
        assert ink(canvas) == pytest.approx(math.pi * radius**2, rel=0.06)
        rows, columns = np.nonzero(canvas.pixels[..., 0] < 255)
        weights = 255.0 - canvas.pixels[rows, columns, 0]
        assert np.average(columns + 0.5, weights=weights) == pytest.approx(x, abs=0.1)
        assert np.average(rows + 0.5, weights=weights) == pytest.approx(y, abs=0.1)


def test_a_disc_half_outside_or_far_away_harms_nothing():
    canvas = a_canvas()
    canvas.disc((0.0, 180.0), 20.0, BLACK)
    assert ink(canvas) == pytest.approx(math.pi * 20.0**2 / 2, rel=0.05)
    for far in ((-1e9, 5.0), (1e30, 5.0), (5.0, 1e9)):
        canvas.disc(far, 20.0, RED)
        canvas.line([(0.0, 0.0), far], WHITE)
    assert not (canvas.pixels == RED).all(axis=-1).any()


def test_lines_are_drawn_between_pixels():
    thin, shifted = a_canvas(), a_canvas()
    thin.line([(50.0, 100.5), (250.0, 100.5)], BLACK)
    shifted.line([(50.0, 101.0), (250.0, 101.0)], BLACK)
    assert (thin.pixels[100, 60:240] < 30).all()
    assert (shifted.pixels[100:102, 60:240] > 30).all()
    assert (shifted.pixels[100:102, 60:240] < 225).all()


@pytest.mark.parametrize("anchor", ["left", "centre", "right"])
@pytest.mark.parametrize("line", ["base", "middle", "top"])
def test_letters_lie_inside_the_box_that_the_canvas_records(anchor, line):
    canvas = a_canvas()
    box = canvas.text((320.0, 180.0), "Apqgfdlb 0.25 m", 24, BLACK, anchor=anchor, line=line)
    assert canvas.texts[-1].box == box
    rows, columns = np.nonzero(canvas.pixels[..., 0] < 200)
    assert box.left - 1 <= columns.min()
    assert columns.max() <= box.right
    assert box.top - 0.15 * 24 <= rows.min()
    assert rows.max() <= box.bottom + 0.1 * 24


def test_centred_text_is_centred_on_its_ink():
    canvas = a_canvas()
    canvas.text((320.0, 180.0), "HOH", 40, BLACK, anchor="centre")
    rows, columns = np.nonzero(canvas.pixels[..., 0] < 128)
    assert (columns.min() + columns.max() + 1) / 2 == pytest.approx(320.0, abs=1.5)
    assert (rows.min() + rows.max() + 1) / 2 == pytest.approx(180.0, abs=1.5)


def test_text_by_its_top_never_reaches_above_it():
    canvas = a_canvas()
    for y in np.arange(100.0, 101.0, 0.1):
        assert canvas.text((10.0, y), "text", 13, BLACK, line="top").top >= y


def test_text_is_cut_only_where_no_wording_fits():
    canvas = a_canvas()
    assert canvas.fitted(["a long wording", "short"], 1000.0, 16) == "a long wording"
    assert canvas.fitted(["a long wording", "short"], 60.0, 16) == "short"
    cut = canvas.fitted(["a long wording", "shorter"], 30.0, 16)
    assert cut.endswith("…")
    assert cut.startswith("sh")
    assert canvas.fitted("anything", 2.0, 16) == ""
    canvas.fit((10.0, 50.0), ["a long wording", "short"], 60.0, 16, BLACK)
    assert canvas.texts[-1].text == "short"


def test_names_are_cut_in_the_middle():
    canvas = a_canvas()
    name = "a long name of an action, number 7"
    assert canvas.abbreviated(name, 1000.0, 16) == name
    cut = canvas.abbreviated(name, 120.0, 16)
    assert cut.startswith("a long")
    assert cut.endswith("r 7")
    assert "…" in cut
    assert canvas.measure(cut, 16) <= 120.0
    assert canvas.abbreviated(name, 2.0, 16) == ""


def test_letters_that_the_face_lacks_become_boxes_and_no_others():
    canvas = a_canvas()
    canvas.text((10.0, 50.0), "e\u0301 λ ? − ทา 🤖 走", 16, BLACK)
    assert canvas.texts[-1].text == "é λ ? − □□ □ 走"


def test_line_breaks_in_names_do_not_break_lines():
    canvas = a_canvas()
    canvas.text((10.0, 50.0), "one\ntwo\tthree", 16, BLACK)
    assert canvas.texts[-1].text == "one two three"
    assert (canvas.pixels[60:] == 255).all()


def test_nothing_is_drawn_outside_of_a_clip():
    canvas = a_canvas()
    part = canvas.clipped(Box(100.0, 100.0, 200.0, 200.0))
    part.disc((100.0, 150.0), 30.0, BLACK)
    part.line([(0.0, 110.0), (640.0, 110.0)], BLACK, 3.0)
    draw_faint_paths(part, np.array([[[0.0, 190.0], [640.0, 190.0]]]), BLACK, 3.0, 0.9)
    part.text((90.0, 170.0), "across the edge of the clip", 16, BLACK)
    assert ink(part) > 1000.0
    assert ink(canvas) == ink(part)
    assert canvas.pixels[110, 150, 0] == 0  # the same coordinates in both


def test_a_copy_is_a_page_of_its_own():
    canvas = a_canvas()
    copy = canvas.copy()
    copy.text((10.0, 50.0), "only here", 16, BLACK)
    assert ink(canvas) == 0.0
    assert not canvas.texts


def test_type_stays_legible_on_the_smallest_page_and_grows_with_the_largest():
    small, large = a_canvas().type, Canvas(3840, 2160, LIGHT).type
    assert small.small >= 8
    assert large.small > 4 * small.small
    for scale in (small, large):
        assert scale.small <= scale.body <= scale.heading < scale.title


@given(
    x=st.floats(-500, 500),
    y=st.floats(-500, 500),
    width=st.floats(0.5, 60),
    height=st.floats(0.5, 60),
)
def test_a_view_shows_its_bounds_with_equal_scales_and_y_up(x, y, width, height):
    box = Box(10.0, 20.0, 410.0, 220.0)
    view = View.around((x, y, x + width, y + height), box)
    corners = view.to_pixels([(x, y), (x + width, y + height)])
    across, down = corners[1] - corners[0]
    assert across == pytest.approx(width * view.scale)
    assert down == pytest.approx(-height * view.scale)
    assert (corners >= (box.left - 1e-6, box.top - 1e-6)).all()
    assert (corners <= (box.right + 1e-6, box.bottom + 1e-6)).all()
    x0, y0, x1, y1 = view.bounds
    assert view.to_pixels([(x0, y1), (x1, y0)]).ravel() == pytest.approx(
        [box.left, box.top, box.right, box.bottom], abs=1e-6
    )


def test_boxes_cut_into_columns_and_rows_share_the_room():
    left, right = Box(0.0, 0.0, 110.0, 50.0).columns((1, 3), 10.0)
    assert (left.right, right.left, right.right) == (25.0, 35.0, 110.0)
    top, bottom = Box(0.0, 0.0, 110.0, 50.0).rows((1, 1), 10.0)
    assert (top.bottom, bottom.top, bottom.bottom) == (20.0, 30.0, 50.0)


def test_the_coverage_of_a_disc_sums_to_its_area():
    assert disc_coverage(10.2, 9.6, 5.0, 20, 20).sum() == pytest.approx(math.pi * 25, rel=0.01)
