import numpy as np
import pytest

from scenes import Pedestrian, Robot, Scene, simulate
from studio.errors import InputError
from studio.scene.selection import only

BY_ACTION = (
    "robot",
    "pedestrians",
    "features",
    "clearance_m",
    "progress_m",
    "person_step",
    "wall_step",
)


@pytest.fixture(scope="module")
def rollouts():
    person = Pedestrian(start=(3.0, 0.2), goal=(-9.0, 0.2))
    scene = Scene("a-scene", Robot(start=(0.0, 0.0), goal=(8.0, 0.0)), (person,))
    return simulate(scene, rollouts=3, horizon=0.5)


def test_only_takes_what_belongs_to_the_named_actions_in_the_order_of_the_names(rollouts):
    taken = only(rollouts, ["stop", "forward"])
    assert [action.name for action in taken.actions] == ["stop", "forward"]
    for name in BY_ACTION:
        np.testing.assert_array_equal(getattr(taken, name), getattr(rollouts, name)[[2, 0]])
        assert not getattr(taken, name).flags.writeable
    assert taken.without_robot is rollouts.without_robot
    assert taken.scene == rollouts.scene


@pytest.mark.parametrize(
    ("names", "message"),
    [
        (["forwards"], "action: 'forwards' is not there: forward, slow_down, stop"),
        ([], "none given, at least one is needed: forward"),
        (["stop", "stop"], "stop, stop: each can be taken once"),
    ],
)
def test_only_refuses_actions_in_one_line(rollouts, names, message):
    with pytest.raises(InputError, match=message) as error:
        only(rollouts, names)
    assert "\n" not in str(error.value)
