"""Output is written as a whole or not at all."""

from pathlib import Path

import pytest

from studio.errors import InputError, RunError
from studio.files import replacing


def test_replacing_is_all_or_nothing(tmp_path: Path) -> None:
    final = tmp_path / "a.txt"
    with replacing(final) as [part]:
        part.write_text("new")
        assert not final.exists()
        assert part.parent == final.parent
    assert final.read_text() == "new"
    with pytest.raises(ZeroDivisionError), replacing(final, tmp_path / "b.txt") as parts:
        parts[0].write_text("half" + str(parts[1].write_text("half") / 0))
    assert final.read_text() == "new"
    assert list(tmp_path.iterdir()) == [final]


def test_folders_are_made_and_go_again_if_nothing_comes_of_it(tmp_path: Path) -> None:
    final = tmp_path / "new" / "deep" / "a.txt"
    with pytest.raises(ZeroDivisionError), replacing(final) as [part]:
        part.write_text(str(1 / 0))
    assert not list(tmp_path.iterdir())
    with replacing(final) as [part]:
        part.write_text("done")
    assert final.read_text() == "done"


def test_what_cannot_be_written_is_known_before_the_work_begins(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    (tmp_path / "folder").mkdir()
    for path in (tmp_path / "file" / "a.txt", tmp_path / "folder"):
        with pytest.raises(InputError, match=r"--out: .*(cannot be written|is a folder)"):  # noqa: SIM117
            with replacing(tmp_path / "other.txt", path):
                pytest.fail("the work began")
    assert not (tmp_path / "other.txt").exists()


def test_a_full_disk_is_named_with_the_final_name(tmp_path: Path) -> None:
    final = tmp_path / "a.txt"
    with pytest.raises(RunError, match=r"a\.txt: cannot be written: No space left"):  # noqa: SIM117
        with replacing(final) as [part]:
            raise OSError(28, "No space left on device", str(part))
    assert not list(tmp_path.iterdir())
