"""The Rerun viewer: where its program is, and how it is opened."""

import subprocess
from pathlib import Path

import rerun_cli

from studio.errors import RunError

VIEWER = Path(rerun_cli.__file__).with_name("rerun")
"""The program itself, not the wrapper script beside it, which would outlive whoever starts it."""


def open_viewer(recording: Path) -> None:
    """Show a recording in the Rerun viewer, and wait until the viewer is closed.

    The viewer starts in the recording's folder, from which links to other recordings lead on.

    Raises:
        RunError: if the viewer fails.
    """
    command = [VIEWER, recording.resolve()]
    code = subprocess.run(command, cwd=recording.parent, check=False).returncode
    if code:
        raise RunError(f"the Rerun viewer ended with exit code {code}; is there a display?")
