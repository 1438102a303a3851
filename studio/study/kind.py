"""The recording of a study: what learners made of teachers."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from studio.errors import InputError

if TYPE_CHECKING:
    import pyarrow as pa

    from learners import Teacher
    from studio.painter.canvas import Canvas
    from studio.painter.segments import Segment
    from studio.recorder.contents import Contents
    from studio.recording import Excerpt, Look, Size

SPAN = "pairs of a study"


@dataclass(frozen=True)
class StudyRecording:
    """What came of a study, as recorded.

    Attributes:
        table: one row a fit, see `learners.STUDY_SCHEMA`.
        teachers: who was learned from.
    """

    table: pa.Table
    teachers: tuple[Teacher, ...]

    still_is_cut = True

    @property
    def size(self) -> Size:
        """Size of the still picture unless one asks for another, px."""
        from studio.study.picture.page import SIZE

        return SIZE

    def still(self, look: Look, excerpt: Excerpt) -> Canvas:
        """Draw the still picture of the excerpt, which is counted in pairs."""
        from studio.study.picture.page import compose_study_picture

        shown = self.between(excerpt)
        size = look.size or self.size
        return compose_study_picture(shown.table, shown.teachers, size, look.colours)

    def moving(self, size: Size, look: Look, excerpt: Excerpt) -> list[Segment]:
        """The film of the excerpt, which is counted in pairs."""
        from studio.study.picture.film import compose_study_film

        shown, rate = self.between(excerpt), look.frames_per_second
        return compose_study_film(shown.table, shown.teachers, size, rate, look.colours)

    def between(self, excerpt: Excerpt) -> StudyRecording:
        """The recording as if the study had been of the excerpt's numbers of pairs alone.

        Raises:
            InputError: if the study has no number of pairs there, or actions are asked for.
        """
        import pyarrow.compute as pc

        excerpt.refuse_actions("a study")
        pairs = self.table["pairs"]
        if not len(pairs):
            return self
        low, high = excerpt.span(pc.min(pairs).as_py(), pc.max(pairs).as_py())
        wanted = pc.and_(pc.greater_equal(pairs, low), pc.less_equal(pairs, high))
        table = self.table.filter(wanted)
        if not table.num_rows:
            sizes = ", ".join(map(str, sorted(set(pairs.to_pylist()))))
            raise InputError(
                f"--from, --to: {low:g} to {high:g} pairs are not allowed: some of {sizes}"
            )
        return replace(self, table=table)


def read(contents: Contents) -> StudyRecording:
    """Read the recording of a study, see `studio.kinds.Kind`."""
    from studio.study.recording import entities
    from studio.study.recording.read import read_study
    from studio.study.recording.write import SCHEMA_VERSION

    contents.check_edition(entities.STUDY, SCHEMA_VERSION)
    return StudyRecording(*read_study(contents))
