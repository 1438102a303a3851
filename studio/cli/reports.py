"""What commands print when they have succeeded, as lines."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from scenes import FAMILIES, PATTERNS
from studio.comparison.comparison import SIDES
from studio.style.words import action_label, contacts_told

if TYPE_CHECKING:
    from scenes.bank import BankPlan
    from studio.orchestrator import Compared, Learned, Recorded


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
    return [f"{bank}  {rows:,} outcomes of {plan.scenes} scenes, {_file_size(bank)}"]


def recorded_report(recorded: Recorded) -> list[str]:
    """Contacts of every action and its value to every teacher, a row an action."""
    rollouts, judgements = recorded.rollouts, recorded.judgements
    heads = "".join(f"{'V ' + judgement.teacher:>10} " for judgement in judgements)
    lines = [f"{'action':<16}{'contact':>10} {heads}"]
    for index, (name, touched) in enumerate(zip(rollouts.names, rollouts.touched, strict=True)):
        contacts = f"{touched.sum()} of {rollouts.count}"
        values = "".join(
            f"{judgement.values[index]:>10.3f}{'*' if judgement.best == index else ' '}"
            for judgement in judgements
        )
        lines.append(f"{action_label(name):<16}{contacts:>10} {values}")
    lines.append("* the action that this teacher would pick")
    return lines + files_report(recorded.files)


def compared_report(compared: Compared) -> list[str]:
    """Which action is on which side, and its contacts."""
    rollouts = compared.comparison.rollouts
    lines = [
        f"{side}  {action_label(name):<16}{contacts_told(touched, rollouts.count, rollouts.count)}"
        for side, name, touched in zip(
            SIDES, rollouts.names, rollouts.touched.sum(axis=1), strict=True
        )
    ]
    return lines + files_report(compared.files)


def learned_report(learned: Learned) -> list[str]:
    """The learning curves as a table, and what is to be known of the fits."""
    results = learned.results
    lines = [
        "regret on held-out scenes, in % of a random action's, mean over seeds",
        f"{'teacher':<12}{'learner':<16}" + "".join(f"{size:>8}" for size in results.sizes),
    ]
    for curve in results.curves("regret_percent"):
        means = "".join(f"{mean:>8.2f}" for mean in curve.mean)
        lines.append(f"{curve.teacher:<12}{curve.learner:<16}{means}")
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
