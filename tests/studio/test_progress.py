"""What a person is told while the studio works."""

import subprocess
import sys
from pathlib import Path


def test_no_progress_bar_reaches_a_pipe(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "studio", "sample", "--scenes", "2", "--rollouts", "1"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=True,
    )
    assert "\x1b" not in done.stdout + done.stderr
    assert done.stdout.count("\n") == 1
