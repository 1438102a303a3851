"""Make every picture of the README and of the docs anew, by the commands that users have.

Recordings are shown by the real Rerun viewer, without a window; on a machine without a graphics
card that takes a software Vulkan driver (Debian: mesa-vulkan-drivers).
"""

import tempfile
from collections.abc import Mapping
from pathlib import Path

import av
import cv2

from studio.orchestrator import Studio
from studio.recording import Excerpt, Look
from tests.headless import headless_viewer

PICTURES = Path(__file__).parent / "pictures"
LEAD = Path(__file__).with_name("lead_scene.toml")


def main() -> None:
    """Record the scene of the README, compare two of its actions, run the default study."""
    PICTURES.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        studio = Studio(folder)
        draw_scene(studio)
        draw_comparison(studio)
        draw_study(studio)


def draw_scene(studio: Studio) -> None:
    """The picture of a scene in light and dark, a film of it, and its recording."""
    recording = studio.record(LEAD, png=False, mp4=False).files[0]
    studio.render(recording, PICTURES / "scene.png")
    studio.render(recording, PICTURES / "scene_dark.png", look=Look(theme="dark"))
    forward = Excerpt(actions=("forward",), end=3.0)
    studio.render(recording, PICTURES / "film.gif", look=Look((960, 540), 15), excerpt=forward)
    save_frame(studio, recording, 1.9, PICTURES / "film.png")
    tabs = {"Overview": "recording", "forward": "action", "Prospects": "prospects"}
    show(recording, "sim_time", 2.5, tabs | {"Minds": "minds"})


def draw_comparison(studio: Studio) -> None:
    """The picture of a comparison, and its recording half way."""
    recording, picture = studio.compare(LEAD, "forward", "slow_down", mp4=False).files
    picture.replace(PICTURES / "comparison.png")
    show(recording, "story", 12.1, {"Which would you rather the robot did?": "comparing"})


def draw_study(studio: Studio) -> None:
    """The picture of a study, the figure for a paper, and the recording."""
    _, picture, recording, second, *_ = studio.learn(figure=PICTURES / "curves.svg").files
    picture.replace(PICTURES / "learning.png")
    second.replace(PICTURES / "learning_2.png")
    show(recording, "pairs", 2000, {"T&K": "learning_recording", "Families of T&K": "families"})


def save_frame(studio: Studio, recording: Path, seconds: float, path: Path) -> None:
    """Save what the film of a recording shows at one moment."""
    [film] = studio.render(recording, recording.with_suffix(".mp4"))
    with av.open(str(film)) as container:
        for frame in container.decode(video=0):
            if frame.time is not None and frame.time >= seconds:
                cv2.imwrite(str(path), frame.to_ndarray(format="bgr24"))
                return


def show(recording: Path, timeline: str, when: float, tabs: Mapping[str, str]) -> None:
    """Save tabs of a recording, as the viewer shows them at some time, under names of their own."""
    with headless_viewer(recording) as viewer:
        if timeline == "pairs":
            viewer.client.set_time(timeline, sequence=int(when))
        else:
            viewer.client.set_time(timeline, duration=when)
        for tab in viewer.tabs:
            if tab.name in tabs:
                viewer.show(tab)
                (PICTURES / f"{tabs[tab.name]}.png").write_bytes(viewer.screenshot())


if __name__ == "__main__":
    main()
