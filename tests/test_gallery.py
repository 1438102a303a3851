"""The scene that README and gallery lead with is what they say it is."""

from pathlib import Path

import pytest

from scenes import META_ACTIONS, Rollouts, simulate
from studio.scene.judgements import Judgement, judge
from studio.scene.reference import reference_utilities
from studio.scene.sources import Source, find_scene
from studio.scene.words import contact_told, pick_told

ROOT = Path(__file__).parent.parent
NAMES = [action.name for action in META_ACTIONS]


@pytest.fixture(scope="module")
def few() -> Rollouts:
    return simulate(find_scene(Source(str(ROOT / "docs" / "lead_scene.toml"))))


@pytest.fixture(scope="module")
def judgements(few: Rollouts) -> tuple[Judgement, ...]:
    return judge(few, reference=reference_utilities(few))


def words_of(name: str) -> str:
    """A text without its line breaks."""
    return " ".join((ROOT / name).read_text(encoding="utf-8").split())


def test_teachers_differ_and_every_pick_is_sure(judgements: tuple[Judgement, ...]) -> None:
    assert all(each.is_sure for each in judgements)
    assert len({each.candidates for each in judgements}) >= 2
    # what the picture shows of these very rollouts leads to the same picks
    assert [each.best for each in judgements] == [each.candidates[0] for each in judgements]


def test_two_thousand_rollouts_lead_to_the_same_picks(
    few: Rollouts, judgements: tuple[Judgement, ...]
) -> None:
    many = judge(simulate(few.scene, rollouts=2000))
    assert [each.candidates for each in many] == [each.candidates for each in judgements]


@pytest.mark.parametrize("name", ["README.md", "docs/gallery.md"])
def test_captions_say_who_picks_what(name: str, judgements: tuple[Judgement, ...]) -> None:
    words = words_of(name)
    for each in judgements[:2]:
        assert f"{each.label} picks {pick_told(each, NAMES)}" in words


def test_captions_say_how_often_there_is_contact_and_how_sure_picks_are(
    few: Rollouts, judgements: tuple[Judgement, ...]
) -> None:
    words = words_of("README.md")
    forward = NAMES.index("forward")
    touched = int(few.touched[forward].sum())
    assert f"{touched} of {few.count} rollouts, {contact_told(few, forward)}" in words
    shares = [f"{100.0 * each.shares.max():.0f} %" for each in judgements]
    assert f"in {shares[0]}, {shares[1]} and {shares[2]} of draws" in words
