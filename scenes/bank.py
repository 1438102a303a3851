"""The outcome bank: the prospects of many scenes in one Parquet file.

Each row is one rollout. The bank is what passes from the world of scenes to the learners;
everything needed to make it again stands in the file's metadata under the key `prospect_studio`, as
JSON.
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

_BANK_VERSION = 2  # of the file's columns and metadata
_KEY = b"prospect_studio"  # of the metadata
_ROWS_PER_GROUP = 20_000  # a group of rows is written as soon as this many rows wait for it

MOST_SCENES = 1_000_000
"""Most scenes in one bank."""

METRES = ("clearance_m", "deviation_m", "progress_m")
"""The columns in metres: the first features before they are scaled, and fields of `Rollouts`."""

CONTACTS = ("people_touched", "wall_touched")
"""The columns that tell apart what `collisions` counts together; properties of `Rollouts`."""

BANK_SCHEMA = pa.schema(
    pa.field(name, kind, nullable=False)
    for name, kind in {
        "scene": pa.int64(),
        "family": pa.string(),
        "pattern": pa.string(),
        "action": pa.string(),
        "rollout": pa.int64(),
        **dict.fromkeys((*FEATURES, *METRES), pa.float64()),
        "people_touched": pa.int64(),
        "wall_touched": pa.bool_(),
    }.items()
)
"""The columns of the bank."""

Progress = Callable[[int, int], None]
"""Is told how many of how many steps are done."""


@dataclass(frozen=True)
class BankPlan:
    """What to sample; what is not described here is as for `scenes.simulate`.

    Raises:
        InputError: if the number of scenes is out of range.
    """

    scenes: int = 300  # how many; scene i is number i of the series
    seed: int = 0  # of the scenes and of the noise
    rollouts: int = 50  # K, for each scene and action
    families: tuple[str, ...] = ()  # names of those to draw from; none means all
    patterns: tuple[str, ...] = ()  # names of those to draw from; none means all
    horizon: float = 4.0  # s
    model: ForceSet = "extended"
    engine: Engine = "batched"
    noise: Noise = field(default_factory=Noise)
    limits: Limits = field(default_factory=Limits)
    actions: tuple[MetaAction, ...] = META_ACTIONS

    def __post_init__(self) -> None:
        check_whole("scenes", self.scenes, 1, MOST_SCENES)


def write_bank(
    path: Path,
    plan: BankPlan,
    progress: Progress = lambda _done, _total: None,
    workers: int | None = None,
) -> None:
    """Sample the bank and write it.

    Several scenes are simulated at once, and their rows are written in the order of the scenes:
    memory does not grow with the number of scenes, and the file does not depend on the workers.

    Args:
        path: the Parquet file to write.
        plan: what to sample.
        progress: called after every scene with the number of scenes done and of all scenes.
        workers: how many scenes are simulated at once; None is one per processor.

    Raises:
        InputError: if the plan asks for something that cannot be simulated.
    """
    if workers is None:
        workers = os.cpu_count() or 1
    check_whole("workers", workers, 1, 1024)
    schema = BANK_SCHEMA.with_metadata({_KEY: json.dumps(metadata(plan))})
    # The first scene is simulated here, so that a wrong plan fails before a file is opened.
    first = sample_rows(plan, 0)
    waiting, rows = [first], first.num_rows
    progress(1, plan.scenes)
    with pq.ParquetWriter(path, schema, compression="zstd") as writer:
        for done, table in enumerate(_in_order(plan, range(1, plan.scenes), workers), start=2):
            waiting.append(table)
            rows += table.num_rows
            if rows >= _ROWS_PER_GROUP:
                writer.write_table(pa.concat_tables(waiting).cast(schema))
                waiting, rows = [], 0
            progress(done, plan.scenes)
        if waiting:
            writer.write_table(pa.concat_tables(waiting).cast(schema))


def sample_rows(plan: BankPlan, number: int) -> pa.Table:
    """Simulate one scene of the plan, and return its rows."""
    # One thread is enough: the other processors are busy with other scenes.
    return outcome_rows(simulate_planned(plan, planned_scene(plan, number), threads=1))


def planned_scene(plan: BankPlan, number: int) -> Scene:
    """The scene of this number in the plan."""
    return sample_scene(plan.seed, number, plan.families or None, plan.patterns or None)


def simulate_planned(plan: BankPlan, scene: Scene, threads: int | None = None) -> Rollouts:
    """Simulate a scene of the plan, whatever its name, into the same rollouts as in the bank."""
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
    """The A · K rows of one scene, action by action."""
    scene, rows = rollouts.scene, len(rollouts.actions) * rollouts.count
    columns = (
        [scene.number] * rows,
        [scene.family] * rows,
        [scene.pattern] * rows,
        [name for name in rollouts.names for _ in range(rollouts.count)],
        [*range(rollouts.count)] * len(rollouts.actions),
        *rollouts.features.reshape(rows, -1).T,
        *(getattr(rollouts, name).ravel() for name in (*METRES, *CONTACTS)),
    )
    return pa.table(dict(zip(BANK_SCHEMA.names, columns, strict=True)), schema=BANK_SCHEMA)


def metadata(plan: BankPlan) -> dict[str, Any]:
    """Everything needed to make the bank again."""
    scales = (CLEARANCE_SCALE, DEVIATION_SCALE, PROGRESS_SPEED * plan.horizon)
    packages = ("prospect-studio", "numpy", "numba", "pysocialforce", "pyarrow")
    return {
        "bank_version": _BANK_VERSION,
        **asdict(plan),
        "dt": DEFAULT_STEP,
        "scales": dict(zip(METRES, scales, strict=True)),
        "versions": {
            "python": platform.python_version(),
            **{name: version(name) for name in packages},
        },
    }


def read_plan(path: Path) -> BankPlan | None:
    """The plan by which a bank was sampled; None if the file does not say it or cannot be read.

    The plan gives the same rows again if the versions of all packages are the same; whoever needs
    the same rows compares the features.
    """
    try:
        said = json.loads(_metadata_in(path))
        if (said["bank_version"], said["dt"]) != (_BANK_VERSION, DEFAULT_STEP):
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
    except (KeyError, TypeError, ValueError):
        return None


def is_bank_of(plan: BankPlan, path: Path) -> bool:
    """Whether a file is the bank of this plan, made with the versions that are installed."""
    return _metadata_in(path) == json.dumps(metadata(plan)).encode()


def _metadata_in(path: Path) -> bytes:
    """The metadata of a bank as JSON; empty if the file is no bank or cannot be read."""
    try:
        said: bytes = (pq.read_schema(path).metadata or {}).get(_KEY, b"")
    except (OSError, pa.ArrowInvalid):
        return b""
    return said


def _in_order(plan: BankPlan, numbers: range, workers: int) -> Iterator[pa.Table]:
    """The rows of each scene in turn, with at most twice as many scenes under way as workers."""
    # The compiled engine releases Python's interpreter lock, so its threads run at the same time;
    # pysocialforce is plain Python and needs processes.
    executor: Executor
    if plan.engine == "batched":
        executor = ThreadPoolExecutor(workers)
    else:
        executor = ProcessPoolExecutor(workers, mp_context=get_context("spawn"))
    with executor as pool:
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
