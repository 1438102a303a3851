"""The recording of a comparison: two actions of a scene side by side."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from studio.recording import Recording

if TYPE_CHECKING:
    import pyarrow as pa

    from studio.comparison.comparison import Comparison
    from studio.painter.canvas import Canvas
    from studio.painter.segments import Segment
    from studio.recorder.contents import Contents
    from studio.recording import Excerpt, Look, Size
    from studio.scene.judgements import Judgement

SPAN = "outcomes of a comparison"


@dataclass(frozen=True)
class ComparisonRecording(Recording):
    """Two actions side by side, as recorded."""

    comparison: Comparison  # positions and headings are rounded as the recording is
    judgements: tuple[Judgement, ...]  # what each teacher thinks of these two, left then right

    still_is_cut = False

    @property
    def size(self) -> Size:
        """Size of the still picture unless one asks for another, px."""
        from studio.comparison.picture.page import SIZE

        return SIZE

    def still(self, look: Look, excerpt: Excerpt) -> Canvas:
        """Draw the still picture, see `studio.recording.Recording`."""
        from studio.comparison.picture.page import compose_comparison_picture

        excerpt.refuse_actions("a comparison")
        return compose_comparison_picture(self.comparison, look.size or self.size, look.colours)

    def moving(self, size: Size, look: Look, excerpt: Excerpt) -> list[Segment]:
        """The film, whose excerpt is counted in outcomes, the first being 1."""
        from studio.comparison.picture.film import compose_comparison_film

        excerpt.refuse_actions("a comparison")
        from studio.comparison.picture.page import MOST_PLAYED

        span = excerpt.span(1, min(self.comparison.rollouts.paths, MOST_PLAYED))
        rate = look.frames_per_second
        return compose_comparison_film(self.comparison, size, rate, look.colours, span)

    def to_arrow(self) -> pa.Table:
        """One row an outcome, and on which `side` it is: A or B, then as of a scene."""
        import pyarrow as pa

        from studio.comparison.comparison import SIDES
        from studio.scene.table import outcomes_as_table

        rollouts = self.comparison.rollouts
        sides = pa.array([side for side in SIDES for _ in range(rollouts.count)])
        return outcomes_as_table(rollouts).add_column(0, "side", sides)


def read(contents: Contents) -> ComparisonRecording:
    """Read the recording of a comparison, see `studio.kinds.Kind`."""
    from studio.comparison.recording.read import read_comparison
    from studio.scene.recording import entities
    from studio.scene.recording.write import SCHEMA_VERSION

    contents.check_edition(entities.SIMULATION, SCHEMA_VERSION)
    return ComparisonRecording(*read_comparison(contents))
