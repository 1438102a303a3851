"""The pages of a recording, in Markdown: what one sees, and how to make it again."""

import math
from collections.abc import Mapping, Sequence
from itertools import combinations

from learners import REWARD, CptParameters
from scenes import FEATURES, Rollouts
from studio.recorder.markdown import link, plain, table
from studio.scene.again import how_to_make_again, record_command, settings_of
from studio.scene.certainty import wilson
from studio.scene.judgements import Judgement
from studio.scene.recording import entities
from studio.scene.true_walks import true_walks_told
from studio.scene.words import bias_told, draws_told, pick_with_shares
from studio.style.words import counted, estimate_told, number, share_told, short_label

MOST_VALUES = 3
"""Teachers whose values stand side by side in a table; more have no room beside the worlds."""

WAYS_OF_JUDGING = {
    "eu": "goes by the mean utility",
    "tk": "by cumulative prospect theory with the parameters that Tversky and Kahneman measured",
    "strong": "by more extreme ones",
}
"""How the usual teachers judge: halves of sentences, of which each goes on from the one before."""

SUMMARY = """# {name}

The robot meets {people} and must choose. Each action was simulated {times}{sample}. A ring with an
arrowhead is the robot in the first of these rollouts, grey rings are the people in it, all in true
size; dots are the robot in the others. A red × marks where it first touches a person, a red square
where a wall.

{picks}

{tables}

{sure}

{judging}V is what an action is worth to them: the largest is picked (★), or it is open which one
is (☆).

{real}Choose the timeline `rollout` below and drag it: every view then shows one rollout at a time.
Hover or select any mark to see whose it is and what came of it."""

DISAGREEMENTS = """How many pairs of actions, of {pairs}, two teachers order differently, and how
much value V the second one loses by doing what the first one values most, with its 95 % interval:
V of the second one's best action − V of the first one's.

{tables}

{sure}"""

ABOUT = """# {name}

A robot and {people}, `{family}`, `{pattern}`. Under each action the scene was simulated {times} for
{horizon:g} s, always with the same luck: actions differ in nothing but the action.

## What one sees

* {world} from above; the robot starts at the ring and is headed for the target. All move along the
  timeline `sim_time`{sample}.
* A coloured ring is the robot in the first rollout, and its arrowhead shows where it faces; grey
  rings are the people in that rollout. Dots are the robot, and on the tab of an action the people,
  in the other rollouts; bars join those who walk in a group.
* A robot turns red at the step at which it first touches a person or a wall. A red × marks where it
  first touches a person, a red square where a wall. Lines are the paths.
* Along the timeline `rollout` each rollout is shown in turn, at the moment of its first contact or
  else of its smallest gap. The table follows, and a ring marks the dot of the rollout.
* Histograms count outcomes by feature, in bins that all actions share: red are those in which a
  person was touched, pale red those in which only a wall was. Grey behind them is the most that any
  action has in a bin.
* The gap over time is that between the robot and the nearest person: its mean over rollouts, and
  one standard deviation to each side.
* Prospects: {utilities}, and the certainty equivalents: the sure utilities that teachers value as
  much as the action.
* Minds: {minds} in losses and in gains, how good a gain feels and how bad a loss, and how the
  teachers therefore rank the actions.

Press space to stop and go on; double-click a view to set it back.

## Actions

{actions}

## Outcomes

{tables}

{sure}

## Teachers

An outcome with features φ has utility x = θ·φ. A teacher values it at x^α as a gain and −λ(−x)^η as
a loss, and counts probabilities p as exp(−(−ln p)^γ) for gains, with δ for losses. All ones is
expected utility (EU).

{teachers}

{again}"""


def scene_summary(rollouts: Rollouts, judgements: tuple[Judgement, ...]) -> str:
    """What to look at first: the actions in tables, and which one each teacher picks, how surely.

    It stands beside the worlds under all actions.
    """
    known = [each for each in judgements if each.teacher in WAYS_OF_JUDGING]
    judging = ", ".join(f"{each.label} {WAYS_OF_JUDGING[each.teacher]}" for each in known)
    walks = true_walks_told(rollouts)
    return SUMMARY.format(
        **_told(rollouts, judgements),
        picks="\n".join(picks_told(rollouts, judgements)),
        judging=f"{judging}; " if known else "",
        real="".join(f"The recorded people have {said}.\n\n" for said in walks[:1]),
    )


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
    tables = [*table(("teachers", "pairs", "loss"), "lrr", counts), *details]
    page = _told(rollouts, judgements) | {"tables": "\n".join(tables)}
    return DISAGREEMENTS.format(**page, pairs=pairs_in_all)


def scene_page(
    rollouts: Rollouts, judgements: tuple[Judgement, ...], versions: Mapping[str, str]
) -> str:
    """Everything there is to know about the recording of a scene."""
    driven = [
        (action_link(rollouts, index), number(action.speed), number(action.turn_rate))
        for index, action in enumerate(rollouts.actions)
    ]
    minds = [(each.label, *(f"{n:g}" for n in each.parameters.numbers)) for each in judgements]
    worths = zip(FEATURES, map(number, REWARD), strict=True)
    teachers = [
        *table(("teacher", *CptParameters.SYMBOLS), "lrrrrr", minds),
        "",
        *table(("feature φ", "worth θ"), "lr", worths),
    ]
    settings = table(("setting", "value"), "ll", settings_of(rollouts, versions))
    return ABOUT.format(
        **_told(rollouts, judgements),
        family=rollouts.scene.family,
        pattern=rollouts.scene.pattern,
        horizon=rollouts.horizon,
        world=link("The world", entities.WORLD),
        utilities=link("what the outcomes are worth", entities.UTILITIES),
        minds=link("how much a probability counts", entities.MINDS),
        actions="\n".join(table(("action", "speed v, m/s", "turn rate ω, rad/s"), "lrr", driven)),
        teachers="\n".join(teachers),
        again="\n".join(how_to_make_again(rollouts, record_command(rollouts), settings)),
    )


def _told(rollouts: Rollouts, judgements: tuple[Judgement, ...]) -> dict[str, str]:
    """What several pages tell: of the scene, of its actions, and how sure that is."""
    people, count = len(rollouts.scene.pedestrians), rollouts.count
    sample = f"; paths are shown of a sample of {rollouts.paths} of {count} rollouts"
    sure = ["Gaps and progress are means; shares of contacts have Wilson's intervals."]
    if judgements:
        bias = bias_told(judgements, rollouts.names, count)
        sure = [draws_told(judgements, count), *filter(None, [bias]), *sure]
    return {
        "name": rollouts.scene.name.replace("_", " "),
        "people": {0: "nobody", 1: "one person"}.get(people, f"{people} people"),
        "times": counted(count, "time"),
        "sample": sample if rollouts.paths < count else "",
        "tables": "\n".join(outcome_table(rollouts, judgements)),
        "sure": " ".join(sure),
    }


def picks_told(rollouts: Rollouts, judgements: Sequence[Judgement]) -> list[str]:
    """What each teacher picks, or between which actions it is open, with shares of draws."""
    names = [short_label(name) for name in rollouts.names]
    return [
        f"* **{each.label}** {'picks' if each.is_sure else 'may pick'} "
        f"{plain(pick_with_shares(each, names))}"
        for each in judgements
    ]


def outcome_table(rollouts: Rollouts, judgements: Sequence[Judgement]) -> list[str]:
    """Tables of the actions: contacts and means, then the value to every teacher.

    Bold and starred is what a teacher picks, or may pick where that is open.
    """
    links = [action_link(rollouts, index) for index in range(len(rollouts.actions))]
    contacts = [
        [share_told(share.value, share.low, share.high) for share in shares]
        for shares in (
            [wilson(int(touched.sum()), rollouts.count) for touched in kind]
            for kind in (rollouts.people_touched > 0, rollouts.wall_touched)
        )
    ]
    means = [
        [number(mean, ".2f") for mean in values.mean(axis=1)]
        for values in (rollouts.clearance_m, rollouts.progress_m)
    ]
    heads = ["action", "touches people", "touches walls", "gap, m", "progress, m"]
    lines = table(heads, "lrrrr", list(zip(links, *contacts, *means, strict=True)))
    for first in range(0, len(judgements), MOST_VALUES):
        some = judgements[first : first + MOST_VALUES]
        heads = ["action", *(f"V {each.label}" for each in some)]
        rows = list(zip(links, *map(_values_told, some), strict=True))
        lines += ["", *table(heads, "l" + "r" * len(some), rows)]
    return lines


def _values_told(judgement: Judgement) -> list[str]:
    ends = zip(judgement.values, judgement.low, judgement.high, strict=True)
    told = [estimate_told(*each) for each in ends]
    for index in judgement.candidates:
        told[index] = f"**{told[index]}** {'★' if judgement.is_sure else '☆'}"
    return told


def action_link(rollouts: Rollouts, index: int) -> str:
    """A link to the world under an action."""
    name = rollouts.names[index]
    return link(plain(short_label(name)), entities.action(name))
