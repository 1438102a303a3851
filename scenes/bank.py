"""The outcome bank: the prospects of many scenes in one Parquet file.

One row a rollout. The bank is what passes from the world of scenes to the learners; everything
needed to make it again stands in the file's metadata under the key `prospect_studio`, as JSON.
"""

import json
import os
import platform
from collections import deque
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from dataclasses import asdict, dataclass, field, fields
from importlib.metadata import version
from multiprocessing import get_context
from pathlib import Path
from typing import Any, get_args

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq

from scenes.actions import META_ACTIONS, MetaAction
from scenes.crowd import ForceSet
from scenes.errors import check_whole
from scenes.families import sample_scene
from scenes.features import CLEARANCE_SCALE, DEVIATION_SCALE, FEATURES, PROGRESS_SPEED
from scenes.noise import Noise
from scenes.robot import Limits
from scenes.rollouts import DEFAULT_STEP, Engine, Rollouts, simulate
from scenes.scene import Scene

BANK_VERSION = 1
"""Version of the file's columns and metadata."""

MOST_SCENES = 1_000_000

BANK_SCHEMA = pa.schema(
    [
        pa.field("scene", pa.int64(), nullable=False),
        pa.field("family", pa.string(), nullable=False),
        pa.field("pattern", pa.string(), nullable=False),
        pa.field("action", pa.string(), nullable=False),
        pa.field("rollout", pa.int64(), nullable=False),
        *(pa.field(name, pa.float64(), nullable=False) for name in FEATURES),
        pa.field("clearance_m", pa.float64(), nullable=False),
        pa.field("deviation_m", pa.float64(), nullable=False),
        pa.field("progress_m", pa.float64(), nullable=False),
    ]
)
"""Columns of the bank; features are scaled, `_m` columns are metres."""

Progress = Callable[[int, int], None]
"""Is told how many of how many steps are done."""

_ROWS_PER_GROUP = 20_000


@dataclass(frozen=True)
class BankPlan:
    """What to sample.

    Attributes:
        scenes: how many scenes; scene i is number i of the series.
        seed: of the scenes and of the noise, 0 to 2⁶⁴ - 1.
        rollouts: K, per scene and action.
        families: names of the families to draw from; none named means all.
        patterns: names of the patterns to draw from; none named means all.
        horizon: simulated time, s.
        model: force set.
        engine: who computes.
        noise: how strongly everything is shaken.
        limits: what the robot's motors can do.
        actions: the commands to try.

    Raises:
        InputError: if the number of scenes is out of range.
    """

    scenes: int = 300
    seed: int = 0
    rollouts: int = 50
    families: tuple[str, ...] = ()
    patterns: tuple[str, ...] = ()
    horizon: float = 4.0
    model: ForceSet = "extended"
    engine: Engine = "batched"
    noise: Noise = field(default_factory=Noise)
    limits: Limits = field(default_factory=Limits)
    actions: tuple[MetaAction, ...] = META_ACTIONS

    def __post_init__(self) -> None:
        check_whole("scenes", self.scenes, 1, MOST_SCENES)


def write_bank(
    path: Path, plan: BankPlan, progress: Progress | None = None, workers: int | None = None
) -> None:
    """Sample the bank and write it.

    Scenes are simulated side by side and written in order, a few at a time: memory does not grow
    with the number of scenes, and the file's content does not depend on the number of workers.

    Args:
        path: the Parquet file to write.
        plan: what to sample.
        progress: told after every scene how many of how many are done.
        workers: how many scenes at a time; one per processor if left out.

    Raises:
        InputError: if the plan asks for something that cannot be simulated.
    """
    if workers is None:
        workers = os.cpu_count() or 1
    check_whole("workers", workers, 1, 1024)
    schema = BANK_SCHEMA.with_metadata({"prospect_studio": json.dumps(metadata(plan))})
    # The first scene is simulated here: a wrong plan fails before a file is opened.
    first = sample_rows(plan, 0)
    waiting, rows, done = [first], first.num_rows, 1
    progress = progress or (lambda _done, _total: None)
    progress(done, plan.scenes)
    with pq.ParquetWriter(path, schema, compression="zstd") as writer:
        for table in _in_order(plan, range(1, plan.scenes), workers):
            waiting.append(table)
            rows += table.num_rows
            if rows >= _ROWS_PER_GROUP:
                writer.write_table(pa.concat_tables(waiting).cast(schema))
                waiting, rows = [], 0
            done += 1
            progress(done, plan.scenes)
        if waiting:
            writer.write_table(pa.concat_tables(waiting).cast(schema))


def sample_rows(plan: BankPlan, number: int) -> pa.Table:
    """Simulate one scene of the plan; its rows."""
    # the other processors have scenes of their own
    return outcome_rows(simulate_planned(plan, planned_scene(plan, number), threads=1))


def planned_scene(plan: BankPlan, number: int) -> Scene:
    """The scene of this number in the plan."""
    return sample_scene(plan.seed, number, plan.families or None, plan.patterns or None)


def simulate_planned(plan: BankPlan, scene: Scene, threads: int | None = None) -> Rollouts:
    """Simulate a scene of the plan as the plan wants it; the same rollouts as in the bank.

    Args:
        plan: what was sampled.
        scene: a scene of the plan; its name may be changed.
        threads: as for `simulate`.
    """
    return simulate(
        scene,
        plan.actions,
        plan.rollouts,
        plan.seed,
        plan.engine,
        plan.noise,
        model=plan.model,
        horizon=plan.horizon,
        limits=plan.limits,
        threads=threads,
    )


def outcome_rows(rollouts: Rollouts) -> pa.Table:
    """The rows of one scene, [A · K] of them, action by action."""
    actions, tries = rollouts.features.shape[:2]
    rows = actions * tries
    scene = rollouts.scene
    columns: dict[str, Any] = {
        "scene": np.full(rows, scene.number, dtype=np.int64),
        "family": [scene.family] * rows,
        "pattern": [scene.pattern] * rows,
        "action": [action.name for action in rollouts.actions for _ in range(tries)],
        "rollout": np.tile(np.arange(tries, dtype=np.int64), actions),
    }
    for index, name in enumerate(FEATURES):
        columns[name] = rollouts.features[..., index].ravel()
    columns["clearance_m"] = rollouts.clearance_m.ravel()
    columns["deviation_m"] = rollouts.deviation_m.ravel()
    columns["progress_m"] = rollouts.progress_m.ravel()
    return pa.table(columns, schema=BANK_SCHEMA)


def metadata(plan: BankPlan) -> dict[str, Any]:
    """Everything needed to make the bank again."""
    return {
        "bank_version": BANK_VERSION,
        **asdict(plan),
        "dt": DEFAULT_STEP,
        "scales": {
            "clearance_m": CLEARANCE_SCALE,
            "deviation_m": DEVIATION_SCALE,
            "progress_m": PROGRESS_SPEED * plan.horizon,
        },
        "versions": {
            "python": platform.python_version(),
            **{
                name: version(name)
                for name in ("prospect-studio", "numpy", "numba", "pysocialforce", "pyarrow")
            },
        },
    }


def read_plan(path: Path) -> BankPlan | None:
    """The plan that a bank says it was sampled by; none if it does not say, or cannot be read.

    What the plan gives today is what stands in the file if the versions of all packages are the
    same; whoever depends on it compares the features.
    """
    try:
        said = json.loads((pq.read_schema(path).metadata or {})[b"prospect_studio"])
        if (said["bank_version"], said["dt"]) != (BANK_VERSION, DEFAULT_STEP):
            return None
        if said["engine"] not in get_args(Engine):
            return None
        plain = {each.name: said[each.name] for each in fields(BankPlan)}
        made = {
            "families": tuple(said["families"]),
            "patterns": tuple(said["patterns"]),
            "noise": Noise(**said["noise"]),
            "limits": Limits(**said["limits"]),
            "actions": tuple(MetaAction(**action) for action in said["actions"]),
        }
        return BankPlan(**(plain | made))
    except (OSError, pa.ArrowInvalid, KeyError, TypeError, ValueError):
        return None


def is_bank_of(plan: BankPlan, path: Path) -> bool:
    """Whether a file is the bank that this plan gives, made with these very versions."""
    try:
        said = pq.read_schema(path).metadata or {}
    except (OSError, pa.ArrowInvalid):
        return False
    return said.get(b"prospect_studio") == json.dumps(metadata(plan)).encode()


def _in_order(plan: BankPlan, numbers: range, workers: int) -> Iterator[pa.Table]:
    """The rows of each scene in turn, with twice as many scenes under way as workers."""
    with _executor(plan.engine, workers) as pool:
        under_way: deque[Future[pa.Table]] = deque()
        try:
            for number in numbers:
                under_way.append(pool.submit(sample_rows, plan, number))
                if len(under_way) > 2 * workers:
                    yield under_way.popleft().result()
            while under_way:
                yield under_way.popleft().result()
        finally:
            for future in under_way:
                future.cancel()


def _executor(engine: Engine, workers: int) -> Executor:
    # The compiled engine lets go of the interpreter while it works, so threads run side by side;
    # pysocialforce is Python, and needs processes.
    if engine == "batched":
        return ThreadPoolExecutor(workers)
    return ProcessPoolExecutor(workers, mp_context=get_context("spawn"))
