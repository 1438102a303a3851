import re
from collections import defaultdict
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from scenes import scene_from_toml
from studio.comparison.comparison import QUESTION
from studio.comparison.recording.write import write_comparison_recording
from studio.scene.judgements import judge
from studio.style.palette import ACTION_COLOURS, LIGHT
from tests.entities import read_blueprint, read_entities, verify
from tests.studio.comparison.made_up import a_comparison

pytestmark = pytest.mark.usefixtures("strict_rerun")

REFERENCE = Path(__file__).parents[4] / "recordings" / "README.md"
HALF_A_STEP = 1.0 / 256.0
SECONDS_EACH = 2.0  # of so few outcomes


def with_contacts(people=2, rollouts=4, **settings):
    """A comparison in which every second outcome on the left has contact, from step 2 on."""
    contact = np.zeros((2, rollouts), bool)
    contact[0, ::2] = True
    return a_comparison(people, rollouts, contact=contact, **settings)


def write(path, comparison):
    write_comparison_recording(path, comparison, judge(comparison.rollouts))
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


def names(comparison):
    return list(comparison.rollouts.names)


def test_it_can_be_verified_and_opens_on_the_question(recording):
    verify(recording)
    found = str(read_blueprint(recording))
    for words in (QUESTION, "All at once", "About", "story"):
        assert words in found


def test_it_says_which_actions_are_compared_and_how_they_came_to_their_sides(entities, compared):
    told = {name: rows[0] for name, rows in entities["/__properties/comparison"].items()}
    assert [*told["left"], *told["right"]] == names(compared)
    assert told["seed"] == [compared.seed]
    assert told["actions"] == ["forward", "stop", "turn_left", "slow_down"]
    scene = scene_from_toml(entities["/__properties/scene"]["toml"][0][0])
    assert scene == compared.rollouts.scene
    assert entities["/__properties/simulation"]["rollouts"] == [[4]]


def test_it_holds_the_numbers_of_both_actions_where_a_scene_has_them(entities, compared):
    rollouts = compared.rollouts
    for side, name in enumerate(names(compared)):
        robots = np.array(entities[f"/world/actions/{name}/robots"]["Points2D:positions"])
        given = rollouts.robot[side, ..., :2]
        np.testing.assert_allclose(robots.swapaxes(0, 1), given, atol=HALF_A_STEP)
        people = entities[f"/world/actions/{name}/pedestrians"]["Points2D:positions"]
        walks = rollouts.pedestrians[side].swapaxes(0, 1)
        np.testing.assert_allclose(np.array(people).reshape(walks.shape), walks, atol=HALF_A_STEP)
    outcomes = entities["/outcomes"]
    assert outcomes["person_step"][0] == rollouts.person_step.ravel().tolist()
    assert outcomes["wall_step"][0] == rollouts.wall_step.ravel().tolist()
    np.testing.assert_allclose(outcomes["progress"][0], rollouts.features[..., 2].ravel(), 1e-6)
    assert len(entities["/judgements"]["tk"][0]) == 2


def test_every_outcome_plays_on_both_sides_at_once(entities, compared):
    rollouts = compared.rollouts
    count, times = rollouts.robot.shape[1:3]
    for side, name in enumerate(names(compared)):
        robot = entities[f"/world/story/{name}/robot"]
        when = np.array([time.total_seconds() for time in robot["story"]])
        starts = 0.6 + SECONDS_EACH * np.arange(count)
        assert when[0] == 0.0
        np.testing.assert_allclose(when[1:-2].reshape(count, times)[:, 0], starts)
        np.testing.assert_allclose(when[1:-2].reshape(count, times)[:, -1], starts + 1.6)
        np.testing.assert_allclose(when[-2:], [8.6, 11.6])
        places = np.array(robot["Points2D:positions"])[:, 0]
        given = rollouts.robot[side, ..., :2].reshape(-1, 2)
        np.testing.assert_allclose(places[1:-2], given, atol=HALF_A_STEP)
        np.testing.assert_allclose(places[[0, -2, -1]], [(0.0, 0.0)] * 3)
        people = np.array(entities[f"/world/story/{name}/pedestrians"]["Points2D:positions"])
        walks = rollouts.pedestrians[side].reshape(-1, 2, 2)
        np.testing.assert_allclose(people[1:-2], walks, atol=HALF_A_STEP)


def test_a_robot_is_red_from_its_contact_until_the_next_outcome(entities, compared):
    left, right = names(compared)
    classes = np.array(entities[f"/world/story/{left}/robot"]["Points2D:class_ids"])[1:-2, 0]
    red = classes.reshape(4, 6) == 0
    assert red[::2].tolist() == [[False, False, *[True] * 4]] * 2
    assert not red[1::2].any()
    others = np.array(entities[f"/world/story/{right}/robot"]["Points2D:class_ids"])
    assert (others == 2).all()
    colours = {
        info["class_id"]: info["class_description"]["info"]["color"] >> 8
        for info in entities["/world"]["AnnotationContext:context"][0][0]
    }
    places = {name: index for index, name in enumerate(compared.actions)}
    expected = [LIGHT.contact, *(ACTION_COLOURS[places[name]] for name in (left, right))]
    assert colours == {
        number: (red << 16) | (green << 8) | blue
        for number, (red, green, blue) in enumerate(expected)
    }


def test_paths_and_dots_come_one_outcome_at_a_time(entities, compared):
    left, right = names(compared)
    paths = entities[f"/world/story/{left}/paths"]
    assert [len(strips) for strips in paths["LineStrips2D:strips"]] == [3, 1, 3, 1]
    assert [
        len(strips) for strips in entities[f"/world/story/{right}/paths"]["LineStrips2D:strips"]
    ] == [1] * 4
    when = [time.total_seconds() for time in paths["story"]]
    assert when == pytest.approx([2.2, 4.2, 6.2, 8.2])
    counts = entities[f"/figures/dots/{left}/count"]["LineStrips2D:labels"]
    assert counts == [
        ["Outcome 1 of 4", ""],
        ["Outcome 1 of 4", "1 of 1 so far"],
        ["Outcome 2 of 4", "1 of 1 so far"],
        ["Outcome 2 of 4", "1 of 2 so far"],
        ["Outcome 3 of 4", "1 of 2 so far"],
        ["Outcome 3 of 4", "2 of 3 so far"],
        ["Outcome 4 of 4", "2 of 3 so far"],
        ["Outcome 4 of 4", "2 of 4 with contact"],
        ["", "2 of 4 with contact"],
    ]
    when = [time.total_seconds() for time in entities[f"/figures/dots/{left}/count"]["story"]]
    assert when == pytest.approx([0.6, 2.2, 2.6, 4.2, 4.6, 6.2, 6.6, 8.2, 8.6])
    icons = np.array(entities[f"/figures/dots/{left}/outcomes"]["Points2D:positions"])[:, 0]
    waiting = np.array(entities[f"/figures/dots/{left}/waiting"]["Points2D:positions"])[0]
    np.testing.assert_allclose(icons, waiting[[0, 3, 1, 2]])


def test_dots_lie_at_their_values_on_an_axis_that_both_sides_share(entities, compared):
    progress = compared.rollouts.progress_m
    dots = [
        np.array(entities[f"/figures/dots/{name}/outcomes"]["Points2D:positions"])[:, 1, 0]
        for name in names(compared)
    ]
    values, across = progress.ravel(), np.concatenate(dots)
    slope, offset = np.polyfit(values, across, 1)
    # within a bin, of which there are 24 on an axis that is at most 0.46 wide
    assert np.abs(across - (slope * values + offset)).max() < 0.46 / 24
    axes = [entities[f"/figures/dots/{name}"] for name in names(compared)]
    assert axes[0]["LineStrips2D:labels"] == axes[1]["LineStrips2D:labels"]


@pytest.mark.parametrize("seed", range(3))
def test_red_dots_lie_below_the_others_at_any_time(seed, tmp_path):
    rng = np.random.default_rng(seed)
    comparison = a_comparison(rollouts=12, horizon=0.2)
    comparison = replace(
        comparison,
        rollouts=replace(
            comparison.rollouts,
            person_step=rng.choice([-1, 1], (2, 12)),
            wall_step=np.full((2, 12), -1),
            progress_m=rng.choice([0.1, 0.9], (2, 12)),
        ),
    )
    entities = read_entities(write(tmp_path / "test.rrd", comparison))
    for side, name in enumerate(names(comparison)):
        dots = entities[f"/figures/dots/{name}/outcomes"]
        contacts = entities[f"/figures/dots/{name}/contacts"]["Points2D:positions"]
        red, seen = int.from_bytes([*LIGHT.contact, 255]), {}
        covered = {}
        for outcome in range(12):
            row = dots["Points2D:positions"][outcome], dots["Points2D:colors"][outcome]
            seen |= {tuple(place): colour for place, colour in zip(*row, strict=True)}
            covered |= {tuple(place): red for place in contacts[outcome]}
            shown = seen | covered
            assert len(shown) == len(seen) == 3 * (outcome + 1)
            touched = comparison.rollouts.touched[side, : outcome + 1]
            assert sum(colour == red for colour in shown.values()) == 3 * touched.sum()
            in_plots = [(x, y, colour == red) for (x, y), colour in shown.items() if y < 0.22]
            for x, y, is_red in in_plots:
                below = [other[2] for other in in_plots if other[0] == x and other[1] < y]
                assert all(below) or not is_red


def test_the_reference_names_every_entity_and_component(entities, compared):
    described = defaultdict(set)
    text = REFERENCE.read_text(encoding="utf-8")
    of_a_scene = text[: text.index("# What `learning.rrd` contains")]
    of_a_comparison = text[text.index("# What a comparison contains") :]
    shared = set(re.findall(r"`(/[^`]+)`", of_a_comparison[: of_a_comparison.index("## Time")]))

    def describe(section, concerned):
        for row in section.splitlines():
            cells = row.split(" | ")
            if row.startswith("| `/") and concerned(cells[0].strip("| `")):
                found = set(re.findall(r"`([^`]+)`", cells[1] + cells[2]))
                for name in names(compared):
                    described[cells[0].strip("| `").replace("{action}", name)] |= found

    describe(of_a_scene, lambda path: path in shared)
    describe(of_a_comparison, lambda path: True)
    assert {path: set(components) for path, components in entities.items()} == described


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
        {"names": ("veer/left & a very long way: 1!", "veer/left & a very long way: 2!")},
    ],
    ids=["nobody", "one of each", "a crowd", "long names"],
)
def test_unusual_comparisons_can_be_written(settings, tmp_path):
    entities = read_entities(write(tmp_path / "test.rrd", with_contacts(**settings)))
    assert sum(path.endswith("/robot") for path in entities) == 2


def test_a_full_disk_is_an_error_and_not_a_file_cut_short(compared):
    with pytest.raises(OSError, match="No space left"):
        write(Path("/dev/full"), compared)
