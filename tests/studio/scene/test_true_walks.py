from dataclasses import replace

import numpy as np
import pytest

from scenes import Noise, Pedestrian, Robot, Rollouts, Scene, simulate
from studio.scene.true_walks import distance_from_true_walks, true_walks, true_walks_told

STILL = Noise(**dict.fromkeys(Noise.__dataclass_fields__, 0.0))


def some_rollouts(
    *tracks: tuple[tuple[float, float], ...] | None, horizon: float = 1.0
) -> Rollouts:
    """People who stand 5 m apart, whatever their true walks were."""
    scene = Scene(
        "a-scene",
        Robot(start=(0.0, 0.0), goal=(8.0, 0.0)),
        tuple(
            Pedestrian((9.0, 5.0 * row), (9.0, 5.0 * row), desired_speed=0.0, track=track)
            for row, track in enumerate(tracks)
        ),
    )
    return simulate(scene, rollouts=3, horizon=1.0, noise=STILL)


def test_true_walks_are_known_between_annotations_and_to_the_end_of_the_track() -> None:
    rollouts = some_rollouts(((9.0, 0.0), (9.4, 0.8), (9.4, 1.6)), None)
    walks = true_walks(rollouts)
    assert walks.shape == (11, 2, 2)
    np.testing.assert_allclose(walks[[0, 1, 4, 8], 0], [(9, 0), (9.1, 0.2), (9.4, 0.8), (9.4, 1.6)])
    assert np.isnan(walks[9:, 0]).all()
    assert np.isnan(walks[:, 1]).all()


def test_the_distance_is_the_mean_over_all_moments_of_which_the_truth_is_known() -> None:
    rollouts = some_rollouts(((9.0, 0.0), (9.0, 0.8), (9.0, 1.6)), ((9.3, 5.0),), None)
    apart = distance_from_true_walks(rollouts)
    assert apart is not None
    moved = np.arange(9) * 0.2
    assert apart.value == pytest.approx((moved.sum() + 0.3) / 10, abs=1e-6)
    assert apart.low <= apart.value <= apart.high
    for told in true_walks_told(rollouts):
        assert f"{apart.value:.3f}" in told


def test_it_is_known_as_well_as_rollouts_agree() -> None:
    rollouts = some_rollouts(((9.0, 0.0),) * 3)
    shaken = rollouts.without_robot + np.array([-0.3, 0.0, 0.3])[:, None, None, None]
    apart = distance_from_true_walks(replace(rollouts, without_robot=shaken))
    assert apart is not None
    assert apart.high - apart.low > 0.1


def test_nothing_is_told_of_people_who_are_made_up() -> None:
    rollouts = some_rollouts(None, None)
    assert distance_from_true_walks(rollouts) is None
    assert true_walks_told(rollouts) == []
    assert distance_from_true_walks(some_rollouts()) is None


def test_tracks_change_nothing_in_the_simulation() -> None:
    real, made_up = some_rollouts(((9.0, 0.0), (20.0, 0.0))), some_rollouts(None)
    np.testing.assert_array_equal(real.pedestrians, made_up.pedestrians)
    np.testing.assert_array_equal(real.features, made_up.features)
