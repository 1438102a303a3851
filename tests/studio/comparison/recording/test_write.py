import re
from collections import defaultdict
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from scenes import scene_from_toml
from studio.comparison.comparison import QUESTION, Timetable
from studio.comparison.recording.write import write_comparison_recording
from studio.kinds import open_recording
from studio.scene.judgements import judge, utilities
from studio.style.palette import LIGHT, SIDE_COLOURS
from tests.entities import read_blueprint, read_entities, verify
from tests.studio.comparison.made_up import NAMES, a_comparison

pytestmark = pytest.mark.usefixtures("strict_rerun")

REFERENCE = Path(__file__).parents[4] / "recordings" / "README.md"
HALF_A_STEP = 1.0 / 256.0
SIDES = ("A", "B")
PLOTS = ("icons", "progress", "gap", "aside")


def with_contacts(people=2, rollouts=4, **settings):
    """A comparison in which every second outcome on the left has contact, from step 2 on."""
    contact = np.zeros((2, rollouts), bool)
    contact[0, ::2] = True
    return a_comparison(people, rollouts, contact=contact, **settings)


def write(path, comparison, reference=None):
    judgements = judge(comparison.rollouts, reference=reference)
    write_comparison_recording(path, comparison, judgements)
    return path


@pytest.fixture(scope="module")
def compared():
    return with_contacts()


@pytest.fixture(scope="module")
def recording(compared, tmp_path_factory):
    return write(tmp_path_factory.mktemp("recording") / "test.rrd", compared)


@pytest.fixture(scope="module")
def entities(recording):
    return read_entities(recording)


def seconds(entity):
    return np.array([time.total_seconds() for time in entity["story"]])


def test_it_can_be_verified_and_opens_on_the_question(recording):
    verify(recording)
    found = str(read_blueprint(recording))
    for words in (QUESTION, "All at once", "Outcomes", "Which is which", "story"):
        assert words in found


def test_nothing_but_the_last_page_and_the_properties_tells_names_or_values(recording, entities):
    told = {path: str(rows) for path, rows in entities.items()}
    for name in NAMES:
        those = {path for path, rows in told.items() if name in rows or name in path}
        assert those <= {"/about", "/__properties/comparison"}
        assert name.replace("_", " ") not in str(read_blueprint(recording))
    assert not any("T&K" in rows for path, rows in told.items() if path != "/about")
    assert "judgements" not in str(read_blueprint(recording))
    assert entities["/__properties"]["RecordingInfo:name"] == [[f"a-scene: {QUESTION}"]]


def test_names_are_told_where_they_shall_be(tmp_path):
    path = write(tmp_path / "named.rrd", with_contacts(named=True))
    found, entities = str(read_blueprint(path)), read_entities(path)
    assert "slow down" in found
    assert "Which is which" not in found
    assert "/world/story/slow_down/robot" in entities
    assert "slow down" in entities["/__properties"]["RecordingInfo:name"][0][0]


@pytest.mark.parametrize("named", [False, True])
def test_it_is_read_back_as_it_was_compared(named, tmp_path):
    comparison = with_contacts(named=named)
    read = open_recording(write(tmp_path / "test.rrd", comparison)).comparison
    assert read.named == named
    assert read.rollouts.actions == comparison.rollouts.actions
    assert (read.actions, read.seed) == (comparison.actions, comparison.seed)
    np.testing.assert_array_equal(read.rollouts.person_step, comparison.rollouts.person_step)


def test_of_many_outcomes_all_numbers_are_kept_and_a_hundred_paths(tmp_path):
    comparison = a_comparison(people=1, rollouts=130, horizon=0.2)
    read = open_recording(write(tmp_path / "test.rrd", comparison)).comparison.rollouts
    assert (read.count, read.paths) == (130, 100)
    np.testing.assert_allclose(read.progress_m, comparison.rollouts.progress_m)


def test_it_says_which_actions_are_compared_and_how_they_came_to_their_sides(entities, compared):
    told = {name: rows[0] for name, rows in entities["/__properties/comparison"].items()}
    assert [*told["left"], *told["right"]] == list(compared.rollouts.names)
    assert told["seed"] == [compared.seed]
    assert told["named"] == [False]
    assert told["actions"] == ["forward", "stop", "turn_left", "slow_down"]
    scene = scene_from_toml(entities["/__properties/scene"]["toml"][0][0])
    assert scene == compared.rollouts.scene
    assert entities["/__properties/simulation"]["rollouts"] == [[4]]


def test_every_outcome_plays_on_both_sides_at_once(entities, compared):
    rollouts, table = compared.rollouts, Timetable.of(4, compared.rollouts.horizon)
    count, times = rollouts.robot.shape[1:3]
    for side, name in enumerate(SIDES):
        robot = entities[f"/world/story/{name}/robot"]
        when = seconds(robot)
        assert when[0] == 0.0
        playing = when[1:-1].reshape(count, times)
        np.testing.assert_allclose(playing[:, 0], table.starts, atol=1e-6)
        np.testing.assert_allclose(playing[:, -1], table.ends, atol=1e-6)
        assert when[-1] == pytest.approx(table.over + 6.0)
        places = np.array(robot["Ellipses2D:centers"])[1:-1, 0]
        given = rollouts.robot[side, ..., :2].reshape(-1, 2)
        np.testing.assert_allclose(places, given, atol=HALF_A_STEP)
        people = np.array(entities[f"/world/story/{name}/people"]["Ellipses2D:centers"])
        walks = rollouts.pedestrians[side].reshape(-1, 2, 2)
        np.testing.assert_allclose(people[1:-1], walks, atol=HALF_A_STEP)


def test_a_robot_is_red_from_its_contact_until_the_next_outcome(entities):
    classes = np.array(entities["/world/story/A/robot"]["Ellipses2D:class_ids"])[1:-1, 0]
    red = classes.reshape(4, 6) == 0
    assert red[::2].tolist() == [[False, False, *[True] * 4]] * 2
    assert not red[1::2].any()
    assert (np.array(entities["/world/story/B/robot"]["Ellipses2D:class_ids"]) == 2).all()
    colours = {
        info["class_id"]: info["class_description"]["info"]["color"] >> 8
        for info in entities["/world"]["AnnotationContext:context"][0][0]
    }
    assert colours == {
        number: (red << 16) | (green << 8) | blue
        for number, (red, green, blue) in enumerate([LIGHT.contact, *SIDE_COLOURS])
    }


def test_paths_contacts_and_dots_come_as_outcomes_end_and_tell_what_these_were(entities, compared):
    when = [0.0, *Timetable.of(4, compared.rollouts.horizon).ends]
    expected = {
        "/world/story/A/paths": [0, 1, 2, 3, 4],
        "/world/story/A/contacts": [0, 1, 1, 2, 2],
        "/world/story/B/paths": [0, 1, 2, 3, 4],
    }
    for plot in PLOTS:
        expected |= {
            f"/figures/dots/A/{plot}": [0, 0, 1, 1, 2],
            f"/figures/dots/A/{plot}/contacts": [0, 1, 1, 2, 2],
            f"/figures/dots/B/{plot}": [0, 1, 2, 3, 4],
        }
    for path, numbers in expected.items():
        entity = entities[path]
        [marks] = [
            rows for name, rows in entity.items() if name.split(":")[-1] in ("strips", "positions")
        ]
        assert [len(row) for row in marks] == numbers
        np.testing.assert_allclose(seconds(entity), when, atol=1e-6)
        [told] = entity["told"]
        assert len(told) == max(numbers)
        for before, after in pairwise(marks):
            assert after[: len(before)] == before
    [told] = entities["/figures/dots/A/gap/contacts"]["told"]
    assert [words.split(":")[0] for words in told] == ["outcome 1 of A", "outcome 3 of A"]
    assert "/world/story/B/contacts" not in entities
    said = entities["/figures/dots/A/so_far"]["TextDocument:text"]
    assert [row[0] for row in said][-1] == "Outcome 4 of 4 · 2 of 4 with contact"


def test_dots_lie_at_their_values_on_an_axis_that_both_sides_share(entities, compared):
    progress, parts = compared.rollouts.progress_m, []
    for side, name in enumerate(SIDES):
        free = ~compared.rollouts.touched[side]
        across = np.array(entities[f"/figures/dots/{name}/progress"]["Points2D:positions"][-1])[
            :, 0
        ]
        parts.append((progress[side][free], across))
    values, across = map(np.concatenate, zip(*parts, strict=True))
    slope, offset = np.polyfit(values, across, 1)
    # within a bin, of which there are 18 on an axis that is 360 px wide
    assert np.abs(across - (slope * values + offset)).max() < 360 / 18
    images = [entities[f"/figures/dots/{name}"]["EncodedImage:blob"] for name in SIDES]
    assert images[0] == images[1]


def test_tables_show_outcomes_and_not_what_they_are_worth(recording, entities):
    assert "utility" in entities["/outcomes/A"]
    shown = str(read_blueprint(recording)["DataframeQuery:select"])
    assert "progress_m" in shown
    assert "utility" not in shown


def test_the_reference_names_every_entity_and_component(tmp_path):
    """Recordings in which nothing is absent: people and walls are touched, or are not."""
    comparison = a_comparison(rollouts=101, horizon=0.5, people=2)
    rollouts = comparison.rollouts
    person, wall = np.full((2, 101), -1), np.full((2, 101), -1)
    person[:, 0], wall[:, 1] = 2, 3
    features = rollouts.features.copy()
    features[..., 4] = (wall >= 0) + (person >= 0).astype(float)
    rollouts = replace(rollouts, person_step=person, wall_step=wall, features=features)
    some = rollouts.keep_paths(40).with_paths()
    found = defaultdict(set)
    for number, own in enumerate((rollouts, some)):
        many = np.tile(utilities(own), (1, 3))
        path = write(tmp_path / f"{number}.rrd", replace(comparison, rollouts=own), many)
        for entity, components in read_entities(path).items():
            found[entity] |= set(components)
    text, described = REFERENCE.read_text(encoding="utf-8"), defaultdict(set)
    of_a_scene = text[: text.index("# What `learning.rrd` contains")]
    of_a_comparison = text[text.index("# What a comparison contains") :]
    introduction = of_a_comparison[: of_a_comparison.index("## Time")]
    shared = set(re.findall(r"`(/[^`]+)`", introduction))

    def describe(section, is_meant):
        for row in section.splitlines():
            cells = row.split(" | ")
            if not row.startswith("| `/"):
                continue
            components = set(re.findall(r"`([^`]+)`", cells[1] + cells[2]))
            for path in filter(is_meant, re.findall(r"`([^`]+)`", cells[0])):
                for side in SIDES:
                    described[path.replace("{action}", side)] |= components

    describe(of_a_scene, lambda path: path in shared)
    describe(of_a_comparison, lambda path: True)
    assert found == described


def test_links_lead_to_what_is_there(entities):
    page = entities["/about"]["TextDocument:text"][0][0]
    targets = re.findall(r"recording://([^)>]+)", page)
    assert targets
    for target in targets:
        assert any(path.startswith(f"/{target}") for path in entities), target


@pytest.mark.parametrize(
    "settings",
    [
        {"people": 0},
        {"rollouts": 1, "horizon": 0.1},
        {"people": 40, "rollouts": 60, "horizon": 4.0},
        {"names": ("veer/left & a very long way: 1!", "veer/left & 2!"), "named": True},
        {"rollouts": 60, "paths": 3},
    ],
    ids=["nobody", "one of each", "a crowd", "long names", "some paths"],
)
def test_unusual_comparisons_can_be_written(settings, tmp_path):
    path = write(tmp_path / "test.rrd", with_contacts(**settings))
    entities = read_entities(path)
    stories = [path for path in entities if path.startswith("/world/story/")]
    assert sum(path.endswith("/robot") for path in stories) == 2
    read = open_recording(path).comparison.rollouts
    assert read.paths == settings.get("paths", read.count)


def test_a_full_disk_is_an_error_and_not_a_file_cut_short(compared):
    with pytest.raises(OSError, match="No space left"):
        write(Path("/dev/full"), compared)
