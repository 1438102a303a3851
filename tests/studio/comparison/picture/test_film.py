import dataclasses
import itertools

import av
import cv2
import numpy as np
import pytest

from scenes import META_ACTIONS, MetaAction, Pedestrian, Robot, Scene, Wall, simulate
from studio.comparison.comparison import QUESTION, compare
from studio.comparison.dots import DotMeasure, DotScale, dot_measures
from studio.comparison.picture.dots import IconArray
from studio.comparison.picture.film import (
    Pace,
    compose_comparison_film,
    play_outcomes,
    scenes_at_rest,
)
from studio.comparison.picture.page import (
    compose_comparison_picture,
    lay_out_comparison,
)
from studio.errors import InputError
from studio.painter.canvas import Box, Canvas
from studio.painter.encode import write_mp4
from studio.style.palette import DARK, LIGHT

SIZE = (640, 360)
NAMES = ("forward", "slow_down")
LONG = "a_long_name_of_an_action_that_goes_on_and_on_and_then_goes_on_for_quite_a_while"


def a_comparison(people=3, rollouts=5, horizon=0.5, name="a-scene", names=NAMES, contact=None):
    starts = [(1.5 + 0.6 * (index % 6), -1.2 + 0.5 * (index // 6)) for index in range(people)]
    scene = Scene(
        name=name,
        robot=Robot(start=(0.0, 0.0), goal=(6.0, 0.5)),
        pedestrians=tuple(Pedestrian(start, (-9.0, start[1])) for start in starts),
        walls=(Wall((-2.0, 3.0), (7.0, 3.0)),),
        groups=((0, 1),) if people > 1 else (),
    )
    actions = (
        MetaAction(names[0], 1.0, 0.0),
        *META_ACTIONS[2:4],
        MetaAction(names[1], 0.5, 0.0),
    )
    simulated = simulate(scene, actions, rollouts=rollouts, horizon=horizon)
    comparison = compare(simulated, *names, seed=1)
    if contact is None:
        return comparison
    steps = np.where(np.array(contact), 2, -1)
    return dataclasses.replace(
        comparison, rollouts=dataclasses.replace(comparison.rollouts, contact_step=steps)
    )


CASES = {
    "default": {},
    "nobody": {"people": 0},
    "one outcome": {"rollouts": 1, "people": 1},
    "seven outcomes, one step": {"rollouts": 7, "horizon": 0.1},
    "forty people, many outcomes": {"rollouts": 200, "people": 40},
    "very many outcomes": {"rollouts": 1200, "people": 1},
    "long names": {"name": "W" * 64, "names": (LONG, f"{LONG}_and_on")},
}


@pytest.fixture(scope="module", params=CASES)
def unusual(request):
    return a_comparison(**CASES[request.param])


@pytest.fixture(scope="module")
def comparison():
    return a_comparison(contact=((True, False, True, False, False), (False,) * 5))


def texts(canvas):
    return [placed.text for placed in canvas.texts]


def red_pixels(pixels):
    return int((pixels == LIGHT.contact).all(axis=-1).sum())


def check_texts(canvas):
    for placed in canvas.texts:
        assert canvas.box.contains(placed.box), placed
    for first, second in itertools.combinations(canvas.texts, 2):
        assert not first.box.overlaps(second.box), (first, second)


# The picture


@pytest.mark.parametrize("size", [(640, 360), (1280, 720), (1000, 1400)])
def test_texts_stay_on_the_page_and_off_one_another(unusual, size):
    canvas = compose_comparison_picture(unusual, size)
    check_texts(canvas)
    assert canvas.texts[0].text == QUESTION


def test_texts_stay_apart_on_a_large_page(comparison):
    check_texts(compose_comparison_picture(comparison, (3840, 2160)))


def test_the_page_names_both_sides_and_counts_their_contacts(comparison):
    told = texts(compose_comparison_picture(comparison))
    left, right = (action.name.replace("_", " ") for action in comparison.rollouts.actions)
    assert told.index("A") < told.index(left) < told.index("B") < told.index(right)
    assert told.index("2 of 5 with contact") < told.index("0 of 5 with contact")
    for axis in ("progress towards the goal, m", "smallest gap to a person, m"):
        assert told.count(axis) == 2


def test_both_sides_have_the_same_axes(comparison):
    page = lay_out_comparison(comparison, (1600, 900))
    for plot in page.plots:
        left, right = plot.rooms
        assert left.width == pytest.approx(right.width)
        assert left.bottom == right.bottom
    assert page.views[0].scale == page.views[1].scale
    assert page.views[0].centre == page.views[1].centre


def test_an_action_keeps_the_colour_that_it_has_among_all_actions(comparison):
    pixels = compose_comparison_picture(comparison).pixels
    names = list(comparison.actions)
    for side, action in enumerate(comparison.rollouts.actions):
        theme = LIGHT.of(names)
        half = pixels[:, :800] if side == 0 else pixels[:, 800:]
        assert (half == theme.action_colour(action.name)).all(axis=-1).sum() > 300


def test_red_appears_if_and_only_if_something_was_touched(comparison):
    width = 1600
    pixels = compose_comparison_picture(comparison, (width, 900)).pixels
    assert red_pixels(pixels[:, : width // 2]) > 300
    assert red_pixels(pixels[:, width // 2 :]) == 0


def test_the_png_shows_what_was_drawn_in_either_theme(comparison, tmp_path):
    for theme in (LIGHT, DARK):
        compose_comparison_picture(comparison, (641, 361), theme).save(tmp_path / "picture.png")
        pixels = cv2.cvtColor(cv2.imread(str(tmp_path / "picture.png")), cv2.COLOR_BGR2RGB)
        assert np.array_equal(
            pixels, compose_comparison_picture(comparison, (641, 361), theme).pixels
        )
        assert 0.2 < (pixels == theme.ground).all(axis=-1).mean() < 0.95


# Dots


@pytest.mark.parametrize("count", [1, 7, 50, 200])
def test_icons_fill_up_from_both_ends_and_have_room(count):
    room = Box(10.0, 10.0, 510.0, 50.0)
    array = IconArray.fit(room, count, 22.0)
    assert room.inset(-1e-6).contains(array.box)
    for touched, others in ((0, 0), (count // 3, count // 2), (count // 2, count - count // 2)):
        canvas = Canvas(640, 360, LIGHT)
        array.draw(canvas, touched, others, (0, 0, 200))
        middles = [
            canvas.pixels[
                int(array.box.top + down),
                int(array.box.left + across),
            ]
            for across, down in array.grid.places()
        ]
        red = [bool((middle == LIGHT.contact).all()) for middle in middles]
        waiting = [bool((middle == LIGHT.grid).all()) for middle in middles]
        assert red == [index < touched for index in range(count)]
        assert waiting == [touched <= index < count - others for index in range(count)]


@pytest.mark.parametrize("count", [1, 7, 50, 200, 3000])
def test_dots_of_every_outcome_find_room(count):
    room = Box(0.0, 0.0, 300.0, 120.0)
    rng = np.random.default_rng(0)
    for values in (rng.uniform(0.0, 1.0, (2, count)), np.zeros((2, count)), np.ones((2, count))):
        measure = DotMeasure(("x",), values, 0.0, 1.0)
        scale = DotScale.fit(measure, room.width, room.height, 15.0)
        assert scale.bins.min() >= 0
        assert scale.bins.max() <= 23
        for row in scale.bins:
            tallest = np.bincount(row).max()
            highest = scale.place(23, tallest - 1)[1] + scale.pitch / 2
            assert highest <= room.height + 1e-9
        for number in range(scale.abreast):
            across, _ = scale.place(23, number)
            assert 23 / 24 * room.width < across < room.width


def test_touching_a_person_has_a_bin_of_its_own_and_ticks_lie_where_their_values_do():
    rollouts = a_comparison(rollouts=4).rollouts
    gaps = np.array([[0.0, 1e-9, 0.5, 1.0], [0.0, 0.0, 0.99, 0.25]])
    _, gap = dot_measures(dataclasses.replace(rollouts, clearance_m=gaps))
    bins = gap.bins()
    assert ((bins == 0) == (gaps == 0.0)).all()
    assert bins[0, 1] > 1  # apart from it
    for value, place in zip(gaps.ravel(), bins.ravel(), strict=True):
        assert place / 24 - 1e-9 <= gap.at(value) <= (place + 1) / 24 + 1e-9
    assert not any(start <= 1.5 / 24 <= end for start, end in gap.lines())


def test_dots_of_both_measures_are_of_one_size(comparison):
    crowded = np.tile([[0.3] * 25 + [1.0] * 25], (2, 1))
    shown = [
        DotMeasure(("x",), np.tile(np.linspace(0.0, 1.0, 50), (2, 1)), 0.0, 1.0),
        DotMeasure(("y",), crowded, 0.0, 1.0),
    ]
    first, second = DotScale.fit_all(shown, 300.0, 120.0, 15.0)
    assert first.pitch == second.pitch
    assert second.pitch == DotScale.fit(shown[1], 300.0, 120.0, 15.0).pitch
    assert len({plot.scale.pitch for plot in lay_out_comparison(comparison, SIZE).plots}) == 1


# The film


@pytest.mark.parametrize(
    "draw", [scenes_at_rest, lambda page: next(play_outcomes(page, Pace.of(1, 10), range(1)))]
)
def test_who_stands_on_the_goal_does_not_hide_it(draw):
    standing = Pedestrian((1.5, 0.0), (1.5, 0.0), desired_speed=0.0)
    scene = Scene("a-scene", Robot((0.0, 0.0), (1.5, 0.0)), (standing,))
    page = lay_out_comparison(compare(simulate(scene, rollouts=1, horizon=0.5), *NAMES), SIZE)
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
    with av.open(str(path)) as container:
        return path, [frame.to_ndarray(format="rgb24") for frame in container.decode(video=0)]


def drawn(comparison, frames_per_second=30):
    segments = compose_comparison_film(comparison, SIZE, frames_per_second)
    frames = [[frame.copy() for frame in segment.frames()] for segment in segments]
    assert [len(part) for part in frames] == [segment.length for segment in segments]
    return list(itertools.chain(*frames))


def test_the_film_rests_shows_every_outcome_and_ends_with_the_picture(comparison, film):
    frames = drawn(comparison)
    assert len(frames) == len(film[1]) == 18 + 5 * 60 + 90
    picture = compose_comparison_picture(comparison, SIZE).pixels
    for frame, decoded in list(zip(frames, film[1], strict=True))[-90::89]:
        np.testing.assert_array_equal(frame, picture)
        assert np.abs(decoded.astype(int) - picture).mean() < 2.0
    for frame in frames[1:18]:
        np.testing.assert_array_equal(frame, frames[0])
    assert not np.array_equal(frames[18], frames[19])


def test_the_same_input_gives_the_same_bytes(comparison, film, tmp_path):
    write_mp4(tmp_path / "again.mp4", compose_comparison_film(comparison, SIZE, 30), SIZE, 30)
    assert (tmp_path / "again.mp4").read_bytes() == film[0].read_bytes()


@pytest.mark.parametrize("size", [SIZE, (1274, 714)])
def test_a_part_that_starts_later_goes_on_where_the_one_before_it_stopped(size):
    page, pace = lay_out_comparison(a_comparison(rollouts=30), size), Pace.of(30, 5)
    whole = [canvas.pixels.copy() for canvas in play_outcomes(page, pace, range(30))]
    later = [canvas.pixels.copy() for canvas in play_outcomes(page, pace, range(28, 30))]
    for first, second in zip(whole[28 * pace.frames :], later, strict=True):
        np.testing.assert_array_equal(first, second)


def test_counts_grow_as_outcomes_come_to_their_end(comparison):
    page, pace = lay_out_comparison(comparison, SIZE), Pace.of(5, 10)
    assert not any("contact" in text or "so far" in text for text in texts(scenes_at_rest(page)))
    told = [texts(canvas) for canvas in play_outcomes(page, pace, range(5))]
    touched = comparison.rollouts.touched[0]
    for outcome in range(5):
        start, end = told[outcome * pace.frames], told[(outcome + 1) * pace.frames - 1]
        assert any(text.startswith(f"Outcome {outcome + 1} of 5") for text in start)
        so_far = f"{touched[:outcome].sum()} of {outcome} so far"
        assert (so_far in start) == (outcome > 0)
        ended = "5 with contact" if outcome == 4 else f"{outcome + 1} so far"
        assert f"{touched[: outcome + 1].sum()} of {ended}" in end
        assert sum(text.endswith(ended) for text in end) == 2
    check_texts(scenes_at_rest(page))


def test_the_robot_turns_red_when_it_touches_something_and_not_before(comparison):
    page, pace = lay_out_comparison(comparison, SIZE), Pace.of(5, 10)
    reds = [red_pixels(canvas.pixels) for canvas in play_outcomes(page, pace, range(1))]
    before = int(2 / 5 * pace.moving) - 1  # contact is at step 2 of 5
    assert reds[:before] == [0] * before
    assert min(reds[before + 1 :]) > 20


@pytest.mark.parametrize("size", [SIZE, (1920, 1080)])
def test_texts_stay_apart_all_along(unusual, size):
    page = lay_out_comparison(unusual, size)
    pace = Pace.of(unusual.rollouts.count, 30)
    check_texts(scenes_at_rest(page))
    last = pace.turns - 1
    for canvas in itertools.islice(play_outcomes(page, pace, range(last, last + 1)), 0, None, 20):
        check_texts(canvas)


@pytest.mark.parametrize("count", [1, 7, 50, 200, 300, 1200, 10_000])
def test_the_film_is_neither_too_fast_nor_too_long(count):
    pace = Pace.of(count, 30)
    assert 0.1 <= pace.frames / 30 <= 2.0
    assert 2.0 <= pace.turns * pace.frames / 30 <= 32.0
    assert 1 <= pace.moving <= pace.frames
    assert pace.shown(0) == 0
    assert pace.shown(pace.turns) == count
    if count == 50:
        assert pace.frames == 12


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
