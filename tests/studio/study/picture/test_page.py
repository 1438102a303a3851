"""Both pages of a study's picture."""

import itertools
import re
import warnings

import cv2
import numpy as np
import pyarrow as pa
import pytest

from studio.errors import InputError
from studio.painter.canvas import Canvas
from studio.study.picture.finding import compose_finding
from studio.study.picture.page import compose_study_picture
from studio.study.picture.scales import Scales
from studio.study.results import StudyResults
from studio.study.words import parameters_told
from studio.style.palette import LIGHT, THEMES, learner_colour
from tests.canvases import check_texts, texts
from tests.studio.study.picture.cases import CASES, FOUR, NOTHING, OWN
from tests.studio.study.tables import THREE, study_of

SIZES = [(640, 400), (1280, 800), (1600, 1000), (3840, 2400), (1000, 1400), (2400, 700)]


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


PAGES = [compose_finding, compose_study_picture]


@pytest.mark.parametrize("compose", PAGES)
@pytest.mark.parametrize(("name", "size", "theme"), [*pages()])
def test_texts_stay_on_the_page_and_off_one_another(compose, name, size, theme):
    canvas = compose(CASES[name](), size, THEMES[theme])
    assert len(canvas.texts) > 5
    check_texts(canvas)


@pytest.mark.parametrize("compose", PAGES)
@pytest.mark.parametrize("seeds", [1, 10])
def test_nothing_is_cut_off_with_four_teachers_and_three_learners(monkeypatch, compose, seeds):
    refused = []
    whole = Canvas._first_fitting

    def told(canvas, wordings, width, size, weight):
        text = whole(canvas, wordings, width, size, weight)
        if "…" in text or not text:
            refused.append(text)
        return text

    monkeypatch.setattr(Canvas, "_first_fitting", told)
    sizes = (25, 50, 100, 200, 500, 1000, 2000)
    study = study_of(FOUR, ("eu", "cpt", "cpt-tied"), sizes, seeds)
    canvas = compose(study, (1280, 720))
    check_texts(canvas)
    assert refused == []
    written = texts(canvas)
    assert not any("…" in text for text in written)
    for teacher in FOUR:
        assert written.count(parameters_told(teacher)) >= 1
    for learner in ("EU ", "CPT tied ", "CPT "):
        ends = [text for text in written if re.fullmatch(learner + r"[<.0-9 ]+%?", text)]
        assert len(ends) == 4


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
    written = texts(compose_finding(study_of()))
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
    for compose in PAGES:
        assert "95 % bootstrap interval" in " ".join(texts(compose(study_of())))
        assert "interval" not in " ".join(texts(compose(study_of(seeds=1))))


def test_the_first_page_says_what_the_seeds_and_the_middle_half_of_them_are():
    said = " ".join(texts(compose_finding(study_of(seeds=10))))
    assert "mean over 10 seeds" in said
    assert "dots: seeds" in said
    assert "interquartile mean" in said


def test_every_seed_is_a_dot(monkeypatch):
    whole, colours = Canvas.disc, []

    def counted(canvas, centre, radius, colour):
        colours.append(colour)
        whole(canvas, centre, radius, colour)

    monkeypatch.setattr(Canvas, "disc", counted)

    def discs(seeds):
        colours.clear()
        compose_finding(study_of(seeds=seeds))
        return colours.count(learner_colour("cpt"))

    assert discs(7) - discs(3) == 4 * 3 * 3  # seeds, teachers, numbers of pairs


def test_the_page_says_what_is_short_for_what():
    said = " ".join(texts(compose_study_picture(study_of())))
    for words in ("cumulative prospect theory", "λ: loss aversion"):
        assert words in said
    said = " ".join(texts(compose_finding(study_of())))
    for words in ("logarithmic", "percentage points"):
        assert words in said
    plain = " ".join(texts(compose_study_picture(study_of(learners=("eu",)))))
    assert "loss aversion" not in plain


def test_every_number_of_pairs_is_named_below_the_regret():
    written = texts(compose_finding(study_of(sizes=(25, 50, 100, 200, 500, 1000, 2000))))
    assert written.count("1000") == 3


def test_fits_that_did_not_converge_are_counted():
    table = study_of().table
    converged = [index % 9 != 0 for index in range(table.num_rows)]
    place = table.column_names.index("converged")
    some = StudyResults(table.set_column(place, "converged", pa.array(converged)), THREE)
    assert "6 did not converge" in " ".join(texts(compose_study_picture(some)))
    assert "all converged" in " ".join(texts(compose_study_picture(study_of())))


def test_the_largest_size_is_compared_in_words():
    written = texts(compose_finding(study_of()))
    assert sum(text.startswith("CPT − EU: ") and text.count("[") == 1 for text in written) == 3
    assert " − " not in " ".join(texts(compose_finding(study_of(learners=("cpt",)))))


def test_zero_regret_has_a_place_of_its_own_on_the_logarithmic_axis():
    assert "EU 0 %" not in texts(compose_finding(study_of()))
    canvas = compose_finding(study_of(regret_percent=0.0))
    assert "EU 0 %" in texts(canvas)
    assert "CPT 0 %" in texts(canvas)


def test_without_fits_the_axis_of_regret_is_that_around_one_percent():
    assert Scales.around(NOTHING).regret == pytest.approx((2.0 / 3.0, 12.0))


def test_shapes_are_shown_only_if_somebody_learnt_them():
    assert "Weight of losses" in texts(compose_study_picture(study_of()))
    assert "Weight of losses" not in texts(compose_study_picture(study_of(learners=("eu",))))


@pytest.mark.parametrize("compose", PAGES)
def test_of_too_many_teachers_it_says_how_many_are_shown(compose):
    assert any("4 of 6 teachers" in text for text in texts(compose(study_of(OWN))))


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
