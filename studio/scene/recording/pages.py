"""The pages of a recording, in Markdown: what one sees, and how to make it again."""

import math
from collections.abc import Mapping
from dataclasses import asdict
from itertools import combinations

from learners import REWARD, CptParameters
from scenes import FEATURES, Rollouts
from studio.recorder.markdown import link, plain, table
from studio.scene.again import how_to_make_again, record_command
from studio.scene.certainty import wilson
from studio.scene.judgements import Judgement
from studio.scene.recording import entities
from studio.scene.words import bias_told, draws_told, pick_with_shares
from studio.style.words import (
    counted,
    estimate_told,
    number,
    share_told,
    short_label,
    signed_number,
)

MOST_VALUES = 3
"""Teachers whose values stand side by side in a table; more have no room beside the worlds."""

WAYS_OF_JUDGING = {
    "eu": "goes by the mean utility",
    "tk": "by cumulative prospect theory with the parameters that Tversky and Kahneman measured",
    "strong": "by more extreme ones",
}
"""How the usual teachers judge: halves of sentences, of which each goes on from the one before."""


def scene_summary(rollouts: Rollouts, judgements: tuple[Judgement, ...]) -> str:
    """What to look at first: the actions in tables, and which one each teacher picks, how surely.

    It stands beside the worlds under all actions.
    """
    return "\n".join(
        [
            f"# {rollouts.scene.name}",
            "",
            f"The robot meets {_people(rollouts)} and must choose. Each action was simulated "
            f"{counted(rollouts.count, 'time')}{_sample(rollouts)}. A ring with an arrowhead is "
            "the robot in the first of these rollouts, grey rings are the people in it, all in "
            "true size; dots are the robot in the others. A red × marks where it first touches a "
            "person, a red square where a wall.",
            "",
            *picks_told(rollouts, judgements),
            "",
            *outcome_table(rollouts, judgements),
            "",
            *_how_sure(rollouts, judgements),
            "",
            _ways_of_judging(judgements),
            "",
            "Choose the timeline `rollout` below and drag it: every view then shows one rollout at "
            "a time. Hover or select any mark to see whose it is and what came of it.",
        ]
    )


def picks_told(rollouts: Rollouts, judgements: tuple[Judgement, ...]) -> list[str]:
    """What each teacher picks, or between which actions it is open, with shares of draws."""
    names = [short_label(name) for name in rollouts.names]
    return [
        f"* **{each.label}** {'picks' if each.is_sure else 'may pick'} "
        f"{plain(pick_with_shares(each, names))}"
        for each in judgements
    ]


def disagreements_page(rollouts: Rollouts, judgements: tuple[Judgement, ...]) -> str:
    """Which pairs of actions two teachers order differently, and what that costs."""
    pairs_in_all = math.comb(len(rollouts.actions), 2)
    if len(judgements) < 2 or not pairs_in_all:
        return "It takes two teachers and two actions to disagree."
    counts, details = [], []
    for one, other in combinations(judgements, 2):
        pairs = one.discordant_pairs(other)
        loss = other.difference(other.best, one.best)
        told = estimate_told(loss.value, loss.low, loss.high)
        counts.append((f"{one.label}, {other.label}", str(len(pairs)), told))
        if pairs:
            preferred = [[action_link(rollouts, action) for action in pair] for pair in pairs]
            heads = [f"{each.label} prefers" for each in (one, other)]
            details += ["", *table(heads, "ll", preferred)]
    return "\n".join(
        [
            f"How many pairs of actions, of {pairs_in_all}, two teachers order differently, and "
            "how much value V the second one loses by doing what the first one values most, with "
            "its 95 % interval: V of the second one's best action − V of the first one's.",
            "",
            *table(("teachers", "pairs", "loss"), "lrr", counts),
            *details,
            "",
            *_how_sure(rollouts, judgements),
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
            *_what_one_sees(rollouts),
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
            *_how_sure(rollouts, judgements),
            *_bias_table(rollouts, judgements),
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


def _what_one_sees(rollouts: Rollouts) -> list[str]:
    return [
        f"* {link('The world', entities.WORLD)} from above; the robot starts at the ring and is "
        f"headed for the target. All move along the timeline `sim_time`{_sample(rollouts)}.",
        "* A coloured ring is the robot in the first rollout, and its arrowhead shows where it "
        "faces; grey rings are the people in that rollout, and bars join those who walk in a "
        "group. Dots are the robot, and on the tab of an action the people, in the other rollouts.",
        "* A robot turns red at the step at which it first touches a person or a wall. A red × "
        "marks where it first touches a person, a red square where a wall. Lines are the paths.",
        "* Along the timeline `rollout` each rollout is shown in turn, at the moment of its first "
        "contact or else of its smallest gap, with the ways of robot and people. The table "
        "follows, and a ring marks the dot of the rollout.",
        "* Histograms count outcomes by feature, in bins that all actions share: red are those in "
        "which a person was touched, pale red those in which only a wall was. Grey behind them is "
        "the most that any action has in a bin.",
        "* The gap over time is that between the robot and the nearest person: its mean over "
        "rollouts, and one standard deviation to each side.",
        f"* Prospects: {link('what the outcomes are worth', entities.UTILITIES)}, and the "
        "certainty equivalents: the sure utilities that teachers value as much as the action.",
        f"* Minds: {link('how much a probability counts', entities.MINDS)} in losses and in "
        "gains, how good a gain feels and how bad a loss, and how the teachers therefore rank the "
        "actions.",
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
    """Tables of the actions: contacts and means, then the value to every teacher."""
    touched = rollouts.people_touched > 0, rollouts.wall_touched
    gap, progress = rollouts.clearance_m.mean(axis=1), rollouts.progress_m.mean(axis=1)
    rows = []
    for index in range(len(rollouts.actions)):
        shares = [wilson(int(each[index].sum()), rollouts.count) for each in touched]
        contacts = [share_told(share.value, share.low, share.high) for share in shares]
        means = [f"{gap[index]:.2f}", number(progress[index], ".2f")]
        rows.append([action_link(rollouts, index), *contacts, *means])
    heads = ["action", "touches people", "touches walls", "gap, m", "progress, m"]
    lines = table(heads, "lrrrr", rows)
    for first in range(0, len(judgements), MOST_VALUES):
        some = judgements[first : first + MOST_VALUES]
        told = [_values_told(each) for each in some]
        rows = [
            [action_link(rollouts, index), *(values[index] for values in told)]
            for index in range(len(rollouts.actions))
        ]
        heads = ["action", *(f"V {each.label}" for each in some)]
        lines += ["", *table(heads, "l" + "r" * len(some), rows)]
    return lines


def _values_told(judgement: Judgement) -> list[str]:
    """V of every action with its interval; bold and starred what is, or may be, the pick."""
    told = [
        estimate_told(*ends)
        for ends in zip(judgement.values, judgement.low, judgement.high, strict=True)
    ]
    star = "★" if judgement.is_sure else "☆"
    for index in judgement.candidates:
        told[index] = f"**{told[index]}** {star}"
    return told


def _how_sure(rollouts: Rollouts, judgements: tuple[Judgement, ...]) -> list[str]:
    """Where the intervals come from, and by how much V from as few rollouts is off on average."""
    if not judgements:
        return []
    means = "Gaps and progress are means; shares of contacts have Wilson's intervals."
    told = (
        draws_told(judgements, rollouts.count),
        bias_told(judgements, rollouts.names, rollouts.count),
        means,
    )
    return [" ".join(filter(None, told))]


def _bias_table(rollouts: Rollouts, judgements: tuple[Judgement, ...]) -> list[str]:
    """By how much V from as many rollouts is too large on average, if a reference tells."""
    held = [(each, each.reference) for each in judgements if each.reference]
    if not held:
        return []
    rows = [
        [action_link(rollouts, index), *(signed_number(float(r.bias[index])) for _, r in held)]
        for index in range(len(rollouts.actions))
    ]
    return [
        "",
        f"By how much V from {counted(rollouts.count, 'rollout')} is too large on average, held "
        f"against {counted(held[0][1].rollouts, 'rollout')}:",
        "",
        *table(["action", *(each.label for each, _ in held)], "l" + "r" * len(held), rows),
    ]


def action_link(rollouts: Rollouts, index: int) -> str:
    """A link to the world under an action."""
    name = rollouts.names[index]
    return link(plain(short_label(name)), entities.action(name))


def _ways_of_judging(judgements: tuple[Judgement, ...]) -> str:
    """Who the teachers are, as far as they are the usual ones, and what V is, in a sentence."""
    told = [
        f"{judgement.label} {WAYS_OF_JUDGING[judgement.teacher]}"
        for judgement in judgements
        if judgement.teacher in WAYS_OF_JUDGING
    ]
    known = f"{', '.join(told)}; " if told else ""
    return (
        f"{known}V is what an action is worth to them: the largest is picked (★), or it is open "
        "which one is (☆)."
    )


def _people(rollouts: Rollouts) -> str:
    people = len(rollouts.scene.pedestrians)
    return {0: "nobody", 1: "one person"}.get(people, f"{people} people")


def _sample(rollouts: Rollouts) -> str:
    """That the recording shows only some of the rollouts, if it does: the end of a sentence."""
    if rollouts.paths == rollouts.count:
        return ""
    return f"; paths are shown of a sample of {rollouts.paths} of {rollouts.count} rollouts"
