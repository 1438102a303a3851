"""What is said of a comparison in pictures, recordings and the terminal alike."""

from collections.abc import Sequence

from scenes import Rollouts, Scene
from studio.arrays import Bounds, IntArray
from studio.comparison.comparison import SIDES, ended_after
from studio.scene.certainty import wilson
from studio.scene.framing import in_view
from studio.scene.measures import NOTHING, PERSON, WALL, contact_kinds
from studio.style.words import contacts_told, counted, number, share_told


def contacts_in_detail(people: int, walls: int, count: int) -> list[str]:
    """How often a person or a wall was touched in `count` outcomes, the longest wording first.

    Outcomes in which a person was touched and those in which a wall alone was are told apart. The
    share of both together comes with its 95 % interval.
    """
    share = wilson(people + walls, count)
    told = share_told(share.value, share.low, share.high)
    if not people + walls:
        return [told]
    parts = [f"× {people} a person"] * bool(people) + [f"□ {walls} a wall"] * bool(walls)
    brief = [f"× {people}"] * bool(people) + [f"□ {walls}"] * bool(walls)
    return [f"{told} · {', '.join(parts)}", f"{told} · {', '.join(brief)}", told]


def crowd_told(scene: Scene, bounds: Bounds) -> str:
    """How many people there are, and how many of them a view with these bounds shows at the start.

    Empty if there is nobody.
    """
    count = len(scene.pedestrians)
    if not count:
        return ""
    people = "1 person" if count == 1 else f"{count} people"
    outside = int((~in_view(scene.starts, bounds)).sum())
    return f"{people} ({count - outside} in view, {outside} not)" if outside else people


def dots_told(count: int, most: int) -> str:
    """How many of `count` outcomes a dot stands for where there are at most so many dots."""
    return "a dot: one outcome" if count <= most else f"{most} dots: {counted(count, 'outcome')}"


def marks_told(rollouts: Rollouts) -> str:
    """What the marks of contact mean, as far as there are any."""
    kinds = contact_kinds(rollouts)
    things = {"× a person": PERSON, "□ a wall": WALL}
    marks = [told for told, kind in things.items() if (kinds == kind).any()]
    return f"touched: {', '.join(marks)}" if marks else ""


def outcomes_told(rollouts: Rollouts, side: int) -> list[str]:
    """What each of the K outcomes of one side was, in the features that are shown."""
    columns = (rollouts.clearance_m, rollouts.progress_m, rollouts.deviation_m)
    kinds = contact_kinds(rollouts)[side].tolist()
    touched = {PERSON: ", touches a person", WALL: ", touches a wall", NOTHING: ""}
    return [
        f"outcome {place + 1} of {SIDES[side]}: gap {gap:.2f} m, "
        f"progress {number(progress, '.2f')} m, aside {aside:.2f} m{touched[kind]}"
        for place, (kind, gap, progress, aside) in enumerate(
            zip(kinds, *(column[side].tolist() for column in columns), strict=True)
        )
    ]


def dots_told_by(arrivals: IntArray, told: Sequence[str]) -> list[str]:
    """What dots tell: of their outcome, or of one of several outcomes that they stand for.

    Args:
        arrivals: with which outcome each dot has come, the first being 1, [N].
        told: of the K outcomes.
    """
    share = len(told) / len(arrivals)
    like = "" if share == 1.0 else f"{share:.3g} outcomes like "
    return [like + told[arrival - 1] for arrival in arrivals]


def playing_told(rollouts: Rollouts, side: int) -> list[str]:
    """What is said of one side before anything plays, and as each outcome begins and ends, [1+2M].

    It is which outcome plays, and in how many of those so far there was contact.
    """
    touched, played = rollouts.touched[side], rollouts.paths
    so_far = [
        contacts_told(int(touched[:ended].sum()), ended, rollouts.count)
        for ended in ended_after(rollouts).tolist()
    ]
    said = [f"{counted(played, 'outcome')}, one at a time"]
    for place in range(played):
        playing = f"Outcome {place + 1} of {played}"
        said += [f"{playing} · {told}" if told else playing for told in so_far[place : place + 2]]
    return said
