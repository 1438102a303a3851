"""What a mark tells when it is hovered: of which rollout it is, and what came of it.

The viewer shows up to three components of a hovered mark, and nothing but a count of more than
that, but for those that have a single value. So a mark tells everything in one text, `told`, of
which 75 letters are shown; its action stands in the path of the entity. The same in numbers is a
row of the table of outcomes.
"""

from collections.abc import Sequence

import rerun as rr

from scenes import Rollouts
from studio.scene.judgements import utilities
from studio.style.words import number


def told_of_rollouts(rollouts: Rollouts, index: int) -> list[str]:
    """What came of each of the M rollouts under an action whose paths are kept."""
    columns = (
        utilities(rollouts)[index],
        rollouts.clearance_m[index],
        rollouts.progress_m[index],
        rollouts.deviation_m[index],
    )
    return [
        f"rollout {place}: utility {number(columns[0][place], '.3f')}, "
        f"gap {columns[1][place]:.2f} m, progress {number(columns[2][place], '.2f')} m, "
        f"aside {columns[3][place]:.2f} m"
        for place in range(rollouts.paths)
    ]


def told_of_people(told: Sequence[str], people: int) -> list[str]:
    """What the people of each rollout tell, those of the first one first."""
    rollouts = [words.split(":")[0] for words in told]
    return [f"person {person} in {each}" for each in rollouts for person in range(people)]


def told_by_row(rows: Sequence[Sequence[str]]) -> list[rr.ComponentColumn]:
    """What marks tell row by row; a single mark tells it twice, or it would not be shown."""
    doubled = [[*row, *row] if len(row) == 1 else row for row in rows]
    words = rr.AnyValues.columns(told=[word for row in doubled for word in row])
    return list(words.partition([len(row) for row in doubled]))
