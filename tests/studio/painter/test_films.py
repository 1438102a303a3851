from pathlib import Path

import av
import cv2
import numpy as np
import pytest

from studio.errors import InputError
from studio.painter import mp4
from studio.painter.gif import write_gif
from studio.painter.mp4 import check_codec, write_mp4
from studio.painter.segments import Segment

SIZE = (160, 96)
FLAT_BLUE = slice(2, 20), slice(2, -2)
FLAT_WHITE = slice(28, 36), slice(2, -2)
FLAT_GREY = slice(85, 94), slice(2, 8)
WHITE, BLUE, RED, GREY = (250, 250, 250), (0, 114, 178), (213, 43, 30), (120, 124, 130)


def page(step, size=SIZE):
    """Flat colours with a disc that moves, and a strip of many greys."""
    pixels = np.full((size[1], size[0], 3), WHITE, np.uint8)
    pixels[: size[1] // 4] = BLUE
    pixels[size[1] // 2 : size[1] // 2 + 8] = np.linspace(0, 255, size[0])[None, :, None]
    pixels[-size[1] // 4 :, : size[0] // 2] = GREY
    cv2.circle(pixels, (20 + 4 * step, 3 * size[1] // 4), 8, RED, cv2.FILLED, cv2.LINE_AA)
    return pixels


def moving(steps, size=SIZE):
    return Segment(len(steps), lambda: (page(step, size) for step in steps))


def film(size=SIZE):
    """Two parts that move and one that stands still."""
    return [moving(range(12), size), moving(range(12, 24), size), moving([24] * 10, size)]


def drawn(segments):
    return [pixels.copy() for segment in segments for pixels in segment.frames()]


def decoded(path):
    """Frames of a film and when they are shown, s."""
    with av.open(str(path)) as container:
        frames = list(container.decode(video=0))
        times = [float(frame.pts * frame.time_base) for frame in frames]
        return [frame.to_ndarray(format="rgb24") for frame in frames], times


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
    frames, times = decoded(tmp_path / "film.mp4")
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
    frames, times = decoded(tmp_path / "film.mp4")
    assert times == pytest.approx([index / 25 for index in range(sum(lengths))])
    for original, frame in zip(drawn(segments), frames, strict=True):
        assert np.abs(original.astype(int) - frame).mean() < 2.0


@pytest.mark.parametrize("codec", ["h264", "av1"])
def test_every_segment_begins_with_a_key_frame_to_jump_to(tmp_path, codec):
    write_mp4(tmp_path / "film.mp4", film(), SIZE, 25, codec)
    with av.open(str(tmp_path / "film.mp4")) as container:
        times = [f.pts * f.time_base for f in container.decode(video=0) if f.key_frame]
    assert {0.0, 12 / 25, 24 / 25} <= {float(time) for time in times}


@pytest.mark.parametrize("name", ["h264.mp4", "av1.mp4", "film.gif"])
def test_the_same_frames_give_the_same_bytes(tmp_path, name):
    for folder in ("once", "again"):
        (tmp_path / folder).mkdir()
        if name.endswith("gif"):
            write_gif(tmp_path / folder / name, film(), SIZE, 25)
        else:
            write_mp4(tmp_path / folder / name, film(), SIZE, 25, Path(name).stem)
    assert (tmp_path / "once" / name).read_bytes() == (tmp_path / "again" / name).read_bytes()


def test_encoding_av1_says_nothing_on_the_terminal(tmp_path, capfd):
    write_mp4(tmp_path / "film.mp4", [moving(range(2))], SIZE, 25, "av1")
    assert capfd.readouterr() == ("", "")


def test_opencv_has_its_threads_back_after_a_film(tmp_path):
    before = cv2.getNumThreads()
    write_mp4(tmp_path / "film.mp4", [moving(range(2))], SIZE, 25)
    assert cv2.getNumThreads() == before


def test_a_gif_shows_what_was_drawn_when_it_was_and_starts_over_for_ever(tmp_path):
    size = (161, 97)
    write_gif(tmp_path / "film.gif", film(size), size, 25)
    assert b"NETSCAPE2.0\x03\x01\x00\x00" in (tmp_path / "film.gif").read_bytes()
    frames, times = decoded(tmp_path / "film.gif")
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
    _, times = decoded(tmp_path / "film.gif")
    assert times == pytest.approx([index / 30 for index in range(31)], abs=0.0051)


def test_a_gif_of_one_frame(tmp_path):
    write_gif(tmp_path / "film.gif", [moving([3])], SIZE, 25)
    (frame,), _ = decoded(tmp_path / "film.gif")
    assert np.abs(frame.astype(int) - page(3)).mean() < 1.0


@pytest.mark.parametrize("size", [(641, 360), (640, 361), (4098, 360), (640, 32), (0, 0), (-2, 90)])
def test_sizes_that_no_film_can_have_are_refused_in_one_line(tmp_path, size):
    with pytest.raises(InputError, match=f"size: {size[0]}x{size[1]} pixels is not") as error:
        write_mp4(tmp_path / "film.mp4", film(), size, 25)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("size", [(1921, 360), (640, 63)])
def test_sizes_that_no_gif_can_have_are_refused_in_one_line(tmp_path, size):
    with pytest.raises(InputError, match=r"size: .* at least 64x64 and at most 1920x1920") as error:
        write_gif(tmp_path / "film.gif", film(), size, 25)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("rate", [0, -1, 61, 29.97])
def test_rates_that_no_film_can_have_are_refused(tmp_path, rate):
    with pytest.raises(InputError, match=f"frames_per_second: {rate} is not .* 1 to 60"):
        write_mp4(tmp_path / "film.mp4", film(), SIZE, rate)
    with pytest.raises(InputError, match=f"frames_per_second: {rate} is not .* 1 to 50"):
        write_gif(tmp_path / "film.gif", film(), SIZE, rate)


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


def test_progress_counts_every_frame_of_a_film_and_both_rounds_of_a_gif(tmp_path):
    told = []
    segments = [moving(range(3)), moving([3, 3])]
    write_mp4(
        tmp_path / "film.mp4", segments, SIZE, 30, progress=lambda *counts: told.append(counts)
    )
    assert told == [(done, 5) for done in range(1, 6)]
    told.clear()
    write_gif(tmp_path / "film.gif", segments, SIZE, 30, lambda *counts: told.append(counts))
    assert told == [(done, 10) for done in range(1, 11)]


@pytest.mark.parametrize("write", [write_mp4, write_gif])
def test_a_failure_while_drawing_comes_through_and_leaves_no_film(tmp_path, write):
    def frames():
        yield page(0)
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        write(tmp_path / "film", [Segment(2, frames)] * 3, SIZE, 30)
    assert not (tmp_path / "film").exists()


@pytest.mark.parametrize("write", [write_mp4, write_gif])
@pytest.mark.parametrize("path", [Path("/nowhere/film"), Path("/dev/full")])
def test_a_film_that_cannot_be_written_is_no_silent_failure(write, path):
    with pytest.raises(OSError, match=r"No such file|No space left|denied"):
        write(path, [moving(range(3))], SIZE, 30)


def test_frames_may_be_drawn_over_one_another(tmp_path):
    """A frame need last only until the next one is asked for."""

    def frames():
        pixels = page(0)
        for step in range(12):
            pixels[:] = page(step)
            yield pixels

    reused, fresh = Segment(12, frames), moving(range(12))
    for name, segment in (("reused", reused), ("fresh", fresh)):
        write_mp4(tmp_path / f"{name}.mp4", [segment], SIZE, 30)
        write_gif(tmp_path / f"{name}.gif", [segment], SIZE, 30)
    for suffix in ("mp4", "gif"):
        reused_bytes = (tmp_path / f"reused.{suffix}").read_bytes()
        assert reused_bytes == (tmp_path / f"fresh.{suffix}").read_bytes()
