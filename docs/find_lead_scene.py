"""Find the scene that README and gallery lead with: `python docs/find_lead_scene.py`.

The scene must be one in which the three teachers pick at least two different actions, and in which
all of that is sure: another fifty rollouts lead to the same pick in at least 95 % of draws, and so
do two thousand. Scenes are looked at in the order of their numbers; the first that qualify are
printed with how sure each pick is.
"""

from collections.abc import Iterator

import click

from scenes import FAMILIES, META_ACTIONS, Scene, simulate
from studio.scene.judgements import Judgement, judge, utilities
from studio.scene.reference import reference_utilities
from studio.scene.sources import numbered_scene
from studio.scene.words import pick_with_shares

NUMBERS = 3000  # of each family and pattern, from 0 on
FEW, MANY = 50, 2000  # rollouts of each action
FIRST_LOOK = 200  # rollouts that rule out most scenes at little cost
PROMISING = 0.85  # share of draws that must lead to each pick at first look


def qualifying_scenes() -> Iterator[tuple[Scene, tuple[Judgement, ...]]]:
    """The scenes to lead with, each with its judgements from few rollouts."""
    for number in range(NUMBERS):
        for name, family in FAMILIES.items():
            for pattern in family.patterns:
                scene = numbered_scene(name, pattern, 0, number)
                judgements = sure_judgements(scene)
                if judgements:
                    yield scene, judgements


def sure_judgements(scene: Scene) -> tuple[Judgement, ...] | None:
    """What the teachers think of the actions, if they differ and all of their picks are sure."""
    few = simulate(scene, rollouts=FEW)
    if len({each.best for each in judge(few)}) < 2:
        return None
    first_look = judge(few, reference=utilities(simulate(scene, rollouts=FIRST_LOOK)))
    if not differ(first_look) or min(each.shares.max() for each in first_look) < PROMISING:
        return None
    judgements = judge(few, reference=reference_utilities(few))
    many = judge(simulate(scene, rollouts=MANY))
    are_sure = all(each.is_sure for each in (*judgements, *many))
    are_same = all(
        one.candidates == two.candidates for one, two in zip(judgements, many, strict=True)
    )
    return judgements if are_sure and are_same and differ(judgements) else None


def differ(judgements: tuple[Judgement, ...]) -> bool:
    """Whether not all teachers pick the same; these very rollouts must lead each to its pick."""
    picks = [each.candidates[0] for each in judgements]
    return len(set(picks)) > 1 and picks == [each.best for each in judgements]


if __name__ == "__main__":
    names = [action.name for action in META_ACTIONS]
    for scene, judgements in qualifying_scenes():
        told = [f"{each.label}: {pick_with_shares(each, names)}" for each in judgements]
        click.echo(f"{scene.family} {scene.pattern} {scene.number}  {', '.join(told)}")
