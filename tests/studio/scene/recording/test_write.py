import re
import tomllib
from collections import defaultdict
from dataclasses import asdict, replace
from pathlib import Path

import numpy as np
import pytest
import rerun as rr

from scenes import META_ACTIONS, MetaAction, Rollouts, load_scene, scene_from_toml, simulate
from studio.arrays import FloatArray
from studio.recorder.contents import Contents, read_contents
from studio.scene.judgements import judge, utilities
from studio.scene.recording.outcomes import STATES
from studio.scene.recording.write import MOST_PATHS, SCHEMA_VERSION, write_recording
from studio.style.palette import ACTION_COLOURS, LIGHT
from studio.style.words import action_label
from tests.entities import read_blueprint, read_entities, verify
from tests.studio.scene.made_up import make_rollouts

pytestmark = pytest.mark.usefixtures("strict_rerun")

REFERENCE = Path(__file__).parents[4] / "recordings" / "README.md"
HALF_A_STEP = 1.0 / 256.0
ROBOTS, SHOWN = "/world/actions/forward/robots", "/world/actions/forward/shown"


@pytest.fixture(scope="module")
def contents(recording: Path) -> Contents:
    return read_contents(recording)


def test_what_was_written_can_be_verified(recording: Path) -> None:
    verify(recording)


def test_every_action_has_its_robots_people_paths_and_table(
    recording: Path, rollouts: Rollouts
) -> None:
    entities = read_entities(recording)
    for action in rollouts.actions:
        for part in ("robots", "pedestrians", "paths", "shown/robot", "shown/people"):
            assert f"/world/actions/{action.name}/{part}" in entities
        assert f"/outcomes/{action.name}" in entities


def test_positions_and_headings_are_those_that_were_given(
    recording: Path, rollouts: Rollouts
) -> None:
    entities = read_entities(recording)
    for index, action in enumerate(rollouts.actions):
        robots = entities[f"/world/actions/{action.name}/robots"]
        positions = np.array(robots["Points2D:positions"]).swapaxes(0, 1)
        np.testing.assert_allclose(positions, rollouts.robot[index, ..., :2], atol=HALF_A_STEP)
        heading = np.array(robots["heading"])[:, 0].T
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


def test_contacts_are_marked_where_they_happen(rollouts: Rollouts, tmp_path: Path) -> None:
    wall = np.full_like(rollouts.wall_step, -1)
    wall[0, 2] = 4
    path = tmp_path / "contacts.rrd"
    write_recording(path, replace(rollouts, wall_step=wall), judge(rollouts))
    marks = read_entities(path)["/world/actions/forward/contacts"]
    cross, square = (np.array(strip) for strip in marks["LineStrips2D:strips"][0])
    for mark, place in ((cross[[0, 1, 3, 4]], (0, 2)), (square[:4], (2, 4))):
        np.testing.assert_allclose(
            mark.mean(axis=0), rollouts.robot[0][place][:2], atol=HALF_A_STEP
        )
    assert (cross[2] == cross.mean(axis=0)).all()  # its strokes go through the middle
    assert marks["told"][0] == [
        "rollout 0 first touches a person at 0.2 s",
        "rollout 2 first touches a wall at 0.4 s",
    ]


def test_an_arrowhead_shows_where_the_robot_in_true_size_faces(
    contents: Contents, rollouts: Rollouts
) -> None:
    rows = contents.rows("/world/actions/slow_down/shown/robot", "step")
    corners = np.array([row["LineStrips2D:strips"][0] for row in rows])  # (T+1, 3, 2)
    x, y, heading = rollouts.robot[1, 0].T
    forwards = corners[:, 1] - corners[:, [0, 2]].mean(axis=1)
    faced = np.arctan2(forwards[:, 1], forwards[:, 0])
    np.testing.assert_allclose(faced, heading, atol=0.05)
    away = np.hypot(corners[..., 0] - x[:, None], corners[..., 1] - y[:, None])
    assert away.max() < 0.25  # it lies on the robot's disc
    half_sizes = [row["Ellipses2D:half_sizes"] for row in rows]
    assert half_sizes == [[[0.25, 0.25]]] * len(rows)


def test_rollouts_are_shown_in_turn_at_their_most_telling_moments(
    contents: Contents, rollouts: Rollouts
) -> None:
    robots = contents.over_time(f"{SHOWN}/robot", "Ellipses2D:centers", "rollout")[:, 0]
    people = contents.over_time(f"{SHOWN}/people", "Ellipses2D:centers", "rollout")
    apart = rollouts.pedestrians[0] - rollouts.robot[0, :, :, None, :2]
    steps = np.linalg.norm(apart, axis=-1).min(axis=-1).argmin(axis=-1)
    steps[0] = 2  # of its contact
    for place, step in enumerate(steps):
        at = rollouts.robot[0, place, step, :2]
        np.testing.assert_allclose(robots[place], at, atol=HALF_A_STEP)
        there = rollouts.pedestrians[0, place, step]
        np.testing.assert_allclose(people[place], there, atol=HALF_A_STEP)
    told = [row["told"] for row in contents.rows(f"{SHOWN}/robot", "rollout")]
    assert all(words[0].startswith(f"rollout {place}: ") for place, words in enumerate(told))


def test_bars_join_the_people_of_a_group(recording: Path, rollouts: Rollouts) -> None:
    people = read_entities(recording)["/world/actions/forward/pedestrians"]
    bars = np.array(people["LineStrips2D:strips"])  # (T+1, 1, 2, 2)
    np.testing.assert_allclose(bars[:, 0], rollouts.pedestrians[0, 0], atol=HALF_A_STEP)


def hovered(recording: Path, entity: str) -> set[str]:
    """Components of which every mark of an entity has a value of its own: the viewer's tooltip."""
    rows = {
        name: values[0]
        for name, values in read_entities(recording)[entity].items()
        if isinstance(values[0], list) and values[0]
    }
    return {name for name, values in rows.items() if len(values) > 1}


def test_marks_tell_of_which_rollout_they_are_and_what_came_of_it(
    recording: Path, rollouts: Rollouts
) -> None:
    entities = read_entities(recording)
    worths = utilities(rollouts)[0]
    for entity in (ROBOTS, "/world/actions/forward/paths"):
        told = entities[entity]["told"][0]
        assert len(told) == rollouts.count
        for place, words in enumerate(told):
            number = f"{worths[place]:.3f}".replace("-", "−")
            assert words.startswith(f"rollout {place}: utility {number}, gap ")
            assert f"{rollouts.progress_m[0, place]:.2f} m" in words
            assert len(words) <= 75  # the viewer cuts what is longer
    people = entities["/world/actions/forward/pedestrians"]["told"][0]
    assert people[:3] == ["person 0 in rollout 0", "person 1 in rollout 0", "person 0 in rollout 1"]


def test_no_mark_has_more_components_of_its_own_than_the_viewer_tells(recording: Path) -> None:
    entities = read_entities(recording)
    answering = [path for path, components in entities.items() if "told" in components]
    assert len(answering) > 10
    for entity in answering:
        assert len(hovered(recording, entity)) <= 3, entity


def test_dots_lie_by_utility_and_say_whose_they_are(recording: Path, rollouts: Rollouts) -> None:
    dots = read_entities(recording)["/figures/utilities/outcomes"]
    places = np.array(dots["Points2D:positions"][0])
    told = dots["told"][0]
    assert len(told) == rollouts.features[..., 0].size
    for index, name in enumerate(rollouts.names):
        found = {}
        for place, words in zip(places, told, strict=True):
            if words.startswith(f"{action_label(name)}, "):
                found[int(words.split("rollout ")[1].split(":")[0])] = place[0]
        assert sorted(found) == [0, 1, 2]
        x = np.array([found[place] for place in range(3)])
        order = np.argsort(utilities(rollouts)[index])
        assert (np.diff(x[order]) >= 0.0).all()


def test_a_ring_lies_on_the_dot_of_the_rollout_of_each_action(
    recording: Path, contents: Contents
) -> None:
    dots = read_entities(recording)["/figures/utilities/outcomes"]
    places = {
        words.split(": ")[0]: place
        for place, words in zip(dots["Points2D:positions"][0], dots["told"][0], strict=True)
    }
    rings = contents.over_time("/figures/utilities/rollout", "Ellipses2D:centers", "rollout")
    for place, centres in enumerate(rings):
        expected = [places[f"{label}, rollout {place}"] for label in ("forward", "slow down")]
        np.testing.assert_array_equal(centres, expected)


def test_outcomes_are_those_that_were_given(contents: Contents, rollouts: Rollouts) -> None:
    for index, name in enumerate(rollouts.names):
        given = {
            "clearance_m": rollouts.clearance_m,
            "deviation_m": rollouts.deviation_m,
            "progress_m": rollouts.progress_m,
            "smoothness": rollouts.features[..., 3],
            "people_touched": rollouts.people_touched,
            "person_step": rollouts.person_step,
            "wall_step": rollouts.wall_step,
        }
        for column, values in given.items():
            told = contents.over_time(f"/outcomes/{name}", column, "rollout")[:, 0]
            np.testing.assert_array_equal(told, values[index])
        worths = contents.over_time(f"/outcomes/{name}", "utility", "rollout")[:, 0]
        np.testing.assert_allclose(worths, utilities(rollouts)[index], rtol=1e-6)


def test_actions_have_their_values_and_how_sure_they_are(
    contents: Contents, rollouts: Rollouts
) -> None:
    def column(name: str) -> FloatArray:
        return contents.over_time("/actions", name, "action")[:, 0]

    for judgement in judge(rollouts):
        label = f"V {judgement.label}"
        np.testing.assert_array_equal(column(label), judgement.values)
        np.testing.assert_array_equal(column(f"{label} low"), judgement.low)
        np.testing.assert_array_equal(column(f"{label} high"), judgement.high)
        np.testing.assert_array_equal(column(f"picked by {judgement.label}"), judgement.shares)
        kept = contents.static("/judgements", judgement.teacher)
        np.testing.assert_array_equal(kept, judgement.values)
    shares = column("touch_people"), column("touch_people_low"), column("touch_people_high")
    assert shares[0].tolist() == [1 / 3, 0.0]
    assert (shares[1] <= shares[0]).all()
    assert (shares[2] > shares[0]).all()


def test_bars_count_all_outcomes_and_those_with_contact(
    recording: Path, rollouts: Rollouts
) -> None:
    entities = read_entities(recording)

    def bars(path: str) -> FloatArray:
        return np.array(entities[path]["BarChart:values"][0][0]["buffer"])

    at = "/histograms/progress"
    each = [bars(f"{at}/{name}/all") for name in rollouts.names]
    assert [counts.sum() for counts in each] == [3, 3]
    np.testing.assert_array_equal(bars(at), np.max(each, axis=0))
    assert bars(f"{at}/forward/touched_person").sum() == 1
    assert f"{at}/slow_down/touched_person" not in entities
    assert f"{at}/forward/touched" not in entities  # nobody touched a wall alone
    edges = entities[at]["BarChart:abscissa"][0][0]["buffer"]
    inside = np.searchsorted(edges, rollouts.progress_m[0, 0], side="right") - 1
    assert bars(f"{at}/forward/touched_person")[inside] == 1


def test_the_gap_is_the_mean_over_rollouts_with_its_deviation(
    contents: Contents, rollouts: Rollouts
) -> None:
    apart = np.linalg.norm(rollouts.pedestrians - rollouts.robot[..., None, :2], axis=-1)
    gap = apart.min(axis=-1) - 0.45
    for index, name in enumerate(rollouts.names):
        mean = contents.over_time(f"/gap/{name}", "Measurements:values", "step")[:, 0]
        np.testing.assert_allclose(mean, gap[index].mean(axis=0))
        variance = contents.over_time(f"/gap/{name}", "Measurements:variances", "step")[:, 0]
        np.testing.assert_allclose(variance, gap[index].var(axis=0))


def test_what_robots_touch_is_told_from_step_to_step(tmp_path: Path) -> None:
    rollouts = make_rollouts(steps=60)  # long enough to meet people
    path = tmp_path / "long.rrd"
    write_recording(path, rollouts, judge(rollouts))
    rows = read_contents(path).rows("/touching/forward", "step")
    apart = np.linalg.norm(rollouts.pedestrians[0] - rollouts.robot[0, :, :, None, :2], axis=-1)
    touching = (apart < 0.45).any(axis=-1)  # (K, T+1)
    assert touching.any()
    states = np.empty(touching.shape, dtype=object)
    for row, following in zip(rows, [*rows[1:], {"step": 61}], strict=True):
        states[:, row["step"] : following["step"]] = np.array(row["StateChange:state"])[:, None]
    np.testing.assert_array_equal(states == "person", touching)
    assert set(states.ravel()) <= set(STATES)


def test_many_rollouts_are_kept_as_numbers_and_some_of_them_with_paths(tmp_path: Path) -> None:
    rollouts = simulate(load_scene("open"), META_ACTIONS[:2], rollouts=1200, horizon=0.5)
    path = tmp_path / "many.rrd"
    write_recording(path, rollouts, judge(rollouts))
    contents = read_contents(path)
    assert contents.over_time(ROBOTS, "Points2D:positions", "step").shape == (6, MOST_PATHS, 2)
    assert len(contents.rows("/outcomes/forward", "rollout")) == 1200
    for shown in ("/world/actions/forward/shown", "/figures/utilities/rollout"):
        [cleared] = [row for row in contents.rows(shown, "rollout") if "Clear:is_recursive" in row]
        assert (cleared["rollout"], cleared["Clear:is_recursive"]) == (MOST_PATHS, [True])
    for page in ("/summary", "/about"):
        assert "a sample of 100 of 1200 rollouts" in contents.text(page, "TextDocument:text")
    raw = (
        sum(each[:, :MOST_PATHS].size for each in (rollouts.robot, rollouts.pedestrians))
        + rollouts.without_robot[:MOST_PATHS].size
    )
    raw += rollouts.features.size + 2 * rollouts.person_step.size
    assert path.stat().st_size <= 1.2 * 4 * raw + 1.5e6


def test_properties_suffice_to_make_it_again(recording: Path, rollouts: Rollouts) -> None:
    entities = read_entities(recording)
    assert scene_from_toml(entities["/__properties/scene"]["toml"][0][0]) == rollouts.scene
    simulation = {name: rows[0][0] for name, rows in entities["/__properties/simulation"].items()}
    assert simulation["schema_version"] == SCHEMA_VERSION
    assert simulation["seed"] == rollouts.seed
    assert (simulation["rollouts"], simulation["paths"]) == (3, 3)
    assert (simulation["dt"], simulation["horizon"]) == (0.1, 0.5)
    assert (simulation["model"], simulation["engine"]) == ("extended", "batched")
    assert simulation["wrap_angles"] is True
    assert tomllib.loads(simulation["noise"]) == asdict(rollouts.noise)
    assert tomllib.loads(simulation["limits"]) == asdict(rollouts.limits)
    actions = tomllib.loads(simulation["actions"])["actions"]
    assert tuple(MetaAction(**action) for action in actions) == rollouts.actions
    assert tomllib.loads(simulation["versions"])["rerun-sdk"] == rr.__version__


def test_the_reference_names_every_entity_and_component(tmp_path: Path) -> None:
    """A recording in which nothing is absent: people, walls and other rollouts are touched."""
    few = make_rollouts(rollouts=101)
    wall = np.full_like(few.wall_step, -1)
    wall[:, 1], person = 3, few.person_step.copy()
    person[:, 0] = 2
    features = few.features.copy()
    features[..., 4] = (wall >= 0) + (person >= 0).astype(float)
    rollouts = replace(few, wall_step=wall, person_step=person, features=features)
    many = np.tile(utilities(rollouts), (1, 10))
    names = names_in(tmp_path / "sampled.rrd", rollouts, many)
    some = rollouts.keep_paths(50).with_paths()
    for path, components in names_in(tmp_path / "single.rrd", some, many[:, :50]).items():
        names[path] |= components
    described: dict[str, set[str]] = defaultdict(set)
    text = REFERENCE.read_text(encoding="utf-8")
    for row in text[: text.index("# What `learning.rrd` contains")].splitlines():
        cells = row.split(" | ")
        if not row.startswith("| `/"):
            continue
        components, timelines = (set(re.findall(r"`([^`]+)`", cell)) for cell in cells[1:3])
        for path in re.findall(r"`([^`]+)`", cells[0]):
            for action in rollouts.actions:
                described[path.replace("{action}", action.name)] |= components | timelines
    assert names == described


def names_in(path: Path, rollouts: Rollouts, many: FloatArray) -> dict[str, set[str]]:
    """Names of the components and timelines of every entity in a recording of these rollouts."""
    write_recording(path, rollouts, judge(rollouts, reference=many))
    return defaultdict(set, {path: set(names) for path, names in read_entities(path).items()})


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
    assert path.stat().st_size <= 1.2 * 4 * numbers + 1.5e6


def test_a_full_disk_is_an_error_and_not_a_file_cut_short(rollouts: Rollouts) -> None:
    with pytest.raises(OSError, match="No space left"):
        write_recording(Path("/dev/full"), rollouts, judge(rollouts))


def test_a_teacher_of_ones_own_can_be_written(rollouts: Rollouts, tmp_path: Path) -> None:
    first = judge(rollouts)[0]
    own = replace(first, teacher="my aunt")
    write_recording(tmp_path / "test.rrd", rollouts, (own,))
    assert "my aunt" in read_entities(tmp_path / "test.rrd")["/judgements"]
