"""What cannot be read of an option's value is said in one line."""

from pathlib import Path

import pytest

from tests.command_line import only_line, run


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ("record --scene open --noise fog=1", "--noise: 'fog' is not known: start, desired_speed"),
        ("record --scene open --noise goal=x", "--noise: 'goal=x' is not a setting"),
        ("record --scene x --robot-start here", "'here' is not a place: two numbers in metres"),
        ("render doorway.rrd --size big", "'big' is not a size: two whole numbers, WxH"),
        ("learn --pairs few", "--pairs: 'few' are not whole numbers"),
    ],
)
def test_values_that_cannot_be_read_are_refused(
    arguments: str, says: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    result = run(*arguments.split())
    assert says in only_line(result)
    assert result.exit_code == 2
    assert not list(tmp_path.iterdir())
