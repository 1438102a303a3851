import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from scenes import MetaAction, Rollouts
from studio.scene.judgements import Judgement, judge, utilities
from studio.scene.recording.pages import disagreements_page, scene_page, scene_summary
from studio.scene.recording.write import write_recording
from tests.entities import read_entities
from tests.studio.scene.made_up import make_rollouts

pytestmark = pytest.mark.usefixtures("strict_rerun")


def surely(judgement: Judgement, *values: float) -> Judgement:
    """A judgement that every draw agrees with."""
    given = np.array(values)
    return replace(judgement, values=given, resampled=np.tile(given, (10, 1)))


def test_pages_name_the_pairs_that_teachers_order_differently(rollouts: Rollouts) -> None:
    eu, tk, _ = judge(rollouts)
    eu, tk = surely(eu, 0.3, 0.1), surely(tk, 0.1, 0.35)
    page = disagreements_page(rollouts, (eu, tk))
    assert "| EU, T&K | 1 | 0.250 [0.250, 0.250] |" in page
    assert "| EU prefers | T&K prefers |" in page
    assert "prefers" not in disagreements_page(rollouts, (eu, eu))
    assert "two teachers" in disagreements_page(rollouts, (eu,))


def test_the_summary_tells_picks_from_what_is_open(rollouts: Rollouts) -> None:
    eu, tk, _ = judge(rollouts)
    draws = np.array([(0.3, 0.1)] * 6 + [(0.3, 0.4)] * 4)
    unsure = replace(tk, values=np.array([0.3, 0.1]), resampled=draws)
    page = scene_summary(rollouts, (surely(eu, 0.1, 0.2), unsure))
    assert "* **EU** picks slow down (100 %)" in page
    assert "* **T&K** may pick forward (60 %) or slow down (40 %)" in page
    rows = [line for line in page.splitlines() if "slow down](" in line and "[0." in line]
    [row] = rows
    assert "**0.200 [0.200, 0.200]** ★" in row
    assert "**0.100 [0.100, 0.400]** ☆" in row


def test_the_summary_tells_people_and_walls_apart(rollouts: Rollouts) -> None:
    wall = np.full_like(rollouts.wall_step, -1)
    wall[1] = 3
    page = scene_summary(replace(rollouts, wall_step=wall), judge(rollouts))
    [forward, slow] = [line for line in page.splitlines() if " % [" in line and "](" in line]
    assert "| 33 % [6, 79] | 0 % [0, 56] |" in forward
    assert "| 0 % [0, 56] | 100 % [44, 100] |" in slow


def test_pages_tell_how_far_values_are_off(rollouts: Rollouts) -> None:
    reference = np.tile(utilities(rollouts), (1, 40))
    judgements = judge(rollouts, reference=reference)
    assert "held against 120 rollouts" in scene_summary(rollouts, judgements)
    assert "On average, 3 rollouts give V too " in scene_page(rollouts, judgements, {})


def test_the_summary_says_how_the_usual_teachers_judge(rollouts: Rollouts) -> None:
    eu, *_ = judge(rollouts)
    page = scene_summary(rollouts, (eu, replace(eu, teacher="my aunt")))
    assert "EU goes by the mean utility; V is" in " ".join(page.split())
    assert "my aunt goes" not in page


def test_names_of_actions_cannot_break_the_pages(tmp_path: Path) -> None:
    odd = (MetaAction("a|b [c](d)", 1.0, 0.0), MetaAction("*" * 80, 0.5, 0.0))
    rollouts = make_rollouts(odd)
    write_recording(tmp_path / "odd.rrd", rollouts, judge(rollouts))
    page = read_entities(tmp_path / "odd.rrd")["/summary"]["TextDocument:text"][0][0]
    row = next(line for line in page.splitlines() if line.startswith("| [a\\|b"))
    header = next(line for line in page.splitlines() if line.startswith("| action"))
    assert row.replace("\\|", "").count("|") == header.count("|")
    assert "\\[c\\]" in row
    assert "*" * 30 not in page


def test_the_page_links_to_the_actions(recording: Path) -> None:
    page = read_entities(recording)["/about"]["TextDocument:text"][0][0]
    assert "recording://world/actions/slow_down" in page
    assert "| noise: desired_speed | 0.26 |" in page


def test_links_lead_to_what_is_there(recording: Path) -> None:
    entities = read_entities(recording)
    for page in ("/summary", "/disagreements", "/about"):
        text = entities[page]["TextDocument:text"][0][0]
        for target in re.findall(r"recording://([^)>]+)", text):
            assert any(path.startswith(f"/{target}") for path in entities), target
