"""The README does what it says."""

import re
from pathlib import Path

import pytest
from click.testing import CliRunner

from scenes.bank import BankPlan, write_bank
from studio.cli import main

README = (Path(__file__).parent.parent / "README.md").read_text(encoding="utf-8")
PYTHON = re.findall(r"```python\n(.*?)```", README, flags=re.DOTALL)
SHELL = re.findall(r"^studio .*", README, flags=re.MULTILINE)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder to work in, with what the examples read."""
    monkeypatch.chdir(tmp_path)
    write_bank(tmp_path / "outcomes.parquet", BankPlan(scenes=8, rollouts=4))
    (tmp_path / "choices.csv").write_text(
        "scene,action_a,action_b,preferred\n0,stop,forward,stop\n1,slow_down,stop,slow_down\n"
    )
    return tmp_path


@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize("block", PYTHON, ids=range(len(PYTHON)))
def test_every_python_example_runs(block: str) -> None:
    exec(compile(block, "README.md", "exec"), {})


@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize("line", SHELL)
def test_every_command_has_the_options_it_is_shown_with(line: str) -> None:
    words = line.split("#")[0].split(">")[0].split()[1:]
    if words[0] in ("scenes",):
        assert CliRunner().invoke(main, words).exit_code == 0
        return
    command = main.commands[words[0]]
    command.make_context(words[0], words[1:])  # parses, and raises what does not fit
