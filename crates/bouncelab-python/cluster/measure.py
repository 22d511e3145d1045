"""Figures for docs/cluster.md; each is a command: `python measure.py FIGURE ...`, from this folder.

spark COUNT [WORKERS]    COUNT recordings on Spark: rows against `session`, files a second, processor time
ray COUNT [WORKERS]      the same on Ray
kernel COUNT             the kernel alone, in one process: files a second, memory
study COUNT              a study of COUNT simulated drops: time and memory
listing COUNT            COUNT simulated paths planned by Spark: memory of the driver
"""

from __future__ import annotations

import os
import resource
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

import psutil
import pyarrow
from clusters import Job, Ray, Spark, cluster
from conftest import PATTERN, differences, listed, names, record
from pyarrow import parquet

from bouncelab import batch
from bouncelab._program import find

SETTINGS: batch.Settings = {"ball": "table-tennis-40", "draws": 1000, "pattern": PATTERN}
TEMPORARY = Path(os.environ.get("TMPDIR", "/tmp")) / "bouncelab-measure"
MB = 1 << 20


class Watch:
    """Processor time of all processes below some, and the most memory of their Python workers."""

    def __init__(self, roots: list[int]) -> None:
        self.roots = roots
        self.times: dict[tuple[int, float], float] = {}
        self.memory: list[tuple[float, float]] = []
        self.stopped = threading.Event()
        self.thread = threading.Thread(target=self._watch)
        self.thread.start()

    def _watch(self) -> None:
        start = time.monotonic()
        while not self.stopped.wait(0.25):
            most = 0.0
            for root in self.roots:
                for process in _family(root):
                    try:
                        times = process.cpu_times()
                        self.times[process.pid, process.create_time()] = times.user + times.system
                        if "python" in process.name() or "ray::" in process.name():
                            most = max(most, process.memory_full_info().uss / MB)
                    except psutil.Error:
                        continue
            self.memory.append((time.monotonic() - start, most))

    def stop(self) -> tuple[float, list[tuple[float, float]]]:
        self.stopped.set()
        self.thread.join()
        return sum(self.times.values()), self.memory


def _family(root: int) -> list[psutil.Process]:
    try:
        process = psutil.Process(root)
        return [process, *process.children(recursive=True)]
    except psutil.Error:
        return []


def engine(kind: type[Spark] | type[Ray], count: int, workers: int = 2) -> None:
    """Rows, speed, processor time and memory, warm."""
    source = record(TEMPORARY / f"recordings-{count}", count)
    given = listed(source) if kind is Ray else source
    with tempfile.TemporaryDirectory(dir=TEMPORARY) as folder, cluster(kind, Path(folder) / "c", workers) as started:
        output = Path(folder) / "results.parquet"
        watch = Watch([process.pid for process in started.processes()])
        start = time.monotonic()
        Job(started, given, output, settings=SETTINGS, faulty=False).finish()
        seconds = time.monotonic() - start
        processors, memory = watch.stop()
        print(f"{kind.__name__}: {len(set(names(output)))} of {count} recordings, {count / seconds:.1f} files/s")
        print(f"processor time of the cluster: {processors:.1f} s, {1000 * processors / count:.1f} ms a recording")
        quarters = [max(used for _, used in memory[i * len(memory) // 4 : (i + 1) * len(memory) // 4]) for i in range(4)]
        print("largest Python worker by quarters of the time, MB:", *(f"{used:.0f}" for used in quarters))
        session = TEMPORARY / f"session-{count}"
        command = [find(), "session", source, "--output", session, "--pattern", PATTERN, "--tables", "parquet"]
        command += ["--ball", SETTINGS["ball"], "--draws", str(SETTINGS["draws"])]
        subprocess.run(command, check=True, capture_output=True)
        cells, different = differences(session, output, Path(folder) / "tables")
        print(f"{cells} cells, {different} differ from those of a session")


def kernel(count: int) -> None:
    """The kernel alone."""
    source = record(TEMPORARY / f"recordings-{count}", count)
    given = parquet.read_table(listed(source), columns=["path"])
    start = time.process_time()
    memory = []
    for part in batch.kernel(SETTINGS, root=source)(given.to_batches()):
        memory.append(psutil.Process().memory_full_info().uss / MB)
        del part
    seconds = time.process_time() - start
    print(f"kernel: {1000 * seconds / count:.1f} ms of processor time a recording")
    print(f"memory: {memory[0]:.0f} MB after 50 recordings, {memory[-1]:.0f} MB after {count}, at most {max(memory):.0f} MB")


def study(count: int) -> None:
    """Simulated rows: the rows of a few recordings, many times under other names, values moved a little."""
    folder = TEMPORARY / f"simulated-{count}.parquet"
    if not folder.exists():
        simulate(folder, count)
    start = time.monotonic()
    document = batch.study(folder)
    most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(f"{document['drops']} drops studied in {time.monotonic() - start:.0f} s with {most:.0f} MB")


def simulate(folder: Path, count: int) -> None:
    import json
    import random

    source = record(TEMPORARY / "recordings-60", 60)
    given = parquet.read_table(listed(source), columns=["path"])
    [rows] = [table.to_pylist() for table in [pyarrow.Table.from_batches(batch.kernel(SETTINGS, root=source)(given.to_batches()))]]
    schema = pyarrow.schema([(name, pyarrow.string()) for name in ("recording", "content_sha256", "settings_sha256", "metadata", "record")])
    schema = schema.append(pyarrow.field("failure", pyarrow.struct([("code", pyarrow.string()), ("message", pyarrow.string())])))
    chance = random.Random(1)
    folder.mkdir(parents=True)
    with parquet.ParquetWriter(folder / "rows.parquet", schema) as writer:
        for start in range(0, count, 5000):
            made = []
            for number in range(start, min(count, start + 5000)):
                row = rows[number % len(rows)]
                record_ = json.loads(row["record"])
                off = chance.gauss(0.0, 0.002)
                for drop in record_["drops"]:
                    for point in drop["posterior"]["curve"]:
                        point["value"] += off
                made.append(
                    {
                        "recording": f"{number:08}.wav",
                        "content_sha256": f"{number:064x}",
                        "record": json.dumps(record_, separators=(",", ":")),
                        **{name: row[name] for name in ("settings_sha256", "metadata", "failure")},
                    }
                )
            writer.write_table(pyarrow.Table.from_pylist(made, schema))


if __name__ == "__main__":
    TEMPORARY.mkdir(exist_ok=True)
    what, *numbers = sys.argv[1:]
    counts = [int(number) for number in numbers]
    {
        "spark": lambda: engine(Spark, *counts),
        "ray": lambda: engine(Ray, *counts),
        "kernel": lambda: kernel(*counts),
        "study": lambda: study(*counts),
    }[what]()
