"""The film of a study and the curves that it lets grow."""

import itertools
from dataclasses import replace
from pathlib import Path

import numpy as np
import pyarrow as pa
import pytest

from learners import TEACHERS
from studio.errors import InputError
from studio.painter.canvas import Canvas
from studio.painter.mp4 import write_mp4
from studio.study.picture.film import compose_study_film
from studio.study.picture.finding import compose_finding, draw_finding, lay_out_finding
from studio.study.picture.growth import fits_between, grown
from studio.study.picture.page import draw_stage, lay_out_study
from studio.study.results import Stage, StudyResults
from studio.style.palette import DARK, LIGHT
from tests.canvases import check_texts, texts
from tests.studio.study.picture.cases import FILMED, NOTHING, four_by_three, incomplete
from tests.studio.study.tables import THREE, study_of, study_table

SIZE = (640, 400)
FRAMES_PER_SECOND = 10
RESTING, MOVING, LOOKING, CLOSING = 8, 6, 30, 60  # frames
TK = TEACHERS["tk"]
HALFWAY = float(np.sqrt(25 * 200))  # between two sizes, on a logarithmic axis


def frames_of(results: StudyResults) -> list[list[np.ndarray]]:
    segments = compose_study_film(results, SIZE, FRAMES_PER_SECOND)
    drawn = [[frame.copy() for frame in segment.frames()] for segment in segments]
    assert [segment.length for segment in segments] == [len(frames) for frames in drawn]
    return drawn


def pages_at(
    results: StudyResults, pairs: float, size: tuple[int, int] = (1600, 900)
) -> list[Canvas]:
    """Both pages at a number of pairs."""
    first, second = lay_out_finding(results, size, LIGHT), lay_out_study(results, size, LIGHT)
    stage = Stage(first.results, pairs)
    return [draw_finding(first, stage), draw_stage(second, stage)]


@pytest.mark.parametrize("name", FILMED)
def test_the_film_grows_both_pages_and_holds_the_picture_for_six_seconds(name: str) -> None:
    results = FILMED[name]()
    drawn = frames_of(results)
    page = [*[RESTING, MOVING] * (len(results.sizes) - 1), LOOKING]
    assert [len(frames) for frames in drawn] == [*page, *page, CLOSING]
    assert CLOSING >= 6 * FRAMES_PER_SECOND
    for frames in drawn:
        if len(frames) != MOVING:
            assert all(np.array_equal(frame, frames[0]) for frame in frames)
    for before, after in itertools.pairwise(drawn):
        assert not np.array_equal(before[-1], after[0])
    assert np.array_equal(drawn[-1][-1], compose_finding(results, SIZE).pixels)


def test_frames_between_two_sizes_differ_from_both_and_from_one_another() -> None:
    drawn = frames_of(study_of())
    for place, frames in enumerate(drawn):
        if len(frames) == MOVING:
            ends = drawn[place - 1][0], drawn[place + 1][0]
            shown = [frame.tobytes() for frame in (*ends, *frames)]
            assert len(set(shown)) == MOVING + 2


def test_the_film_says_that_curves_are_interpolated_but_the_picture_does_not() -> None:
    note = "Between two numbers of pairs the curves are interpolated."
    for lay_out, draw in ((lay_out_finding, draw_finding), (lay_out_study, draw_stage)):
        page = lay_out(study_of(), (1600, 900), LIGHT, note)
        written = " ".join(texts(draw(page, page.results.stages[0])))
        assert note in written
    assert note not in " ".join(texts(compose_finding(study_of())))


def test_a_study_without_fits_has_a_film_too() -> None:
    drawn = frames_of(NOTHING)
    assert [len(frames) for frames in drawn] == [LOOKING, LOOKING, CLOSING]
    assert np.array_equal(drawn[-1][-1], compose_finding(NOTHING, SIZE).pixels)


def test_a_later_page_has_the_axes_of_an_earlier_one() -> None:
    marks = {"0.1", "0.5", "−0.5", "predicted"}
    for early, late in zip(pages_at(study_of(), 25), pages_at(study_of(), 2000), strict=True):
        before, after = (
            {each for each in page.texts if each.text.isdigit() or each.text in marks}
            for page in (early, late)
        )
        assert len(before) >= 12
        assert before <= after


@pytest.mark.parametrize("pairs", [25, 200, 2000])
def test_every_page_says_how_many_pairs_and_what_was_found_out_from_them(pairs: int) -> None:
    for page in pages_at(study_of(), pairs):
        written = texts(page)
        assert f"{pairs} pairs" in written
        assert sum("CPT's regret is" in text for text in written) == 3
    assert f"Reward and parameters at {pairs} pairs" in " ".join(written)


def test_the_title_states_what_was_found_so_far() -> None:
    results = study_of(sizes=(25, 2000), seeds=5)
    table = results.table
    regrets = [
        1.0 + (row["learner"] == "cpt") * (1.0 if row["pairs"] == 25 else -0.5)
        for row in table.to_pylist()
    ]
    place = table.column_names.index("regret_percent")
    turned = StudyResults(
        table.set_column(place, "regret_percent", pa.array(regrets)), results.teachers
    )
    for pairs, said in ((25, "EU has less regret than CPT"), (2000, "CPT has less regret than EU")):
        page, _ = pages_at(turned, pairs)
        assert any(said in text for text in texts(page))


def test_until_a_size_is_reached_the_one_before_is_told() -> None:
    for page in pages_at(study_of(), 199.9):
        assert "25 pairs" in texts(page)
        assert "200 pairs" not in texts(page)


def test_what_a_study_lacks_is_not_told_before_its_time() -> None:
    for page in pages_at(incomplete(), 200):
        assert texts(page).count("no fits yet") == 1
    for page in pages_at(incomplete(), 2000):
        assert not any("regret is" in text for text in texts(page))


@pytest.mark.parametrize("name", FILMED)
def test_texts_stay_on_the_page_and_off_one_another_at_every_number_of_pairs(name: str) -> None:
    results = FILMED[name]()
    for pairs in (*results.sizes, HALFWAY):
        for page in pages_at(results, pairs, (640, 360)):
            check_texts(page)


def test_texts_of_a_full_page_stay_apart_on_the_way() -> None:
    for pairs in (25.0, HALFWAY, 1400.0):
        for page in pages_at(four_by_three(), pairs, (1280, 720)):
            check_texts(page)


def test_a_film_has_its_theme() -> None:
    first, *_ = compose_study_film(study_of(sizes=(25,)), SIZE, FRAMES_PER_SECOND, DARK)
    assert tuple(next(iter(first.frames()))[0, 0]) == DARK.ground


@pytest.mark.parametrize("size", [(641, 400), (320, 200)])
def test_sizes_that_cannot_be_filmed_are_refused_in_one_line(
    size: tuple[int, int], tmp_path: Path
) -> None:
    with pytest.raises(InputError, match=f"size: {size[0]}x{size[1]} pixels is not") as error:
        write_mp4(tmp_path / "film.mp4", compose_study_film(study_of(), size), size, 30)
    assert "\n" not in str(error.value)


# Between two sizes


def test_a_curve_grows_evenly_with_the_logarithm_of_pairs_and_regret() -> None:
    curve = study_of().curve("regret_percent", TK, "cpt")
    assert curve is not None
    part = grown(curve, HALFWAY)
    assert part.pairs.tolist() == pytest.approx([25, HALFWAY])
    assert part.runs.tolist() == [3, 0]
    for name in ("mean", "low", "high"):
        known = getattr(curve, name)
        assert getattr(part, name).tolist() == pytest.approx(
            [known[0], np.sqrt(known[0] * known[1])]
        )


def test_what_can_be_zero_grows_evenly_itself() -> None:
    curve = study_of().curve("regret_percent", TK, "cpt")
    assert curve is not None
    curve = replace(curve, mean=np.array([4.0, 0.0, 1.0]))
    assert grown(curve, HALFWAY).mean.tolist() == pytest.approx([4.0, 2.0])


def test_a_curve_at_a_size_is_that_of_its_points() -> None:
    curve = study_of().curve("regret_percent", TK, "cpt")
    assert curve is not None
    for reached, count in ((24.0, 0), (25.0, 1), (200.0, 2), (2000.0, 3), (9999.0, 3)):
        part = grown(curve, reached)
        assert part.mean.tolist() == curve.mean[:count].tolist()
        assert len(part.samples) == count


def test_fits_move_from_one_size_to_the_next() -> None:
    results = study_of()
    before, after = (results.fits_of(TK, "cpt", pairs) for pairs in (25, 200))
    moved = fits_between(Stage(results, HALFWAY), TK, "cpt")
    assert [fit["seed"] for fit in moved] == [0, 1, 2]
    for fit, start, end in zip(moved, before, after, strict=True):
        expected = (np.array(start["theta"]) + np.array(end["theta"])) / 2
        assert fit["theta"] == pytest.approx(expected.tolist())
        for name in ("alpha", "lambda", "delta"):
            assert fit[name] == pytest.approx(np.sqrt(start[name] * end[name]))
    assert fits_between(Stage(results, 25), TK, "cpt") == before
    assert fits_between(Stage(results, 2000), TK, "cpt") == results.fits_of(TK, "cpt", 2000)


def test_fits_without_parameters_or_without_a_next_size_stay_as_they_are() -> None:
    eu = fits_between(Stage(study_of(), HALFWAY), TK, "eu")
    assert {fit["lambda"] for fit in eu} == {None}
    results = incomplete()
    known = results.fits_of(TK, "eu", 200)
    assert fits_between(Stage(results, 500.0), TK, "eu") == known


def test_the_title_states_what_is_known_by_then() -> None:
    table = study_table()
    better_late = [
        1.0 + (row["learner"] == "cpt") * (-0.5 if row["pairs"] == 2000 else row["seed"] - 1.0)
        for row in table.to_pylist()
    ]
    place = table.column_names.index("regret_percent")
    results = StudyResults(table.set_column(place, "regret_percent", pa.array(better_late)), THREE)
    page = lay_out_finding(results, (1280, 720), LIGHT)
    titles = [texts(draw_finding(page, Stage(page.results, pairs))) for pairs in (25, 300, 2000)]
    for written in titles[:2]:
        assert any("hether CPT has less regret than EU is open" in text for text in written)
    assert any(
        "CPT has less regret than EU for teachers EU, T&K and Strong" in text for text in titles[2]
    )
