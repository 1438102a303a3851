"""The one orchestrator: from a scene to rollouts, outcomes, and files that a person looks at.

Everything heavy is imported where it is used: to import the studio costs nothing, and who wants no
film does not wait for a video encoder.
"""

from __future__ import annotations

import subprocess
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from studio.errors import InputError, RunError
from studio.files import replacing, writable_folder
from studio.progress import Quiet
from studio.sources import Source, find_scene

if TYPE_CHECKING:
    from scenes import Rollouts, Scene
    from scenes.bank import BankPlan
    from studio.judgements import Judgement

_COMPILING = "Compiling the engine: only on its first use, about a quarter of a minute ..."


@dataclass(frozen=True)
class Recorded:
    """What came of recording a scene.

    Attributes:
        rollouts: what was simulated.
        judgements: what each teacher thinks of the actions.
        files: what was written: recording, picture, film.
    """

    rollouts: Rollouts
    judgements: tuple[Judgement, ...]
    files: tuple[Path, ...]


class Studio:
    """Does from Python what the command line does.

    Example:
        `Studio(out="recordings").record("doorway", seed=0)`
    """

    def __init__(self, out: str | Path = "recordings", progress: Quiet | None = None) -> None:
        """Take the folder for output, and whom to tell how far the work is (nobody)."""
        self.out = Path(out)
        self.progress = progress or Quiet()

    def record(
        self,
        scene: str | Source | Scene,
        seed: int = 0,
        *,
        png: bool = True,
        mp4: bool = True,
        **settings: Any,
    ) -> Recorded:
        """Simulate a scene and write its recording, picture and film.

        Args:
            scene: a scene, where it comes from, or just the name or path of where.
            seed: of the noise, and of the scene if only its family is named.
            png: whether to write the picture.
            mp4: whether to write the film.
            settings: further arguments of `scenes.simulate`: rollouts, horizon, model, engine,
                noise and so on.

        Raises:
            InputError: if there is no such scene, a setting is not allowed (`scenes.InputError`),
                or the folder cannot be written to.
        """
        from scenes import simulate, warm_up

        if isinstance(scene, str):
            scene = Source(scene, seed=seed)
        if isinstance(scene, Source):
            scene = find_scene(scene)
        with self.progress.waiting(_COMPILING):
            warm_up(settings.get("engine", "batched"))
        rollouts = simulate(scene, seed=seed, **settings)

        from studio.judgements import judge

        judgements = judge(rollouts)
        folder = writable_folder(self.out, "--out")
        suffixes = [".rrd", *([".png"] if png else []), *([".mp4"] if mp4 else [])]
        files = tuple(folder / f"{scene.name}{suffix}" for suffix in suffixes)
        with ExitStack() as stack:
            for file in files:
                self._write(stack.enter_context(replacing(file)), rollouts, judgements)
        return Recorded(rollouts, judgements, files)

    def sample(self, path: str | Path, plan: BankPlan) -> Path:
        """Sample the outcome bank of a plan into a Parquet file.

        Raises:
            InputError: if the plan asks for something that cannot be simulated
                (`scenes.InputError`), or the file cannot be written.
        """
        from scenes import warm_up
        from scenes.bank import write_bank

        path = Path(path)
        if path.is_dir():
            raise InputError(f"--out: {path}: is a folder: the name of a file is needed")
        with self.progress.waiting(_COMPILING):
            warm_up(plan.engine)
        writable_folder(path.parent, "--out")
        with (
            self.progress.steps("scenes") as done,
            replacing(path) as part,
        ):
            write_bank(part, plan, done)
        return path

    def view(self, path: str | Path) -> None:
        """Open a recording in the Rerun viewer, and wait until it is closed.

        Raises:
            InputError: if the file is not a recording.
            RunError: if the viewer fails.
        """
        path = Path(path)
        check_is_recording(path)
        import rerun_cli

        # The program itself, not the wrapper script beside it, which would outlive us.
        viewer = Path(rerun_cli.__file__).with_name("rerun")
        code = subprocess.run([viewer, path], check=False).returncode
        if code:
            raise RunError(f"the Rerun viewer ended with exit code {code}; is there a display?")

    def _write(self, part: Path, rollouts: Rollouts, judgements: tuple[Judgement, ...]) -> None:
        if part.suffix == ".rrd":
            from studio.recorder.recording import write_recording

            write_recording(part, rollouts, judgements, {})
        elif part.suffix == ".png":
            from studio.painter.picture import write_png

            write_png(part, rollouts, judgements)
        else:
            from studio.painter.film import write_film

            with self.progress.steps("film") as done:
                write_film(part, rollouts, judgements, progress=done)


def check_is_recording(path: Path) -> None:
    """Make sure that a file looks like a Rerun recording.

    Raises:
        InputError: if it does not.
    """
    try:
        with path.open("rb") as file:
            start = file.read(4)
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    if start not in (b"RRF2", b"RRF0", b"RRF1"):
        raise InputError(f"{path}: is not a Rerun recording (.rrd)")
