"""The rooms, the one direction of travel between them, and what keeps the house easy to read."""

import ast
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
SOURCES = [
    path for room in ("studio", "learners", "scenes") for path in (ROOT / room).rglob("*.py")
]
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


def test_what_scenes_and_learners_call_the_features_is_the_same() -> None:
    """The studio weighs the features of the one by the reward of the other, place by place."""
    import learners
    import scenes

    assert scenes.FEATURES == learners.FEATURES
    assert len(learners.REWARD) == len(scenes.FEATURES)


def test_no_file_is_too_long_to_read_at_a_sitting() -> None:
    lengths = {
        str(path.relative_to(ROOT)): len(path.read_text(encoding="utf-8").splitlines())
        for path in SOURCES
    }
    assert {path: length for path, length in lengths.items() if length > 350} == {}


def test_the_ground_floor_of_the_studio_is_small() -> None:
    files = [path.name for path in (ROOT / "studio").iterdir() if path.is_file()]
    assert len(files) <= 10, sorted(files)


ROLES = {
    "read": "of a `kind.py`: reads a recording of this kind",
    "walk": "of an engine: lets people walk",
}
"""What several files rightly call alike, because it plays the same part in each."""


def test_no_two_things_have_one_name() -> None:
    places = defaultdict(list)
    for path in SOURCES:
        for thing in ast.parse(path.read_text(encoding="utf-8")).body:
            is_overload = any(
                "overload" in ast.dump(each) for each in getattr(thing, "decorator_list", ())
            )
            if isinstance(thing, ast.FunctionDef | ast.ClassDef) and not is_overload:
                places[thing.name].append(str(path.relative_to(ROOT)))
    twice = {
        name: where
        for name, where in places.items()
        if len(where) > 1 and not name.startswith("_") and name not in ROLES
    }
    # rooms that know nothing of one another each refuse wrong input in an error of their own
    assert twice.pop("InputError") == ["studio/errors.py", "learners/errors.py", "scenes/errors.py"]
    assert twice == {}
