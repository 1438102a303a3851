"""Read two actions side by side back from their recording."""

from dataclasses import replace

from studio.comparison.comparison import SIDES, Comparison
from studio.comparison.recording import entities
from studio.recorder.contents import Contents
from studio.scene.judgements import Judgement
from studio.scene.recording.read import read_scene


def read_comparison(contents: Contents) -> tuple[Comparison, tuple[Judgement, ...]]:
    """Read back from a recording two actions side by side, and what each teacher thinks of them.

    Positions and headings are rounded. Before edition 3 all recordings told the names of actions.

    Raises:
        InputError: if something is missing, or contradicts itself.
        ValueError: if something is not as the studio writes it, see `read_scene`.
    """
    rollouts, judgements = read_scene(contents)
    actions = tuple(contents.static(entities.COMPARED, "actions").tolist())
    sides = tuple(contents.text(entities.COMPARED, side) for side in ("left", "right"))
    tells = contents.has(entities.COMPARED, "named")
    named = bool(contents.static(entities.COMPARED, "named")[0]) if tells else True
    if rollouts.names != (sides if named else SIDES) or set(sides) - {*actions}:
        raise contents.damaged(f"it compares {sides[0]!r} with {sides[1]!r}")
    true = zip(rollouts.actions, sides, strict=True)
    rollouts = replace(rollouts, actions=tuple(replace(each, name=name) for each, name in true))
    seed = int(contents.static(entities.COMPARED, "seed")[0])
    return Comparison(rollouts, actions, seed, named), judgements
