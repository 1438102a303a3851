"""Where the regret of a study lies: in which families of scenes, and in which scenes.

Each row of a study tells the regret in every scene that its seed held out. Every seed holds out
other scenes, so a scene has one regret for each of the seeds that held it out.
"""

from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc

from learners.arrays import FloatArray, IntArray
from learners.studying.curves import Curve, learning_curves
from learners.studying.plan import StudyScene
from learners.studying.table import SCENE_COLUMNS, TASK_COLUMNS, study_scenes


@dataclass(frozen=True)
class SceneRegrets:
    """What one learner's picks cost one teacher in every scene that was held out at least once."""

    teacher: str
    learner: str
    pairs: int  # how many pairs were learned from
    scenes: IntArray  # [S], ids, ascending
    runs: IntArray  # [S], how many seeds held the scene out
    regret: FloatArray  # [S], mean over these seeds, in units of value
    picks: tuple[str, ...]  # S names of actions, each the pick of most of these seeds


def family_table(table: pa.Table) -> pa.Table:
    """The regret of every fit in each family of scenes.

    Returns:
        One row for every fit and family: `teacher`, `learner`, `pairs`, `seed`, `family`, `scenes`
        (how many scenes of the family were held out), `regret` (mean over these scenes, in units
        of value) and `regret_percent` (the same in % of what an action picked at random would cost
        in these scenes; 0 where no action can be better than another).

    Raises:
        InputError: if the table does not say what its scenes are.
    """
    scenes = study_scenes(table)
    return pa.Table.from_pylist([cell for row in _rows(table) for cell in _by_family(row, scenes)])


def family_curves(table: pa.Table, column: str = "regret_percent") -> dict[str, list[Curve]]:
    """Learning curves of each family of scenes, see `learning_curves`, by the family's name.

    The column is `regret_percent` or `regret` of `family_table`.

    Raises:
        InputError: if the table does not say what its scenes are, or there is no such column.
    """
    cells = family_table(table)
    families = sorted(set(cells["family"].to_pylist()))
    return {
        family: learning_curves(cells.filter(pc.equal(cells["family"], family)), column)
        for family in families
    }


def scene_regrets(table: pa.Table) -> list[SceneRegrets]:
    """The mean regret in every scene, for each teacher, learner and number of pairs of a table."""
    found: dict[tuple[str, str, int], dict[int, list[tuple[float, str]]]] = {}
    for row in _rows(table):
        by_scene = found.setdefault((row["teacher"], row["learner"], row["pairs"]), {})
        for scene, regret, pick in zip(*(row[name] for name in SCENE_COLUMNS), strict=True):
            by_scene.setdefault(scene, []).append((regret, pick))
    regrets = []
    for task, by_scene in found.items():
        scenes = sorted(by_scene)
        runs = [by_scene[scene] for scene in scenes]
        regrets.append(
            SceneRegrets(
                *task,
                scenes=np.array(scenes, dtype=np.int64),
                runs=np.array([len(seeds) for seeds in runs]),
                regret=np.array([np.mean([regret for regret, _ in seeds]) for seeds in runs]),
                picks=tuple(
                    Counter(pick for _, pick in seeds).most_common(1)[0][0] for seeds in runs
                ),
            )
        )
    return regrets


def telling_scenes(table: pa.Table, count: int) -> dict[str, tuple[int, ...]]:
    """Ids of the scenes that tell most about the learners, by the name of their teacher.

    The most telling come first: those in which the learners' regrets after the largest number of
    pairs differ most, and of scenes in which they differ alike, that with the larger regret. Scenes
    without regret are left out. Each teacher has `count` of them at most.
    """
    found: dict[str, tuple[int, ...]] = {}
    everything = scene_regrets(table)
    for teacher in dict.fromkeys(each.teacher for each in everything):
        ours = [each for each in everything if each.teacher == teacher]
        last = max(each.pairs for each in ours)
        learners = [each for each in ours if each.pairs == last]
        shared = sorted(set.intersection(*(set(each.scenes.tolist()) for each in learners)))
        by_learner = np.array([each.regret[np.isin(each.scenes, shared)] for each in learners])
        most = by_learner.max(axis=0)  # (S,)
        order = np.lexsort((-most, by_learner.min(axis=0) - most))
        found[teacher] = tuple(shared[place] for place in order if most[place] > 0.0)[:count]
    return found


def _rows(table: pa.Table) -> list[dict[str, Any]]:
    rows: list[dict[str, Any]] = table.select([*TASK_COLUMNS, *SCENE_COLUMNS]).to_pylist()
    return sorted(rows, key=lambda row: int(row["seed"]))


def _by_family(row: dict[str, Any], scenes: Mapping[int, StudyScene]) -> Iterator[dict[str, Any]]:
    """The regret of one fit in each family."""
    tested = [scenes[scene] for scene in row["held_out_scenes"]]
    families = np.array([scene.family for scene in tested])
    regret = np.array(row["scene_regret"])
    random_regret = np.array([scene.random_regret[row["teacher"]] for scene in tested])
    for family in sorted(set(families.tolist())):
        ours = families == family
        cost = random_regret[ours].mean()
        yield {
            **{name: row[name] for name in TASK_COLUMNS},
            "family": family,
            "scenes": int(ours.sum()),
            "regret": regret[ours].mean(),
            "regret_percent": 100.0 * regret[ours].mean() / cost if cost > 0.0 else 0.0,
        }
