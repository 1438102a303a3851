"""What is said of files that cannot be read, for the tests of all readers."""

from pathlib import Path

import pytest

from studio.errors import InputError
from studio.kinds import read_recording


def refused(path: Path) -> str:
    with pytest.raises(InputError) as error:
        read_recording(path)
    message = str(error.value)
    assert str(path) in message
    assert "\n" not in message
    return message
