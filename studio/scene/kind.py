"""The recording of a scene: what came of every action of it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from studio.recording import Recording

if TYPE_CHECKING:
    import pyarrow as pa

    from scenes import Rollouts
    from studio.painter.canvas import Canvas
    from studio.painter.segments import Segment
    from studio.recorder.contents import Contents
    from studio.recording import Excerpt, Look, Size
    from studio.scene.judgements import Judgement

SPAN = "s of a scene"


@dataclass(frozen=True)
class SceneRecording(Recording):
    """A scene under all its actions, as recorded."""

    rollouts: Rollouts  # positions and headings are rounded as the recording is
    judgements: tuple[Judgement, ...]  # what each teacher thinks of the actions

    still_is_cut = False

    @property
    def size(self) -> Size:
        """Size of the still picture unless one asks for another, px."""
        from studio.scene.picture.page import SIZE

        return SIZE

    def still(self, look: Look, excerpt: Excerpt) -> Canvas:
        """Draw the still picture, see `studio.recording.Recording`."""
        from studio.scene.picture.page import compose_picture

        shown, theme = self.only(excerpt.actions), look.colours.of(self.rollouts.names)
        return compose_picture(shown.rollouts, shown.judgements, look.size or self.size, theme)

    def moving(self, size: Size, look: Look, excerpt: Excerpt) -> list[Segment]:
        """The film, whose excerpt is counted in s of simulated time."""
        from studio.scene.picture.film import compose_film

        shown, theme = self.only(excerpt.actions), look.colours.of(self.rollouts.names)
        span = excerpt.span(0.0, self.rollouts.horizon)
        rate = look.frames_per_second
        return compose_film(shown.rollouts, shown.judgements, size, rate, theme, span)

    def to_arrow(self) -> pa.Table:
        """One row an outcome, see `studio.scene.table.outcomes_as_table`."""
        from studio.scene.table import outcomes_as_table

        return outcomes_as_table(self.rollouts)

    def only(self, names: tuple[str, ...]) -> SceneRecording:
        """The recording as if these were all of its actions; the whole one without names."""
        from studio.scene.selection import only, places_of

        if not names:
            return self
        places = places_of(names, self.rollouts.names)
        judgements = tuple(judgement.of(places) for judgement in self.judgements)
        return SceneRecording(only(self.rollouts, names), judgements)


def read(contents: Contents) -> SceneRecording:
    """Read the recording of a scene, see `studio.kinds.Kind`."""
    from studio.scene.recording import entities
    from studio.scene.recording.read import read_scene
    from studio.scene.recording.write import SCHEMA_VERSION

    contents.check_edition(entities.SIMULATION, SCHEMA_VERSION)
    return SceneRecording(*read_scene(contents))
