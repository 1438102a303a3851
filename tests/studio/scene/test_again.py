from dataclasses import replace
from typing import Any

import pytest

from scenes import META_ACTIONS, Limits, Noise, Rollouts
from studio.scene.again import record_command
from studio.scene.judgements import judge
from studio.scene.recording.pages import scene_page
from tests.studio.scene.made_up import make_rollouts


def page_about(rollouts: Rollouts) -> str:
    return scene_page(rollouts, judge(rollouts), {})


def test_the_page_tells_the_command_that_makes_the_recording_again() -> None:
    page = page_about(replace(make_rollouts(META_ACTIONS), noise=Noise(goal=0.25)))
    said = "studio record --scene test.toml --seed 7 --rollouts 3 --horizon 0.5"
    assert said in page
    assert "--noise goal=0.25" in page


@pytest.mark.parametrize(
    "special",
    [{"actions": META_ACTIONS[:2]}, {"wrap_angles": False}, {"limits": Limits(acceleration=2.0)}],
)
def test_where_no_command_makes_it_again_the_page_says_so(special: dict[str, Any]) -> None:
    rollouts = make_rollouts(special.get("actions", META_ACTIONS))
    rollouts = replace(rollouts, **special)
    assert record_command(rollouts) is None
    page = page_about(rollouts)
    assert "studio record" not in page
    assert "No command does this" in page
