import numpy as np
import pytest

from scenes import Pedestrian, Robot, Scene, load_scene
from studio.scene.picture.plan import PLAN_SIZE, compose_plan, scene_told, velocity_of
from studio.style.palette import THEMES, Theme


@pytest.mark.parametrize("theme", THEMES.values(), ids=THEMES)
def test_everybody_and_every_wall_is_in_the_plan(theme: Theme) -> None:
    scene = load_scene("intersection", number=11)
    pixels = compose_plan(scene, theme=theme).pixels
    assert pixels.shape == (PLAN_SIZE[1], PLAN_SIZE[0], 3)
    for colour in (theme.pedestrian, theme.wall, theme.ink):
        assert (pixels == colour).all(axis=-1).sum() > 200


def test_the_plan_says_what_it_shows() -> None:
    scene = load_scene("intersection", number=11)
    written = [text.text for text in compose_plan(scene).texts]
    assert "intersection · crossing · number 11" in written
    assert "7 pedestrians (1 group), 8 walls" in written
    alone = Scene("mine", Robot((0.0, 0.0), (9.0, 0.0)))
    assert scene_told(alone) == ("mine", "0 pedestrians, no walls")
    assert compose_plan(alone).texts


def test_people_begin_at_their_own_velocity_or_walk_to_their_goal() -> None:
    walker = Pedestrian((0.0, 0.0), (3.0, 4.0), 2.0)
    np.testing.assert_allclose(velocity_of(walker), [1.2, 1.6])
    np.testing.assert_allclose(
        velocity_of(Pedestrian((0.0, 0.0), (3.0, 4.0), 2.0, (0.5, 0.0))), [0.5, 0.0]
    )
    np.testing.assert_allclose(velocity_of(Pedestrian((0.0, 0.0), (0.0, 0.0), 0.0)), [0.0, 0.0])
