"""What several tests of scenes are given."""

from collections.abc import Callable
from pathlib import Path

import pytest

from tests.scenes.crowds import Person, rows


@pytest.fixture
def recording(tmp_path: Path) -> Callable[..., Path]:
    """Writes a made-up recording and gives its folder."""

    def write(people: dict[int, Person] | list[str], **beside: str) -> Path:
        folder = tmp_path / "square"
        folder.mkdir(exist_ok=True)
        lines = people if isinstance(people, list) else rows(people)
        (folder / "obsmat.txt").write_text("\n".join(lines) + "\n", encoding="utf-8")
        for name, text in beside.items():
            (folder / name.replace("_", ".")).write_text(text, encoding="utf-8")
        return folder

    return write
