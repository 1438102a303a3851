"""How fast films, animations and recordings are made, and how much faster than pysocialforce's own.

The peer is the animation of pysocialforce (its `SceneVisualizer`, on matplotlib) of the same
rollouts at the same size: people, groups and walls as it draws them, the robot as one more person,
and the ghosts of all other rollouts as more of its circles; not the trails, texts and histograms of
our frames. They are encoded as H.264 too, while they are drawn. Both are measured in turn.
"""

import importlib
import io
import os
import sys
import tempfile
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from statistics import median
from types import SimpleNamespace
from typing import Any

import av
import numpy as np
from matplotlib.animation import AbstractMovieWriter
from matplotlib.collections import PatchCollection
from matplotlib.patches import Circle

import scenes.reference  # noqa: F401  # imports pysocialforce, quietly and without matplotlib
from scenes import META_ACTIONS, Rollouts, load_scene, simulate
from scenes.scene import PEDESTRIAN_RADIUS
from studio.judgements import Judgement, judge
from studio.painter.encode import write_gif, write_mp4
from studio.painter.film import compose_film
from studio.painter.film_crowd import between
from studio.recorder.recording import write_recording

SceneVisualizer = importlib.reload(sys.modules["pysocialforce.utils.plot"]).SceneVisualizer

SIZE, GIF_SIZE, FRAMES_PER_SECOND = (1280, 720), (800, 450), 30
PAIRS, PEER_FRAMES, DPI = 3, 40, 100


class Writer(AbstractMovieWriter):
    """Encodes the frames of a matplotlib animation while they are drawn."""

    def setup(self, fig: Any, outfile: str, dpi: float | None = None) -> None:
        """Open the file."""
        super().setup(fig, outfile, dpi)
        self._file = av.open(outfile, "w", format="mp4")
        options = {"preset": "veryfast", "crf": "18"}
        self._stream = self._file.add_stream("libx264", rate=FRAMES_PER_SECOND, options=options)
        self._stream.width, self._stream.height = self.frame_size
        self._stream.pix_fmt = "yuv420p"

    def grab_frame(self, **_: Any) -> None:
        """Draw a frame and encode it."""
        drawn = io.BytesIO()
        self.fig.savefig(drawn, format="rgba", dpi=self.dpi)
        width, height = self.frame_size
        pixels = np.frombuffer(drawn.getvalue(), np.uint8).reshape(height, width, 4)
        self._file.mux(self._stream.encode(av.VideoFrame.from_ndarray(pixels, format="rgba")))

    def finish(self) -> None:
        """Encode what is left."""
        self._file.mux(self._stream.encode(None))
        self._file.close()


class Ghosts(SceneVisualizer):
    """The animation of pysocialforce, with ghosts [T, N, 2] (m) as more of its circles."""

    def __init__(self, scene: SimpleNamespace, ghosts: np.ndarray, **settings: Any) -> None:
        super().__init__(scene, **settings)
        self._ghosts = ghosts
        self._circles = [Circle((0.0, 0.0), PEDESTRIAN_RADIUS) for _ in ghosts[0]]
        self._collection = PatchCollection([], animated=True, alpha=0.1)

    def animation_init(self) -> tuple[Any, ...]:
        """Add everything that moves."""
        self.ax.add_collection(self._collection)
        return (self._collection, *super().animation_init())

    def animation_update(self, i: int) -> tuple[Any, ...]:
        """Move everything."""
        for circle, centre in zip(self._circles, self._ghosts[i], strict=True):
            circle.center = centre
        self._collection.set_paths(self._circles)
        return (self._collection, *super().animation_update(i))


def peer(rollouts: Rollouts, ghosts: bool, folder: Path) -> float:
    """Frames a second of pysocialforce's animation of the first action."""
    steps = np.linspace(0.0, rollouts.robot.shape[2] - 1, PEER_FRAMES)
    robots, people = (
        np.stack([between(values, step) for step in steps])
        for values in (rollouts.robot[0, ..., :2], rollouts.pedestrians[0])
    )  # (T, K, 2) and (T, K, P, 2)
    everybody = np.concatenate([people, robots[:, :, None]], axis=2)
    groups = [list(group) for group in rollouts.scene.groups]
    scene = SimpleNamespace(
        # x, y and the radius, which is where pysocialforce looks for limits of the axes
        get_states=lambda: (everybody[:, 0], [groups] * PEER_FRAMES),
        get_length=lambda: PEER_FRAMES,
        get_obstacles=lambda: [np.array(wall) for wall in rollouts.scene.wall_segments],
    )
    settings = {"output": str(folder / "peer"), "writer": Writer(FRAMES_PER_SECOND)}
    settings |= {"figsize": (SIZE[0] / DPI, SIZE[1] / DPI), "dpi": DPI}
    others = everybody[:, 1:].reshape(PEER_FRAMES, -1, 2)
    start = time.perf_counter()
    shown = Ghosts(scene, others, **settings) if ghosts else SceneVisualizer(scene, **settings)
    with shown:
        shown.animate()
    return PEER_FRAMES / (time.perf_counter() - start)


def film(
    rollouts: Rollouts, judgements: tuple[Judgement, ...], path: Path, size: tuple[int, int]
) -> int:
    """Draw and encode the film of a scene; its number of frames."""
    segments = compose_film(rollouts, judgements, size, FRAMES_PER_SECOND)
    if path.suffix == ".gif":
        write_gif(path, segments, size, FRAMES_PER_SECOND)
    else:
        write_mp4(path, segments, size, FRAMES_PER_SECOND, path.stem)
    return sum(segment.length for segment in segments)


def seconds(work: Callable[[], object], times: int = 3) -> tuple[float, float]:
    """Median wall time and processor time of some work, s."""
    taken = []
    for _ in range(times):
        wall, processor = time.perf_counter(), time.process_time()
        work()
        taken.append((time.perf_counter() - wall, time.process_time() - processor))
    walls, processors = zip(*taken, strict=True)
    return median(walls), median(processors)


def main() -> None:
    """Print each figure beside what is wanted."""
    rollouts = simulate(load_scene("doorway", seed=0), META_ACTIONS, rollouts=50, seed=0)
    judgements = judge(rollouts)
    count = rollouts.robot.shape[1]
    print(
        f"doorway: {len(rollouts.scene.pedestrians)} pedestrians, {count} rollouts of "
        f"{len(rollouts.actions)} actions; {SIZE[0]}x{SIZE[1]}; {os.cpu_count()} processors"
    )
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        h264, av1, gif = folder / "h264.mp4", folder / "av1.mp4", folder / "film.gif"
        ratios, bare_ratios, rates = [], [], []
        for pair in range(PAIRS):
            theirs, bare = peer(rollouts, True, folder), peer(rollouts, False, folder)
            start = time.perf_counter()
            frames = film(rollouts, judgements, h264, SIZE)
            rates.append(frames / (time.perf_counter() - start))
            ratios.append(rates[-1] / theirs)
            bare_ratios.append(rates[-1] / bare)
            print(
                f"pair {pair + 1}: pysocialforce {theirs:.1f} frames/s ({bare:.1f} without "
                f"ghosts), film {rates[-1]:.0f} frames/s: {ratios[-1]:.0f} times faster "
                f"({bare_ratios[-1]:.0f} than without ghosts)"
            )
        print(
            f"median: {median(ratios):.0f} times faster (wanted: 30), "
            f"{median(bare_ratios):.0f} than without ghosts; {median(rates):.0f} frames/s "
            f"(wanted: 90)"
        )
        for path, size in ((h264, SIZE), (av1, SIZE), (gif, GIF_SIZE)):
            wall, processor = seconds(partial(film, rollouts, judgements, path, size))
            print(
                f"{path.name} of {frames} frames, {size[0]}x{size[1]}: {wall:.1f} s, "
                f"{processor:.1f} s of processor time, {path.stat().st_size / 1e6:.1f} MB"
            )
        recording = folder / "doorway.rrd"
        write_recording(recording, rollouts, judgements)  # imports
        wall, _ = seconds(partial(write_recording, recording, rollouts, judgements), 5)
        print(f"recording: {wall:.2f} s (wanted: 0.3 s)")


if __name__ == "__main__":
    main()
