import itertools
import warnings

import cv2
import numpy as np
import pyarrow as pa
import pytest

from learners import FEATURES
from studio.errors import InputError
from studio.painter.lettering import ELLIPSIS
from studio.study.picture.finding import compose_finding
from studio.study.picture.page import compose_study_picture
from studio.study.picture.scales import Scales
from studio.study.results import StudyResults
from studio.style.palette import LIGHT, THEMES, learner_colour
from tests.canvases import check_texts, texts
from tests.studio.study.picture.cases import CASES, NOTHING, OWN, four_by_three, incomplete
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


BOTH = pytest.mark.parametrize("compose", [compose_finding, compose_study_picture])


@BOTH
@pytest.mark.parametrize(("name", "size", "theme"), [*pages()])
def test_texts_stay_on_the_page_and_off_one_another(compose, name, size, theme):
    canvas = compose(CASES[name](), size, THEMES[theme])
    assert len(canvas.texts) > 5
    check_texts(canvas)


@BOTH
@pytest.mark.parametrize("size", [(640, 360), (1280, 720), (1600, 900)])
def test_nothing_is_cut_short_with_four_teachers_and_three_learners(compose, size):
    canvas = compose(four_by_three(), size)
    written = texts(canvas)
    assert not [text for text in written if ELLIPSIS in text]
    check_texts(canvas)
    for name in ("CPT", "CPT tied", "EU"):
        labels = [text for text in written if text.removeprefix(name).strip(" .0123456789%") == ""]
        assert len(labels) >= 4, name
    for name in ("EU", "T&K", "Strong", "averse-to-losses"):
        assert written.count(f"Teacher: {name}") == 1
    if compose is compose_study_picture:
        assert all(written.count(feature) == 4 for feature in FEATURES)


@BOTH
def test_long_names_of_teachers_are_written_smaller_before_they_are_cut(compose):
    written = texts(compose(study_of(OWN[:4]), (1280, 720)))
    assert not [text for text in written if ELLIPSIS in text]
    for teacher in OWN[:4]:
        assert any(text.endswith(teacher.name) for text in written)


@pytest.mark.parametrize("size", SIZES)
def test_the_png_has_the_size_asked_for_and_shows_something(tmp_path, size):
    path = tmp_path / "learning.png"
    compose_study_picture(study_of(), size).save(path)
    pixels = cv2.imread(str(path))
    assert pixels.shape == (size[1], size[0], 3)
    assert 0.2 < (pixels == LIGHT.ground).all(axis=-1).mean() < 0.9


@BOTH
def test_every_learner_has_its_colour_and_none_that_of_contact(compose):
    pixels = compose(study_of(learners=("eu", "cpt", "cpt-tied"))).pixels
    for learner in ("eu", "cpt", "cpt-tied"):
        assert has_colour(pixels, learner_colour(learner))
    assert not has_colour(pixels, LIGHT.contact)
    assert not has_colour(compose(study_of(learners=("eu",))).pixels, learner_colour("cpt"))


@BOTH
def test_the_page_says_what_was_studied_and_names_lines_beside_them(compose):
    written = texts(compose(study_of()))
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
        # regrets are in percent with their sign; shares of picks have it in the name of their plot
        labels = [text.rstrip(" %") for text in written if text.startswith(f"{learner} ")]
        numbers = [label.removeprefix(f"{learner} ") for label in labels]
        assert sum(each.replace(".", "").isdigit() for each in numbers) == 3


@BOTH
def test_the_page_says_what_bands_are_where_there_are_some(compose):
    said = " ".join(texts(compose(study_of())))
    assert "95 % bootstrap interval" in said
    assert "interval" not in " ".join(texts(compose(study_of(seeds=1))))


def test_the_page_says_what_is_short_for_what():
    said = " ".join(texts(compose_study_picture(study_of())))
    for words in ("cumulative prospect theory", "λ: loss aversion", "% points"):
        assert words in said
    plain = " ".join(texts(compose_study_picture(study_of(learners=("eu",)))))
    assert "loss aversion" not in plain
    assert "both axes logarithmic" in " ".join(texts(compose_finding(study_of())))


def test_every_number_of_pairs_is_named_below_the_regret():
    sizes = (25, 50, 100, 200, 500, 1000, 2000)
    written = texts(compose_finding(study_of(sizes=sizes)))
    assert all(written.count(str(size)) == 3 for size in sizes)


@BOTH
def test_fits_that_did_not_converge_are_counted(compose):
    table = study_of().table
    converged = [index % 9 != 0 for index in range(table.num_rows)]
    place = table.column_names.index("converged")
    some = StudyResults(table.set_column(place, "converged", pa.array(converged)), THREE)
    assert "6 did not converge" in " ".join(texts(compose(some)))
    assert "all converged" in " ".join(texts(compose(study_of())))


@BOTH
def test_the_largest_size_is_compared_in_words(compose):
    written = " ".join(texts(compose(study_of())))
    assert written.count("CPT's regret is") == 3
    assert "regret is" not in " ".join(texts(compose(study_of(learners=("cpt",)))))


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


def test_errors_of_predictions_make_room_on_a_low_page_and_are_then_not_explained():
    for size, count in (((640, 360), 0), ((1280, 720), 4)):
        written = texts(compose_study_picture(four_by_three(), size))
        assert written.count("predicted") == count
        assert ("Errors: " in " ".join(written)) == bool(count)


@BOTH
def test_of_too_many_teachers_it_says_how_many_are_shown(compose):
    assert any("4 of 6 teachers" in text for text in texts(compose(study_of(OWN))))


@BOTH
def test_a_teacher_without_fits_has_none_yet(compose):
    assert texts(compose(incomplete())).count("no fits yet") == 1


def changed_seed(regret):
    """A study of EU from EU alone, of which one seed has this regret (%) at the most pairs."""
    table = study_of((THREE[0],), learners=("eu",)).table
    regrets = table["regret_percent"].to_pylist()
    regrets[-1] = regret
    place = table.column_names.index("regret_percent")
    return StudyResults(table.set_column(place, "regret_percent", pa.array(regrets)), THREE[:1])


def test_every_seed_is_drawn_and_one_below_the_axis_as_a_triangle():
    plain, lucky = changed_seed(0.03), changed_seed(1e-6)
    assert not plain.regrets.has_less
    assert lucky.regrets.has_less
    notes = [" ".join(texts(compose_finding(each))) for each in (plain, lucky)]
    assert ["Small triangles: seeds" in said for said in notes] == [False, True]
    # the axis does not go down to the seed that lies below it
    assert Scales.around(lucky).regret[0] > 1e-3


@BOTH
def test_the_same_table_gives_the_same_picture_in_silence(compose):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        first, second = (compose(study_of()).pixels for _ in range(2))
    assert np.array_equal(first, second)


def test_what_cannot_be_drawn_or_written_is_refused_in_one_line(tmp_path):
    with pytest.raises(InputError, match="size: 320x200"):
        compose_study_picture(study_of(), (320, 200))
    with pytest.raises(FileNotFoundError):
        compose_study_picture(study_of(), (640, 400)).save(tmp_path / "nowhere" / "learning.png")
