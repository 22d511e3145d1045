"""Recordings for the tests of clusters, and what is made of the rows."""

from __future__ import annotations

import os
import re
import shutil
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import pyarrow
from pyarrow import parquet

import bouncelab as bl
from bouncelab import batch

PATTERN = "{surface}_{height}_{}"
SETTINGS: batch.KernelOptions = {"ball": "table-tennis-40", "draws": 100, "pattern": PATTERN}

#: The number of recordings that are compared with a session.
RECORDINGS = int(os.environ.get("BOUNCELAB_CLUSTER_RECORDINGS", "2000"))


def _record(path: Path) -> None:
    number = int(path.stem.rsplit("_", 1)[1])
    restitution = {"wood": 0.85, "steel": 0.90, "glass": 0.92}[path.name.split("_")[0]]
    sound = bl.synthesize(
        height_m=0.2 + 0.01 * (number % 10),
        restitution=restitution + 0.0001 * (number % 70),
        bounces=8,
        seed=number,
        sample_rate_hz=22_050,
    )
    sound.save(path)


def record(folder: Path, count: int) -> Path:
    """Synthesise recordings."""
    folder.mkdir(parents=True, exist_ok=True)
    paths = [
        folder / f"{('wood', 'steel', 'glass')[number % 3]}_{20 + number % 10}cm_{number:05}.wav"
        for number in range(count)
    ]
    with ProcessPoolExecutor() as pool:
        list(pool.map(_record, paths, chunksize=50))
    return folder


def listed(source: Path) -> Path:
    """The recordings of a folder, as Ray wants them."""
    path = source.with_suffix(".manifest.parquet")
    batch.manifest(source, path)
    return path


def rows(output: Path) -> bytes:
    """The rows of an engine, sorted, byte for byte."""
    return _bytes(_table(output))


def _table(output: Path) -> pyarrow.Table:
    # What a killed driver has not committed lies in a folder with an underscore.
    files = [path for path in output.rglob("*.parquet") if not re.search(r"/[._]", str(path.relative_to(output.parent)))]
    found = pyarrow.concat_tables(parquet.read_table(path) for path in files)
    # Engines have names of their own for what lists hold.
    return found.cast(batch.kernel().schema).sort_by("recording")


def names(output: Path) -> list[str]:
    return _table(output)["recording"].to_pylist()


def with_faults(few: Path, source: Path) -> tuple[Path, list[str]]:
    """Recordings of which 1 % are damaged, one of them empty, one ends its process, and one never ends."""
    shutil.copytree(few, source)
    broken = sorted(source.iterdir())[::100]
    for path in broken:
        path.write_bytes(path.read_bytes()[: 0 if path == broken[0] else 30])
    for name in ("abort", "endless"):
        shutil.copy(next(few.iterdir()), source / f"{name}.wav")
    return source, [path.name for path in broken]


def failures(output: Path) -> dict[str, str]:
    return {row["recording"]: row["failure"]["code"] for row in _table(output).to_pylist() if row["failure"]}


def alone(source: Path) -> bytes:
    """The rows of the kernel without an engine, sorted, byte for byte."""
    kernel = batch.kernel(SETTINGS, root=source)
    given = parquet.read_table(listed(source), columns=["path"])
    return _bytes(pyarrow.Table.from_batches(kernel(given.to_batches()), kernel.schema).sort_by("recording"))


def _bytes(table: pyarrow.Table) -> bytes:
    stream = pyarrow.BufferOutputStream()
    with pyarrow.ipc.new_stream(stream, table.schema) as writer:
        writer.write_table(table.combine_chunks())
    content: bytes = stream.getvalue().to_pybytes()
    return content


def differences(session: Path, results: Path, folder: Path) -> tuple[int, int]:
    """How many cells of the tables there are, and how many of them differ."""
    batch.explode(results, folder)
    cells = different = 0
    for table in ("drops", "impacts"):
        keys = ["recording", "drop", "number"] if table == "impacts" else ["recording", "drop"]
        expected, found = (
            parquet.read_table(place / f"{table}.parquet").sort_by([(key, "ascending") for key in keys])
            for place in (session, folder)
        )
        assert found.schema == expected.schema and len(found) == len(expected)
        cells += expected.num_rows * expected.num_columns
        for name in expected.column_names:
            pairs = zip(found[name].to_pylist(), expected[name].to_pylist(), strict=True)
            different += sum(one != other for one, other in pairs)
    return cells, different


def work(folder: Path) -> list[str]:
    """The recordings that a cluster analysed, one line each."""
    path = folder / "work.log"
    return path.read_text().splitlines() if path.exists() else []
