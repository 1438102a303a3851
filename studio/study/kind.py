"""The recording of a study: what learners made of teachers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from studio.errors import InputError
from studio.recording import Recording

if TYPE_CHECKING:
    import pyarrow as pa

    from studio.painter.canvas import Canvas
    from studio.painter.segments import Segment
    from studio.recorder.contents import Contents
    from studio.recording import Excerpt, Look, Size
    from studio.study.results import StudyResults

SPAN = "pairs of a study"


@dataclass(frozen=True)
class StudyRecording(Recording):
    """What came of a study, as recorded."""

    results: StudyResults

    still_is_cut = True
    pages = 2

    @property
    def size(self) -> Size:
        """Size of the still picture unless one asks for another, px."""
        from studio.study.picture.finding import SIZE

        return SIZE

    def still(self, look: Look, excerpt: Excerpt) -> Canvas:
        """Draw the finding of the excerpt, counted in pairs, or as page 2 what was learned."""
        from studio.study.picture.finding import compose_finding
        from studio.study.picture.page import compose_study_picture

        compose = compose_finding if excerpt.page == 1 else compose_study_picture
        return compose(self.between(excerpt), look.size or self.size, look.colours)

    def moving(self, size: Size, look: Look, excerpt: Excerpt) -> list[Segment]:
        """The film of the excerpt, which is counted in pairs."""
        from studio.study.picture.film import compose_study_film

        shown, rate = self.between(excerpt), look.frames_per_second
        return compose_study_film(shown, size, rate, look.colours)

    def to_arrow(self) -> pa.Table:
        """One row a fit, see `learners.STUDY_SCHEMA`."""
        return self.results.table

    def between(self, excerpt: Excerpt) -> StudyResults:
        """The results as if the study had been of the excerpt's numbers of pairs alone.

        Raises:
            InputError: if the study has no number of pairs there, or actions are asked for.
        """
        excerpt.refuse_actions("a study")
        sizes = self.results.sizes
        if not sizes:
            return self.results
        low, high = excerpt.span(sizes[0], sizes[-1])
        shown = self.results.between(low, high)
        if not shown.sizes:
            raise InputError(
                f"--from, --to: {low:g} to {high:g} pairs are not allowed: "
                f"some of {', '.join(map(str, sizes))}"
            )
        return shown


def read(contents: Contents) -> StudyRecording:
    """Read the recording of a study, see `studio.kinds.Kind`."""
    from studio.study.recording import entities
    from studio.study.recording.read import read_study
    from studio.study.recording.write import SCHEMA_VERSION

    contents.check_edition(entities.STUDY, SCHEMA_VERSION)
    return StudyRecording(read_study(contents))
