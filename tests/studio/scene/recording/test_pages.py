import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from scenes import MetaAction, Rollouts
from studio.scene.judgements import judge
from studio.scene.recording.pages import disagreements_page, scene_summary
from studio.scene.recording.write import write_recording
from tests.entities import read_entities
from tests.studio.scene.made_up import make_rollouts

pytestmark = pytest.mark.usefixtures("strict_rerun")


def test_pages_name_the_pairs_that_teachers_order_differently(rollouts: Rollouts) -> None:
    eu, tk, _ = judge(rollouts)
    eu, tk = (replace(eu, values=np.array([0.3, 0.1])), replace(tk, values=np.array([0.1, 0.35])))
    page = disagreements_page(rollouts, (eu, tk))
    assert "| EU, T&K | 1 | 0.250 |" in page
    assert "| EU prefers | T&K prefers |" in page
    assert "EU and T&K [order](<recording://figures/ranks>) 1 of 1" in scene_summary(
        rollouts, (eu, tk)
    )
    assert "prefers" not in disagreements_page(rollouts, (eu, eu))
    assert "two teachers" in disagreements_page(rollouts, (eu,))


def test_the_summary_says_how_the_usual_teachers_judge(rollouts: Rollouts) -> None:
    eu, *_ = judge(rollouts)
    page = scene_summary(rollouts, (eu, replace(eu, teacher="my aunt")))
    assert "EU goes by the mean utility; V, under their names, is" in page
    assert "my aunt goes" not in page


def test_names_of_actions_cannot_break_the_pages(tmp_path: Path) -> None:
    odd = (MetaAction("a|b [c](d)", 1.0, 0.0), MetaAction("*" * 80, 0.5, 0.0))
    rollouts = make_rollouts(odd)
    write_recording(tmp_path / "odd.rrd", rollouts, judge(rollouts))
    page = read_entities(tmp_path / "odd.rrd")["/summary"]["TextDocument:text"][0][0]
    row = next(line for line in page.splitlines() if "a\\|b" in line)
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
