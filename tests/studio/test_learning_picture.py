import itertools
import warnings

import cv2
import numpy as np
import pyarrow as pa
import pytest

from learners import PROFILES, TEACHERS, Teacher
from studio.errors import InputError, RunError
from studio.painter.learning import (
    compose_learning_picture,
    draw_learning_picture,
    write_learning_picture,
)
from studio.palette import LEARNER_COLOURS, LIGHT

SIZES = [(640, 400), (1280, 800), (1600, 1000), (3840, 2400), (1000, 1400), (2400, 700)]
THREE = tuple(TEACHERS.values())
PARAMETERS = ("alpha", "eta", "lambda", "gamma", "delta")


def a_fit(teacher, learner, pairs, seed, rng, **columns):
    truth = teacher.parameters
    numbers = (truth.alpha, truth.eta, truth.loss_aversion, truth.gamma, truth.delta)
    learnt = np.array(numbers) * np.exp(rng.normal(0, 3 / np.sqrt(pairs), 5))
    theta = np.array(teacher.reward) * np.exp(
        rng.normal(0, 1 / np.sqrt(pairs), len(teacher.reward))
    )
    regret = (100 if learner != "eu" else 60) / pairs * np.exp(rng.normal(0, 0.3))
    predicted = [None, *np.linspace(0.15, 0.95, 9).tolist()]
    preferred = [None, *np.linspace(0.25, 0.85, 9).tolist()]
    row = {
        "teacher": teacher.name,
        "learner": learner,
        "pairs": pairs,
        "seed": seed,
        "regret": regret / 1000,
        "regret_percent": regret,
        "nll": 0.5,
        "certainty": 0.8,
        "theta": theta.tolist(),
        **dict(zip(PARAMETERS, learnt.tolist() if learner != "eu" else [None] * 5, strict=True)),
        "agreement": min(1.0, 0.6 + pairs / 5000),
        "converged": True,
        "calibration_count": [0, *[10] * 9],
        "calibration_predicted": predicted,
        "calibration_preferred": preferred,
    }
    return row | columns


def a_table(
    teachers=THREE,
    learners=("eu", "cpt"),
    sizes=(25, 200, 2000),
    seeds=3,
    **columns,
):
    rng = np.random.default_rng(0)
    tasks = itertools.product(sizes, teachers, learners, range(seeds))
    rows = [
        a_fit(teacher, learner, pairs, seed, rng, **columns)
        for pairs, teacher, learner, seed in tasks
    ]
    numbers = pa.list_(pa.float64())
    schema = pa.schema(
        [
            ("teacher", pa.string()),
            ("learner", pa.string()),
            ("pairs", pa.int64()),
            ("seed", pa.int64()),
            *((name, pa.float64()) for name in ("regret", "regret_percent", "nll", "certainty")),
            ("theta", numbers),
            *((name, pa.float64()) for name in PARAMETERS),
            ("agreement", pa.float64()),
            ("converged", pa.bool_()),
            ("calibration_count", pa.list_(pa.int64())),
            ("calibration_predicted", numbers),
            ("calibration_preferred", numbers),
        ]
    )
    return pa.Table.from_pylist(rows, schema=schema)


def case(teachers=THREE, **options):
    return a_table(teachers, **options), teachers


OWN = tuple(
    Teacher(f"a-teacher-of-my-own-with-a-long-name-{index}", PROFILES["tk"], reward=(0.3,) * 8)
    for index in range(6)
)
EVERYBODY = ("eu", "cpt", "cpt-tied", "cpt-reference", "cpt-tied-reference", "a-learner-of-my-own")

CASES = {
    "default": lambda: case(),
    "one of everything": lambda: case((TEACHERS["tk"],), sizes=(100,), seeds=1),
    "one teacher": lambda: case((TEACHERS["strong"],)),
    "only eu": lambda: case(learners=("eu",)),
    "only cpt": lambda: case(learners=("cpt",)),
    "many learners": lambda: case(learners=EVERYBODY),
    "own teachers": lambda: case(OWN[:4]),
    "more teachers than there is room for": lambda: case(OWN),
    "zero regret": lambda: case(regret=0.0, regret_percent=0.0),
    "huge regret": lambda: case(regret_percent=12345.6),
    "many sizes": lambda: case(sizes=tuple(range(100, 3100, 100)), seeds=2),
    "nothing fitted": lambda: (a_table().slice(0, 0), THREE),
    "one teacher fitted": lambda: (a_table((TEACHERS["eu"],)), THREE),
    "nothing converged": lambda: case(converged=False),
    "nothing known": lambda: case(
        **dict.fromkeys(PARAMETERS),
        certainty=None,
        converged=None,
        calibration_count=[],
        calibration_predicted=None,
        calibration_preferred=None,
    ),
}


def texts_of(canvas):
    return [placed.text for placed in canvas.texts]


def has_colour(pixels, colour):
    return bool((pixels == colour).all(axis=-1).any())


@pytest.mark.parametrize(
    ("name", "size"),
    [
        *itertools.product(CASES, [(640, 400), (1600, 1000)]),
        *itertools.product(["default", "one teacher"], SIZES[3:]),
    ],
)
def test_texts_stay_on_the_page_and_off_one_another(name, size):
    canvas = compose_learning_picture(*CASES[name](), size)
    assert len(canvas.texts) > 5
    for text in canvas.texts:
        assert canvas.box.contains(text.box), text
    for first, second in itertools.combinations(canvas.texts, 2):
        assert not first.box.overlaps(second.box), (first, second)


@pytest.mark.parametrize("size", SIZES)
def test_the_png_has_the_size_asked_for_and_shows_something(tmp_path, size):
    path = tmp_path / "learning.png"
    write_learning_picture(path, *case(), size)
    pixels = cv2.imread(str(path))
    assert pixels.shape == (size[1], size[0], 3)
    assert 0.2 < (pixels == LIGHT.ground).all(axis=-1).mean() < 0.9


def test_every_learner_has_its_colour_and_none_that_of_contact():
    pixels = draw_learning_picture(*case(learners=("eu", "cpt", "cpt-tied")))
    for learner in ("eu", "cpt", "cpt-tied"):
        assert has_colour(pixels, LEARNER_COLOURS[learner])
    assert not has_colour(pixels, LIGHT.contact)
    assert not has_colour(draw_learning_picture(*case(learners=("eu",))), LEARNER_COLOURS["cpt"])


def test_the_page_says_what_was_studied_and_names_lines_beside_them():
    texts = texts_of(compose_learning_picture(*case()))
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
        for text in texts
    )
    for teacher in ("EU", "T&K", "Strong"):
        assert any(text.startswith("Teacher") and text.endswith(teacher) for text in texts)
    for learner in ("EU", "CPT"):
        assert sum(text.startswith(f"{learner} ") and text.endswith("%") for text in texts) == 3


def test_the_page_says_what_bands_and_whiskers_are_where_there_are_some():
    said = " ".join(texts_of(compose_learning_picture(*case())))
    assert "95 % bootstrap interval" in said
    assert "standard deviation" in said
    assert "interval" not in " ".join(texts_of(compose_learning_picture(*case(seeds=1))))


def test_fits_that_did_not_converge_are_counted():
    table, teachers = case()
    converged = [index % 9 != 0 for index in range(table.num_rows)]
    place = table.column_names.index("converged")
    some = table.set_column(place, "converged", pa.array(converged))
    assert "6 did not converge" in " ".join(texts_of(compose_learning_picture(some, teachers)))
    assert "all converged" in " ".join(texts_of(compose_learning_picture(table, teachers)))


def test_the_largest_size_is_compared_in_words():
    texts = " ".join(texts_of(compose_learning_picture(*case())))
    assert texts.count("CPT's regret is") == 3
    assert "regret is" not in " ".join(texts_of(compose_learning_picture(*case(learners=("cpt",)))))


def test_zero_regret_has_a_place_of_its_own_on_the_logarithmic_axis():
    assert "EU 0 %" not in texts_of(compose_learning_picture(*case()))
    canvas = compose_learning_picture(*case(regret_percent=0.0))
    assert "EU 0 %" in texts_of(canvas)
    assert "CPT 0 %" in texts_of(canvas)


def test_shapes_are_shown_only_if_somebody_learnt_them():
    assert "Weight of losses" in texts_of(compose_learning_picture(*case()))
    assert "Weight of losses" not in texts_of(compose_learning_picture(*case(learners=("eu",))))


def test_of_too_many_teachers_it_says_how_many_are_shown():
    assert any("4 of 6 teachers" in text for text in texts_of(compose_learning_picture(*case(OWN))))


def test_the_same_table_gives_the_same_picture_in_silence():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        first, second = (draw_learning_picture(*case()) for _ in range(2))
    assert np.array_equal(first, second)


def test_what_cannot_be_drawn_or_written_is_refused_in_one_line(tmp_path):
    with pytest.raises(InputError, match="size: 320x200"):
        draw_learning_picture(*case(), (320, 200))
    with pytest.raises(RunError, match="cannot be written"):
        write_learning_picture(tmp_path / "nowhere" / "learning.png", *case(), (640, 400))
