import dataclasses
import itertools

import av
import numpy as np
import pytest

from scenes import META_ACTIONS, MetaAction, Pedestrian, Robot, Scene, simulate
from studio.errors import InputError
from studio.painter.boxes import Box
from studio.painter.canvas import Canvas
from studio.painter.mp4 import write_mp4
from studio.scene.judgements import judge
from studio.scene.picture.crowd import Ghosts, Trails
from studio.scene.picture.film import (
    compose_film,
    frame_times,
    lay_out_film,
    play_action,
    play_speed,
    telling_order,
)
from studio.scene.picture.page import compose_picture
from studio.scene.picture.so_far import courses
from studio.style.palette import LIGHT
from tests.canvases import check_texts, red_pixels, texts
from tests.films import frames_of

SIZE = (640, 360)
MANY_ACTIONS = tuple(MetaAction(f"action number {index}", 0.1 * index, 0.0) for index in range(20))


def some_rollouts(actions=META_ACTIONS[:2], people=2, rollouts=4, horizon=0.4):
    scene = Scene(
        name="a-scene",
        robot=Robot(start=(40.0, 20.0), goal=(46.0, 20.0)),
        pedestrians=tuple(
            Pedestrian((42.0 + i, 20.5), (38.0, 20.5), desired_speed=0.8) for i in range(people)
        ),
        groups=((0, 1),) if people > 1 else (),
    )
    return simulate(scene, actions, rollouts=rollouts, horizon=horizon)


@pytest.fixture(scope="module")
def default():
    rollouts = some_rollouts()
    return rollouts, judge(rollouts)


@pytest.fixture(scope="module")
def film(default, tmp_path_factory):
    path = tmp_path_factory.mktemp("film") / "film.mp4"
    write_mp4(path, compose_film(*default, SIZE, 30), SIZE, 30)
    return path


def drawn(rollouts, judgements, size=SIZE):
    segments = compose_film(rollouts, judgements, size, 30)
    return [[frame.copy() for frame in segment.frames()] for segment in segments]


def _part(frame, box):
    return frame[round(box.top) : round(box.bottom), round(box.left) : round(box.right)]


def atoms(path):
    """Types of the top-level boxes of an MP4 file, in order."""
    data, at, found = path.read_bytes(), 0, []
    while at < len(data):
        found.append(data[at + 4 : at + 8].decode())
        at += int.from_bytes(data[at : at + 4], "big")
    return found


def test_the_film_plays_in_every_player(default, film):
    with av.open(str(film)) as container:
        (stream,) = container.streams
        codec = stream.codec_context
        assert codec.name == "h264"
        assert codec.pix_fmt == "yuv420p"
        assert (codec.width, codec.height) == SIZE
        assert stream.average_rate == 30
        # BT.601, limited range
        assert (codec.colorspace, codec.color_range) == (5, 1)
        packets = [packet for packet in container.demux(stream) if packet.size]
        assert sorted(packet.pts for packet in packets) == [
            packets[0].pts + index * (packets[1].duration) for index in range(len(packets))
        ]
        assert all(late.dts > early.dts for early, late in itertools.pairwise(packets))
    assert atoms(film).index("moov") < atoms(film).index("mdat")


def test_the_film_has_every_frame_of_every_action_and_of_the_ending(default, film):
    rollouts, _ = default
    frames = frames_of(film)
    played = len(frame_times(0.0, rollouts.horizon, play_speed(rollouts.horizon), 30))
    assert played == 1 + round(rollouts.horizon * 30) + 15
    assert not rollouts.touched.any()
    # the picture that sums everything up is held for six seconds
    assert len(frames) == 2 * played + 180


def test_every_action_begins_with_a_key_frame_to_jump_to(default, film):
    rollouts, _ = default
    played = len(frame_times(0.0, rollouts.horizon, play_speed(rollouts.horizon), 30))
    with av.open(str(film)) as container:
        keys = [frame.pts for frame in container.decode(video=0) if frame.key_frame]
        step = round(1 / (30 * container.streams.video[0].time_base))
    assert {0, played * step, 2 * played * step} <= set(keys)


def test_decoded_colours_are_the_drawn_ones(default, film):
    frames = frames_of(film)
    originals = itertools.chain(*drawn(*default))
    for drawn_frame, frame in list(zip(originals, frames, strict=True))[::8]:
        away = np.abs(drawn_frame.astype(int) - frame)
        assert away.mean() < 2.0
        # colours are stored for blocks of 2x2 pixels, so edges differ: look at flat ground
        assert np.abs(np.median(drawn_frame.astype(int) - frame, axis=(0, 1))).max() <= 1
    assert np.abs(compose_picture(*default, SIZE).pixels.astype(int) - frames[-1]).mean() < 2.0


def test_the_same_input_gives_the_same_bytes(default, film, tmp_path):
    write_mp4(tmp_path / "again.mp4", compose_film(*default, SIZE, 30), SIZE, 30)
    assert (tmp_path / "again.mp4").read_bytes() == film.read_bytes()


def with_contacts(rollouts, **steps):
    """The rollouts with everybody touching something at these steps."""
    never = np.full_like(rollouts.person_step, -1)
    given = {name: never + 1 + steps.get(name, -1) for name in ("person_step", "wall_step")}
    return dataclasses.replace(rollouts, **given)


def test_robots_turn_red_when_they_touch_something_and_not_before(default):
    rollouts, _ = default
    touching = with_contacts(rollouts, person_step=3)
    page = lay_out_film(touching, (1280, 720))
    reds = []
    for canvas in play_action(page, 0, np.array([0.0, 0.2, 0.3, 0.4])):
        said = texts(canvas)
        assert f"{4 if len(reds) > 1 else 0} of 4" in said
        # the last of these is the end, which says how sure the share is
        end = "a person: 100 % [51, 100]" if len(reds) == 3 else "touch a person so far"
        assert end in said
        reds.append(red_pixels(canvas.pixels))
    assert reds[:2] == [0, 0]
    assert min(reds[2:]) > 500


@pytest.mark.parametrize("thing", ["person", "wall"])
def test_the_first_contact_stands_still_and_is_named(default, thing):
    rollouts, judgements = default
    touching = with_contacts(rollouts, **{f"{thing}_step": 2})
    first, *_ = compose_film(touching, judgements, SIZE, 30)
    frames = [frame.copy() for frame in first.frames()]
    still = [np.array_equal(*pair) for pair in itertools.pairwise(frames)]
    moving = 1 + round(rollouts.horizon * 30)
    halted, pause = len(frames) - moving - 15, 15
    assert halted == 21
    assert sum(still) >= halted - 1 + pause
    page = lay_out_film(touching, SIZE)
    (canvas,) = play_action(page, 0, np.array([0.2]))
    assert f"first contact: a {thing}, 0.2 s" in texts(canvas)
    (later,) = play_action(page, 0, np.array([0.3]))
    assert not any("first contact" in text for text in texts(later))


def test_people_and_walls_that_are_touched_are_told_apart(default):
    rollouts, _ = default
    pictures = []
    for steps in ({"person_step": 2}, {"wall_step": 2}):
        touching = with_contacts(rollouts, **steps)
        (canvas,) = play_action(lay_out_film(touching, SIZE), 0, np.array([0.4]))
        pictures.append(canvas.pixels.copy())
    assert not np.array_equal(*pictures)


def test_actions_on_which_teachers_disagree_come_first_then_those_with_contacts(default):
    rollouts, (one, other, _) = default
    rollouts = with_contacts(some_rollouts(META_ACTIONS[:4]), person_step=-1)
    rollouts.person_step[2] = 1
    draws = np.zeros((10, 4))
    one = dataclasses.replace(
        one, values=np.array([0.4, 0.3, 0.2, 0.1]), resampled=draws + np.array([4, 3, 2, 1])
    )
    same = dataclasses.replace(other, values=one.values, resampled=one.resampled)
    assert telling_order(rollouts, [one, same]) == [2, 0, 1, 3]
    differs = dataclasses.replace(
        other, values=np.array([0.1, 0.3, 0.2, 0.4]), resampled=draws + np.array([1, 3, 2, 4])
    )
    assert telling_order(rollouts, [one, differs]) == [0, 3, 2, 1]
    assert telling_order(rollouts, []) == [2, 0, 1, 3]
    first, *_ = drawn(rollouts, [one, differs])
    page = lay_out_film(rollouts, SIZE)
    (canvas,) = play_action(page, 0, np.array([0.0]))
    side = canvas.clipped(page.side).pixels
    assert np.array_equal(_part(first[0], page.side), side)


def test_a_film_of_a_sample_says_so_and_ends_with_what_all_rollouts_tell(default):
    rollouts, judgements = default
    few = with_contacts(rollouts).keep_paths(3)
    few.person_step[0, 3] = 2  # in the rollout whose path is not kept
    page = lay_out_film(few, (1280, 720))
    said = [texts(canvas) for canvas in play_action(page, 0, np.array([0.2, 0.4]))]
    assert any("2 actions × 4 rollouts" in text for text in said[0])
    assert any("a sample, 3 of 4 rollouts" in text for text in said[0])
    assert "0 of 3" in said[1]
    assert any(text.startswith("a person: 25 % [") for text in said[1])
    assert any(text.endswith("of all 4") for text in said[1])
    (second,) = play_action(page, 1, np.array([0.4]))
    assert "× 1 of 4" in texts(second)
    *_, ending = drawn(few, judgements)
    assert np.array_equal(ending[0], compose_picture(few, judgements, SIZE).pixels)


def test_histograms_of_all_actions_have_one_scale_from_the_start(default):
    rollouts, _ = default
    gap, progress = courses(rollouts)
    ends = [np.histogram(own[:, -1], progress.edges)[0].max() for own in progress.values]
    assert progress.most == max(ends)
    assert gap.most >= 1
    page = lay_out_film(rollouts, SIZE)
    for index in range(2):
        shown = play_action(page, index, np.array([0.0, 0.4]))
        assert all(str(progress.most) in texts(canvas) for canvas in shown)


@pytest.mark.parametrize("size", [(640, 360), (3840, 2160)])
@pytest.mark.parametrize(
    "case",
    [
        {},
        {"people": 0},
        {"actions": META_ACTIONS[:1], "rollouts": 1},
        {"actions": MANY_ACTIONS, "rollouts": 2, "horizon": 0.1},
        {"rollouts": 60, "horizon": 30.0},
    ],
    ids=["default", "nobody", "one rollout", "many actions", "long"],
)
def test_texts_stay_on_the_page_and_off_one_another(case, size):
    rollouts = some_rollouts(**case)
    page, last = lay_out_film(rollouts, size), len(rollouts.actions) - 1
    for canvas in play_action(page, last, np.linspace(0.0, rollouts.horizon, 3)):
        check_texts(canvas)


def test_the_film_runs_in_real_time_or_faster_and_says_so(default):
    assert play_speed(1.0) == 1
    assert play_speed(4.0) == 2
    assert 20.0 / play_speed(20.0) <= 2.0
    assert 1000.0 / play_speed(1000.0) <= 2.0
    rollouts, _ = default
    (canvas,) = play_action(lay_out_film(rollouts, SIZE), 0, np.array([0.2]))
    assert any("1× real time" in text.text for text in canvas.texts)
    assert any(text.text == "0.2 s of 0.4 s" for text in canvas.texts)


def test_ghosts_that_overlap_grow_darker_and_those_out_of_view_are_left_out():
    pixels = np.full((100, 200, 3), 255, np.uint8)
    ghosts = Ghosts(pixels.shape[:2], 10.0, 0.2)
    centres = np.array([[50.0, 50.0]] + [[150.0, 50.0]] * 3 + [[-500.0, 1e7], [200.0, 50.0]])
    ghosts.draw(pixels, centres, (0, 0, 0))
    assert pixels[50, 50, 0] == pytest.approx(255 * 0.8, abs=2)
    assert pixels[50, 150, 0] == pytest.approx(255 * 0.8**3, abs=2)
    assert pixels[50, 199, 0] == pytest.approx(255 * 0.8, abs=2)
    assert pixels[5, 5, 0] == 255


def test_trails_drawn_bit_by_bit_are_as_dark_as_drawn_at_once():
    canvas = Canvas(3200, 1800, LIGHT).clipped(Box(0.0, 0.0, 200.0, 100.0))
    paths = np.stack([np.linspace(20.0, 180.0, 11), np.linspace(30.0, 70.0, 11)], axis=-1)[
        None
    ].repeat(3, axis=0)
    slowly = Trails(canvas, paths, (0, 0, 0), 0.3)
    for step in np.linspace(0.0, 10.0, 40):
        bit_by_bit = slowly.drawn_to(step)
    at_once = Trails(canvas, paths, (0, 0, 0), 0.3).drawn_to(10.0)
    assert np.abs(bit_by_bit.astype(int) - at_once).mean() < 0.5
    assert bit_by_bit[50, 100, 0] == pytest.approx(255 * 0.7**3, abs=2)


@pytest.mark.parametrize("size", [(641, 360), (640, 361)])
def test_odd_sizes_are_refused_in_one_line(default, tmp_path, size):
    with pytest.raises(InputError, match=f"size: {size[0]}x{size[1]} pixels is not") as error:
        write_mp4(tmp_path / "film.mp4", compose_film(*default, size, 30), size, 30)
    assert "\n" not in str(error.value)
    assert not (tmp_path / "film.mp4").exists()
