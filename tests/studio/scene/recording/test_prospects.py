import numpy as np

from studio.scene.recording.prospects import stairs


def test_stairs_have_a_level_step_for_every_height() -> None:
    assert stairs(2.0, np.array([0.5, 0.25])).tolist() == [
        [2.0, 0.5],
        [2.5, 0.5],
        [2.5, 0.25],
        [3.0, 0.25],
    ]
