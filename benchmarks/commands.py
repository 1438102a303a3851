"""How long a person waits for each command, first and later, and how large a recording is."""

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median

from studio.orchestrator import Studio

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

        recorded = Studio(folder).record("doorway", png=False, mp4=False)
        rollouts = recorded.rollouts
        numbers = rollouts.robot.size + rollouts.pedestrians.size + rollouts.without_robot.size
        size, raw = recorded.files[0].stat().st_size, 4 * numbers
        print(
            f"recording: {size / 1e6:.2f} MB, {size / raw:.2f} times its {numbers:,} poses and "
            f"positions as float32 (wanted: 1.2)"
        )


if __name__ == "__main__":
    main()
