"""The film of a study, and what it shows between numbers of pairs."""

import itertools

import numpy as np
import pytest

from learners import TEACHERS
from studio.errors import InputError
from studio.painter.mp4 import write_mp4
from studio.study.picture.film import INTERPOLATED, compose_study_film
from studio.study.picture.finding import compose_finding, draw_finding, lay_out_finding
from studio.study.picture.growth import fits_between, grown
from studio.study.picture.page import draw_stage, lay_out_study
from studio.study.results import Stage, StudyResults
from studio.style.palette import DARK, LIGHT
from tests.canvases import check_texts, texts
from tests.studio.study.picture.cases import NOTHING, OWN
from tests.studio.study.tables import THREE, study_of, study_table

FILM_SIZE = (640, 400)
FRAMES_PER_SECOND = 10


def incomplete():
    """The last size is known of one learner of one teacher only; one teacher has none at all."""
    table = study_table(THREE[:2])
    rows = table.to_pylist()
    kept = [
        row["pairs"] < 2000 or (row["teacher"], row["learner"]) == ("tk", "cpt") for row in rows
    ]
    return StudyResults(table.filter(kept), THREE)


FILMED = {
    "default": study_of,
    "one size": lambda: study_of(sizes=(100,), seeds=1),
    "one teacher": lambda: study_of((TEACHERS["tk"],)),
    "six teachers": lambda: study_of(OWN),
    "only eu": lambda: study_of(learners=("eu",)),
    "zero regret": lambda: study_of(regret=0.0, regret_percent=0.0),
    "incomplete": incomplete,
}


def frames_of(results, **options):
    segments = compose_study_film(results, FILM_SIZE, FRAMES_PER_SECOND, **options)
    return [[frame.copy() for frame in segment.frames()] for segment in segments], segments


def page_at(results, pairs):
    page = lay_out_study(results, (1600, 1000), LIGHT)
    return draw_stage(page, Stage(page.results, pairs))


def texts_at(results, pairs):
    return texts(page_at(results, pairs))


@pytest.mark.parametrize("name", FILMED)
def test_the_film_grows_page_by_page_and_ends_with_the_finding(name):
    results = FILMED[name]()
    drawn, segments = frames_of(results)
    moves = len(results.sizes) - 1
    # each page stands at every number of pairs and moves on to the next, and the finding closes
    standing, moving, looking, closing = 8, 6, 30, 60
    page = [standing, moving] * moves + [looking]
    assert [segment.length for segment in segments] == [*page, *page, closing]
    assert [len(frames) for frames in drawn] == [segment.length for segment in segments]
    for frames in drawn:
        is_still = all(np.array_equal(frame, frames[0]) for frame in frames)
        assert is_still == (len(frames) != moving)
    finding = compose_finding(results, FILM_SIZE).pixels
    assert all(np.array_equal(frame, finding) for frame in drawn[-1])


def test_the_film_moves_smoothly_between_numbers_of_pairs():
    drawn, _ = frames_of(study_of())
    before, ways, after = drawn[0][-1], drawn[1], drawn[2][0]

    def apart(one, other):
        return np.abs(one.astype(int) - other.astype(int)).mean()

    steps = [apart(*pair) for pair in itertools.pairwise([before, *ways])]
    assert max(steps) < 0.7 * apart(before, after)
    assert all(steps)


def test_what_lies_between_two_numbers_of_pairs_is_interpolated_and_the_film_says_so():
    results = study_of()
    curve = results.curve("regret_percent", THREE[1], "cpt")
    middle = grown(curve, float(np.sqrt(25 * 200)))
    assert middle.pairs.tolist() == pytest.approx([25, np.sqrt(25 * 200)])
    assert middle.mean[1] == pytest.approx(np.sqrt(curve.mean[0] * curve.mean[1]))
    assert grown(curve, 200.0).mean.tolist() == curve.mean[:2].tolist()
    [cpt, *_] = fits_between(Stage(results, np.sqrt(25 * 200)), THREE[1], "cpt")
    ends = [results.fits_of(THREE[1], "cpt", pairs)[0] for pairs in (25, 200)]
    assert cpt["lambda"] == pytest.approx(np.sqrt(ends[0]["lambda"] * ends[1]["lambda"]))
    assert cpt["theta"] == pytest.approx(np.mean([fit["theta"] for fit in ends], axis=0))
    for lay_out, draw in ((lay_out_finding, draw_finding), (lay_out_study, draw_stage)):
        page = lay_out(results, FILM_SIZE, LIGHT, INTERPOLATED)
        assert "interpolated" in " ".join(texts(draw(page, page.results.stages[0])))


def test_a_study_without_fits_has_a_film_too():
    drawn, _ = frames_of(NOTHING)
    assert np.array_equal(drawn[-1][-1], compose_finding(NOTHING, FILM_SIZE).pixels)


def test_a_later_page_has_the_axes_of_an_earlier_one():
    early, late = (
        {
            placed
            for placed in page_at(study_of(), pairs).texts
            if placed.text.isdigit() or placed.text in ("0.1", "0.5", "−0.5", "predicted")
        }
        for pairs in (25, 2000)
    )
    assert len(early) > 40
    assert early <= late


def test_every_page_says_how_many_pairs_and_what_was_found_out_from_them():
    results = study_of()
    for pairs in (25, 200, 2000):
        texts = texts_at(results, pairs)
        assert f"{pairs} pairs" in texts
        assert f"Reward and parameters at {pairs} pairs" in " ".join(texts)
    before, after = (texts_at(results, pairs) for pairs in (199, 200))
    assert "25 pairs" in before
    assert "200 pairs" in after


def test_what_a_study_lacks_is_not_told_before_its_time():
    results = incomplete()
    page = lay_out_finding(results, (1600, 1000), LIGHT)
    early, late = (texts(draw_finding(page, Stage(page.results, pairs))) for pairs in (200, 2000))
    assert early.count("no fits yet") == 1
    assert not any(" − " in text and "[" in text for text in late)


@pytest.mark.parametrize("name", FILMED)
def test_texts_stay_on_the_page_and_off_one_another_at_every_number_of_pairs(name):
    results = FILMED[name]()
    minds = lay_out_study(results, (640, 360), LIGHT, INTERPOLATED)
    finding = lay_out_finding(results, (640, 360), LIGHT, INTERPOLATED)
    for stage in minds.results.stages:
        check_texts(draw_stage(minds, stage))
        check_texts(draw_finding(finding, stage))


def test_a_film_has_its_theme():
    drawn, _ = frames_of(study_of(sizes=(25,)), theme=DARK)
    assert tuple(drawn[0][0][0, 0]) == DARK.ground


@pytest.mark.parametrize("size", [(641, 400), (320, 200)])
def test_sizes_that_cannot_be_filmed_are_refused_in_one_line(size, tmp_path):
    with pytest.raises(InputError, match=f"size: {size[0]}x{size[1]} pixels is not") as error:
        write_mp4(tmp_path / "film.mp4", compose_study_film(study_of(), size), size, 30)
    assert "\n" not in str(error.value)
