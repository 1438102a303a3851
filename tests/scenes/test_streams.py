"""The random streams of scenes and rollouts."""

from scenes.streams import rollout_stream, scene_stream


def test_a_stream_is_found_again_by_its_numbers() -> None:
    assert scene_stream(3, 5).random() == scene_stream(3, 5).random()
    assert rollout_stream(3, 5, 7).random() == rollout_stream(3, 5, 7).random()


def test_no_scene_shares_its_stream_with_a_rollout() -> None:
    # Both have the key (3, 5).
    assert scene_stream(3, 5).random() != rollout_stream(3, 0, 5).random()
