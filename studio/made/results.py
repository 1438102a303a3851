"""What was made of a scene, two actions or a study: its files, and what they were made from."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from studio.style.words import counted

if TYPE_CHECKING:
    from collections.abc import Sequence

    import pyarrow as pa

    from scenes import Rollouts
    from studio.comparison.comparison import Comparison
    from studio.recording import Recording
    from studio.scene.judgements import Judgement
    from studio.study.results import StudyResults


@dataclass(frozen=True, kw_only=True, repr=False)
class Made(ABC):
    """What was made: the files, the recording first, or of a study the table first.

    In a notebook it shows a picture and a few lines.
    """

    files: tuple[Path, ...]

    @property
    @abstractmethod
    def recording(self) -> Recording:
        """What the recording says, but for rounding; `to_arrow` and `to_pandas` make it a table."""

    @property
    @abstractmethod
    def told(self) -> Sequence[str]:
        """What was made, in one line or a few."""

    def show(self, width: int | None = None, height: int = 640) -> None:
        """Show the recording in Rerun's viewer, in a notebook below the cell that calls this.

        Width and height are in px; without a width, it is as wide as the cell. It takes the
        package's extra `notebook`.

        Raises:
            InputError: if the viewer for notebooks is not installed.
        """
        from studio.made.notebook import show_inline

        first = next(file for file in self.files if file.suffix == ".rrd")
        show_inline(first, width, height)

    def __repr__(self) -> str:
        named = ", ".join(file.name for file in self.files[:4])
        more = f" and {len(self.files) - 4} more" if len(self.files) > 4 else ""
        return f"<{type(self).__name__} {'; '.join(self.told)}; {named}{more}>"

    def _repr_html_(self) -> str:
        from studio.made.notebook import page_of

        places = ", ".join(map(str, self.files[:4]))
        return page_of(self.recording, [*self.told, places])


@dataclass(frozen=True, kw_only=True, repr=False)
class Recorded(Made):
    """What came of recording a scene: its rollouts, and what each teacher thinks of its actions."""

    rollouts: Rollouts
    judgements: tuple[Judgement, ...]

    @property
    def recording(self) -> Recording:
        """The scene under all its actions."""
        from studio.scene.kind import SceneRecording

        return SceneRecording(self.rollouts, self.judgements)

    @property
    def told(self) -> Sequence[str]:
        """What was simulated, and what the teachers pick."""
        from studio.scene.words import pick_told

        rollouts = self.rollouts
        sizes = f"{counted(len(rollouts.names), 'action')} × {counted(rollouts.count, 'rollout')}"
        picks = (
            f"{each.label} picks {pick_told(each, rollouts.names)}" for each in self.judgements
        )
        return [f"{rollouts.scene.name}, seed {rollouts.seed}: {sizes}", ", ".join(picks)]


@dataclass(frozen=True, kw_only=True, repr=False)
class Compared(Made):
    """What came of comparing two actions, which are on random sides.

    The judgements are what each teacher thinks of the two, left then right.
    """

    comparison: Comparison
    judgements: tuple[Judgement, ...]

    @property
    def recording(self) -> Recording:
        """The two actions side by side."""
        from studio.comparison.kind import ComparisonRecording

        return ComparisonRecording(self.comparison, self.judgements)

    @property
    def told(self) -> Sequence[str]:
        """The question, which does not say which action is where."""
        from studio.comparison.comparison import QUESTION, SIDES

        rollouts = self.comparison.rollouts
        outcomes = f"{rollouts.count} outcomes of {' and '.join(SIDES)} in {rollouts.scene.name}"
        return [f"{QUESTION} {outcomes}"]


@dataclass(frozen=True, kw_only=True, repr=False)
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

    @property
    def recording(self) -> Recording:
        """The study."""
        from studio.study.kind import StudyRecording

        return StudyRecording(self.results)

    @property
    def told(self) -> Sequence[str]:
        """How much was studied."""
        from studio.study.words import study_subtitles

        return [study_subtitles(self.results, left_out=0)[0]]
