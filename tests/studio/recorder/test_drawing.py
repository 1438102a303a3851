import numpy as np
import pytest

from studio.recorder.drawing import DASH, DASH_GAP, PAGE_RESOLUTION, Drawing
from studio.style.palette import LIGHT


def test_dashes_follow_a_line_and_leave_gaps():
    drawing = Drawing()
    drawing.dashes(np.array([(0.0, 0.0), (0.3, 0.0), (0.3, 0.2)]), LIGHT.ink)
    lengths = [np.hypot(*np.diff(line, axis=0).T).sum() for line in drawing.lines]
    assert len(lengths) == 0.5 / (DASH + DASH_GAP)
    assert lengths == pytest.approx([DASH] * len(lengths))


def test_an_area_is_filled_from_one_curve_to_the_other():
    drawing, x = Drawing(), np.linspace(0.0, 1.0, 50)
    drawing.fill(x, 0.1 * x, 0.4 + 0.0 * x, LIGHT.grid)
    (points,), (radius,) = drawing.lines, drawing.radii
    assert (points[:, 1] - radius >= 0.1 * points[:, 0] - 1e-12).all()
    assert points[:, 1].max() + radius == pytest.approx(0.4)


def test_places_are_rounded_where_a_drawing_has_a_resolution():
    drawing = Drawing(resolution=PAGE_RESOLUTION)
    drawing.line([(0.1234567, 0.5), (0.7654321, 0.25)], LIGHT.ink)
    steps = drawing.lines[0] / PAGE_RESOLUTION
    np.testing.assert_array_equal(steps, np.round(steps))
