"""What commands print when they have succeeded, as lines."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from scenes import FAMILIES, PATTERNS
from studio.comparison.comparison import SIDES
from studio.style.words import action_label, contacts_told, counted, estimate_told, teacher_name

if TYPE_CHECKING:
    from scenes.bank import BankPlan
    from studio.made.results import Compared, Learned, Recorded
    from studio.scene.judgements import Judgement


def families_report() -> list[str]:
    """The families of generated scenes, and the patterns of how people meet in them."""
    return [
        "families",
        *(
            f"  {name:<15} {family.description} ({', '.join(family.patterns)})"
            for name, family in FAMILIES.items()
        ),
        "patterns",
        *(f"  {name:<15} {description}" for name, description in PATTERNS.items()),
    ]


def frames_report(frames: Iterable[tuple[int, int]]) -> list[str]:
    """The frames of recorded tracks, each with its number of people."""
    return ["frame   people", *(f"{frame:<7} {people}" for frame, people in frames)]


def sampled_report(plan: BankPlan, bank: Path) -> list[str]:
    """How much an outcome bank of this plan holds."""
    rows = plan.scenes * len(plan.actions) * plan.rollouts
    return [f"{bank}  {rows} outcomes of {plan.scenes} scenes, {_file_size(bank)}"]


def recorded_report(recorded: Recorded) -> list[str]:
    """Contacts of every action, its value to every teacher, and who picks what, all with how sure.

    The first table tells people and walls apart, the second has a column a teacher.
    """
    from studio.scene.true_walks import true_walks_told
    from studio.scene.words import contact_told

    rollouts, judgements = recorded.rollouts, recorded.judgements
    labels = [action_label(name) for name in rollouts.names]
    width = max(16, *(len(label) + 2 for label in labels))
    people, walls = rollouts.people_touched > 0, rollouts.wall_touched
    lines = [f"{'contact with':<{width}}{'people':>8}{'walls':>8}  either, of {rollouts.count}"]
    for index, label in enumerate(labels):
        counts = "".join(f"{each[index].sum():>8}" for each in (people, walls))
        lines.append(f"{label:<{width}}{counts}  {contact_told(rollouts, index)}")
    lines += ["", *_values_lines(judgements, labels, width)]
    lines += ["", *_picks_lines(judgements, rollouts.names, rollouts.count, width)]
    lines += [f"The recorded people have {told}." for told in true_walks_told(rollouts)[:1]]
    return [line.rstrip() for line in lines] + files_report(recorded.files)


def _values_lines(judgements: Sequence[Judgement], labels: Sequence[str], width: int) -> list[str]:
    """The value of every action to every teacher with its interval, a column a teacher."""
    lines = [f"{'value V to':<{width}}" + "".join(f"{who.label:<24}" for who in judgements)]
    ends = [(judgement.low, judgement.high) for judgement in judgements]
    for index, label in enumerate(labels):
        told = (
            estimate_told(judgement.values[index], low[index], high[index])
            for judgement, (low, high) in zip(judgements, ends, strict=True)
        )
        lines.append(f"{label:<{width}}" + "".join(f"{text:<24}" for text in told))
    return lines


def _picks_lines(
    judgements: Sequence[Judgement], names: Sequence[str], count: int, width: int
) -> list[str]:
    """Who picks what among actions of these names, and how sure `count` rollouts make that."""
    from studio.scene.words import bias_told, draws_told, pick_with_shares

    lines = ["picks"]
    for judgement in judgements:
        picked = pick_with_shares(judgement, names)
        lines.append(f"{judgement.label:<{width}}{'' if judgement.is_sure else 'open: '}{picked}")
    lines += ["", draws_told(judgements, count)]
    return [*lines, *filter(None, [bias_told(judgements, names, count)])]


def compared_report(compared: Compared) -> list[str]:
    """How often there is contact on each side; by name, also which action it is and its value."""
    from studio.comparison.words import contacts_in_detail
    from studio.scene.measures import PERSON, WALL, contact_kinds

    comparison, judgements = compared.comparison, compared.judgements
    shown, kinds = comparison.shown, contact_kinds(comparison.rollouts)
    labels = [
        f"{side}  {action_label(name)}" if comparison.named else side
        for side, name in zip(SIDES, shown.names, strict=True)
    ]
    width = max(16, *(len(label) + 2 for label in labels)) if comparison.named else 3
    lines = []
    for index, label in enumerate(labels):
        people, walls = (int((kinds[index] == kind).sum()) for kind in (PERSON, WALL))
        counted = contacts_told(people + walls, shown.count, shown.count)
        detail = contacts_in_detail(people, walls, shown.count)[0]
        lines.append(f"{label:<{width}}{counted}: {detail}")
    if comparison.named:
        lines += ["", *_values_lines(judgements, labels, width)]
        lines += ["", *_picks_lines(judgements, shown.names, shown.count, width)]
    return [line.rstrip() for line in lines] + files_report(compared.files)


def learned_report(learned: Learned) -> list[str]:
    """The learning curves as a table, what follows from them, and what is to be known of the fits.

    Each curve has a row of means over seeds and one of interquartile means, since a single seed may
    carry a mean.
    """
    from studio.study.words import lesson

    results = learned.results
    lines = [
        "regret on held-out scenes, in % of a random action's: mean over seeds, and mean of the",
        "middle half of the seeds",
        f"{'teacher':<12}{'learner':<16}{'':<8}" + "".join(f"{size:>8}" for size in results.sizes),
    ]
    for curve in results.curves("regret_percent"):
        for names, what, means in (
            (f"{curve.teacher:<12}{curve.learner:<16}", "mean", curve.mean),
            (" " * 28, "middle", curve.middle),
        ):
            lines.append(f"{names}{what:<8}" + "".join(f"{mean:>8.2f}" for mean in means))
    lessons = [(teacher, lesson(results, teacher)) for teacher in results.taught]
    told = [f"{teacher_name(teacher.name)}: {said}" for teacher, said in lessons if said]
    lines += (
        [f"at {counted(results.sizes[-1], 'pair')}, with 95 % intervals", *told] if told else []
    )
    if results.repeated:
        again = f"up to {results.repeated} were asked again"
        lines.append(f"there are fewer pairs than wanted: {again}")
    if results.unsettled:
        lines.append(f"{results.unsettled} of {len(results.fits)} fits did not converge")
    if learned.caption:
        lines.append(f"caption: {learned.caption}")
    return lines + files_report(learned.files)


def files_report(files: Sequence[Path]) -> list[str]:
    """The files that were written, with their sizes."""
    return [f"{file}  {_file_size(file)}" for file in files]


def _file_size(file: Path) -> str:
    count = file.stat().st_size
    return f"{count / 1e6:.1f} MB" if count >= 5e4 else f"{count / 1e3:.0f} kB"
