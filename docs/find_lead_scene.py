"""Find the scene that README and gallery lead with: `python docs/find_lead_scene.py`.

It must be a scene in which the three teachers pick at least two different actions, and in which all
of that is sure: another fifty rollouts lead to the same pick in at least 95 % of draws, and two
thousand rollouts lead to it, too. Among generated scenes that is rarer than one in ten thousand.
The search therefore begins with the generated scene that comes nearest, and moves one person after
the other a little, as long as picks get surer. It writes `lead_scene.toml` beside itself.
"""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import click
import numpy as np

from scenes import FAMILIES, META_ACTIONS, Scene, scene_to_toml, simulate
from studio.scene.judgements import Judgement, judge, utilities
from studio.scene.sources import numbered_scene
from studio.scene.words import pick_with_shares

NUMBERS = 12  # of each family and pattern, from 0 on
FEW, MANY = 50, 2000  # rollouts of each action
POOL = 400  # rollouts that a scene is scored by
SURE = 0.975  # share of draws that must lead to each pick; more than 95 %, since POOL is small
STEPS = (0.1, 0.3, 1.0)  # by how much a person is moved, standard deviations, m
MOST_STEPS = 1500
LEAD = Path(__file__).with_name("lead_scene.toml")


def find() -> tuple[Scene, tuple[Judgement, ...]] | None:
    """The scene to lead with, and how it is judged by few rollouts; None if the search fails."""
    scored = [(score(scene), scene) for scene in generated_scenes()]
    ranked = sorted(scored, key=lambda each: -each[0])
    for start, scene in ranked[:5]:
        click.echo(f"{scene.family} {scene.pattern} {scene.number}: {start:.3f}")
        found = climb(scene, start)
        if found is not None:
            return found
    return None


def generated_scenes() -> Iterator[Scene]:
    """The first scenes of every family and pattern."""
    for number in range(NUMBERS):
        for name, family in FAMILIES.items():
            yield from (numbered_scene(name, pattern, 0, number) for pattern in family.patterns)


def climb(scene: Scene, best: float) -> tuple[Scene, tuple[Judgement, ...]] | None:
    """Move people of a scene a little as long as picks get surer, until they are sure."""
    rng = np.random.default_rng(scene.number)
    for step in range(MOST_STEPS):
        if best >= SURE:
            judgements = sure_judgements(scene)
            if judgements is not None:
                return scene, judgements
        try:
            moved = with_one_moved(scene, rng)
            rated = score(moved)
        except ValueError:  # somebody would stand in a wall
            continue
        if rated > best:
            click.echo(f"  {step}: {rated:.3f}")
            scene, best = moved, rated
    return None


def with_one_moved(scene: Scene, rng: np.random.Generator) -> Scene:
    """The scene with one person's start and goal moved by the same random way."""
    people = [*scene.pedestrians]
    index = int(rng.integers(len(people)))
    x, y = np.round(rng.choice(STEPS) * rng.standard_normal(2), 2).tolist()
    person = people[index]
    (start_x, start_y), (goal_x, goal_y) = person.start, person.goal
    people[index] = replace(person, start=(start_x + x, start_y + y), goal=(goal_x + x, goal_y + y))
    return replace(scene, pedestrians=tuple(people))


def score(scene: Scene) -> float:
    """The share of draws that lead to the least sure of the three picks; 0 if all are the same."""
    few = simulate(scene, rollouts=FEW)
    if len({each.best for each in judge(few)}) < 2:
        return 0.0
    judgements = judge(few, reference=utilities(simulate(scene, rollouts=POOL)))
    return min(float(each.shares.max()) for each in judgements) if differ(judgements) else 0.0


def sure_judgements(scene: Scene) -> tuple[Judgement, ...] | None:
    """What the teachers think by few rollouts, if that is sure and many say the same."""
    few, many = simulate(scene, rollouts=FEW), simulate(scene, rollouts=MANY)
    first = utilities(many)[:, :1000]
    judgements, held_against = judge(few, reference=first), judge(many)
    are_sure = all(each.is_sure for each in (*judgements, *held_against))
    are_same = all(
        one.candidates == two.candidates for one, two in zip(judgements, held_against, strict=True)
    )
    return judgements if are_sure and are_same and differ(judgements) else None


def differ(judgements: tuple[Judgement, ...]) -> bool:
    """Whether not all teachers pick the same; these very rollouts must lead each to its pick."""
    picks = [each.candidates[0] for each in judgements]
    return len(set(picks)) > 1 and picks == [each.best for each in judgements]


if __name__ == "__main__":
    found = find()
    if found is None:
        raise SystemExit("no scene found")
    scene, judgements = found
    names = [action.name for action in META_ACTIONS]
    for judgement in judgements:
        click.echo(f"{judgement.label}: {pick_with_shares(judgement, names)}")
    LEAD.write_text(scene_to_toml(replace(scene, name="lead_scene")), encoding="utf-8")
