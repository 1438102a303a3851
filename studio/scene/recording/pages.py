"""The pages of a recording, in Markdown: what one sees, and how to make it again."""

import math
from collections.abc import Mapping
from dataclasses import asdict
from itertools import combinations

import numpy as np

from learners import REWARD, CptParameters
from scenes import FEATURES, Rollouts
from studio.recorder.markdown import link, plain, table
from studio.scene.again import how_to_make_again, record_command
from studio.scene.judgements import Judgement
from studio.scene.recording import entities
from studio.style.words import counted, number, short_label

WAYS_OF_JUDGING = {
    "eu": "goes by the mean utility",
    "tk": "by cumulative prospect theory with the parameters that Tversky and Kahneman measured",
    "strong": "by more extreme ones",
}
"""How the usual teachers judge: halves of sentences, of which each goes on from the one before."""


def scene_summary(rollouts: Rollouts, judgements: tuple[Judgement, ...]) -> str:
    """What to look at first: the actions in a table, and which one each teacher picks."""
    picks = [f"**{each.label}** picks {action_link(rollouts, each.best)}" for each in judgements]
    return "\n".join(
        [
            f"# {rollouts.scene.name}",
            "",
            f"The robot meets {_people(rollouts)} and must choose. Each action was simulated "
            f"{counted(rollouts.count, 'time')}. Balls are the robot (with an arrowhead) and the "
            "people (grey) in the first of these rollouts, in true size; dots are those in the "
            "others. People react to the robot, so every action has its own. A robot is red once "
            "it has touched somebody or a wall; a cross marks where.",
            "",
            *outcome_table(rollouts, judgements),
            "",
            f"{'; '.join(picks)}.{_disagreement(rollouts, judgements)}",
            "",
            _ways_of_judging(judgements),
            "",
            "Gap to the nearest person: median over rollouts of the smallest; progress towards the "
            "goal: mean.",
        ]
    )


def disagreements_page(rollouts: Rollouts, judgements: tuple[Judgement, ...]) -> str:
    """Which pairs of actions two teachers order differently, and what that costs."""
    pairs_in_all = math.comb(len(rollouts.actions), 2)
    if len(judgements) < 2 or not pairs_in_all:
        return "It takes two teachers and two actions to disagree."
    counts, details = [], []
    for one, other in combinations(judgements, 2):
        pairs = one.discordant_pairs(other)
        loss = number(other.values[other.best] - other.values[one.best], ".3f")
        counts.append((f"{one.label}, {other.label}", str(len(pairs)), loss))
        if pairs:
            preferred = [[action_link(rollouts, action) for action in pair] for pair in pairs]
            heads = [f"{each.label} prefers" for each in (one, other)]
            details += ["", *table(heads, "ll", preferred)]
    return "\n".join(
        [
            f"How many pairs of actions, of {pairs_in_all}, two teachers order differently, and "
            "how much value the second one loses by doing what the first one picks.",
            "",
            *table(("teachers", "pairs", "loss"), "lrr", counts),
            *details,
        ]
    )


def scene_page(
    rollouts: Rollouts, judgements: tuple[Judgement, ...], versions: Mapping[str, str]
) -> str:
    """Everything there is to know about the recording of a scene."""
    scene = rollouts.scene
    return "\n".join(
        [
            f"# {scene.name}",
            "",
            f"A robot and {_people(rollouts)}, `{scene.family}`, `{scene.pattern}`. Under each "
            f"action the scene was simulated {counted(rollouts.count, 'time')} for "
            f"{rollouts.horizon:g} s, always with the same luck: actions differ in nothing but the "
            "action.",
            "",
            "## What one sees",
            "",
            *_what_one_sees(),
            "",
            "Press space to stop and go on; double-click a view to set it back.",
            "",
            "## Actions",
            "",
            *table(
                ("action", "speed v, m/s", "turn rate ω, rad/s"),
                "lrr",
                [
                    (action_link(rollouts, index), number(action.speed), number(action.turn_rate))
                    for index, action in enumerate(rollouts.actions)
                ],
            ),
            "",
            "## Outcomes",
            "",
            *outcome_table(rollouts, judgements),
            "",
            "## Teachers",
            "",
            "An outcome with features φ has utility x = θ·φ. A teacher values it at x^α as a gain "
            "and −λ(−x)^η as a loss, and counts probabilities p as exp(−(−ln p)^γ) for gains, "
            "with δ for losses. All ones is expected utility (EU).",
            "",
            *table(
                ("teacher", *CptParameters.SYMBOLS),
                "lrrrrr",
                [(each.label, *(f"{n:g}" for n in each.parameters.numbers)) for each in judgements],
            ),
            "",
            *table(("feature φ", "worth θ"), "lr", zip(FEATURES, map(number, REWARD), strict=True)),
            "",
            *how_to_make_again(rollouts, record_command(rollouts), _settings(rollouts, versions)),
        ]
    )


def _what_one_sees() -> list[str]:
    return [
        f"* {link('The world', entities.WORLD)} from above, on a grid of metres; the robot starts "
        "at the ring with the nose and is headed for the target.",
        "* A coloured ball is the robot in the first rollout, and its arrowhead shows where it "
        "faces; a grey ball is a person in that rollout, and bars join people who walk in a group. "
        "Both are in true size. Dots are the robot and the people in the other rollouts.",
        "* A robot turns red at the step at which it first touches a person or a wall; a red cross "
        "marks where. Faint lines are the paths that robots take, a bold one is that of the first "
        "rollout.",
        "* Histograms count the outcomes by feature, in bins that all actions share, those with "
        "contact in red; the number at the upper left is the height of the tallest bar.",
        "* The gap over time is that between the robot and the nearest person: the median, and a "
        "band from the 10 % to the 90 % quantile.",
        f"* Prospects: {link('all outcomes', entities.ACTION_TABLE)}, every feature on one scale; "
        f"and {link('what they are worth', entities.PROSPECTS)}: their utilities from the worst to "
        "the best, the decision weight of each in multiples of its probability, and, as marks, the "
        "certainty equivalents: the sure utilities that the teachers value as much as the action.",
        f"* Minds: how much a probability {link('of a gain', entities.GAIN_WEIGHTS)} and "
        f"{link('of a loss', entities.LOSS_WEIGHTS)} counts, what that "
        f"{link('makes of fifty equally likely outcomes', entities.DECISION_WEIGHTS)}, the worse "
        f"half losses and the better half gains, how good a gain {link('feels', entities.VALUES)} "
        f"and how bad a loss, and how the teachers therefore "
        f"{link('rank the actions', entities.RANKS)}.",
    ]


def _settings(rollouts: Rollouts, versions: Mapping[str, str]) -> list[str]:
    """The settings of a simulation, in a table."""
    settings = {
        "seed": rollouts.seed,
        "rollouts": rollouts.count,
        "steps": f"{rollouts.steps} of {rollouts.dt:g} s",
        "model": rollouts.model,
        "engine": rollouts.engine,
        "wrap_angles": rollouts.wrap_angles,
        **{f"noise: {name}": given for name, given in asdict(rollouts.noise).items()},
        **{f"limits: {name}": given for name, given in asdict(rollouts.limits).items()},
        **{f"version: {name}": given for name, given in versions.items()},
    }
    return table(("setting", "value"), "ll", [(name, str(n)) for name, n in settings.items()])


def outcome_table(rollouts: Rollouts, judgements: tuple[Judgement, ...]) -> list[str]:
    """One row an action: contacts, gap, progress, and its value to every teacher."""
    contacts = rollouts.touched.sum(axis=1)
    gap = np.median(rollouts.clearance_m, axis=1)
    progress = rollouts.progress_m.mean(axis=1)
    rows = []
    for index in range(len(rollouts.actions)):
        worths = [(number(each.values[index], ".3f"), index == each.best) for each in judgements]
        rows.append(
            (
                action_link(rollouts, index),
                f"{contacts[index]} / {rollouts.count}",
                f"{gap[index]:.2f}",
                f"{progress[index]:.2f}",
                *(f"**{worth}** ★" if is_picked else worth for worth, is_picked in worths),
            )
        )
    heads = ["action", "contact", "gap, m", "progress, m", *(each.label for each in judgements)]
    return table(heads, "lrrr" + "r" * len(judgements), rows)


def action_link(rollouts: Rollouts, index: int) -> str:
    """A link to the world under an action."""
    name = rollouts.names[index]
    return link(plain(short_label(name)), entities.action(name))


def _disagreement(rollouts: Rollouts, judgements: tuple[Judgement, ...]) -> str:
    """How many pairs of actions the two teachers who agree least order differently, in words."""
    couples = [
        (len(one.discordant_pairs(other)), f"{one.label} and {other.label}")
        for one, other in combinations(judgements, 2)
    ]
    most, names = max(couples, key=lambda couple: couple[0], default=(0, ""))
    if not most:
        return ""
    pairs_in_all = math.comb(len(rollouts.actions), 2)
    order = link("order", entities.RANKS)
    return f" {names} {order} {most} of {pairs_in_all} pairs of actions differently."


def _ways_of_judging(judgements: tuple[Judgement, ...]) -> str:
    """Who the teachers are, as far as they are the usual ones, and what V is, in a sentence."""
    told = [
        f"{judgement.label} {WAYS_OF_JUDGING[judgement.teacher]}"
        for judgement in judgements
        if judgement.teacher in WAYS_OF_JUDGING
    ]
    known = f"{', '.join(told)}; " if told else ""
    return (
        f"{known}V, under their names, is what an action is worth to them: the largest is picked "
        "(★)."
    )


def _people(rollouts: Rollouts) -> str:
    people = len(rollouts.scene.pedestrians)
    return {0: "nobody", 1: "one person"}.get(people, f"{people} people")
