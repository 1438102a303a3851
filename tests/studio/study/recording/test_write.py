import json
import re
import subprocess
import sys
import tomllib
from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pyarrow as pa
import pytest
import rerun as rr
from rerun.chunk import RrdReader

from learners import (
    TEACHERS,
    CptParameters,
    Teacher,
    family_curves,
    learning_curves,
    scene_regrets,
    telling_scenes,
)
from studio.study.fits import calibration_with_intervals
from studio.study.links import SceneLink
from studio.study.recording.write import SCHEMA_VERSION, write_study_recording
from studio.study.results import StudyResults
from tests.studio.study.tables import RANDOM_REGRET, THREE, study_table, table_with_a_gap

REFERENCE = Path(__file__).parents[4] / "recordings" / "README.md"
SETTINGS: dict[str, Any] = {"outcomes": "bank.parquet"}
PAIR = (TEACHERS["eu"], TEACHERS["tk"])
SIZES = (25, 100)
LINKS = {
    number: SceneLink(f"doorway-0-{number}", f"scenes/doorway-0-{number}.rrd", (f"make {number}",))
    for number in range(12)
}


@pytest.fixture(autouse=True)
def _strict() -> Iterator[None]:
    before = rr.strict_mode()
    rr.set_strict_mode(True)
    yield
    rr.set_strict_mode(before)


@pytest.fixture(scope="module")
def table() -> pa.Table:
    return study_table(PAIR, sizes=SIZES)


@pytest.fixture(scope="module")
def recording(table: pa.Table, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("recording") / "learning.rrd"
    write_study_recording(path, StudyResults(table, tuple(TEACHERS.values())), SETTINGS, LINKS)
    return path


def read(path: Path) -> dict[str, dict[str, list[Any]]]:
    """Entity path, then component or timeline, to its rows in the order of time."""
    entities: dict[str, dict[str, list[Any]]] = defaultdict(dict)
    for chunk in RrdReader(path).stream().to_chunks():
        batch = chunk.to_record_batch()
        if not chunk.is_static:
            batch = batch.sort_by("row" if "row" in batch.schema.names else "pairs")
        for name in batch.schema.names:
            if name != "rerun.controls.RowId":
                rows = entities[str(chunk.entity_path)].setdefault(name, [])
                rows.extend(batch.column(name).to_pylist())
    return entities


def test_what_was_written_can_be_verified(recording: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "rerun", "rrd", "verify", str(recording)],
        capture_output=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr


def marks(rows: dict[str, list[Any]], component: str, what: str, learner: str) -> np.ndarray:
    """What a plot has of the marks of a learner that are called so, [sizes, marks]."""
    (of,), (words,) = rows["learner"], rows["what"]
    places = [
        place
        for place, (name, word) in enumerate(zip(of, words, strict=True))
        if name == learner and word.startswith(what)
    ]
    return np.array(rows[component])[:, places]


@pytest.mark.parametrize(
    ("name", "column", "place"),
    [
        ("regret", "regret_percent", np.log10),
        ("agreement", "agreement", lambda share: 100.0 * share),
        ("likelihood", "nll", np.asarray),
        ("parameters/lambda", "lambda", np.asarray),
    ],
)
def test_curves_are_those_of_the_table(
    recording: Path, table: pa.Table, name: str, column: str, place: Callable[..., Any]
) -> None:
    entities = read(recording)
    curves = [curve for curve in learning_curves(table, column) if curve.teacher == "tk"]
    rows, bands = entities[f"/curves/tk/{name}"], entities[f"/curves/tk/{name}/interval"]
    assert rows["pairs"] == bands["pairs"] == list(SIZES)
    for index, curve in enumerate(curves):
        drawn = marks(rows, "Scalars:scalars", "mean", curve.learner)
        np.testing.assert_allclose(drawn[:, 0], place(curve.mean))
        seeds = marks(rows, "Scalars:scalars", "seed", curve.learner)
        np.testing.assert_allclose(seeds, place(np.array(curve.samples)))
        middle = np.array(bands["Measurements:values"])[:, index]
        reach = np.sqrt(np.array(bands["Measurements:variances"])[:, index])
        np.testing.assert_allclose(middle - reach, place(curve.low))
        np.testing.assert_allclose(middle + reach, place(curve.high))


def test_every_mark_of_a_plot_says_what_it_is(recording: Path, table: pa.Table) -> None:
    rows = read(recording)["/curves/tk/regret"]
    (curve,) = (
        curve for curve in learning_curves(table) if (curve.teacher, curve.learner) == ("tk", "cpt")
    )
    assert rows["teacher"] == [["tk"]]
    (words,) = rows["what"]
    assert words == [
        *["seed 0", "seed 1", "seed 2"] * 2,
        *["interquartile mean"] * 2,
        *["mean"] * 2,
    ]
    (names,) = rows["SeriesPoints:names"]
    assert names[3] == "CPT learner: seed 0"
    assert rows["SeriesLines:names"] == [names]
    told = marks(rows, "value", "mean", "cpt")[-1, 0]
    assert told == f"{curve.mean[-1]:.3g} [{curve.low[-1]:.3g}, {curve.high[-1]:.3g}]"
    middle = marks(rows, "value", "interquartile", "cpt")[-1, 0]
    ends = f"[{curve.middle_low[-1]:.3g}, {curve.middle_high[-1]:.3g}]"
    assert middle == f"{curve.middle[-1]:.3g} {ends}"


def test_parameters_stand_beside_the_truth(recording: Path) -> None:
    entities = read(recording)
    for name, number in (("parameters/lambda", 2.25), ("parameters/gamma", 0.61)):
        rows = entities[f"/curves/tk/{name}"]
        assert marks(rows, "Scalars:scalars", "truth", "").tolist() == [[number]] * 2
    theta = entities["/curves/tk/theta/progress"]
    reward = np.array(TEACHERS["tk"].reward)
    np.testing.assert_allclose(
        marks(theta, "Scalars:scalars", "truth", ""), reward[2] / np.linalg.norm(reward)
    )


def test_every_fit_is_there(recording: Path, table: pa.Table) -> None:
    entities = read(recording)
    rows = table.to_pylist()
    for teacher, learner in (("eu", "eu"), ("tk", "cpt")):
        fits = entities[f"/fits/{teacher}/{learner}"]
        for place, pairs in enumerate(SIZES):
            ours = [
                row
                for row in rows
                if (row["teacher"], row["learner"], row["pairs"]) == (teacher, learner, pairs)
            ]
            assert fits["pairs"][place] == pairs
            assert fits["seed"][place] == [0, 1, 2]
            assert fits["converged"][place] == [True, True, True]
            picks = [pick for row in ours for pick in row["scene_picks"]]
            assert fits["scene_picks"][place] == picks
            for column in (
                *("regret", "nll", "theta", "theta_unit", "calibration_count"),
                *("held_out_scenes", "scene_regret"),
            ):
                given = np.ravel([row[column] for row in ours])
                np.testing.assert_allclose(fits[column][place], given, err_msg=column)
    assert "alpha" not in entities["/fits/tk/eu"]
    assert "alpha" in entities["/fits/tk/cpt"]


def test_regret_by_family_is_that_of_the_table(recording: Path, table: pa.Table) -> None:
    entities = read(recording)
    for family, curves in family_curves(table, "regret").items():
        for curve in curves:
            rows = entities[f"/curves/{curve.teacher}/families/{family}"]
            drawn = marks(rows, "Scalars:scalars", "mean", curve.learner)
            np.testing.assert_allclose(
                drawn[:, 0], np.log10(100.0 * curve.mean / RANDOM_REGRET[family])
            )


def test_every_fit_and_held_out_scene_has_its_row_in_a_table(
    recording: Path, table: pa.Table
) -> None:
    entities = read(recording)
    fits = entities["/tables/fits"]
    assert fits["row"] == list(range(table.num_rows))
    regrets = np.array(fits["regret_percent"]).ravel()
    np.testing.assert_allclose(regrets, table["regret_percent"].to_numpy(), atol=1e-3)
    scenes = entities["/tables/scenes"]
    expected = [each for each in scene_regrets(table) if each.pairs == SIZES[-1]]
    assert len(scenes["row"]) == sum(len(each.scenes) for each in expected)
    (whose,) = (each for each in expected if (each.teacher, each.learner) == ("tk", "cpt"))
    rows = zip(
        *(scenes[name] for name in ("teacher", "learner", "scene", "learner_picks")), strict=True
    )
    found = {row[2][0]: row[3][0] for row in rows if (row[0], row[1]) == (["tk"], ["cpt"])}
    assert found == dict(zip(whose.scenes.tolist(), whose.picks, strict=True))


def test_the_table_of_learners_has_means_with_their_intervals(
    recording: Path, table: pa.Table
) -> None:
    rows = read(recording)["/tables/learners"]
    curves = learning_curves(table)
    for name, side in (
        ("regret_percent", "mean"),
        ("regret_percent_low", "low"),
        ("middle", "middle"),
        ("middle_high", "middle_high"),
    ):
        expected = np.concatenate([getattr(curve, side) for curve in curves])
        np.testing.assert_allclose(np.ravel(rows[name]), expected, atol=1e-3)


def test_bars_of_calibration_reach_to_the_ends_of_the_interval(
    recording: Path, table: pa.Table
) -> None:
    entities = read(recording)
    fits = StudyResults(table, PAIR).fits_of(TEACHERS["tk"], "cpt", SIZES[-1])
    predicted, preferred, low, high = calibration_with_intervals(fits)
    for name, heights in (("1_high", high), ("2_low", low), ("3_predicted", predicted)):
        (drawn,) = entities[f"/calibration/tk/cpt/{name}"]["BarChart:values"][-1]
        np.testing.assert_allclose(drawn["buffer"], heights)
    counts = np.array([fit["calibration_count"] for fit in fits])
    own = np.nan_to_num(np.array([fit["calibration_preferred"] for fit in fits], dtype=float))
    some = counts.sum(axis=0) > 0
    pooled = (counts * own).sum(axis=0)[some] / counts.sum(axis=0)[some]
    np.testing.assert_allclose(preferred[some], pooled)
    assert (preferred[~some] == 0.0).all()


def test_the_interval_of_a_calibration_holds_seeds_that_differ() -> None:
    fits = [
        {
            "calibration_count": [10],
            "calibration_predicted": [0.5],
            "calibration_preferred": [share],
        }
        for share in (0.2, 0.4, 0.6, 0.8)
    ]
    _, (preferred,), (low,), (high,) = calibration_with_intervals(fits)
    assert preferred == pytest.approx(0.5)
    assert 0.2 < low < 0.5 < high < 0.8


def test_what_is_learnt_is_drawn_for_each_number_of_pairs(recording: Path) -> None:
    shapes = read(recording)["/shapes/tk"]
    assert shapes["pairs"] == list(SIZES)
    few, many = (
        cv2.imdecode(np.frombuffer(bytes(blob[0]), np.uint8), cv2.IMREAD_COLOR)
        for blob in shapes["EncodedImage:blob"]
    )
    assert few.shape == many.shape
    assert (few != many).any()


def test_the_page_of_scenes_tells_of_those_that_differ_most(
    recording: Path, table: pa.Table
) -> None:
    entities, found = read(recording), telling_scenes(table, 3)
    for teacher in ("eu", "tk"):
        page = entities[f"/scenes/{teacher}"]
        assert page["pairs"] == list(SIZES)
        part = page["TextDocument:text"][-1][0]
        assert "make 0" in part
        assert len(found[teacher]) == 3
        for scene in found[teacher]:
            name = f"{['doorway', 'open'][scene % 2]} {scene} ↗"
            assert f"[{name}](<scenes/doorway-0-{scene}.rrd>)" in part
            (each,) = (
                one
                for one in scene_regrets(table)
                if (one.teacher, one.learner, one.pairs) == (teacher, "cpt", SIZES[-1])
            )
            (at,) = np.flatnonzero(each.scenes == scene)
            percent = 100.0 * float(each.regret[at]) / RANDOM_REGRET[["doorway", "open"][scene % 2]]
            (row,) = (line for line in part.splitlines() if f"[{name}]" in line)
            assert "| stop | " in row
            said = f"{percent:.{0 if percent >= 10.0 else 1}f} %" if percent > 0.0 else "0 %"
            assert row.endswith(f"| {each.picks[at]}, {said} ({each.runs[at]}) |")


def test_without_recordings_of_scenes_the_page_says_so(table: pa.Table, tmp_path: Path) -> None:
    write_study_recording(tmp_path / "test.rrd", StudyResults(table, PAIR), {})
    for (text,) in read(tmp_path / "test.rrd")["/scenes/tk"]["TextDocument:text"]:
        assert "These scenes have no recordings" in text
        assert "](" not in text


def test_a_learner_without_a_curve_in_a_family_is_left_out_of_its_plot(tmp_path: Path) -> None:
    results = StudyResults(table_with_a_gap(), THREE)
    write_study_recording(tmp_path / "gap.rrd", results, {})
    entities = read(tmp_path / "gap.rrd")
    assert set(entities["/curves/eu/families/doorway"]["learner"][0]) == {"cpt"}
    assert set(entities["/curves/eu/families/open"]["learner"][0]) == {"eu", "cpt"}


def test_a_table_that_does_not_tell_of_its_scenes_has_no_families(
    table: pa.Table, tmp_path: Path
) -> None:
    bare = table.replace_schema_metadata(None)
    write_study_recording(tmp_path / "test.rrd", StudyResults(bare, PAIR), {})
    entities = read(tmp_path / "test.rrd")
    assert not [entity for entity in entities if "families" in entity or "scenes" in entity]


def test_pages_tell_the_numbers_of_their_time(recording: Path, table: pa.Table) -> None:
    page = read(recording)["/pages/tk"]
    assert page["pairs"] == list(SIZES)
    (curve,) = (
        curve for curve in learning_curves(table) if (curve.teacher, curve.learner) == ("tk", "cpt")
    )
    for place, rows in enumerate(page["TextDocument:text"]):
        assert f"T&K after {SIZES[place]} pairs" in rows[0]
        low, high = curve.low[place], curve.high[place]
        assert f"| {curve.mean[place]:.2f} [{low:.2f}, {high:.2f}] |" in rows[0]


def test_the_summary_has_all_regrets_with_their_intervals(recording: Path, table: pa.Table) -> None:
    text = read(recording)["/summary"]["TextDocument:text"][0][0]
    for curve in learning_curves(table):
        told = curve.at(SIZES[-1])
        assert told is not None
        assert f"| {told.mean:.2f} [{told.low:.2f}, {told.high:.2f}] |" in text
        assert f"| {told.middle:.2f} [{told.middle_low:.2f}, {told.middle_high:.2f}] |" in text


def test_the_page_tells_the_command_and_all_settings(recording: Path) -> None:
    page = read(recording)["/about"]["TextDocument:text"][0][0]
    command = (
        "studio learn --outcomes bank.parquet --teachers eu,tk --learners eu,cpt "
        "--pairs 25,100 --seeds 3"
    )
    assert command in page
    for line in ("| held_out | 0.25 |", "| bank | abc |", "| learner: EU | deviation 1 |"):
        assert line in page


def test_teachers_of_ones_own_are_part_of_the_command(tmp_path: Path) -> None:
    own = Teacher("cautious", CptParameters(0.9, 0.9, 9.0, 0.6, 0.7), beta=5.0)
    path = tmp_path / "own.rrd"
    results = StudyResults(study_table([own], ["cpt"]), (own,))
    write_study_recording(path, results, {})
    (row,) = read(path)["/__properties/study"]["command"]
    assert "--profile cautious=0.9,0.9,9,0.6,0.7 --beta 5 --learners cpt" in row[0]


def test_properties_suffice_to_make_it_again(recording: Path) -> None:
    entities = read(recording)
    study = {name: rows[0] for name, rows in entities["/__properties/study"].items()}
    assert study["schema_version"] == [SCHEMA_VERSION]
    assert (study["learners"], study["pairs"], study["seeds"]) == (["eu", "cpt"], [25, 100], [3])
    teachers = tomllib.loads(study["teachers"][0])
    assert teachers == {teacher.name: teacher.description() for teacher in PAIR}
    assert json.loads(study["study"][0])["bank"] == "abc"
    assert tomllib.loads(study["versions"][0])["rerun-sdk"] == rr.__version__
    settings = entities["/__properties/settings"]
    assert {name: rows[0][0] for name, rows in settings.items()} == SETTINGS


def test_the_reference_names_every_entity_and_component(recording: Path) -> None:
    described: dict[str, set[str]] = defaultdict(set)
    text = REFERENCE.read_text(encoding="utf-8")
    start, end = text.index("# What `learning.rrd` contains"), text.index("# What a comparison")
    for row in text[start:end].splitlines():
        cells = row.split(" | ")
        if not row.startswith("| `/"):
            continue
        path, components = cells[0].strip("| `"), set(re.findall(r"`([^`]+)`", cells[1]))
        if cells[1].strip() == "any":
            components = set(SETTINGS)
        timelines = set(re.findall(r"`([^`]+)`", cells[2]))
        for teacher in PAIR:
            for learner in ("eu", "cpt"):
                absent = {"alpha", "eta", "lambda", "gamma", "delta"} if learner == "eu" else set()
                is_of_learner = "{learner}" in path
                for family in ("doorway", "open"):
                    entity = path.format(teacher=teacher.name, learner=learner, family=family)
                    described[entity] |= (
                        components - absent if is_of_learner else components
                    ) | timelines
    written = {path: set(names) for path, names in read(recording).items()}
    assert written == described


def test_the_reference_has_the_edition_of_the_layout() -> None:
    text = REFERENCE.read_text(encoding="utf-8")
    words = " ".join(text[text.index("# What `learning.rrd` contains") :].split())
    assert f"edition {SCHEMA_VERSION} of the layout" in words


def test_opens_at_the_end_with_a_tab_a_teacher(recording: Path) -> None:
    reader = RrdReader(recording)
    (blueprint,) = reader.blueprints()
    names, timelines = set(), set()
    for chunk in reader.stream(store=blueprint).to_chunks():
        batch = chunk.to_record_batch()
        for component in ("ContainerBlueprint:display_name", "ViewBlueprint:display_name"):
            if component in batch.schema.names:
                names |= {name for row in batch.column(component).to_pylist() for name in row or []}
        if "TimePanelBlueprint:timeline" in batch.schema.names:
            timelines |= {
                name
                for row in batch.column("TimePanelBlueprint:timeline").to_pylist()
                for name in row
            }
    assert {
        "Overview",
        "EU",
        "T&K",
        "Parameters",
        "Families",
        "Calibration",
        "Tables",
        "About",
    } <= names
    assert "Strong" not in names
    assert timelines == {"pairs"}


@pytest.mark.parametrize(
    ("table", "teachers"),
    [
        (study_table(PAIR[1:], ["cpt"], [50], 1), PAIR[1:]),
        (study_table(PAIR, ["eu"], SIZES, 2), PAIR),
        (study_table(PAIR, ["cpt-tied", "eu", "cpt", "cpt-reference", "my own"], SIZES, 2), PAIR),
        (study_table(PAIR, ["eu", "cpt"], range(1, 40), 1), PAIR),
        (study_table(PAIR, sizes=SIZES).slice(0, 20), PAIR),
        (study_table(PAIR, sizes=SIZES).replace_schema_metadata(None), PAIR),
        (
            study_table(
                [replace(PAIR[0], name=f"aunt/№ {number} & <co>!") for number in range(6)], seeds=1
            ),
            [replace(PAIR[0], name=f"aunt/№ {number} & <co>!") for number in range(6)],
        ),
    ],
    ids=[
        "one of each",
        "EU only",
        "many learners",
        "many sizes",
        "interrupted",
        "no metadata",
        "long names",
    ],
)
def test_unusual_studies_can_be_written(
    table: pa.Table, teachers: Sequence[Teacher], tmp_path: Path
) -> None:
    path = tmp_path / "unusual.rrd"
    write_study_recording(path, StudyResults(table, tuple(teachers)), {})
    assert sum(entity.endswith("/regret") for entity in read(path)) == len(teachers)


@pytest.mark.parametrize("regret", [0.0, 1e-9, 400.0])
def test_regrets_of_any_size_have_a_place(regret: float, tmp_path: Path) -> None:
    table = study_table(PAIR[:1], ["eu"], SIZES, 2, regret_percent=regret)
    write_study_recording(tmp_path / "test.rrd", StudyResults(table, PAIR), {})
    places = np.array(read(tmp_path / "test.rrd")["/curves/eu/regret"]["Scalars:scalars"])
    expected = np.log10(regret) if regret > 0.0 else np.log10(0.05)
    np.testing.assert_allclose(places, expected)


def test_a_teacher_who_wants_nothing_can_be_written(tmp_path: Path) -> None:
    idle = Teacher("idle", TEACHERS["tk"].parameters, reward=(0.0,) * 5)
    write_study_recording(tmp_path / "test.rrd", StudyResults(study_table([idle]), (idle,)), {})


def test_a_full_disk_is_an_error_and_not_a_file_cut_short(table: pa.Table) -> None:
    with pytest.raises(OSError, match="No space left"):
        write_study_recording(Path("/dev/full"), StudyResults(table, PAIR), {})


def test_what_cannot_be_logged_is_an_error_even_if_rerun_is_lenient(
    table: pa.Table, tmp_path: Path
) -> None:
    rr.set_strict_mode(False)
    settings: Any = {"unloggable": object()}
    with pytest.raises(ValueError, match="arrow"):
        write_study_recording(tmp_path / "learning.rrd", StudyResults(table, PAIR), settings)
