import av
import numpy as np
import pytest

from studio.errors import InputError
from studio.painter.gif import write_gif
from tests.films import frames_and_times, frames_of
from tests.studio.painter.made_up import SIZE, drawn, film, moving, page


def test_a_gif_shows_what_was_drawn_when_it_was_and_starts_over_for_ever(tmp_path):
    size = (161, 97)
    write_gif(tmp_path / "film.gif", film(size), size, 25)
    assert b"NETSCAPE2.0\x03\x01\x00\x00" in (tmp_path / "film.gif").read_bytes()
    frames, times = frames_and_times(tmp_path / "film.gif")
    # the ten that stand still are one
    assert times == pytest.approx([index / 25 for index in range(25)])
    for original, frame in zip(drawn(film(size)), frames, strict=False):
        away = np.abs(original.astype(int) - frame)
        assert away.mean() < 1.0
        assert away.max() <= 12


def test_a_gif_lasts_as_long_as_its_frames_and_holds_the_last(tmp_path):
    write_gif(tmp_path / "film.gif", film(), SIZE, 25)
    with av.open(str(tmp_path / "film.gif")) as container:
        assert container.duration == pytest.approx(34 / 25 * 1e6, abs=1e4)
        *_, last = container.decode(video=0)
        assert last.duration * last.time_base == pytest.approx(10 / 25)


def test_a_gif_keeps_time_though_it_counts_hundredths_of_a_second(tmp_path):
    write_gif(tmp_path / "film.gif", [moving(range(31))], SIZE, 30)
    _, times = frames_and_times(tmp_path / "film.gif")
    assert times == pytest.approx([index / 30 for index in range(31)], abs=0.0051)


def test_a_gif_of_one_frame(tmp_path):
    write_gif(tmp_path / "film.gif", [moving([3])], SIZE, 25)
    (frame,) = frames_of(tmp_path / "film.gif")
    assert np.abs(frame.astype(int) - page(3)).mean() < 1.0


@pytest.mark.parametrize("size", [(1921, 360), (640, 63)])
def test_sizes_that_no_gif_can_have_are_refused_in_one_line(tmp_path, size):
    with pytest.raises(InputError, match=r"size: .* at least 64x64 and at most 1920x1920") as error:
        write_gif(tmp_path / "film.gif", film(), size, 25)
    assert "\n" not in str(error.value)
