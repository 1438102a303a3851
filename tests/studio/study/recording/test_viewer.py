"""The recording of a large study in the real Rerun viewer, in a window as small as a projector."""

from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np

from learners import TEACHERS
from studio.study.recording.write import write_study_recording
from tests.headless import NoGraphicsError, headless_viewer
from tests.studio.conftest import Missing
from tests.studio.study.tables import study_of

BLANK = 0.01  # share of a view that differs from its ground if there is something to see
TITLE = (29, 75)  # widths of what stands at the left and at the right of a view's title, px
LETTER = 6.6  # width of a letter of a title, on average, px


def test_no_tab_is_empty_and_no_title_cut_off_with_four_teachers_and_three_learners(
    missing: Missing, tmp_path: Path
) -> None:
    teachers = (*TEACHERS.values(), replace(TEACHERS["tk"], name="cautious walker"))
    results = study_of(teachers, ("eu", "cpt", "cpt-tied"), (25, 2000), 2)
    write_study_recording(tmp_path / "learning.rrd", results, {})
    try:
        with headless_viewer(tmp_path / "learning.rrd", (1280, 720)) as viewer:
            for tab in viewer.tabs:
                viewer.show(tab)
                for view in viewer.views():
                    pixels = cv2.imdecode(np.frombuffer(view.png, np.uint8), cv2.IMREAD_COLOR)
                    colours, counts = np.unique(pixels.reshape(-1, 3), axis=0, return_counts=True)
                    away = np.abs(pixels.astype(int) - colours[counts.argmax()]).max(axis=-1)
                    assert (away > 60).mean() > BLANK, (tab.name, view.name)
                    room = pixels.shape[1] - sum(TITLE)
                    assert LETTER * len(view.name) <= room, (tab.name, view.name)
            assert viewer.problems() == ()
    except NoGraphicsError:
        missing("mesa-vulkan-drivers")
