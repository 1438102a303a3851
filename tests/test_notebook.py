"""The notebook for first steps runs, and shows what it promises."""

from pathlib import Path
from typing import Any

import pytest

NOTEBOOK = Path(__file__).parent.parent / "docs" / "first-steps.ipynb"
VIEWER = "application/vnd.jupyter.widget-view+json"


@pytest.mark.slow
@pytest.mark.filterwarnings("default")  # of the kernel and what talks to it
def test_every_cell_runs_and_shows_something(tmp_path: Path) -> None:
    import nbformat
    from nbclient import NotebookClient

    notebook = nbformat.read(NOTEBOOK, as_version=4)
    NotebookClient(notebook, timeout=600, resources={"metadata": {"path": str(tmp_path)}}).execute()
    shown: dict[str, list[dict[str, Any]]] = {}
    for cell in notebook.cells:
        if cell.cell_type == "code":
            assert cell.outputs, cell.source
            last = cell.source.splitlines()[-1]
            shown[last] = [output.get("data", {}) for output in cell.outputs]
    for thing in ("scene", "recorded", "compared", "learned"):
        [data] = [data for data in shown[thing] if "text/html" in data]
        assert data["text/html"].startswith('<img src="data:image/png;base64,')
        assert len(data["text/plain"]) < 500
    assert any(VIEWER in data for data in shown["recorded.show()"])
    assert (
        "stop"
        in shown[next(last for last in shown if last.startswith("by_action"))][0]["text/html"]
    )


def test_it_is_kept_without_what_it_shows() -> None:
    assert '"outputs": []' in NOTEBOOK.read_text(encoding="utf-8")
    assert "image/png" not in NOTEBOOK.read_text(encoding="utf-8")
