"""Makes every kind of output and says what differs from an earlier time, for refactorings.

    python tests/unchanged.py FOLDER [--compare OTHER_FOLDER]

The studio in the working folder is run by its command line alone, and its files are read with
Rerun's and Arrow's own readers: nothing in here knows how the studio is made. FOLDER is made anew
and gets `digests.json` beside the outputs; OTHER_FOLDER is one that this script made before. The
exit code is 1 if anything differs.
"""

import argparse
import difflib
import hashlib
import json
import lzma
import os
import re
import shlex
import shutil
import subprocess
import sys
import time
from collections import defaultdict
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any
from uuid import UUID

import cv2
import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
from rerun.chunk import RrdReader
from unchanged_commands import FIRST, SAYING, WRITING, WRONG, renderings

TRACKS = Path("data/ewap/seq_eth")

Digest = str | dict[str, "Digest"]


def run(folder: Path, name: str, command: str) -> str:
    """Run a command in a folder, keep what it says in a file there, return its output."""
    code = Path.cwd()
    paths = os.pathsep.join([str(code), *filter(None, [os.environ.get("PYTHONPATH")])])
    done = subprocess.run(
        [sys.executable, "-P", "-m", "studio", *shlex.split(command)],
        cwd=folder,
        env=os.environ | {"PYTHONPATH": paths, "COLUMNS": "100"},
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        check=False,
    )
    said = f"$ studio {command}\n{done.stdout}--- stderr\n{done.stderr}--- exit code "
    said = said.replace(str(folder), "<folder>").replace(str(code), "<code>")
    said = re.sub(r"Preparing the engine.*\n", "", said)  # depends on the time it takes
    said = re.sub(r"(\.rrd  )[\d.]+ [kM]B", r"\1<size>", said)  # random ids pack differently
    file = folder / "said" / f"{name}.txt"
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(f"{said}{done.returncode}\n")
    return done.stdout


def make(folder: Path) -> None:
    """Make every kind of output in a folder."""
    inputs = folder / "inputs"
    inputs.mkdir(parents=True)
    (folder / "digests.json").write_text("{}")
    shared = [
        above / "shared" / TRACKS for above in (Path.cwd(), *Path.cwd().parents, Path("/work"))
    ]
    shutil.copytree(next(filter(Path.exists, shared)), inputs / "tracks")
    old = []
    for packed in sorted((Path.cwd() / "tests").rglob("*.rrd.xz")):
        (inputs / packed.stem).write_bytes(lzma.decompress(packed.read_bytes()))
        old.append(Path(packed.stem).stem)
    said = {name: run(folder, name, command) for name, command in FIRST.items()}
    scene = said["scenes/toml"]
    (inputs / "mine.toml").write_text(scene)
    (inputs / "broken.toml").write_text(scene + "walls = [\n")
    (inputs / "contradicting.toml").write_text(scene.replace("groups = [", "groups = [[0, 99], "))
    (inputs / "unknown.toml").write_text("weather = 'fog'\n" + scene)
    (inputs / "text.txt").write_text("This is no recording.\n")
    recording = (folder / "record/doorway.rrd").read_bytes()
    (inputs / "beside.rrd").write_bytes(recording)
    (inputs / "cut.rrd").write_bytes(recording[:5000])
    foreign = "import rerun; rerun.init('x', recording_id='x'); rerun.save('foreign.rrd'); "
    foreign += "rerun.log('a', rerun.Points2D([[0, 0]]))"
    subprocess.run([sys.executable, "-c", foreign], cwd=inputs, check=True)
    (folder / "render").mkdir()
    with ThreadPoolExecutor(2) as pool:
        for commands in (WRITING, renderings(old) | SAYING | WRONG):
            list(pool.map(lambda named: run(folder, *named), commands.items()))


def sha(content: bytes) -> str:
    """A digest of bytes."""
    return hashlib.sha256(content).hexdigest()


def array_digest(array: pa.Array, renamed: Callable[[str], str] = str) -> str:
    """A digest of an array's type and values, however they lie in memory."""
    kind, nulls = array.type, array.is_null().to_numpy(zero_copy_only=False).tobytes()
    parts = [str(kind), sha(nulls)]
    if pa.types.is_list(kind) or pa.types.is_large_list(kind):
        parts += [sha(array.value_lengths().fill_null(-1).to_numpy().tobytes())]
        parts += [array_digest(array.flatten(), renamed)]
    elif pa.types.is_fixed_size_list(kind):
        parts += [array_digest(array.flatten(), renamed)]
    elif pa.types.is_struct(kind):
        parts += [array_digest(part, renamed) for part in array.flatten()]
    elif pa.types.is_union(kind):
        chosen = zip(array.type_codes.to_pylist(), array, strict=True)
        parts += [str([(code, value.as_py()) for code, value in chosen])]
    elif pa.types.is_primitive(kind):
        if array.null_count:
            array = array.drop_null()
        parts += [sha(array.to_numpy(zero_copy_only=False).tobytes())]
    else:  # strings and bytes
        parts += [renamed(repr(array.to_pylist()))]
    return sha("\n".join(parts).encode())


def parquet_digest(path: Path) -> Digest:
    """Digests of the columns of a table, its schema and its metadata."""
    table = pq.read_table(path)
    columns = {name: array_digest(table[name].combine_chunks()) for name in table.column_names}
    schema = sha(table.schema.to_string(show_schema_metadata=False).encode())
    said = {k.decode(): v.decode() for k, v in (table.schema.metadata or {}).items()}
    metadata = {name: sha(text.encode()) for name, text in said.items() if name != "ARROW:schema"}
    return {"columns": dict(columns), "schema": schema, "metadata": dict(metadata)}


def block_names(columns: dict[tuple[str, str, str], list[Any]]) -> dict[str, str]:
    """Names, by place below the root, for the random ids of a blueprint's containers and views."""
    names: dict[str, str] = {}

    def name(block: str, place: str) -> None:
        identity = block.split("/")[-1]
        names[identity] = place
        for _, _, array, _ in columns.get((f"/container/{identity}", CONTENTS, "static"), []):
            for number, inner in enumerate(array.to_pylist()[-1] or ()):
                name(inner, f"{place}.{number}")

    for _, _, array, _ in columns.get(("/viewport", ROOT, "static"), []):
        name(str(UUID(bytes=bytes(array.to_pylist()[-1][0]))), "root")
    return names


CONTENTS, ROOT = "ContainerBlueprint:contents", "ViewportBlueprint:root_container"
UNTIMELY = ("log_time", "log_tick", "blueprint")
"""Timelines that say when something was written."""


def store_digest(reader: RrdReader, store: Any) -> dict[str, Digest]:
    """Digests of a store's components by entity, component and timeline."""
    columns: dict[tuple[str, str, str], list[Any]] = defaultdict(list)
    for chunk in reader.stream(store=store).to_chunks():
        batch = chunk.to_record_batch()
        fields = {field.name: (field.metadata or {}) for field in batch.schema}
        kinds = {name: said.get(b"rerun:kind", b"").decode() for name, said in fields.items()}
        rows = batch.column("rerun.controls.RowId").to_pylist()
        times = [name for name in kinds if kinds[name] == "index" and name not in UNTIMELY]
        for name in (name for name in kinds if kinds[name] == "data"):
            array, said = batch.column(name), fields[name]
            stated = [said.get(f"rerun:{k}".encode(), b"") for k in ("archetype", "component_type")]
            for line in times or ["static"]:
                when = batch.column(line).cast(pa.int64()).to_pylist() if times else [0] * len(rows)
                columns[chunk.entity_path, name, line].append((when, rows, array, stated))
    names = block_names(columns) if store.kind == "blueprint" else {}

    def renamed(text: str) -> str:
        return re.sub(r"[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}", lambda m: names[m[0]], text)

    digest: dict[str, Any] = defaultdict(dict)
    for (entity, name, line), parts in columns.items():
        when = [moment for part in parts for moment in part[0]]
        rows = [row for part in parts for row in part[1]]
        array = parts[0][2] if len(parts) == 1 else pa.concat_arrays(part[2] for part in parts)
        inorder = sorted(
            zip(when, rows, range(len(rows)), array.is_valid().to_pylist(), strict=True)
        )
        order = [place for _, _, place, valid in inorder if valid]
        moments = sha(np.array([when[place] for place in order], np.int64).tobytes())
        if order != list(range(len(array))):  # Arrow cannot take from unions, so take no more
            array = array.take(pa.array(order, pa.int64()))
        values = "" if name == ROOT else array_digest(array, renamed)
        whole = sha(f"{moments} {values} {sorted({str(part[3]) for part in parts})}".encode())
        digest[f"{store.kind} {renamed(entity)}"][f"{name} @ {line}"] = f"{len(order)} rows {whole}"
    return dict(digest)


def recording_digest(path: Path) -> Digest:
    """Digests of everything that a recording says, its blueprint included."""
    reader = RrdReader(path)
    digest: dict[str, Digest] = {}
    for store in reader.recordings():
        digest["recording"] = f"{store.application_id} {store.recording_id}"
        digest |= store_digest(reader, store)
    for store in reader.blueprints():
        digest["blueprint"] = store.application_id
        digest |= store_digest(reader, store)
    return digest


def digests(folder: Path) -> dict[str, Digest]:
    """Digests of all files in a folder that are outputs."""
    found: dict[str, Digest] = {}
    for path in sorted(folder.rglob("*")):
        name = path.relative_to(folder).as_posix()
        given = name.startswith("inputs/") and path.name not in ("beside.png", "beside.mp4")
        if path.is_dir() or given or name == "digests.json":
            continue
        readers = {".rrd": recording_digest, ".parquet": parquet_digest}
        read = readers.get(path.suffix)
        found[name] = read(path) if read else sha(path.read_bytes())
    return found


def differences(one: Digest, other: Digest) -> Iterator[str]:
    """Where two digests differ, in words."""
    if isinstance(one, dict) and isinstance(other, dict):
        for key in sorted(one.keys() | other.keys()):
            if key not in one or key not in other:
                yield f"{key}: only {'here' if key in one else 'in the other'}"
            else:
                yield from (
                    f"{key}: {each}".rstrip(": ") for each in differences(one[key], other[key])
                )
    elif one != other:
        yield ""


def explained(name: str, folder: Path, other: Path) -> Iterator[str]:
    """More about a file that is in both folders and differs."""
    ours, theirs = folder / name, other / name
    if ours.suffix in (".txt", ".svg"):
        texts = [path.read_text().splitlines() for path in (theirs, ours)]
        yield from list(difflib.unified_diff(*texts, "other", "here", lineterm=""))[:60]
    elif ours.suffix == ".png":
        one, two = (cv2.imread(str(path), cv2.IMREAD_UNCHANGED) for path in (ours, theirs))
        if one.shape != two.shape:
            yield f"sizes {one.shape} here, {two.shape} in the other"
        else:
            yield f"{int((one != two).any(axis=-1).sum())} of {one[..., 0].size} pixels differ"


def main() -> int:
    """Make the outputs, write the digests, and compare them."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--compare", type=Path, metavar="OTHER_FOLDER")
    given = parser.parse_args()
    folder, began = given.folder.resolve(), time.monotonic()
    if folder.exists() and any(folder.iterdir()) and not (folder / "digests.json").exists():
        parser.error(f"{folder}: is not empty, and not of this script")
    shutil.rmtree(folder, ignore_errors=True)
    make(folder)
    found = digests(folder)
    (folder / "digests.json").write_text(json.dumps(found, indent=1, ensure_ascii=False))
    say = sys.stdout.write
    say(f"{len(found)} files of {Path.cwd()} in {time.monotonic() - began:.0f} s\n")
    if given.compare is None:
        return 0
    wanted = json.loads((given.compare / "digests.json").read_text())
    different = list(differences(found, wanted))
    for line in different:
        say(f"DIFFERS {line}\n")
    for name in sorted(found.keys() & wanted.keys()):
        if found[name] != wanted[name]:
            say("".join(f"{name}: {line}\n" for line in explained(name, folder, given.compare)))
    say(f"{len(different)} differences from {given.compare}\n")
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
