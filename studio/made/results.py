"""What was made of a scene, two actions or a study: its files, and what they were made from."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import pyarrow as pa

    from scenes import Rollouts
    from studio.comparison.comparison import Comparison
    from studio.scene.judgements import Judgement
    from studio.study.results import StudyResults


@dataclass(frozen=True, kw_only=True)
class Made:
    """What was made: the files, the recording first, or of a study the table first."""

    files: tuple[Path, ...]


@dataclass(frozen=True, kw_only=True)
class Recorded(Made):
    """What came of recording a scene: its rollouts, and what each teacher thinks of its actions."""

    rollouts: Rollouts
    judgements: tuple[Judgement, ...]


@dataclass(frozen=True, kw_only=True)
class Compared(Made):
    """What came of comparing two actions, which are on random sides.

    The judgements are what each teacher thinks of the two, left then right.
    """

    comparison: Comparison
    judgements: tuple[Judgement, ...]


@dataclass(frozen=True, kw_only=True)
class Learned(Made):
    """What came of a study; recordings of single scenes come last among its files.

    The caption is one for the figure, in one line; it is empty without a figure.
    """

    results: StudyResults
    caption: str = ""

    @property
    def table(self) -> pa.Table:
        """One row a fit, see `learners.STUDY_SCHEMA`."""
        return self.results.table
