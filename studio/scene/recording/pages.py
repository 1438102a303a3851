"""The pages of a recording, in Markdown: what one sees, and how to make it again."""

import math
import re
from collections.abc import Mapping
from dataclasses import asdict
from itertools import combinations

import numpy as np

from learners import REWARD
from scenes import FEATURES, META_ACTIONS, Rollouts, scene_to_toml
from studio.scene.again import how_to_make_again
from studio.scene.judgements import Judgement
from studio.scene.recording import entities
from studio.scene.recording.ranks import discordant_pairs
from studio.style.words import counted, number, short, teacher_name

WAYS_OF_JUDGING = {
    "eu": "goes by the mean utility",
    "tk": "by cumulative prospect theory with the parameters that Tversky and Kahneman measured",
    "strong": "by more extreme ones",
}
"""How the usual teachers judge, in the order in which they are told."""


def summary_page(rollouts: Rollouts, judgements: tuple[Judgement, ...]) -> str:
    """What to look at first: the actions in a table, and which one each teacher picks."""
    scene, count = rollouts.scene, rollouts.count
    picks = [
        f"**{teacher_name(judgement.teacher)}** picks {_link(rollouts, judgement.best)}"
        for judgement in judgements
    ]
    return "\n".join(
        [
            f"# {scene.name}",
            "",
            f"The robot meets {_people(rollouts)} and must choose. Each action was simulated "
            f"{counted(count, 'time')}. Balls are the robot (with an arrowhead) and the people "
            "(grey) in the first of these futures, in true size; dots are those in the others. "
            "People react to the robot, so every action has its own. A robot is red once it has "
            "touched somebody or a wall; a cross marks where.",
            "",
            *outcome_table(rollouts, judgements),
            "",
            f"{'; '.join(picks)}.{_disagreement(rollouts, judgements)}",
            "",
            _minds(judgements),
            "",
            "Gap to the nearest person: median over futures of the smallest; progress towards the "
            "goal: mean.",
        ]
    )


def disagreements_page(rollouts: Rollouts, judgements: tuple[Judgement, ...]) -> str:
    """Which pairs of actions two teachers order differently, and what that costs."""
    pairs_in_all = math.comb(len(rollouts.actions), 2)
    if len(judgements) < 2 or not pairs_in_all:
        return "It takes two teachers and two actions to disagree."
    lines = [
        f"How many pairs of actions, of {pairs_in_all}, two teachers order differently, and how "
        "much value the second one loses by doing what the first one picks.",
        "",
        "| teachers | pairs | loss |",
        "|:--|--:|--:|",
    ]
    details = []
    for one, other in combinations(judgements, 2):
        pairs = discordant_pairs(one.values, other.values)
        loss = number(other.values[other.best] - other.values[one.best], ".3f")
        first, second = teacher_name(one.teacher), teacher_name(other.teacher)
        lines.append(f"| {first}, {second} | {len(pairs)} | {loss} |")
        if pairs:
            details += ["", f"| {first} prefers | {second} prefers |", "|:--|:--|"]
            details += [f"| {_link(rollouts, a)} | {_link(rollouts, b)} |" for a, b in pairs]
    return "\n".join(lines + details)


def about_page(
    rollouts: Rollouts,
    judgements: tuple[Judgement, ...],
    versions: Mapping[str, str],
) -> str:
    """Everything there is to know about a recording."""
    scene, count = rollouts.scene, rollouts.count
    steps = rollouts.steps
    actions = [
        f"| {_link(rollouts, index)} | {number(action.speed)} | {number(action.turn_rate)} |"
        for index, action in enumerate(rollouts.actions)
    ]
    minds = [
        f"| {teacher_name(judgement.teacher)} | "
        + " | ".join(f"{number:g}" for number in _parameters(judgement))
        + " |"
        for judgement in judgements
    ]
    rewards = [
        f"| {feature} | {number(worth)} |" for feature, worth in zip(FEATURES, REWARD, strict=True)
    ]
    further = {
        **{f"noise: {name}": given for name, given in asdict(rollouts.noise).items()},
        **{f"limits: {name}": given for name, given in asdict(rollouts.limits).items()},
        **{f"version: {name}": given for name, given in versions.items()},
    }
    return "\n".join(
        [
            f"# {scene.name}",
            "",
            f"A robot and {_people(rollouts)}, `{scene.family}`, `{scene.pattern}`. Under each "
            f"action the scene was simulated {counted(count, 'time')} for {rollouts.horizon:g} s, "
            "always with the same luck: actions differ in nothing but the action.",
            "",
            "## What one sees",
            "",
            f"* [The world](recording://{entities.WORLD}) from above, on a grid of metres; the "
            "robot starts at the ring with the nose and is headed for the target.",
            "* A coloured ball is the robot in the first future, and its arrowhead shows where it "
            "faces; a grey ball is a person in that future, and bars join people who walk in a "
            "group. Both are in true size. Dots are the robot and the people in the other futures.",
            "* A robot turns red at the step at which it first touches a person or a wall; a red "
            "cross marks where. Faint lines are the paths that robots take, a bold one is that of "
            "the first future.",
            "* Histograms count the outcomes by feature, in bins that all actions share, those "
            "with contact in red; the number at the upper left is the height of the tallest bar.",
            "* The gap over time is that between the robot and the nearest person: the median, "
            "and a band from the 10 % to the 90 % quantile.",
            f"* Prospects: [all outcomes](recording://{entities.COMPARISON}), every feature on one "
            f"scale; and [what they are worth](recording://{entities.PROSPECTS}): their utilities "
            "from the worst to the best, the decision weight of each in multiples of its "
            "probability, and, as marks, the certainty equivalents: the sure utilities that the "
            "teachers value as much as the action.",
            f"* Minds: how much a probability [of a gain](recording://{entities.GAIN_WEIGHTS}) and "
            f"[of a loss](recording://{entities.LOSS_WEIGHTS}) counts, what that [makes of fifty "
            f"equally likely outcomes](recording://{entities.DECISION_WEIGHTS}), the worse half "
            f"losses and the better half gains, how good a gain [feels](recording://"
            f"{entities.VALUES}) and how bad a loss, and how the teachers therefore [rank the "
            f"actions](recording://{entities.RANKS}).",
            "",
            "Press space to stop and go on; double-click a view to set it back.",
            "",
            "## Actions",
            "",
            "| action | speed v, m/s | turn rate ω, rad/s |",
            "|:--|--:|--:|",
            *actions,
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
            "| teacher | α | η | λ | γ | δ |",
            "|:--|--:|--:|--:|--:|--:|",
            *minds,
            "",
            "| feature φ | worth θ |",
            "|:--|--:|",
            *rewards,
            "",
            "## Make it again",
            "",
            *how_to_make_again(
                rollouts, "studio record" if rollouts.actions == META_ACTIONS else None
            ),
            "",
            "| setting | value |",
            "|:--|:--|",
            f"| seed | {rollouts.seed} |",
            f"| rollouts | {count} |",
            f"| steps | {steps} of {rollouts.dt:g} s |",
            f"| model | {rollouts.model} |",
            f"| engine | {rollouts.engine} |",
            f"| wrap_angles | {rollouts.wrap_angles} |",
            *(f"| {name} | {given} |" for name, given in further.items()),
            "",
            "```toml",
            scene_to_toml(scene).rstrip(),
            "```",
        ]
    )


def outcome_table(rollouts: Rollouts, judgements: tuple[Judgement, ...]) -> list[str]:
    """One row an action: contacts, gap, progress, and its value to every teacher."""
    count = rollouts.count
    contacts = rollouts.touched.sum(axis=1)
    gap = np.median(rollouts.clearance_m, axis=1)
    progress = rollouts.progress_m.mean(axis=1)
    values = " | ".join(teacher_name(judgement.teacher) for judgement in judgements)
    lines = [
        f"| action | contact | gap, m | progress, m | {values} |",
        "|:--|--:|--:|--:|" + "--:|" * len(judgements),
    ]
    for index in range(len(rollouts.actions)):
        worths = []
        for judgement in judgements:
            worth = number(judgement.values[index], ".3f")
            worths.append(f"**{worth}** ★" if index == judgement.best else worth)
        lines.append(
            f"| {_link(rollouts, index)} | {contacts[index]} / {count} | {gap[index]:.2f} | "
            f"{progress[index]:.2f} | {' | '.join(worths)} |"
        )
    return lines


def _disagreement(rollouts: Rollouts, judgements: tuple[Judgement, ...]) -> str:
    """How many pairs of actions the two teachers who agree least order differently, in words."""
    counts = [
        (len(discordant_pairs(one.values, other.values)), one, other)
        for one, other in combinations(judgements, 2)
    ]
    most, one, other = max(counts, key=lambda given: given[0], default=(0, None, None))
    if one is None or other is None or not most:
        return ""
    return (
        f" {teacher_name(one.teacher)} and {teacher_name(other.teacher)} "
        f"[order](recording://{entities.RANKS}) {most} of "
        f"{math.comb(len(rollouts.actions), 2)} pairs of actions differently."
    )


def _minds(judgements: tuple[Judgement, ...]) -> str:
    """Who the teachers are, as far as they are the usual ones, and what V is, in a sentence."""
    minds = [
        f"{teacher_name(judgement.teacher)} {WAYS_OF_JUDGING[judgement.teacher]}"
        for judgement in judgements
        if judgement.teacher in WAYS_OF_JUDGING
    ]
    known = f"{', '.join(minds)}; " if minds else ""
    return (
        f"{known}V, under their names, is what an action is worth to them: the largest is picked "
        "(★)."
    )


def _link(rollouts: Rollouts, index: int) -> str:
    name = rollouts.names[index]
    # Markdown ends a link at a space unless it is in angle brackets, and eats backslashes
    target = entities.action(name).replace("\\", "\\\\")
    shown = re.sub(r"([\\|\[\]*_`<])", r"\\\1", short(name))
    return f"[{shown}](<recording://{target}>)"


def _people(rollouts: Rollouts) -> str:
    people = len(rollouts.scene.pedestrians)
    return {0: "nobody", 1: "one person"}.get(people, f"{people} people")


def _parameters(judgement: Judgement) -> tuple[float, ...]:
    parameters = judgement.parameters
    return (
        parameters.alpha,
        parameters.eta,
        parameters.loss_aversion,
        parameters.gamma,
        parameters.delta,
    )
