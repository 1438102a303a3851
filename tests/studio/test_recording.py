"""Pictures and films are painted from recordings alone."""

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import av
import cv2
import numpy as np
import pyarrow.parquet as pq
import pytest
from click.testing import Result

from scenes import MetaAction
from studio.errors import InputError
from studio.kinds import read_recording
from studio.orchestrator import Studio
from studio.recording import Excerpt, Look, write_picture
from studio.study.picture.finding import compose_finding
from studio.study.picture.page import compose_study_picture
from studio.study.results import StudyResults
from studio.style.palette import ACTION_COLOURS, DARK, LIGHT
from tests.command_line import run

SMALL = Look(size=(640, 360), frames_per_second=10)
QUICK = ("--size", "640x360", "--fps", "10")


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A recorded scene with its picture and film, and a comparison."""
    out = tmp_path_factory.mktemp("recorded")
    Studio(out).record("doorway", rollouts=4, horizon=1.0)
    Studio(out).compare("doorway", "forward", "stop", names=True, rollouts=4, horizon=1.0)
    return out


def render(*arguments: str | Path) -> Result:
    return run("render", *arguments)


def size_of(path: Path) -> tuple[int, int]:
    if path.suffix == ".png":
        height, width, _ = cv2.imread(str(path)).shape
        return width, height
    with av.open(str(path)) as film:
        stream = film.streams.video[0]
        return stream.width, stream.height


def frames_of(path: Path) -> list[np.ndarray]:
    with av.open(str(path)) as film:
        return [frame.to_ndarray(format="rgb24") for frame in film.decode(video=0)]


def has_colour(path: Path, colour: tuple[int, int, int]) -> bool:
    return bool((cv2.imread(str(path))[..., ::-1] == colour).all(axis=-1).any())


def test_a_recording_is_painted_again_byte_by_byte(folder: Path, tmp_path: Path) -> None:
    for name in ("doorway", "doorway-forward-stop"):
        files = [tmp_path / f"{name}.png", tmp_path / f"{name}.mp4"]
        Studio().render(folder / f"{name}.rrd", *files)
        for file in files:
            assert file.read_bytes() == (folder / file.name).read_bytes()


def test_left_to_itself_it_writes_a_picture_and_a_film_beside_the_recording(
    folder: Path, tmp_path: Path
) -> None:
    recording = tmp_path / "mine.rrd"
    recording.write_bytes((folder / "doorway.rrd").read_bytes())
    result = render(recording, *QUICK)
    assert result.exit_code == 0, result.stderr
    assert sorted(path.name for path in tmp_path.iterdir()) == ["mine.mp4", "mine.png", "mine.rrd"]
    for name in ("mine.png", "mine.mp4"):
        assert size_of(tmp_path / name) == (640, 360)
        assert name in result.stdout


@pytest.mark.parametrize("name", ["doorway", "doorway-forward-stop"])
def test_every_kind_of_file_can_be_painted(name: str, folder: Path, tmp_path: Path) -> None:
    files = {kind: tmp_path / f"x.{kind}" for kind in ("png", "mp4", "gif")}
    options = [part for kind, path in files.items() for part in (f"--{kind}", path)]
    result = render(folder / f"{name}.rrd", *options, *QUICK, "--theme", "dark")
    assert result.exit_code == 0, result.stderr
    for path in files.values():
        assert size_of(path) == (640, 360)
    assert has_colour(files["png"], DARK.ground)
    assert not has_colour(files["png"], LIGHT.ground)


def test_a_film_can_be_av1(folder: Path, tmp_path: Path) -> None:
    options = ("--actions", "stop", "--codec", "av1", *QUICK)
    result = render(folder / "doorway.rrd", "--mp4", tmp_path / "x.mp4", *options)
    assert result.exit_code == 0, result.stderr
    with av.open(str(tmp_path / "x.mp4")) as film:
        assert film.streams.video[0].codec_context.name in ("av1", "libdav1d")
        assert len(list(film.decode(video=0))) > 10


def test_some_actions_keep_the_colours_that_they_have_among_all(
    folder: Path, tmp_path: Path
) -> None:
    picture = tmp_path / "x.png"
    result = render(folder / "doorway.rrd", "--png", picture, "--actions", "turn_left,stop")
    assert result.exit_code == 0, result.stderr
    shown = [has_colour(picture, colour) for colour in ACTION_COLOURS]
    assert shown == [False, False, True, True, False, False, False]
    recording = read_recording(folder / "doorway.rrd")
    texts = [placed.text for placed in recording.still(Look(), Excerpt(("stop",))).texts]
    assert texts.count("stop") == 3 + 3  # at its path, in two tables, and as the pick of all three
    assert "turn left" not in texts


def test_a_film_can_be_cut_to_a_span_of_simulated_time(folder: Path, tmp_path: Path) -> None:
    def frames(*options: str) -> int:
        path = tmp_path / "x.mp4"
        assert render(folder / "doorway.rrd", "--mp4", path, *QUICK, *options).exit_code == 0
        return len(frames_of(path))

    whole = frames("--actions", "stop")  # 1 s, the pause of 0.5 s, the picture for 6 s
    assert whole == 11 + 5 + 60
    assert frames("--actions", "stop", "--from", "0.5") == 6 + 5 + 60
    assert frames("--actions", "stop", "--from", "0.2", "--to", "0.7") == 6 + 5


def test_the_film_of_a_comparison_can_be_cut_to_some_outcomes(folder: Path, tmp_path: Path) -> None:
    path, recording = tmp_path / "x.mp4", folder / "doorway-forward-stop.rrd"
    assert render(recording, "--mp4", path, *QUICK, "--from", "2", "--to", "3").exit_code == 0
    assert len(frames_of(path)) == 2 * 13  # each moves for 0.8 s and stands still for 0.5 s
    assert render(recording, "--mp4", path, *QUICK, "--from", "9").exit_code == 2


def test_a_study_is_painted_as_its_table(study_recording: Path, tmp_path: Path) -> None:
    result = render(
        study_recording, "--png", tmp_path / "x.png", "--mp4", tmp_path / "x.mp4", "--fps", "5"
    )
    assert result.exit_code == 0, result.stderr
    drawn = (study_recording.parent / "learning.png").read_bytes()
    assert (tmp_path / "x.png").read_bytes() == drawn
    frames = frames_of(tmp_path / "x.mp4")
    assert frames[0].shape == (720, 1280, 3)
    assert not np.array_equal(frames[0], frames[-1])
    # it ends with the picture, held for six seconds but for what the codec loses
    last = frames[-6 * 5 :]
    assert max(np.abs(frame.astype(int) - last[-1]).mean() for frame in last) < 1.0
    still = read_recording(study_recording).still(Look(size=(1280, 720)), Excerpt()).pixels
    assert np.abs(last[-1].astype(int) - still).mean() < 4.0


def test_what_was_learned_is_the_second_page_of_a_study(
    study_recording: Path, tmp_path: Path
) -> None:
    result = render(study_recording, "--page", "2", "--png", tmp_path / "x.png")
    assert result.exit_code == 0, result.stderr
    second = study_recording.with_name("learning-2.png").read_bytes()
    assert (tmp_path / "x.png").read_bytes() == second
    assert second != study_recording.with_name("learning.png").read_bytes()


@pytest.mark.parametrize(
    ("page", "kind", "said"),
    [
        ("3", "png", "--page: 3 is not there: 1 to 2"),
        ("0", "png", "--page: 0 is not there: 1 to 2"),
        ("2", "mp4", "--page: goes with a picture, a film shows all pages"),
    ],
)
def test_pages_that_are_not_there_are_refused_in_one_line(
    page: str, kind: str, said: str, study_recording: Path, tmp_path: Path
) -> None:
    result = render(study_recording, "--page", page, f"--{kind}", tmp_path / f"x.{kind}")
    assert result.exit_code == 2
    assert result.stderr == f"studio: {said}\n"
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("name", ["doorway", "doorway-forward-stop"])
def test_the_picture_of_a_scene_or_a_comparison_has_one_page(
    name: str, folder: Path, tmp_path: Path
) -> None:
    result = render(folder / f"{name}.rrd", "--page", "2", "--png", tmp_path / "x.png")
    assert result.exit_code == 2
    assert result.stderr == "studio: --page: 2 is not there: 1\n"
    assert not list(tmp_path.iterdir())


def test_a_study_can_be_cut_to_some_numbers_of_pairs(study_recording: Path) -> None:
    recording = read_recording(study_recording)
    cut = recording.still(Look(), Excerpt(end=10)).pixels
    table = pq.read_table(study_recording.with_suffix(".parquet"))
    of_ten = table.filter(table["pairs"].to_numpy() <= 10)
    results = StudyResults(of_ten, recording.results.teachers)
    assert np.array_equal(cut, compose_finding(results).pixels)
    second = recording.still(Look(), Excerpt(end=10, page=2)).pixels
    assert np.array_equal(second, compose_study_picture(results).pixels)
    with pytest.raises(InputError, match="11 to 29 pairs are not allowed: some of 10, 30"):
        recording.still(Look(), Excerpt(start=11, end=29))


@pytest.mark.parametrize(
    "name",
    [
        "scene-edition-1",
        "scene-edition-2",
        "learning-edition-1",
        "learning-edition-2",
        "comparison-edition-2",
    ],
)
def test_recordings_of_an_older_edition_are_painted(name: str, old: Callable[[str], Path]) -> None:
    recording = old(name)
    result = render(recording, "--fps", "5")
    assert result.exit_code == 0, result.stderr
    assert cv2.imread(str(recording.with_suffix(".png"))).std() > 5.0
    assert len(frames_of(recording.with_suffix(".mp4"))) > 10


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ("--actions fly", "'fly' is not there: forward, slow_down, stop"),
        ("--actions stop,stop", "each can be taken once"),
        ("--size 641x360", "641x360 pixels is not allowed"),
        ("--size 12x9", "12x9 pixels is not allowed"),
        ("--size 99999x99998", "99999x99998 pixels is not allowed"),
        ("--fps 0", "0 is not allowed: a whole number, 1 to 60"),
        ("--fps -5", "-5 is not allowed: a whole number, 1 to 60"),
        ("--png x.png --fps -5", "-5 is not allowed: a whole number, 1 to 60"),
        ("--png x.png --mp4 y.mp4 --gif " + "z" * 300 + ".gif", "cannot be written: File name too"),
        ("--theme pink", "'pink' is not one of 'light', 'dark'"),
        ("--codec vp9", "'vp9' is not one of 'h264', 'av1'"),
        ("--from 0.7 --to 0.2", "0.7 to 0.2 s is not allowed: within 0 to 1 s"),
        ("--to 9", "0 to 9 s is not allowed"),
        ("--png x.jpg", "x.jpg: a name that ends in .png is needed"),
        ("--png x.png --from 0.5", "--from, --to: go with a film"),
    ],
)
def test_what_cannot_be_painted_is_refused_in_one_line(
    options: str, said: str, folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    recording = tmp_path / "doorway.rrd"
    recording.write_bytes((folder / "doorway.rrd").read_bytes())
    result = render(recording, *options.split())
    assert result.exit_code == 2, result.exception
    assert result.stderr.count("\n") == 1
    assert said in result.stderr
    assert [path.name for path in tmp_path.iterdir()] == ["doorway.rrd"]


@pytest.mark.parametrize("options", [(), ("--actions", "stop")])
def test_actions_go_with_scenes_only(
    options: tuple[str, ...], study_recording: Path, tmp_path: Path
) -> None:
    result = render(study_recording, "--png", tmp_path / "x.png", *options)
    assert result.exit_code == (2 if options else 0)
    assert (tmp_path / "x.png").exists() != bool(options)


@pytest.mark.parametrize("kind", ["png", "mp4", "gif"])
def test_an_old_picture_survives_a_full_disk(kind: str, folder: Path, tmp_path: Path) -> None:
    old = tmp_path / f"x.{kind}"
    old.write_text("old")
    command = f"{sys.executable} -m studio render {folder / 'doorway.rrd'} --{kind} {old}"
    # as if the disk were full after 8 kB; Python then ignores the signal and sees an error
    full = subprocess.run(
        ["bash", "-c", f"ulimit -f 8; {command} {' '.join(QUICK)}"],
        check=False,
        capture_output=True,
        text=True,
    )
    assert full.returncode == 1, full.stderr
    assert full.stderr.startswith(f"studio: {old}: cannot be written: ")
    assert full.stderr.count("\n") == 1
    assert [path.name for path in tmp_path.iterdir()] == [old.name]
    assert old.read_text() == "old"


def test_a_codec_that_is_not_there_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("studio.painter.mp4._is_present", lambda name: name == "libx264")
    with pytest.raises(InputError, match="codec: 'av1' is not part of this PyAV: h264"):
        Look(codec="av1")


def test_a_file_named_twice_is_refused(folder: Path, tmp_path: Path) -> None:
    files = [tmp_path / "p.png", tmp_path / "q.png", tmp_path / "." / "q.png"]
    with pytest.raises(InputError, match=r"q\.png: is named twice"):
        Studio().render(folder / "doorway.rrd", *files)


def test_a_gif_of_a_study_may_have_odd_sides(study_recording: Path, tmp_path: Path) -> None:
    options = ("--size", "641x401", "--fps", "2")
    result = render(study_recording, "--gif", tmp_path / "x.gif", *options)
    assert result.exit_code == 0, result.stderr
    assert size_of(tmp_path / "x.gif") == (641, 401)


@pytest.mark.parametrize("fps", ["1", "2"])
def test_films_of_few_frames_are_whole(fps: str, study_recording: Path, tmp_path: Path) -> None:
    result = render(study_recording, "--mp4", tmp_path / "x.mp4", "--fps", fps)
    assert result.exit_code == 0, result.stderr
    with av.open(str(tmp_path / "x.mp4")) as film:
        times = [float(frame.time or 0.0) for frame in film.decode(video=0)]
    assert times == pytest.approx([index / int(fps) for index in range(len(times))])


def test_other_endings_are_refused(folder: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"x\.webm: is not allowed: a name that ends in \.png"):
        Studio().render(folder / "doorway.rrd", tmp_path / "x.webm")
    with pytest.raises(InputError, match=r"x\.webm: is not allowed"):
        write_picture(tmp_path / "x.webm", read_recording(folder / "doorway.rrd"), SMALL)


COMPARE = ("compare", "--scene", "open", "--rollouts", "3", "--horizon", "0.5", "--no-mp4", "--out")


def test_compare_says_by_name_which_action_is_on_which_side_and_how_it_is_valued(
    tmp_path: Path,
) -> None:
    result = run(*COMPARE, tmp_path, "stop", "forward", "--names")
    assert result.exit_code == 0, result.stderr
    read = read_recording(tmp_path / "open-stop-forward.rrd")
    for side, action in zip("AB", read.comparison.rollouts.actions, strict=True):
        assert f"{side}  {action.name}" in result.stdout
    assert "T&K" in result.stdout
    assert (tmp_path / "open-stop-forward.png").exists()


def test_compare_is_blind_unless_told_otherwise_and_loses_no_other_comparison(
    tmp_path: Path,
) -> None:
    told = [run(*COMPARE, tmp_path, *pair) for pair in (("stop", "forward"), ("stop", "slow_down"))]
    assert [result.exit_code for result in told] == [0, 0]
    files = [path.name for path in tmp_path.iterdir()]
    assert len(files) == 4
    assert all(name.startswith("open-compare-") for name in files)
    for words in [*files, *(result.stdout for result in told)]:
        assert not any(name in words for name in ("stop", "forward", "slow", "T&K"))
    again = run(*COMPARE, tmp_path, "forward", "stop")
    assert again.exit_code == 0, again.stderr
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted(files)


def test_names_of_actions_cannot_lead_out_of_the_folder(tmp_path: Path) -> None:
    actions = (MetaAction("left/right", 1.0, 0.0), MetaAction("../up", 0.5, 0.0))
    files = (
        Studio(tmp_path)
        .compare(
            *("open", "left/right", "../up"),
            names=True,
            actions=actions,
            rollouts=2,
            horizon=0.5,
            mp4=False,
        )
        .files
    )
    assert [path.name for path in files] == [
        "open-left_right-.._up.rrd",
        "open-left_right-.._up.png",
    ]
    assert {path.parent for path in files} == {tmp_path}


@pytest.mark.parametrize(
    ("actions", "said"),
    [
        (("forward", "fly"), "'fly' is not there"),
        (("forward", "../../x"), "'../../x' is not there"),
        (("stop", "stop"), "'stop' twice"),
    ],
)
def test_compare_refuses_actions_that_are_not_two(
    actions: tuple[str, str], said: str, tmp_path: Path
) -> None:
    result = run("compare", "--scene", "open", *actions, "--out", tmp_path / "out")
    assert result.exit_code == 2
    assert said in result.stderr
    assert not (tmp_path / "out").exists()
