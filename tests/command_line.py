"""The command line, called from tests."""

from pathlib import Path

from click.testing import CliRunner, Result

from studio.cli import main


def run(*arguments: str | Path) -> Result:
    return CliRunner().invoke(main, [str(argument) for argument in arguments])


def only_line(result: Result) -> str:
    """What stands on standard error, which must be one line."""
    assert isinstance(result.exception, SystemExit), result.exception
    assert result.stderr.count("\n") == 1, result.stderr
    return result.stderr.strip()
