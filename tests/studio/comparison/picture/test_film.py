import itertools

import numpy as np
import pytest

from scenes import Pedestrian, Robot, Scene, simulate
from studio.comparison.comparison import side_by_side
from studio.comparison.picture.film import (
    Pace,
    compose_comparison_film,
    play_outcomes,
    replay,
    scenes_at_rest,
)
from studio.comparison.picture.page import compose_comparison_picture, lay_out_comparison
from studio.comparison.telling import telling_outcomes
from studio.errors import InputError
from studio.painter.mp4 import write_mp4
from studio.style.palette import LIGHT
from studio.style.words import action_label
from tests.canvases import check_texts, red_pixels, texts
from tests.films import frames_of
from tests.studio.comparison.made_up import NAMES, SIZE, a_comparison


@pytest.mark.parametrize(
    "draw", [scenes_at_rest, lambda page: next(play_outcomes(page, Pace.of(1, 0.5, 10), range(1)))]
)
def test_who_stands_on_the_goal_does_not_hide_it(draw):
    standing = Pedestrian((1.5, 0.0), (1.5, 0.0), desired_speed=0.0)
    scene = Scene("a-scene", Robot((0.0, 0.0), (1.5, 0.0)), (standing,))
    page = lay_out_comparison(side_by_side(simulate(scene, rollouts=1, horizon=0.5), *NAMES), SIZE)
    canvas = draw(page)
    for view in page.views:
        x, y = view.to_pixels((1.5, 0.0)).astype(int)
        assert (canvas.pixels[y, x] == LIGHT.ink).all()
        beside = canvas.pixels[y - 20 : y + 20, x - 20 : x + 20]
        assert (beside == LIGHT.pedestrian).all(axis=-1).any()


@pytest.fixture(scope="module")
def film(comparison, tmp_path_factory):
    path = tmp_path_factory.mktemp("film") / "film.mp4"
    write_mp4(path, compose_comparison_film(comparison, SIZE, 30), SIZE, 30)
    return path, frames_of(path)


def drawn(comparison, frames_per_second=30):
    segments = compose_comparison_film(comparison, SIZE, frames_per_second)
    frames = [[frame.copy() for frame in segment.frames()] for segment in segments]
    assert [len(part) for part in frames] == [segment.length for segment in segments]
    return list(itertools.chain(*frames))


def test_the_film_rests_shows_every_outcome_then_two_of_them_again_and_ends_with_the_picture(
    comparison, film
):
    frames, pace = drawn(comparison), Pace.of(5, 0.5, 30)
    ending = 6 * 30
    playing = int(pace.frames.sum())
    assert len(frames) == len(film[1]) == 30 + playing + 2 * pace.frames_of_replay + ending
    picture = compose_comparison_picture(comparison, SIZE).pixels
    for frame, decoded in list(zip(frames, film[1], strict=True))[-ending :: ending - 1]:
        np.testing.assert_array_equal(frame, picture)
        assert np.abs(decoded.astype(int) - picture).mean() < 2.0
    for frame in frames[1:30]:
        np.testing.assert_array_equal(frame, frames[0])
    assert not np.array_equal(frames[30], frames[31])


def test_the_same_input_gives_the_same_bytes(comparison, film, tmp_path):
    write_mp4(tmp_path / "again.mp4", compose_comparison_film(comparison, SIZE, 30), SIZE, 30)
    assert (tmp_path / "again.mp4").read_bytes() == film[0].read_bytes()


@pytest.mark.parametrize("size", [SIZE, (1274, 714)])
def test_a_part_that_starts_later_goes_on_where_the_one_before_it_stopped(size):
    page, pace = lay_out_comparison(a_comparison(rollouts=30), size), Pace.of(30, 0.5, 5)
    whole = [canvas.pixels.copy() for canvas in play_outcomes(page, pace, range(30))]
    later = [canvas.pixels.copy() for canvas in play_outcomes(page, pace, range(28, 30))]
    for first, second in zip(whole[-len(later) :], later, strict=True):
        np.testing.assert_array_equal(first, second)


def test_counts_grow_as_outcomes_come_to_their_end(comparison):
    page, pace = lay_out_comparison(comparison, SIZE), Pace.of(5, 0.5, 10)
    assert not any("contact" in text or "so far" in text for text in texts(scenes_at_rest(page)))
    told = [texts(canvas) for canvas in play_outcomes(page, pace, range(5))]
    touched, ends = comparison.rollouts.touched[0], np.cumsum(pace.frames)
    for outcome, last in enumerate(ends):
        start, end = told[last - pace.frames[outcome]], told[last - 1]
        assert any(text.startswith(f"Outcome {outcome + 1} of 5") for text in start)
        so_far = f"{touched[:outcome].sum()} of {outcome} so far"
        assert (so_far in start) == (outcome > 0)
        ended = "5 with contact" if outcome == 4 else f"{outcome + 1} so far"
        assert f"{touched[: outcome + 1].sum()} of {ended}" in end
        assert sum(text.endswith(ended) for text in end) == 2
        # how sure the share is comes when all have been shown
        assert any("[12, 77]" in text for text in end) == (outcome == 4)
    check_texts(scenes_at_rest(page))


def test_the_robot_turns_red_when_it_touches_something_and_not_before(comparison):
    page, pace = lay_out_comparison(comparison, SIZE), Pace.of(5, 0.5, 10)
    reds = [red_pixels(canvas.pixels) for canvas in play_outcomes(page, pace, range(1))]
    before = int(2 / 5 * pace.moving[0]) - 1  # contact is at step 2 of 5
    assert reds[:before] == [0] * before
    assert min(reds[before + 1 :]) > 20


@pytest.mark.parametrize("size", [SIZE, (1920, 1080)])
def test_texts_stay_apart_all_along(unusual, size):
    page = lay_out_comparison(unusual, size)
    count = page.sample.count
    pace = Pace.of(count, page.rollouts.horizon, 30)
    check_texts(scenes_at_rest(page))
    for canvas in itertools.islice(play_outcomes(page, pace, [count - 1]), 0, None, 20):
        check_texts(canvas)
    for telling in telling_outcomes(page.rollouts):
        check_texts(next(replay(page, pace, telling)))


def test_no_frame_of_a_blind_film_names_an_action(comparison):
    page, pace = lay_out_comparison(comparison, SIZE), Pace.of(5, 0.5, 10)
    [worst, typical] = telling_outcomes(page.rollouts)
    frames = (
        scenes_at_rest(page),
        *play_outcomes(page, pace, range(5)),
        *replay(page, pace, worst),
    )
    for canvas in itertools.chain(frames, replay(page, pace, typical)):
        for name in comparison.actions:
            assert not any(action_label(name) in text for text in texts(canvas))


def test_the_worst_and_the_typical_outcome_play_once_more_as_what_they_are(comparison):
    page, pace = lay_out_comparison(comparison, (1280, 720)), Pace.of(5, 0.5, 10)
    for telling in telling_outcomes(page.rollouts):
        shown = [canvas.pixels.copy() for canvas in replay(page, pace, telling)]
        assert len(shown) == pace.frames_of_replay
        told = texts(next(replay(page, pace, telling)))
        for place in telling.places:
            assert f"{telling.name} outcome: no. {place + 1} of 5" in told
        assert any(text.startswith(f"Once more: the {telling.name} outcome") for text in told)
        moving = int(pace.moving[0])
        np.testing.assert_array_equal(shown[-1], shown[moving])
        assert not np.array_equal(shown[0], shown[moving])


@pytest.mark.parametrize("horizon", [0.1, 4.0, 10.0])
@pytest.mark.parametrize("count", [1, 2, 7, 50, 300])
def test_the_first_three_play_slowly_and_the_others_fast(count, horizon):
    pace = Pace.of(count, horizon, 30)
    seconds = pace.frames / 30
    assert (seconds >= 0.1).all()
    assert (seconds <= 6.5).all()
    assert seconds[3:].sum() <= 32.0
    assert (pace.moving >= 1).all()
    assert (pace.moving <= pace.frames).all()
    if horizon == 4.0:
        np.testing.assert_allclose(horizon / (pace.moving[:3] / 30), 2.5, rtol=0.05)
        assert pace.told(0, horizon) == "2.5× real time"
    if (count, horizon) == (50, 4.0):
        assert (np.abs(seconds[3:] - 0.4) < 0.05).all()


def test_a_part_of_a_film_has_neither_rest_nor_replay_nor_picture(comparison):
    pace = Pace.of(5, 0.5, 30)

    def lengths(span):
        return sum(each.length for each in compose_comparison_film(comparison, SIZE, 30, span=span))

    assert lengths((2, 4)) == pace.frames[1:4].sum()
    assert lengths((1, 4)) == 30 + pace.frames[:4].sum()
    assert lengths((5, 5)) == pace.frames[4] + 2 * pace.frames_of_replay + 180
    with pytest.raises(InputError, match="outcomes 2 to 6 are not allowed: within 1 to 5"):
        lengths((2, 6))


def test_odd_sizes_are_refused_and_a_file_that_cannot_be_written_is_reported(comparison, tmp_path):
    with pytest.raises(InputError, match="641x361 pixels is not allowed"):
        write_mp4(
            tmp_path / "film.mp4",
            compose_comparison_film(comparison, (641, 361), 30),
            (641, 361),
            30,
        )
    with pytest.raises(FileNotFoundError):
        compose_comparison_picture(comparison, SIZE).save(tmp_path / "no" / "picture.png")


@pytest.mark.parametrize("count", [1, 7, 50, 300])
def test_parts_of_a_film_follow_one_another_and_are_about_as_long(count):
    pace = Pace.of(count, 4.0, 30)
    parts = pace.parts(range(count))
    assert list(itertools.chain(*parts)) == list(range(count))
    lengths = [pace.frames[part].sum() for part in parts]
    assert max(lengths) <= sum(lengths) / 8 + pace.frames.max()
