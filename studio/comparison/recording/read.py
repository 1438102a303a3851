"""Read two actions side by side back from their recording."""

from dataclasses import dataclass

from studio.comparison.comparison import Comparison
from studio.recorder.contents import Contents
from studio.scene.judgements import Judgement
from studio.scene.recording import entities
from studio.scene.recording.read import read_scene


@dataclass(frozen=True)
class ComparisonRecording:
    """Two actions side by side, as recorded.

    Attributes:
        comparison: of the two actions; positions and headings are rounded as the recording is.
        judgements: what each teacher thinks of these two, left then right.
    """

    comparison: Comparison
    judgements: tuple[Judgement, ...]


def read_comparison(contents: Contents) -> ComparisonRecording:
    """Read a comparison back from its recording.

    Raises:
        InputError: if something is missing, or contradicts itself.
        ValueError: if something is not as the studio writes it, see `read_scene`.
    """
    scene = read_scene(contents)
    actions = tuple(contents.static(entities.COMPARED, "actions").tolist())
    sides = tuple(contents.text(entities.COMPARED, side) for side in ("left", "right"))
    if sides != scene.rollouts.names or set(sides) - {*actions}:
        raise contents.damaged(f"it compares {sides[0]!r} with {sides[1]!r}")
    seed = int(contents.static(entities.COMPARED, "seed")[0])
    return ComparisonRecording(Comparison(scene.rollouts, actions, seed), scene.judgements)
