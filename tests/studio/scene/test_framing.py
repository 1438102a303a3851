import numpy as np
import pytest

from scenes import META_ACTIONS, Pedestrian, Robot, Scene, Wall, simulate
from studio.scene.framing import MARGIN, SURROUNDINGS, bounds_of_shape, bounds_to_show


def some_rollouts(people=((3.0, 0.3),), goal=(6.0, 0.0)):
    scene = Scene(
        name="a-scene",
        robot=Robot(start=(0.0, 0.0), goal=goal),
        pedestrians=tuple(Pedestrian(at, (-9.0, at[1]), desired_speed=1.3) for at in people),
        walls=(Wall((-20.0, 20.0), (20.0, 20.0)), Wall((-20.0, -1.5), (20.0, -1.5))),
    )
    return simulate(scene, META_ACTIONS, rollouts=5, horizon=3.0)


def paths(rollouts):
    return rollouts.robot[..., :2].reshape(-1, 2)


def within(points, bounds):
    x0, y0, x1, y1 = bounds
    return bool(((points >= (x0, y0)) & (points <= (x1, y1))).all())


def test_all_that_the_robot_may_do_is_shown_and_little_else():
    rollouts = some_rollouts()
    x0, y0, x1, y1 = bounds_to_show(rollouts)
    (left, low), (right, high) = paths(rollouts).min(axis=0), paths(rollouts).max(axis=0)
    reach = SURROUNDINGS + MARGIN
    assert (x0, x1, y1) == pytest.approx((left - reach, right + reach, high + reach))
    assert y0 == pytest.approx(max(-1.5, low - SURROUNDINGS) - MARGIN)


@pytest.mark.parametrize("shape", [(16.0, 9.0), (300.0, 100.0), (1.0, 2.0)])
def test_bounds_of_a_shape_show_all_the_others_do(shape):
    rollouts = some_rollouts()
    x0, y0, x1, y1 = bounds_of_shape(rollouts, *shape)
    assert (x1 - x0) / (y1 - y0) == pytest.approx(shape[0] / shape[1])
    inner = bounds_to_show(rollouts)
    hair = 1e-9
    outer = (x0 - hair, y0 - hair, x1 + hair, y1 + hair)
    assert within(np.array(inner).reshape(2, 2), outer)
    # no farther away than they need be
    assert min((x1 - x0) - (inner[2] - inner[0]), (y1 - y0) - (inner[3] - inner[1])) < 1e-9


def test_spare_room_goes_to_the_goal_and_to_people_who_come_near():
    met, passing = (5.5, 0.3), (-6.0, 15.0)
    bounds = bounds_of_shape(some_rollouts((met, passing)), 2.0, 1.0)
    assert within(np.array([met, (6.0, 0.0)]), bounds)
    assert not within(np.array([passing]), bounds)
    behind = bounds_of_shape(some_rollouts((), goal=(-4.0, 0.0)), 2.0, 1.0)
    assert behind[0] < bounds[0]
