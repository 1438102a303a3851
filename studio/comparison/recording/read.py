"""Read two actions side by side back from their recording."""

from studio.comparison.comparison import Comparison
from studio.comparison.recording import entities
from studio.recorder.contents import Contents
from studio.scene.judgements import Judgement
from studio.scene.recording.read import read_scene


def read_comparison(contents: Contents) -> tuple[Comparison, tuple[Judgement, ...]]:
    """Read back from a recording two actions side by side, and what each teacher thinks of them.

    Positions and headings are rounded as the recording is.

    Raises:
        InputError: if something is missing, or contradicts itself.
        ValueError: if something is not as the studio writes it, see `read_scene`.
    """
    rollouts, judgements = read_scene(contents)
    actions = tuple(contents.static(entities.COMPARED, "actions").tolist())
    sides = tuple(contents.text(entities.COMPARED, side) for side in ("left", "right"))
    if sides != rollouts.names or set(sides) - {*actions}:
        raise contents.damaged(f"it compares {sides[0]!r} with {sides[1]!r}")
    seed = int(contents.static(entities.COMPARED, "seed")[0])
    return Comparison(rollouts, actions, seed), judgements
