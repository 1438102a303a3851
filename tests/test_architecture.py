"""The rooms and the one direction of travel between them."""

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
HEAVY = ("rerun", "cv2", "av", "torch", "numba", "pysocialforce", "matplotlib")


def test_rooms_import_only_what_they_may() -> None:
    linter = Path(sys.executable).with_name("lint-imports")
    done = subprocess.run(
        [linter, "--no-cache"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout


@pytest.mark.parametrize(
    "code",
    [
        "import studio",
        "import studio.orchestrator",
        "from click.testing import CliRunner; from studio.cli import main; "
        "assert 'record' in CliRunner().invoke(main, ['--help']).output",
        "from click.testing import CliRunner; from studio.cli import main; "
        "assert '--scene' in CliRunner().invoke(main, ['record', '--help']).output",
        "import scenes; scenes.load_scene('doorway')",
        "import learners; learners.prospect_value([[0.1, -0.2]], learners.PROFILES['tk'])",
    ],
    ids=["studio", "orchestrator", "studio --help", "studio record --help", "a scene", "a value"],
)
def test_what_is_light_loads_nothing_heavy(code: str) -> None:
    check = f"import sys; {code}; print(*sorted(set({HEAVY!r}) & set(sys.modules)))"
    done = subprocess.run([sys.executable, "-c", check], capture_output=True, text=True, check=True)
    assert done.stdout.split() == []


def test_a_scene_is_judged_and_recorded_without_torch(tmp_path: Path) -> None:
    arguments = ["record", "--scene", "open", "--rollouts", "2", "--no-mp4", "--out", str(tmp_path)]
    check = (
        f"import sys; from studio.cli import main; main({arguments!r}, standalone_mode=False); "
        "assert 'torch' not in sys.modules"
    )
    done = subprocess.run(
        [sys.executable, "-c", check], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "open.rrd").exists()
