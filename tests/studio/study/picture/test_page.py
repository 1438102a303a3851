import itertools
import warnings

import cv2
import numpy as np
import pyarrow as pa
import pytest

from learners import PARAMETER_COLUMNS, PROFILES, TEACHERS, Teacher
from studio.errors import InputError
from studio.painter.mp4 import write_mp4
from studio.study.picture.film import compose_study_film
from studio.study.picture.page import compose_study_picture, draw_stage, lay_out_study
from studio.study.picture.scales import Scales
from studio.study.results import Stage, StudyResults
from studio.style.palette import DARK, LIGHT, THEMES, learner_colour
from tests.canvases import check_texts, texts
from tests.studio.study.tables import THREE, study_of, study_table

SIZES = [(640, 400), (1280, 800), (1600, 1000), (3840, 2400), (1000, 1400), (2400, 700)]


NOTHING = StudyResults(study_table().slice(0, 0), THREE)


OWN = tuple(
    Teacher(f"a-teacher-of-my-own-with-a-long-name-{index}", PROFILES["tk"], reward=(0.3,) * 8)
    for index in range(6)
)
EVERYBODY = ("eu", "cpt", "cpt-tied", "cpt-reference", "cpt-tied-reference", "a-learner-of-my-own")

CASES = {
    "default": study_of,
    "one of everything": lambda: study_of((TEACHERS["tk"],), sizes=(100,), seeds=1),
    "one teacher": lambda: study_of((TEACHERS["strong"],)),
    "only eu": lambda: study_of(learners=("eu",)),
    "only cpt": lambda: study_of(learners=("cpt",)),
    "many learners": lambda: study_of(learners=EVERYBODY),
    "own teachers": lambda: study_of(OWN[:4]),
    "more teachers than there is room for": lambda: study_of(OWN),
    "zero regret": lambda: study_of(regret=0.0, regret_percent=0.0),
    "huge regret": lambda: study_of(regret_percent=12345.6),
    "many sizes": lambda: study_of(sizes=tuple(range(100, 3100, 100)), seeds=1),
    "nothing fitted": lambda: NOTHING,
    "one teacher fitted": lambda: StudyResults(study_table((TEACHERS["eu"],)), THREE),
    "nothing converged": lambda: study_of(converged=False),
    "nothing known": lambda: study_of(
        **dict.fromkeys(PARAMETER_COLUMNS),
        certainty=None,
        converged=None,
        calibration_count=[],
        calibration_predicted=None,
        calibration_preferred=None,
    ),
}


def has_colour(pixels, colour):
    return bool((pixels == colour).all(axis=-1).any())


def pages():
    """Every case on the smallest page and another one, the usual case on all of them."""
    others = itertools.cycle([(1080, 1350), (1600, 900), (1600, 1000), (1280, 720)])
    for name, other in zip(CASES, others, strict=False):
        yield name, (640, 360), "light"
        yield name, other, "dark"
    for name, size in itertools.product(["default", "one teacher"], SIZES):
        yield name, size, "light"


@pytest.mark.parametrize(("name", "size", "theme"), [*pages()])
def test_texts_stay_on_the_page_and_off_one_another(name, size, theme):
    canvas = compose_study_picture(CASES[name](), size, THEMES[theme])
    assert len(canvas.texts) > 5
    check_texts(canvas)


@pytest.mark.parametrize("size", SIZES)
def test_the_png_has_the_size_asked_for_and_shows_something(tmp_path, size):
    path = tmp_path / "learning.png"
    compose_study_picture(study_of(), size).save(path)
    pixels = cv2.imread(str(path))
    assert pixels.shape == (size[1], size[0], 3)
    assert 0.2 < (pixels == LIGHT.ground).all(axis=-1).mean() < 0.9


def test_every_learner_has_its_colour_and_none_that_of_contact():
    pixels = compose_study_picture(study_of(learners=("eu", "cpt", "cpt-tied"))).pixels
    for learner in ("eu", "cpt", "cpt-tied"):
        assert has_colour(pixels, learner_colour(learner))
    assert not has_colour(pixels, LIGHT.contact)
    assert not has_colour(
        compose_study_picture(study_of(learners=("eu",))).pixels, learner_colour("cpt")
    )


def test_the_page_says_what_was_studied_and_names_lines_beside_them():
    written = texts(compose_study_picture(study_of()))
    assert any(
        all(
            part in text
            for part in (
                "54 fits",
                "3 teachers × 2 learners",
                "25 to 2000 pairs",
                "3 seeds",
                "80 %",
            )
        )
        for text in written
    )
    for teacher in ("EU", "T&K", "Strong"):
        assert any(text.startswith("Teacher") and text.endswith(teacher) for text in written)
    for learner in ("EU", "CPT"):
        assert sum(text.startswith(f"{learner} ") and text.endswith("%") for text in written) == 3


def test_the_page_says_what_bands_are_where_there_are_some():
    said = " ".join(texts(compose_study_picture(study_of())))
    assert "95 % bootstrap interval" in said
    assert "interval" not in " ".join(texts(compose_study_picture(study_of(seeds=1))))


def test_the_page_says_what_is_short_for_what():
    said = " ".join(texts(compose_study_picture(study_of())))
    for words in ("cumulative prospect theory", "λ: loss aversion", "logarithmic", "% points"):
        assert words in said
    plain = " ".join(texts(compose_study_picture(study_of(learners=("eu",)))))
    assert "loss aversion" not in plain


def test_every_number_of_pairs_is_named_below_the_regret():
    written = texts(compose_study_picture(study_of(sizes=(25, 50, 100, 200, 500, 1000, 2000))))
    assert written.count("1000") >= 3


def test_fits_that_did_not_converge_are_counted():
    table = study_of().table
    converged = [index % 9 != 0 for index in range(table.num_rows)]
    place = table.column_names.index("converged")
    some = StudyResults(table.set_column(place, "converged", pa.array(converged)), THREE)
    assert "6 did not converge" in " ".join(texts(compose_study_picture(some)))
    assert "all converged" in " ".join(texts(compose_study_picture(study_of())))


def test_the_largest_size_is_compared_in_words():
    written = " ".join(texts(compose_study_picture(study_of())))
    assert written.count("CPT's regret is") == 3
    assert "regret is" not in " ".join(texts(compose_study_picture(study_of(learners=("cpt",)))))


def test_zero_regret_has_a_place_of_its_own_on_the_logarithmic_axis():
    assert "EU 0 %" not in texts(compose_study_picture(study_of()))
    canvas = compose_study_picture(study_of(regret_percent=0.0))
    assert "EU 0 %" in texts(canvas)
    assert "CPT 0 %" in texts(canvas)


def test_without_fits_the_axis_of_regret_is_that_around_one_percent():
    assert Scales.around(NOTHING).regret == pytest.approx((2.0 / 3.0, 12.0))


def test_shapes_are_shown_only_if_somebody_learnt_them():
    assert "Weight of losses" in texts(compose_study_picture(study_of()))
    assert "Weight of losses" not in texts(compose_study_picture(study_of(learners=("eu",))))


def test_of_too_many_teachers_it_says_how_many_are_shown():
    assert any("4 of 6 teachers" in text for text in texts(compose_study_picture(study_of(OWN))))


def test_the_same_table_gives_the_same_picture_in_silence():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        first, second = (compose_study_picture(study_of()).pixels for _ in range(2))
    assert np.array_equal(first, second)


def test_what_cannot_be_drawn_or_written_is_refused_in_one_line(tmp_path):
    with pytest.raises(InputError, match="size: 320x200"):
        compose_study_picture(study_of(), (320, 200))
    with pytest.raises(FileNotFoundError):
        compose_study_picture(study_of(), (640, 400)).save(tmp_path / "nowhere" / "learning.png")


# The film

FILM_SIZE = (640, 400)
FRAMES_PER_SECOND = 10
STANDING, ENDING = 15, 30  # frames


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
def test_the_film_stands_at_every_number_of_pairs_and_ends_with_the_picture(name):
    results = FILMED[name]()
    drawn, segments = frames_of(results)
    sizes = results.sizes
    lengths = [*[STANDING] * (len(sizes) - 1), ENDING]
    assert [len(frames) for frames in drawn] == lengths
    assert [segment.length for segment in segments] == lengths
    for frames in drawn:
        assert all(np.array_equal(frame, frames[0]) for frame in frames)
    for before, after in itertools.pairwise(drawn):
        assert not np.array_equal(before[0], after[0])
    assert np.array_equal(drawn[-1][-1], compose_study_picture(results, FILM_SIZE).pixels)


def test_a_study_without_fits_has_a_film_too():
    drawn, _ = frames_of(NOTHING)
    assert len(drawn) == 1
    assert np.array_equal(drawn[0][-1], compose_study_picture(NOTHING, FILM_SIZE).pixels)


def test_a_later_page_has_the_axes_of_an_earlier_one():
    early, late = (
        {
            placed
            for placed in page_at(study_of(), pairs).texts
            if placed.text.isdigit() or placed.text in ("0.1", "0.5", "−0.5", "predicted")
        }
        for pairs in (25, 2000)
    )
    assert len(early) > 60
    assert early <= late


def test_every_page_says_how_many_pairs_and_what_was_found_out_from_them():
    results = study_of()
    for pairs in (25, 200, 2000):
        texts = texts_at(results, pairs)
        assert f"{pairs} pairs" in texts
        assert f"Reward and parameters at {pairs} pairs" in " ".join(texts)
        assert sum("CPT's regret is" in text for text in texts) == 3
    before, after = (texts_at(results, pairs) for pairs in (199, 200))
    assert "25 pairs" in before
    assert "200 pairs" in after


def test_what_a_study_lacks_is_not_told_before_its_time():
    results = incomplete()
    assert texts_at(results, 200).count("no fits yet") == 1
    assert not any("regret is" in text for text in texts_at(results, 2000))


@pytest.mark.parametrize("name", FILMED)
def test_texts_stay_on_the_page_and_off_one_another_at_every_number_of_pairs(name):
    page = lay_out_study(FILMED[name](), (640, 360), LIGHT)
    for stage in page.results.stages:
        check_texts(draw_stage(page, stage))


def test_a_film_has_its_theme():
    drawn, _ = frames_of(study_of(sizes=(25,)), theme=DARK)
    assert tuple(drawn[0][0][0, 0]) == DARK.ground


@pytest.mark.parametrize("size", [(641, 400), (320, 200)])
def test_sizes_that_cannot_be_filmed_are_refused_in_one_line(size, tmp_path):
    with pytest.raises(InputError, match=f"size: {size[0]}x{size[1]} pixels is not") as error:
        write_mp4(tmp_path / "film.mp4", compose_study_film(study_of(), size), size, 30)
    assert "\n" not in str(error.value)
