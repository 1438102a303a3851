import numpy as np

from scenes import FEATURES, load_scene, simulate
from scenes.features import CLEARANCE_SCALE
from studio.scene.measures import gap_over_time, measures, progress_over_time, touched_by
from tests.studio.scene.made_up import make_rollouts


def test_gap_and_progress_over_time_come_to_what_outcomes_are_described_by() -> None:
    rollouts = simulate(load_scene("doorway"), rollouts=5, horizon=2.0)
    smallest = np.clip(gap_over_time(rollouts).min(axis=-1), 0.0, CLEARANCE_SCALE)
    np.testing.assert_allclose(smallest, rollouts.clearance_m)
    progress = progress_over_time(rollouts)
    assert not progress[..., 0].any()
    np.testing.assert_allclose(progress[..., -1], rollouts.progress_m)


def test_nobody_is_infinitely_far_away() -> None:
    assert np.isposinf(gap_over_time(make_rollouts(people=0))).all()


def test_measures_are_the_features_in_metres_where_they_are_lengths() -> None:
    rollouts = make_rollouts()
    shown = measures(rollouts)
    assert tuple(measure.feature for measure in shown) == FEATURES
    assert [measure.title for measure in shown][2:] == ["progress, m", "smoothness", "collisions"]
    np.testing.assert_array_equal(shown[2].values, rollouts.progress_m)
    np.testing.assert_array_equal(shown[3].values, rollouts.features[..., 3])


def test_contacts_last_from_the_step_at_which_they_begin() -> None:
    rollouts = make_rollouts()  # the first robot under the first action, at step 2
    steps = rollouts.contact_step[0]
    assert [touched_by(steps, step).tolist() for step in (1.9, 2)] == [
        [False] * 3,
        [True, False, False],
    ]
