import json
import re
import subprocess
import sys
import tomllib
from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pytest
import rerun as rr
from rerun.chunk import RrdReader

from learners import (
    STUDY_SCHEMA,
    TEACHERS,
    CptParameters,
    Teacher,
    family_curves,
    learning_curves,
    scene_regrets,
    telling_scenes,
    value,
    weight,
)
from studio.recorder.axes import Axes, Scale, linear
from studio.study.links import SceneLink
from studio.study.recording.curves import AGREEMENT_CURVES, REGRET_CURVES
from studio.study.recording.families import NOTHING, family_figure, scene_percents
from studio.study.recording.minds import value_figure, visible
from studio.study.recording.write import SCHEMA_VERSION, write_study_recording
from studio.study.results import CURVE_COLUMNS, FAMILY_COLUMNS, StudyResults
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
            batch = batch.sort_by("pairs")
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


def test_curves_are_those_of_the_table(recording: Path, table: pa.Table) -> None:
    entities = read(recording)
    for column in CURVE_COLUMNS:
        for curve in learning_curves(table, column):
            rows = entities[f"/curves/{curve.teacher}/{curve.learner}"]
            assert rows["pairs"] == list(SIZES)
            sides = np.stack([curve.mean, curve.std, curve.low, curve.high], axis=1)
            expected = sides.reshape(len(SIZES), -1)
            np.testing.assert_allclose(rows[column], expected, err_msg=column)


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
    for column in FAMILY_COLUMNS:
        families = family_curves(table, column)
        for place, curve in enumerate(families["doorway"]):
            assert curve.learner == families["open"][place].learner
            rows = entities[f"/families/{curve.teacher}/{curve.learner}"]
            assert rows["pairs"] == list(SIZES)
            assert rows["family"] == [["doorway", "open"]] * len(SIZES)
            both = [families[family][place] for family in ("doorway", "open")]
            sides = np.array([[one.mean, one.std, one.low, one.high] for one in both])
            expected = sides.transpose(2, 1, 0).reshape(len(SIZES), -1)
            np.testing.assert_allclose(rows[column], expected, err_msg=column)


def test_every_held_out_scene_and_every_mean_is_drawn(recording: Path, table: pa.Table) -> None:
    results = StudyResults(table, PAIR)
    figure = family_figure(results)
    learnt = read(recording)["/figures/tk/families/learnt"]
    assert learnt["pairs"] == list(SIZES)
    regrets = results.scene_regrets(TEACHERS["tk"], "cpt", SIZES[-1])
    assert regrets is not None
    drawn = np.array([np.mean(strip, axis=0) for strip in learnt["LineStrips2D:strips"][-1]])
    percents = scene_percents(results, TEACHERS["tk"], regrets)
    for scene, percent in zip(regrets.scenes.tolist(), percents, strict=True):
        middle = figure.strip(results.scenes[scene].family, "cpt")
        beside = drawn[np.abs(drawn[:, 1] - middle) < figure.strip_height / 2.0]
        if percent > 0.0:
            assert np.abs(beside[:, 0] - figure.across(np.array(percent))).min() < 1e-5
        else:
            assert (beside[:, 0] < NOTHING).any()
    words = learnt["LineStrips2D:labels"][-1]
    for family, curves in family_curves(table, "regret").items():
        (curve,) = (one for one in curves if (one.teacher, one.learner) == ("tk", "cpt"))
        mean = 100.0 * curve.mean[-1] / RANDOM_REGRET[family]
        spot = (float(figure.across(mean)), figure.strip(family, "cpt"))
        assert np.abs(drawn - spot).sum(axis=1).min() < 1e-5
        assert f"{mean:.2f} %" in words


def test_every_scene_that_is_told_of_has_a_numbered_ring_a_learner(
    recording: Path, table: pa.Table
) -> None:
    learnt = read(recording)["/figures/tk/families/learnt"]
    numbers = [words for words in learnt["LineStrips2D:labels"][-1] if words.isdigit()]
    assert sorted(numbers) == ["1", "1", "2", "2", "3", "3"]
    assert len(telling_scenes(table, 3)["tk"]) == 3


def test_the_page_of_scenes_tells_of_those_that_differ_most(
    recording: Path, table: pa.Table
) -> None:
    page = read(recording)["/scenes"]
    assert page["pairs"] == list(SIZES)
    last = page["TextDocument:text"][-1][0]
    found = telling_scenes(table, 3)
    for teacher, title in (("eu", "## EU teacher"), ("tk", "## T&K teacher")):
        assert len(found[teacher]) == 3
        part = last[last.index(title) :].split("## ")[1]
        for scene in found[teacher]:
            assert f"[doorway-0-{scene} ↗](<scenes/doorway-0-{scene}.rrd>)" in part
            (each,) = (
                one
                for one in scene_regrets(table)
                if (one.teacher, one.learner, one.pairs) == (teacher, "cpt", SIZES[-1])
            )
            (at,) = np.flatnonzero(each.scenes == scene)
            percent = 100.0 * float(each.regret[at]) / RANDOM_REGRET[["doorway", "open"][scene % 2]]
            (row,) = (line for line in part.splitlines() if f"[doorway-0-{scene} ↗]" in line)
            assert "| stop | " in row
            assert f"| mixed | {each.runs[at]} of 3 |" in row
            said = f"{percent:.{0 if percent >= 10.0 else 1}f} %" if percent > 0.0 else "0 %"
            assert row.endswith(f"| {each.picks[at]}, {said} |")
    assert "make 0" in last


def test_without_recordings_of_scenes_the_page_says_so(table: pa.Table, tmp_path: Path) -> None:
    write_study_recording(tmp_path / "test.rrd", StudyResults(table, PAIR), {})
    for (text,) in read(tmp_path / "test.rrd")["/scenes"]["TextDocument:text"]:
        assert "These scenes have no recordings" in text
        assert "](" not in text


def test_a_family_without_a_curve_keeps_its_place_among_the_numbers(tmp_path: Path) -> None:
    results = StudyResults(table_with_a_gap(), THREE)
    write_study_recording(tmp_path / "gap.rrd", results, {})
    rows = read(tmp_path / "gap.rrd")["/families/eu/eu"]
    curve = results.family_curve("regret", "open", TEACHERS["eu"], "eu")
    assert curve is not None
    assert rows["family"] == [["doorway", "open"]]
    expected = [(np.nan, side[0]) for side in (curve.mean, curve.std, curve.low, curve.high)]
    np.testing.assert_array_equal(rows["regret"][0], np.ravel(expected))


def test_a_table_that_does_not_tell_of_its_scenes_has_no_families(
    table: pa.Table, tmp_path: Path
) -> None:
    bare = table.replace_schema_metadata(None)
    write_study_recording(tmp_path / "test.rrd", StudyResults(bare, PAIR), {})
    entities = read(tmp_path / "test.rrd")
    assert "/scenes" not in entities
    assert not [entity for entity in entities if "families" in entity]
    assert (
        "](<recording://figures/eu/families>)" not in entities["/about"]["TextDocument:text"][0][0]
    )


def test_drawn_means_lie_where_the_axes_put_them(recording: Path, table: pa.Table) -> None:
    axes = REGRET_CURVES.axes(StudyResults(table, PAIR))
    strips = read(recording)["/figures/tk/regret"]["LineStrips2D:strips"][0]
    for curve in learning_curves(table):
        if curve.teacher == "tk":
            expected = axes.points(curve.pairs, curve.mean)
            assert any(
                len(strip) == len(expected) and np.allclose(strip, expected, atol=1e-6)
                for strip in strips
            )


@pytest.mark.parametrize(
    ("figure", "curvature"), [("weights_of_gains", 0.61), ("weights_of_losses", 0.69)]
)
def test_the_true_weights_are_the_teachers(recording: Path, figure: str, curvature: float) -> None:
    strips = read(recording)[f"/figures/tk/{figure}/truth"]["LineStrips2D:strips"][0]
    p, drawn = np.concatenate(strips).T
    np.testing.assert_allclose(drawn, weight(p.clip(0.0, 1.0), curvature), atol=0.03)
    inside = (p > 0.02) & (p < 0.98)
    expected = weight(p[inside], curvature)
    np.testing.assert_allclose(drawn[inside], expected, atol=2e-3)


def test_the_true_value_is_the_teachers(recording: Path) -> None:
    teacher = TEACHERS["tk"]
    mind = value_figure(teacher)
    utilities = np.linalg.norm(teacher.reward) * mind.x
    np.testing.assert_allclose(mind.truth, value(utilities, teacher.parameters))
    strips = read(recording)["/figures/tk/values/truth"]["LineStrips2D:strips"][0]
    page = np.concatenate(strips)
    expected = np.interp(page[:, 0], *mind.axes.points(mind.x, mind.truth).T)
    np.testing.assert_allclose(page[:, 1], expected, atol=1e-3)


def test_minds_sharpen_over_pairs(recording: Path) -> None:
    entities = read(recording)
    learnt = entities["/figures/tk/weights_of_losses/learnt"]
    assert learnt["pairs"] == list(SIZES)
    off = []
    for strips in learnt["LineStrips2D:strips"]:
        # every seed of both learners, once if alike, then their means
        assert len(strips) == 1 + 3 + 2
        p, drawn = np.array(strips[-1]).T
        off.append(np.abs(drawn - weight(p.clip(0.0, 1.0), 0.69)).mean())
    assert off[1] < off[0]


def test_pages_tell_the_numbers_of_their_time(recording: Path, table: pa.Table) -> None:
    page = read(recording)["/pages/tk"]
    assert page["pairs"] == list(SIZES)
    (curve,) = (
        curve for curve in learning_curves(table) if (curve.teacher, curve.learner) == ("tk", "cpt")
    )
    for place, rows in enumerate(page["TextDocument:text"]):
        assert f"T&K after {SIZES[place]} pairs" in rows[0]
        assert f"{curve.mean[place]:.2f} ± {curve.std[place]:.2f}" in rows[0]
        assert "bands: 95 % intervals of the means" in rows[0]


def test_the_summary_has_the_table_of_regrets(recording: Path, table: pa.Table) -> None:
    entities = read(recording)
    for page in ("/summary", "/about"):
        text = entities[page]["TextDocument:text"][0][0]
        for curve in learning_curves(table):
            for mean, std in zip(curve.mean, curve.std, strict=True):
                assert f"{mean:.2f} ± {std:.2f}" in text


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


def test_links_lead_to_what_is_there(recording: Path) -> None:
    entities = read(recording)
    for page in ("/summary", "/about"):
        targets = re.findall(r"recording://([^)>]+)", entities[page]["TextDocument:text"][0][0])
        assert targets
        for target in targets:
            assert f"/{target}" in entities, target


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
                entity = path.replace("{teacher}", teacher.name).replace("{learner}", learner)
                absent = {"alpha", "eta", "lambda", "gamma", "delta"} if learner == "eu" else set()
                is_of_learner = "{learner}" in path
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
    assert {"Overview", "EU", "T&K", "Families", "Calibration", "About"} <= names
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
def test_regrets_of_any_size_are_drawn(regret: float, tmp_path: Path) -> None:
    table = study_table(PAIR[:1], ["eu"], SIZES, 2)
    place = table.column_names.index("regret_percent")
    table = table.set_column(
        place, STUDY_SCHEMA.field("regret_percent"), pa.array([regret] * table.num_rows)
    )
    write_study_recording(tmp_path / "test.rrd", StudyResults(table, PAIR), {})
    strips = read(tmp_path / "test.rrd")["/figures/eu/regret"]["LineStrips2D:strips"][0]
    assert np.isfinite(np.concatenate(strips)).all()


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


@pytest.mark.parametrize("lowest", [0.0, 0.57, 0.74, 0.9, 0.999, 1.0])
def test_ticks_of_the_best_action_found_are_fine_where_the_data_are(lowest: float) -> None:
    table = study_table(PAIR[:1], ["eu"], [25], 1)
    place = table.column_names.index("agreement")
    table = table.set_column(place, STUDY_SCHEMA.field("agreement"), pa.array([lowest]))
    ticks = AGREEMENT_CURVES.axes(StudyResults(table, PAIR)).y.ticks
    assert ticks[-1] == 1.0
    assert ticks[0] <= lowest + 1e-9
    assert 2 <= len(ticks) <= 11
    assert ticks[1] - ticks[0] < max(0.011, (1.0 - lowest) / 3.0)


def test_functions_are_cut_where_they_leave_the_page() -> None:
    axes = Axes(linear((0.0, 1.0)), Scale((-1.0, 1.0), ("", "")))
    x = np.linspace(0.0, 1.0, 5)
    np.testing.assert_allclose(visible(axes, x, 4.0 * x - 2.0)[[0, -1]], [(0.25, 0.0), (0.75, 1.0)])
