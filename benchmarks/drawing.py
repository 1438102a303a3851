"""How fast films and recordings are made and shown, beside pysocialforce's own animation.

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
from dataclasses import dataclass
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
from studio.painter.gif import write_gif
from studio.painter.mp4 import write_mp4
from studio.scene.judgements import Judgement, judge
from studio.scene.picture.crowd import between
from studio.scene.picture.film import compose_film
from studio.scene.recording.write import write_recording
from studio.scene.reference import reference_utilities
from tests.headless import headless_viewer

SceneVisualizer = importlib.reload(sys.modules["pysocialforce.utils.plot"]).SceneVisualizer

SIZE, GIF_SIZE, FRAMES_PER_SECOND = (1280, 720), (800, 450), 30
PAIRS, PEER_FRAMES, DPI = 3, 40, 100


@dataclass(frozen=True)
class Pace:
    """How long some frames took: wall and processor time, s."""

    frames: int
    wall: float
    processor: float

    @classmethod
    def of(cls, work: Callable[[], int]) -> "Pace":
        """The pace of some work that returns its number of frames."""
        wall, processor = time.perf_counter(), time.process_time()
        frames = work()
        return cls(frames, time.perf_counter() - wall, time.process_time() - processor)

    @property
    def rate(self) -> float:
        """Frames a second."""
        return self.frames / self.wall

    @property
    def cost(self) -> float:
        """Processor time a frame, ms."""
        return 1e3 * self.processor / self.frames


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


def peer(rollouts: Rollouts, ghosts: bool, folder: Path) -> Pace:
    """How fast pysocialforce animates the first action."""
    steps = np.linspace(0.0, rollouts.steps, PEER_FRAMES)
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

    def animate() -> int:
        shown = Ghosts(scene, others, **settings) if ghosts else SceneVisualizer(scene, **settings)
        with shown:
            shown.animate()
        return PEER_FRAMES

    return Pace.of(animate)


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


def shown(recording: Path) -> tuple[float, float]:
    """When the viewer has loaded a recording, and when it has drawn it, s after its start."""
    start = time.perf_counter()
    with headless_viewer(recording, SIZE) as viewer:
        loaded = time.perf_counter() - start
        viewer.client.take_screenshot()
        return loaded, time.perf_counter() - start


def main() -> None:
    """Print each figure beside what is wanted."""
    rollouts = simulate(load_scene("doorway", seed=0), META_ACTIONS, rollouts=50, seed=0)
    judgements = judge(rollouts, reference=reference_utilities(rollouts))
    count = rollouts.count
    print(
        f"doorway: {len(rollouts.scene.pedestrians)} pedestrians, {count} rollouts of "
        f"{len(rollouts.actions)} actions; {SIZE[0]}x{SIZE[1]}; {os.cpu_count()} processors"
    )
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        h264, av1, gif = folder / "h264.mp4", folder / "av1.mp4", folder / "film.gif"
        films = {
            path: partial(film, rollouts, judgements, path, size)
            for path, size in ((h264, SIZE), (av1, SIZE), (gif, GIF_SIZE))
        }
        ratios, bare_ratios, cheaper, rates = [], [], [], []
        for pair in range(PAIRS):
            theirs, bare = peer(rollouts, True, folder), peer(rollouts, False, folder)
            ours = Pace.of(films[h264])
            rates.append(ours.rate)
            ratios.append(ours.rate / theirs.rate)
            bare_ratios.append(ours.rate / bare.rate)
            cheaper.append(theirs.cost / ours.cost)
            print(
                f"pair {pair + 1}: pysocialforce {theirs.rate:.1f} frames/s, {theirs.cost:.0f} ms "
                f"of processor time a frame (without ghosts {bare.rate:.1f} and {bare.cost:.0f}); "
                f"film {ours.rate:.0f} frames/s, {ours.cost:.1f} ms: {ratios[-1]:.0f} times faster"
            )
        print(
            f"film: {median(ratios):.0f} times the frames/s of pysocialforce (wanted: 30; "
            f"{median(bare_ratios):.0f} times those without ghosts), for one "
            f"{median(cheaper):.0f}th of the processor time a frame"
        )
        print(f"film: {median(rates):.0f} frames/s (wanted: 90)")
        for path, made in films.items():
            tries = sorted((Pace.of(made) for _ in range(3)), key=lambda pace: pace.wall)
            pace = tries[len(tries) // 2]
            print(
                f"{path.name} of {pace.frames} frames: {pace.wall:.1f} s, "
                f"{pace.processor:.1f} s of processor time, {path.stat().st_size / 1e6:.1f} MB"
            )
        recording = folder / "doorway.rrd"
        write_recording(recording, rollouts, judgements)  # imports
        taken = []
        for _ in range(5):
            start = time.perf_counter()
            write_recording(recording, rollouts, judgements)
            taken.append(time.perf_counter() - start)
        print(f"recording: {median(taken):.2f} s (wanted: 0.5 s)")
        loaded, drawn = (
            median(times) for times in zip(*(shown(recording) for _ in range(3)), strict=True)
        )
        print(
            f"viewer: first frame {drawn - loaded:.2f} s after loading (wanted: 2 s), "
            f"{drawn:.2f} s after its start; drawn by the processor where there is no graphics card"
        )


if __name__ == "__main__":
    main()
