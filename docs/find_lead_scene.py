"""Find the scene that README and gallery lead with: `python docs/find_lead_scene.py`.

It must be a scene in which the three teachers pick at least two different actions, and in which all
of that is sure: another fifty rollouts lead to the same pick in at least 95 % of draws, and two
thousand rollouts lead to it, too. Among thousands of generated scenes there was none: a risk that
some people take is rare enough to be missing from some samples of fifty. It takes a risk that costs
much when it comes. Here the robot drives between two groups who stand and wait, and where it drifts
aside it touches several people at once. The search tries how many wait, how far apart, and how wide
the way between them is, and writes `lead_scene.toml` beside itself.
"""

from collections.abc import Iterator
from itertools import product
from pathlib import Path

import click
import numpy as np

from scenes import META_ACTIONS, Pedestrian, Robot, Scene, scene_to_toml, simulate
from studio.scene.judgements import Judgement, judge, utilities
from studio.scene.reference import reference_utilities
from studio.scene.words import pick_with_shares

WAITING = (2, 3, 4)  # people in each of the two groups
SPACES = (0.5, 0.6, 0.7)  # from one of them to the next, m
FIRST = (2.2, 2.5, 2.8)  # from the robot's start to the first of them, along its way, m
ASIDE = (0.95, 1.0, 1.05, 1.1, 1.15, 1.2)  # from the middle of the way to them, m
FEW, MANY = 50, 2000  # rollouts of each action
FIRST_LOOK = 300  # rollouts by which scenes are ranked
LEAD = Path(__file__).with_name("lead_scene.toml")


def scenes() -> Iterator[Scene]:
    """The scenes to try: a robot that passes between two groups."""
    for waiting, space, first, aside in product(WAITING, SPACES, FIRST, ASIDE):
        along = [round(first + space * place, 2) for place in range(waiting)]
        people = [
            Pedestrian(start=(x, y), goal=(x, y), desired_speed=0.0)
            for y in (aside, -aside)
            for x in along
        ]
        left, right = tuple(range(waiting)), tuple(range(waiting, 2 * waiting))
        robot = Robot(start=(0.0, 0.0), goal=(6.0, 0.0))
        yield Scene("between_two_groups", robot, tuple(people), groups=(left, right))


def surest() -> tuple[Scene, tuple[Judgement, ...]] | None:
    """The scene whose picks are surest, and its judgements by few rollouts; None if none is sure.

    Ranked by little, the scenes are tried in turn until one holds by a thousand rollouts and by two
    thousand.
    """
    ranked = sorted(((score(scene), place, scene) for place, scene in enumerate(scenes())))
    for _, _, scene in reversed(ranked):
        few = simulate(scene, rollouts=FEW)
        judgements = judge(few, reference=reference_utilities(few))
        many = judge(simulate(scene, rollouts=MANY))
        are_sure = all(each.is_sure for each in (*judgements, *many))
        are_same = all(
            one.candidates == two.candidates for one, two in zip(judgements, many, strict=True)
        )
        if are_sure and are_same and differ(judgements):
            return scene, judgements
    return None


def score(scene: Scene) -> float:
    """The share of draws that lead to the least sure of the three picks; 0 if all are the same."""
    few, pool = simulate(scene, rollouts=FEW), simulate(scene, rollouts=FIRST_LOOK)
    judgements = judge(few, reference=utilities(pool))
    return min(float(np.max(each.shares)) for each in judgements) if differ(judgements) else 0.0


def differ(judgements: tuple[Judgement, ...]) -> bool:
    """Whether not all teachers pick the same; these very rollouts must lead each to its pick."""
    picks = [each.candidates[0] for each in judgements]
    return len(set(picks)) > 1 and picks == [each.best for each in judgements]


if __name__ == "__main__":
    found = surest()
    if found is None:
        raise SystemExit("no scene found")
    scene, judgements = found
    names = [action.name for action in META_ACTIONS]
    for judgement in judgements:
        click.echo(f"{judgement.label}: {pick_with_shares(judgement, names)}")
    LEAD.write_text(scene_to_toml(scene), encoding="utf-8")
