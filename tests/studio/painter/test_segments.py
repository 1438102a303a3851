"""What all films of segments have in common, whatever their file."""

from pathlib import Path

import pytest

from studio.errors import InputError
from studio.painter.gif import write_gif
from studio.painter.mp4 import write_mp4
from studio.painter.segments import Segment
from tests.studio.painter.made_up import SIZE, film, moving, page


@pytest.mark.parametrize("name", ["h264.mp4", "av1.mp4", "film.gif"])
def test_the_same_frames_give_the_same_bytes(tmp_path, name):
    for folder in ("once", "again"):
        (tmp_path / folder).mkdir()
        if name.endswith("gif"):
            write_gif(tmp_path / folder / name, film(), SIZE, 25)
        else:
            write_mp4(tmp_path / folder / name, film(), SIZE, 25, Path(name).stem)
    assert (tmp_path / "once" / name).read_bytes() == (tmp_path / "again" / name).read_bytes()


@pytest.mark.parametrize("rate", [0, -1, 61, 29.97])
def test_rates_that_no_film_can_have_are_refused(tmp_path, rate):
    with pytest.raises(InputError, match=f"frames_per_second: {rate} is not .* 1 to 60"):
        write_mp4(tmp_path / "film.mp4", film(), SIZE, rate)
    with pytest.raises(InputError, match=f"frames_per_second: {rate} is not .* 1 to 50"):
        write_gif(tmp_path / "film.gif", film(), SIZE, rate)


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
