"""What the study claims, on a bank like that of the paper. Run by name: pytest -m slow."""

import pytest

from learners import (
    read_bank,
)

pytestmark = pytest.mark.slow

SEEDS = 20
SCENES = 300


@pytest.fixture(scope="module")
def bank(tmp_path_factory):
    studio = pytest.importorskip("studio.orchestrator")
    path = tmp_path_factory.mktemp("claims") / "outcomes.parquet"
    studio.Studio(path.parent).sample(path, scenes=SCENES)
    return read_bank(path)
