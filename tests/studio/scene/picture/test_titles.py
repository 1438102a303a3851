from dataclasses import replace

import numpy as np
import pytest

from learners import PROFILES
from scenes import META_ACTIONS, Pedestrian, Robot, Scene, simulate
from studio.scene.framing import bounds_to_show, in_view
from studio.scene.judgements import Judgement
from studio.scene.picture.film import lay_out_film
from studio.scene.picture.page import compose_picture
from studio.scene.picture.titles import findings, subtitles, titles
from tests.canvases import texts
from tests.studio.scene.made_up import make_rollouts

NAMES = ("forward", "slow_down", "stop", "turn_left", "turn_right")


def judgement(teacher: str, *picks: str) -> Judgement:
    """A teacher who picks each of these actions in as many draws."""
    resampled = np.zeros((60, len(NAMES)))
    for place, name in enumerate(picks):
        resampled[place :: len(picks), NAMES.index(name)] = 1.0
    return Judgement(teacher, PROFILES[teacher], resampled.mean(axis=0), resampled)


def test_teachers_who_pick_alike_are_named_together_and_what_is_open_is_called_open() -> None:
    every = [
        judgement("eu", "forward"),
        judgement("tk", "forward", "slow_down"),
        judgement("strong", "forward"),
    ]
    long, brief = findings(every, NAMES)
    assert long == "EU and Strong pick forward · T&K: forward or slow down, it is open which"
    assert brief == "EU and Strong pick forward · T&K: forward or slow down (open)"
    assert findings(every[:1], NAMES)[0] == "EU picks forward"


def test_many_actions_of_which_it_is_open_which_are_counted() -> None:
    long, _ = findings([judgement("tk", *NAMES[:4])], NAMES)
    assert long == "T&K: open between 4 of 5 actions"


def test_long_names_keep_both_of_their_ends() -> None:
    names = tuple(f"a_name_that_is_rather_long_number_{index}" for index in range(5))
    one = replace(judgement("eu", "slow_down"))
    assert findings([one], names)[0].startswith("EU picks a name")
    assert findings([one], names)[0].endswith("number 1")


def test_real_crowds_are_named_in_words_with_their_frame() -> None:
    rollouts = make_rollouts()
    scene = replace(
        rollouts.scene, name="seq_eth-1234", family="tracks", pattern="recorded", number=1234
    )
    real = replace(rollouts, scene=scene)
    assert titles(real)[0] == "seq eth · a real crowd at frame 1234"
    assert "frame 1234" in subtitles(real, bounds_to_show(real))[0]
    assert "number" not in subtitles(real, bounds_to_show(real))[0]


@pytest.fixture(scope="module")
def spread_out():
    """One person near the robot, three out of its reach, of whom two are on the same side."""
    places = ((4.0, 0.5), (-40.0, 1.0), (0.0, 60.0), (1.0, 61.0))
    people = tuple(Pedestrian(place, (place[0] + 30.0, place[1])) for place in places)
    scene = Scene("a-scene", Robot(start=(0.0, 0.0), goal=(6.0, 0.0)), people)
    return simulate(scene, META_ACTIONS[:2], rollouts=4, horizon=1.0)


@pytest.mark.parametrize("size", [(640, 360), (1280, 720), (1080, 1350)])
def test_who_is_out_of_view_is_counted_at_the_edge_and_in_the_heading(spread_out, size) -> None:
    canvases = [compose_picture(spread_out, (), size)]
    if size[0] > size[1]:
        canvases.append(lay_out_film(spread_out, size).canvas)
    for canvas in canvases:
        said = texts(canvas)
        assert "1 more person" in said
        assert "2 more people" in said
        assert any("4 pedestrians (1 in view, 3 not)" in text for text in said)


def test_where_everybody_is_in_view_nobody_is_counted_out(spread_out) -> None:
    scene = replace(spread_out.scene, pedestrians=spread_out.scene.pedestrians[:1])
    rollouts = simulate(scene, META_ACTIONS[:2], rollouts=4, horizon=1.0)
    assert in_view(scene.starts, bounds_to_show(rollouts)).all()
    said = " ".join(texts(compose_picture(rollouts, ())))
    assert "1 pedestrian ·" in said
    assert "in view" not in said
    assert " more p" not in said
