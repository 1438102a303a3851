import av
import cv2
import numpy as np
import pytest

from studio.errors import InputError
from studio.painter import mp4
from studio.painter.mp4 import check_codec, write_mp4
from studio.painter.segments import Segment
from tests.films import frames_and_times
from tests.studio.painter.made_up import SIZE, drawn, film, moving

FLAT_BLUE = slice(2, 20), slice(2, -2)
FLAT_WHITE = slice(28, 36), slice(2, -2)
FLAT_GREY = slice(85, 94), slice(2, 8)


@pytest.mark.parametrize(("codec", "name"), [("h264", "h264"), ("av1", "av1")])
def test_mp4_films_say_what_their_colours_mean(tmp_path, codec, name):
    write_mp4(tmp_path / "film.mp4", film(), SIZE, 25, codec)
    with av.open(str(tmp_path / "film.mp4")) as container:
        (stream,) = container.streams
        assert stream.codec_context.codec.canonical_name == name
        assert stream.codec_context.pix_fmt == "yuv420p"
        assert (stream.width, stream.height) == SIZE
        assert stream.average_rate == 25
        # BT.601, limited range
        assert stream.codec_context.colorspace == 5
        assert stream.codec_context.color_range == 1


@pytest.mark.parametrize("codec", ["h264", "av1"])
@pytest.mark.parametrize("size", [(160, 96), (162, 94)])
def test_mp4_films_show_every_frame_as_it_was_drawn(tmp_path, codec, size):
    write_mp4(tmp_path / "film.mp4", film(size), size, 25, codec)
    frames, times = frames_and_times(tmp_path / "film.mp4")
    assert times == pytest.approx([index / 25 for index in range(34)])
    for original, frame in zip(drawn(film(size)), frames, strict=True):
        away = np.abs(original.astype(int) - frame)
        assert away.mean() < 2.0
        # colours are stored for blocks of 2x2 pixels, so edges differ: look at flat ground
        for rows, columns in (FLAT_BLUE, FLAT_WHITE, FLAT_GREY):
            assert away[rows, columns].mean() < 2.0


@pytest.mark.parametrize("codec", ["h264", "av1"])
@pytest.mark.parametrize("lengths", [[1], [1, 5], [2, 5], [5, 1, 5], [1, 18, 1], [2, 2, 2]])
def test_short_segments_are_shown_in_order(tmp_path, codec, lengths):
    first = np.cumsum([0, *lengths])
    segments = [moving(range(at, at + n)) for at, n in zip(first, lengths, strict=False)]
    write_mp4(tmp_path / "film.mp4", segments, SIZE, 25, codec)
    frames, times = frames_and_times(tmp_path / "film.mp4")
    assert times == pytest.approx([index / 25 for index in range(sum(lengths))])
    for original, frame in zip(drawn(segments), frames, strict=True):
        assert np.abs(original.astype(int) - frame).mean() < 2.0


@pytest.mark.parametrize("codec", ["h264", "av1"])
def test_every_segment_begins_with_a_key_frame_to_jump_to(tmp_path, codec):
    write_mp4(tmp_path / "film.mp4", film(), SIZE, 25, codec)
    with av.open(str(tmp_path / "film.mp4")) as container:
        times = [f.pts * f.time_base for f in container.decode(video=0) if f.key_frame]
    assert {0.0, 12 / 25, 24 / 25} <= {float(time) for time in times}


def test_encoding_av1_says_nothing_on_the_terminal(tmp_path, capfd):
    write_mp4(tmp_path / "film.mp4", [moving(range(2))], SIZE, 25, "av1")
    assert capfd.readouterr() == ("", "")


def test_opencv_has_its_threads_back_after_a_film(tmp_path):
    before = cv2.getNumThreads()
    write_mp4(tmp_path / "film.mp4", [moving(range(2))], SIZE, 25)
    assert cv2.getNumThreads() == before


@pytest.mark.parametrize("size", [(641, 360), (640, 361), (4098, 360), (640, 32), (0, 0), (-2, 90)])
def test_sizes_that_no_film_can_have_are_refused_in_one_line(tmp_path, size):
    with pytest.raises(InputError, match=f"size: {size[0]}x{size[1]} pixels is not") as error:
        write_mp4(tmp_path / "film.mp4", film(), size, 25)
    assert "\n" not in str(error.value)


def test_a_codec_that_is_not_known_is_refused_before_anything_is_drawn(tmp_path):
    def frames():
        raise AssertionError

    with pytest.raises(InputError, match="codec: 'vp9' is not known: h264, av1"):
        write_mp4(tmp_path / "film.mp4", [Segment(2, frames)], SIZE, 25, "vp9")


def test_a_codec_that_pyav_was_built_without_is_refused(monkeypatch):
    lacking = mp4._Codec("no-such-encoder", {})
    monkeypatch.setitem(mp4._CODECS, "av1", lacking)
    with pytest.raises(InputError, match="codec: 'av1' is not part of this PyAV: h264"):
        check_codec("av1")
