import re
import tomllib
from collections import defaultdict
from dataclasses import asdict, replace
from pathlib import Path

import numpy as np
import pytest
import rerun as rr

from learners import value
from scenes import FEATURES, META_ACTIONS, MetaAction, Rollouts, scene_from_toml
from studio.scene.judgements import judge, utilities
from studio.scene.recording.write import SCHEMA_VERSION, write_recording
from studio.style.palette import ACTION_COLOURS, LIGHT
from studio.style.words import action_label
from tests.entities import read_blueprint, read_entities, verify
from tests.studio.scene.made_up import make_rollouts

pytestmark = pytest.mark.usefixtures("strict_rerun")

REFERENCE = Path(__file__).parents[4] / "recordings" / "README.md"
HALF_A_STEP = 1.0 / 256.0


def test_what_was_written_can_be_verified(recording: Path) -> None:
    verify(recording)


def test_every_action_has_its_robots_people_paths_and_figure(
    recording: Path, rollouts: Rollouts
) -> None:
    entities = read_entities(recording)
    for action in rollouts.actions:
        for part in ("robots", "pedestrians", "paths"):
            assert f"/world/actions/{action.name}/{part}" in entities
        assert f"/figures/actions/{action.name}" in entities


def test_positions_and_headings_are_those_that_were_given(
    recording: Path, rollouts: Rollouts
) -> None:
    entities = read_entities(recording)
    for index, action in enumerate(rollouts.actions):
        robots = entities[f"/world/actions/{action.name}/robots"]
        positions = np.array(robots["Points2D:positions"]).swapaxes(0, 1)
        np.testing.assert_allclose(positions, rollouts.robot[index, ..., :2], atol=HALF_A_STEP)
        heading = np.array(robots["heading"]).swapaxes(0, 1)
        np.testing.assert_allclose(heading, rollouts.robot[index, ..., 2], atol=2 * HALF_A_STEP)
        people = entities[f"/world/actions/{action.name}/pedestrians"]["Points2D:positions"]
        given = rollouts.pedestrians[index].swapaxes(0, 1)
        np.testing.assert_allclose(np.array(people).reshape(given.shape), given, atol=HALF_A_STEP)


def test_time_runs_in_seconds_and_in_steps(recording: Path, rollouts: Rollouts) -> None:
    robots = read_entities(recording)["/world/actions/forward/robots"]
    assert robots["step"] == list(range(6))
    seconds = [time.total_seconds() for time in robots["sim_time"]]
    assert seconds == pytest.approx([0.0, 0.1, 0.2, 0.3, 0.4, 0.5])


def test_a_robot_is_red_from_the_step_of_its_contact(recording: Path) -> None:
    entities = read_entities(recording)
    touched = np.array(entities["/world/actions/forward/robots"]["Points2D:class_ids"]) == 0
    assert touched[:, 0].tolist() == [False, False, True, True, True, True]
    assert not touched[:, 1:].any()
    colours = {
        info["class_id"]: info["class_description"]["info"]["color"]
        for info in entities["/world"]["AnnotationContext:context"][0][0]
    }
    expected = [LIGHT.contact, *ACTION_COLOURS[:2]]
    assert colours == {
        number: (red << 24) | (green << 16) | (blue << 8) | 255
        for number, (red, green, blue) in enumerate(expected)
    }


def test_contacts_are_marked_where_they_happen(recording: Path, rollouts: Rollouts) -> None:
    strips = read_entities(recording)["/world/actions/forward/paths"]["LineStrips2D:strips"][0]
    *_, first, second = strips
    place = rollouts.robot[0, 0, 2, :2]
    for stroke in (first, second):
        np.testing.assert_allclose(np.mean(stroke, axis=0), place, atol=HALF_A_STEP)


def test_the_path_of_the_robot_drawn_in_full_lies_above_the_others(
    recording: Path, rollouts: Rollouts
) -> None:
    paths = read_entities(recording)["/world/actions/forward/paths"]
    strips, count = paths["LineStrips2D:strips"][0], len(rollouts.robot[0])
    assert strips[count] == strips[0]
    assert len(set(paths["LineStrips2D:colors"][0][: count + 1])) == 2


def test_an_arrowhead_shows_where_the_robot_faces(recording: Path, rollouts: Rollouts) -> None:
    robots = read_entities(recording)["/world/actions/slow_down/robots"]
    corners = np.array([row[0] for row in robots["LineStrips2D:strips"]])  # (T+1, 3, 2)
    x, y, heading = rollouts.robot[1, 0].T
    forwards = corners[:, 1] - corners[:, [0, 2]].mean(axis=1)
    faced = np.arctan2(forwards[:, 1], forwards[:, 0])
    np.testing.assert_allclose(faced, heading, atol=0.05)
    away = np.hypot(corners[..., 0] - x[:, None], corners[..., 1] - y[:, None])
    assert away.max() < 0.25  # it lies on the robot's disc


def test_bars_join_the_people_of_a_group(recording: Path, rollouts: Rollouts) -> None:
    people = read_entities(recording)["/world/actions/forward/pedestrians"]
    bars = np.array(people["LineStrips2D:strips"])  # (T+1, 1, 2, 2)
    np.testing.assert_allclose(bars[:, 0], rollouts.pedestrians[0, 0], atol=HALF_A_STEP)


def test_dots_show_the_utility_of_every_outcome(recording: Path, rollouts: Rollouts) -> None:
    shape = rollouts.features.shape[:2]
    dots = read_entities(recording)["/figures/prospects/outcomes"]["Points2D:positions"][0]
    x, y = np.array(dots).reshape(*shape, 2).transpose(2, 0, 1)
    ranked = np.sort(utilities(rollouts), axis=-1)
    assert (np.diff(x, axis=1) > 0.0).all()
    slope, offset = np.polyfit(ranked.ravel(), y.ravel(), 1)  # all actions on one scale
    assert slope > 0.0
    np.testing.assert_allclose(y, offset + slope * ranked, atol=1.0 / 512.0)


def test_the_drawn_weights_and_utilities_make_the_values(
    recording: Path, rollouts: Rollouts
) -> None:
    strips = read_entities(recording)["/figures/prospects"]["LineStrips2D:strips"][0]
    actions, count = rollouts.features.shape[:2]
    stairs = np.array([strip for strip in strips if len(strip) == 2 * count])
    levels = stairs[:, ::2, 1].reshape(actions, -1, count)  # a line a teacher, in some order
    unit = next(line[0] for line in levels[0] if np.ptp(line) < 1e-6)  # EU counts all alike
    ranked = np.sort(utilities(rollouts), axis=-1)
    for judgement in judge(rollouts):
        values = np.asarray(value(ranked, judgement.parameters))[:, None]
        summed = (levels / unit * values).mean(axis=-1)  # (A, lines)
        gap = np.abs(summed - judgement.values[:, None]).min(axis=1)
        assert (gap < 0.01).all()


def test_ranks_are_those_of_the_values(recording: Path, rollouts: Rollouts) -> None:
    figure = read_entities(recording)["/figures/ranks"]
    words = figure["LineStrips2D:labels"][0]
    places = [strip[0] for strip in figure["LineStrips2D:strips"][0]]  # labels come first
    best_first = sorted(zip(words, places, strict=False), key=lambda label: -label[1][1])
    names = [word for word, _ in best_first if word in {"forward", "slow down"}]
    by_eu, *_, by_strong = judge(rollouts)
    expected = {action_label(rollouts.names[each.best]) for each in (by_eu, by_strong)}
    assert set(names[:2]) == expected  # on the left and on the right
    for judgement in judge(rollouts):
        for worth in judgement.values:
            assert f"{worth:.3f}".replace("-", "−") in words


def test_outcomes_are_those_that_were_given(recording: Path, rollouts: Rollouts) -> None:
    outcomes = read_entities(recording)["/outcomes"]
    for column, feature in enumerate(FEATURES):
        given = rollouts.features[..., column].ravel()
        np.testing.assert_allclose(outcomes[feature][0], given, rtol=1e-6)
    assert outcomes["person_step"][0] == rollouts.person_step.ravel().tolist()
    assert outcomes["wall_step"][0] == rollouts.wall_step.ravel().tolist()


def test_judgements_are_those_that_were_given(recording: Path, rollouts: Rollouts) -> None:
    values = read_entities(recording)["/judgements"]
    for judgement in judge(rollouts):
        np.testing.assert_allclose(values[judgement.teacher][0], judgement.values)


def test_clearance_is_the_median_gap_to_the_nearest_person(
    recording: Path, rollouts: Rollouts
) -> None:
    apart = rollouts.pedestrians - rollouts.robot[..., None, :2]
    gap = np.hypot(apart[..., 0], apart[..., 1]).min(axis=-1) - 0.45
    series = np.array(read_entities(recording)["/clearance"]["Scalars:scalars"])
    np.testing.assert_allclose(series, np.median(gap, axis=1).T)


def test_properties_suffice_to_make_it_again(recording: Path, rollouts: Rollouts) -> None:
    entities = read_entities(recording)
    assert scene_from_toml(entities["/__properties/scene"]["toml"][0][0]) == rollouts.scene
    simulation = {name: rows[0][0] for name, rows in entities["/__properties/simulation"].items()}
    assert simulation["schema_version"] == SCHEMA_VERSION
    assert simulation["seed"] == rollouts.seed
    assert simulation["rollouts"] == 3
    assert (simulation["dt"], simulation["horizon"]) == (0.1, 0.5)
    assert (simulation["model"], simulation["engine"]) == ("extended", "batched")
    assert simulation["wrap_angles"] is True
    assert tomllib.loads(simulation["noise"]) == asdict(rollouts.noise)
    assert tomllib.loads(simulation["limits"]) == asdict(rollouts.limits)
    actions = tomllib.loads(simulation["actions"])["actions"]
    assert tuple(MetaAction(**action) for action in actions) == rollouts.actions
    assert tomllib.loads(simulation["versions"])["rerun-sdk"] == rr.__version__


def test_the_reference_names_every_entity_and_component(
    recording: Path, rollouts: Rollouts
) -> None:
    described: dict[str, set[str]] = defaultdict(set)
    text = REFERENCE.read_text(encoding="utf-8")
    for row in text[: text.index("# What `learning.rrd` contains")].splitlines():
        cells = row.split(" | ")
        if not row.startswith("| `/"):
            continue
        path, components = cells[0].strip("| `"), set(re.findall(r"`([^`]+)`", cells[1]))
        timelines = set(re.findall(r"`([^`]+)`", cells[2]))
        for action in rollouts.actions:
            described[path.replace("{action}", action.name)] |= components | timelines
    written = {path: set(names) for path, names in read_entities(recording).items()}
    assert written == described


def test_the_reference_has_the_edition_of_the_layout() -> None:
    words = " ".join(REFERENCE.read_text(encoding="utf-8").split())
    assert f"edition {SCHEMA_VERSION} of the layout" in words


def test_opens_on_the_overview_with_a_tab_an_action(recording: Path, rollouts: Rollouts) -> None:
    blueprint = read_blueprint(recording)
    names = {
        *blueprint["ContainerBlueprint:display_name"],
        *blueprint["ViewBlueprint:display_name"],
    }
    assert {"Overview", "Prospects", "Minds", "About", *map(action_label, rollouts.names)} <= names


@pytest.mark.parametrize(
    "rollouts",
    [
        make_rollouts(people=0),
        make_rollouts(actions=META_ACTIONS[:1], rollouts=1, steps=1),
        make_rollouts(people=40),
        make_rollouts(centre=(350.0, -120.0)),
        make_rollouts(
            actions=tuple(
                MetaAction(f"veer/left & a very long way: {number}!", 0.1 * number, 0.1)
                for number in range(12)
            )
        ),
        make_rollouts(actions=(MetaAction("θ → λ·½", 1.0, 0.0), MetaAction("γ", 0.0, 0.0))),
        replace(make_rollouts(), person_step=np.full((2, 3), -1)),
    ],
    ids=[
        "nobody",
        "one of each",
        "a crowd",
        "far from zero",
        "many long names",
        "Greek names",
        "no contact",
    ],
)
def test_unusual_scenes_can_be_written(rollouts: Rollouts, tmp_path: Path) -> None:
    path = tmp_path / "unusual.rrd"
    write_recording(path, rollouts, judge(rollouts))
    robots = [entity for entity in read_entities(path) if entity.endswith("/robots")]
    assert len(robots) == len(rollouts.actions)


def test_size_stays_near_that_of_the_numbers(tmp_path: Path) -> None:
    rollouts = make_rollouts(actions=META_ACTIONS, rollouts=50, steps=40, people=8)
    path = tmp_path / "large.rrd"
    write_recording(path, rollouts, judge(rollouts))
    numbers = rollouts.robot.size + rollouts.pedestrians.size + rollouts.without_robot.size
    assert path.stat().st_size <= 1.2 * 4 * numbers


def test_a_full_disk_is_an_error_and_not_a_file_cut_short(rollouts: Rollouts) -> None:
    with pytest.raises(OSError, match="No space left"):
        write_recording(Path("/dev/full"), rollouts, judge(rollouts))


def test_a_teacher_of_ones_own_can_be_written(rollouts: Rollouts, tmp_path: Path) -> None:
    first = judge(rollouts)[0]
    own = replace(first, teacher="my aunt")
    write_recording(tmp_path / "test.rrd", rollouts, (own,))
    assert "my aunt" in read_entities(tmp_path / "test.rrd")["/judgements"]
