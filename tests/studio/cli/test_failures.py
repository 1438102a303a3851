"""How commands end that fail."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

IMPORTING_FOR_EVER = """
import click
from studio.cli.failures import OneLineErrors

@click.group(cls=OneLineErrors)
def main(): ...

@main.command()
def work():
    # as an import does
    exec("open('begun', 'w').close()\\nwhile True: pass")

main()
"""


@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGTERM])
def test_an_interruption_in_the_middle_of_an_import_has_its_exit_code_too(
    how: signal.Signals, tmp_path: Path
) -> None:
    (tmp_path / "endless.py").write_text(IMPORTING_FOR_EVER)
    process = subprocess.Popen(
        [sys.executable, "-m", "endless", "work"], cwd=tmp_path, stderr=subprocess.PIPE, text=True
    )
    deadline = time.monotonic() + 60
    while not (tmp_path / "begun").exists() and time.monotonic() < deadline:
        time.sleep(0.05)
    os.kill(process.pid, how)
    _, said = process.communicate(timeout=60)
    assert process.returncode == 130
    assert said.splitlines()[-1] == "studio: interrupted"
