"""How long a person waits for each command, first and later, and how large a recording is."""

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median

from studio.made.results import Recorded
from studio.orchestrator import Studio
from studio.scene.recording.write import MOST_PATHS

STUDIO = [sys.executable, "-m", "studio"]


def waited(arguments: list[str], times: int, cache: str | None = None) -> float:
    """Median wall time of a command, s; `cache` is where compiled code is kept."""
    environment = os.environ | ({"NUMBA_CACHE_DIR": cache} if cache else {})
    taken = []
    for _ in range(times):
        start = time.perf_counter()
        subprocess.run(
            [*STUDIO, *arguments], env=environment, check=True, stdout=subprocess.DEVNULL
        )
        taken.append(time.perf_counter() - start)
    return median(taken)


def main() -> None:
    """Print each figure beside what is wanted."""
    with tempfile.TemporaryDirectory() as folder:
        record = ["record", "--scene", "doorway", "--out", folder]
        cache = str(Path(folder) / "cache")
        print(f"studio --help: {waited(['--help'], 9):.2f} s (wanted: 0.3 s)")
        print(f"{' '.join(record[:3])}, first: {waited(record, 1, cache):.1f} s (wanted: 40 s)")
        print(f"{' '.join(record[:3])}, later: {waited(record, 5, cache):.1f} s (wanted: 7 s)")

        for rollouts in (50, 5000):
            recorded = Studio(folder).record(
                "doorway", rollouts=rollouts, png=False, mp4=False, force=True
            )
            size, numbers = recorded.files[0].stat().st_size, numbers_in(recorded)
            allowed = 1.2 * 4 * numbers + 1.5e6
            print(
                f"recording of {rollouts} rollouts: {size / 1e6:.2f} MB, for {numbers:,} numbers "
                f"(wanted: 1.2 times them as float32 and 1.5 MB, {allowed / 1e6:.2f} MB)"
            )


def numbers_in(recorded: Recorded) -> int:
    """How many numbers a recording keeps: poses, positions, outcomes, those held against."""
    rollouts = recorded.rollouts.keep_paths(MOST_PATHS)
    paths = rollouts.robot.size + rollouts.pedestrians.size + rollouts.without_robot.size
    outcomes = 8 * rollouts.person_step.size  # the columns of the table of an action's outcomes
    reference = recorded.judgements[0].reference
    return paths + outcomes + (reference.utilities.size if reference else 0)


if __name__ == "__main__":
    main()
