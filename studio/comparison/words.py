"""What is said of a comparison in pictures, recordings and the terminal alike."""

from scenes import Rollouts, Scene
from studio.arrays import Bounds
from studio.scene.certainty import wilson
from studio.scene.framing import in_view
from studio.style.words import counted, share_told


def contacts_in_detail(people: int, walls: int, count: int) -> list[str]:
    """How often a person or a wall was touched in `count` outcomes, the longest wording first.

    Outcomes in which a person was touched and those in which a wall alone was are told apart. The
    share of both together comes with its 95 % interval.
    """
    share = wilson(people + walls, count)
    told = share_told(share.value, share.low, share.high)
    if not people + walls:
        return [told]
    parts = [f"× {people:,} a person"] * bool(people) + [f"□ {walls:,} a wall"] * bool(walls)
    brief = [f"× {people:,}"] * bool(people) + [f"□ {walls:,}"] * bool(walls)
    return [f"{told} · {', '.join(parts)}", f"{told} · {', '.join(brief)}", told]


def people_told(scene: Scene, bounds: Bounds) -> str:
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
    people, walls = (rollouts.people_touched > 0).any(), rollouts.wall_touched.any()
    marks = ["× a person"] * bool(people) + ["□ a wall"] * bool(walls)
    return f"touched: {', '.join(marks)}" if marks else ""
