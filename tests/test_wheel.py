"""What is installed is whole: the wheel does without this checkout."""

import os
import shutil
import subprocess
import sys
import venv
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
ROOMS = ("studio", "scenes", "learners")


def test_every_folder_of_code_is_a_package() -> None:
    """A folder without `__init__.py` would be missing from the wheel."""
    folders = {path.parent for room in ROOMS for path in (ROOT / room).rglob("*.py")}
    assert [folder for folder in folders if not (folder / "__init__.py").exists()] == []


@pytest.mark.slow
def test_the_wheel_records_a_scene_from_another_folder(tmp_path: Path) -> None:
    source, wheels, place, work = (
        tmp_path / name for name in ("source", "wheels", "place", "work")
    )
    work.mkdir()
    # a copy, because building leaves files behind that the next wheel would take for sources
    for room in ROOMS:
        shutil.copytree(ROOT / room, source / room)
    for file in ("pyproject.toml", "README.md", "LICENSE"):
        shutil.copy(ROOT / file, source)
    build = [sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps", "--wheel-dir"]
    subprocess.run([*build, wheels, source], check=True)
    [wheel] = wheels.iterdir()
    venv.create(place, with_pip=True)
    pins = ["--constraint", ROOT / "constraints.txt"]
    subprocess.run([place / "bin" / "pip", "install", "--quiet", *pins, wheel], check=True)
    apart = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    record = ["record", "--scene", "doorway", "--rollouts", "3", "--horizon", "1"]
    subprocess.run([place / "bin" / "studio", *record], cwd=work, env=apart, check=True)
    made = sorted(path.name for path in (work / "recordings").iterdir())
    assert made == ["doorway.mp4", "doorway.png", "doorway.rrd"]
    shown = [place / "bin" / "python", "-c", "import studio; print(studio.__file__)"]
    told = subprocess.run(shown, cwd=work, env=apart, check=True, capture_output=True, text=True)
    assert Path(told.stdout.strip()).is_relative_to(place)
