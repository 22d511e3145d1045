"""Figures for docs/cluster.md; each is a command: `python measure.py FIGURE ...`, from this folder.

spark COUNT [WORKERS]    COUNT recordings on Spark: rows against `session`, files a second, processor time, that of
                         the kernel alone in as many processes, before and after
ray COUNT [WORKERS]      the same on Ray
kernel COUNT             the kernel alone, in one process: files a second, memory
study COUNT              a study of COUNT simulated drops: time and memory
listing COUNT            COUNT files without content planned by Spark, one write: memory of the driver
manifest COUNT           COUNT paths planned by Ray, until the first rows are written: memory of the driver
"""

from __future__ import annotations

import contextlib
import json
import os
import random
import resource
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path
from statistics import fmean

import psutil
import pyarrow
from clusters import Job, Ray, Spark, cluster
from job import spark_session
from laboratory import PATTERN, differences, listed, record
from pyarrow import parquet

from bouncelab import batch

SETTINGS: batch.KernelOptions = {"ball": "table-tennis-40", "draws": 1000, "pattern": PATTERN}
TEMPORARY = Path(os.environ.get("TMPDIR", "/tmp")) / "bouncelab-measure"
MB = 1 << 20


class Watch:
    """Processor time of this process and all below it, and the most memory of a Python worker with its child."""

    def __init__(self) -> None:
        self.before: dict[tuple[int, float], float] = {}
        self.times: dict[tuple[int, float], float] = {}
        self.roles: dict[tuple[int, float], str] = {}
        self.memory: list[float] = []
        self.looking = 0.0
        self.own = time.process_time()
        self._look(self.before)
        self.stopped = threading.Event()
        self.thread = threading.Thread(target=self._watch)
        self.thread.start()

    def _look(self, times: dict[tuple[int, float], float]) -> None:
        of_workers = {0: 0.0}
        for process in psutil.Process().children(recursive=True):
            with contextlib.suppress(psutil.Error):
                key, role, used = (process.pid, process.create_time()), _role(process), process.cpu_times()
                self.roles[key], times[key] = role, used.user + used.system
                if role.startswith(("worker", "child", "pyspark")):
                    worker = process.ppid() if role.startswith("child") else process.pid
                    of_workers[worker] = of_workers.get(worker, 0.0) + process.memory_full_info().uss / MB
        self.memory.append(max(of_workers.values()))

    def _watch(self) -> None:
        while not self.stopped.wait(0.25):
            self._look(self.times)
        self.looking = time.thread_time()

    def stop(self) -> tuple[dict[str, float], list[float]]:
        """Processor time by role, and memory by time."""
        self.stopped.set()
        self.thread.join()
        # To watch is no part of what is watched.
        by_role = {"driver": time.process_time() - self.own - self.looking}
        for process, used in self.times.items():
            role = self.roles[process]
            by_role[role] = by_role.get(role, 0.0) + used - self.before.get(process, 0.0)
        return by_role, self.memory


def _role(process: psutil.Process) -> str:
    """What a process is for: a worker, its child, or the program, script or class that it runs."""
    words = " ".join(process.cmdline()).split()
    if process.name().startswith("ray::"):
        return "worker"
    if "bouncelab._isolated" in words:
        return "child of a worker"
    if process.name() == "java":
        return next((word.rsplit(".", 1)[1] for word in words if word.startswith("org.apache.spark.")), "java")
    if process.name().startswith("python"):
        scripts = (Path(word).name for word in words if word.endswith(".py") or word.startswith("pyspark."))
        return next(scripts, process.name())
    return process.name()


def _family(root: int) -> list[psutil.Process]:
    try:
        process = psutil.Process(root)
        return [process, *process.children(recursive=True)]
    except psutil.Error:
        return []


def engine(kind: type[Spark] | type[Ray], count: int, workers: int = 2) -> None:
    """Rows, speed, processor time and memory, after as many recordings as warm everything up."""
    source, warm = record(TEMPORARY / f"recordings-{count}", count), record(TEMPORARY / "recordings-100", 100)
    with tempfile.TemporaryDirectory(dir=TEMPORARY) as name, cluster(kind, Path(name) / "c", workers) as started:
        folder = Path(name)
        os.environ.update(started.environment)
        analyze = _analyze(started)
        analyze(warm, folder / "warm.parquet")
        alone = [_alone(source, workers)]
        watch, start = Watch(), time.monotonic()
        analyze(source, folder / "results.parquet")
        seconds = time.monotonic() - start
        by_role, memory = watch.stop()
        alone.append(_alone(source, workers))
        processors = sum(by_role.values())
        print(f"{kind.__name__}, {workers} workers: {count} recordings, {count / seconds:.1f} files/s")
        print(f"processor time of cluster and driver: {processors:.1f} s, {1000 * processors / count:.1f} ms a recording")
        print(f"the kernel alone: {alone[0]:.1f} ms before, {alone[1]:.1f} ms after;", end=" ")
        print(f"the engine adds {100 * (1000 * processors / count / fmean(alone) - 1):.1f} %")
        for role, used in sorted(by_role.items(), key=lambda item: -item[1]):
            print(f"  {role}: {1000 * used / count:.2f} ms")
        quarters = [max(memory[i * len(memory) // 4 : (i + 1) * len(memory) // 4]) for i in range(4)]
        print("largest Python worker by quarters of the time, MB:", *(f"{used:.0f}" for used in quarters))
        cells, different = differences(_session(source), folder / "results.parquet", folder / "tables")
        print(f"{cells} cells, {different} differ from those of a session")


def _analyze(started: Spark | Ray) -> Callable[[Path, Path], None]:
    """One driver for several runs."""
    if isinstance(started, Ray):
        import ray as engine_of_ray

        from bouncelab import ray

        engine_of_ray.init(address=started.url, log_to_driver=False)
        return lambda source, output: ray.analyze(listed(source), output, SETTINGS)
    from bouncelab import spark

    session = spark_session(started.url)
    return lambda source, output: print(spark.analyze(session, source, output, SETTINGS), "analysed")


def _session(source: Path) -> Path:
    """The tables of `bouncelab session`, made once."""
    folder = source.with_name(source.name.replace("recordings", "session"))
    command = [sys.executable, "-m", "bouncelab", "session", source, "--output", folder, "--pattern", PATTERN, "--tables", "parquet"]
    command += ["--ball", SETTINGS["ball"], "--draws", str(SETTINGS["draws"])]
    subprocess.run(command, check=True, capture_output=True)
    return folder


def _alone(source: Path, workers: int) -> float:
    """Processor time of the kernel alone for each of at most 2,000 of the recordings, in ms."""
    given = parquet.read_table(listed(source), columns=["path"])
    chosen = range(0, given.num_rows, -(-given.num_rows // 2000))
    parts = [given.take(list(chosen[first::workers])) for first in range(workers)]
    with ProcessPoolExecutor(workers, get_context("spawn")) as pool:
        seconds = sum(pool.map(_analyzed, [source] * workers, parts))
    return 1000 * seconds / len(chosen)


def _analyzed(source: Path, given: pyarrow.Table, memory: list[float] | None = None) -> float:
    """Analyse recordings with the kernel alone; return the processor time, in s."""
    start = time.process_time()
    for part in batch.kernel(SETTINGS, root=source)(given.to_batches()):
        if memory is not None:
            memory.append(psutil.Process().memory_full_info().uss / MB)
        del part
    return time.process_time() - start


def kernel(count: int) -> None:
    """The kernel alone."""
    source = record(TEMPORARY / f"recordings-{count}", count)
    memory: list[float] = []
    seconds = _analyzed(source, parquet.read_table(listed(source), columns=["path"]), memory)
    print(f"kernel: {1000 * seconds / count:.1f} ms of processor time a recording")
    print(f"memory: {memory[0]:.0f} MB after 50 recordings, {memory[-1]:.0f} MB after {count}, at most {max(memory):.0f} MB")


def study(count: int) -> None:
    """A study of simulated rows."""
    folder = TEMPORARY / f"simulated-{count}.parquet"
    if not folder.exists():
        simulate(folder, count)
    start = time.monotonic()
    document = batch.study(folder)
    most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(f"{document['drops']} drops studied in {time.monotonic() - start:.0f} s with {most:.0f} MB")


def simulate(folder: Path, count: int) -> None:
    """Rows of sixty drops whose restitution is moved by a hundred random amounts, under names of their own."""
    chance = random.Random(1)
    source = record(TEMPORARY / "recordings-60", 60)
    given = parquet.read_table(listed(source), columns=["path"])
    rows = pyarrow.Table.from_batches(batch.kernel(SETTINGS, root=source)(given.to_batches()))
    templates = [row for row in rows.to_pylist() if row["drops"]]
    records = []
    for place in range(100 * len(templates)):
        moved, off = json.loads(templates[place % len(templates)]["record"]), chance.gauss(0.0, 0.002)
        # A reading is a sum of ln e at some speeds with weights.
        for reading in (it for drop in moved["drops"] for it in drop["posterior"]["evidence"]["readings"]):
            reading["value"] += off * sum(reading["weights"])
        records.append(json.dumps(moved, separators=(",", ":")))
    same = ["kernel_sha256", "settings_sha256", "metadata", "failure"]
    schema = pyarrow.schema(rows.schema.field(name) for name in ["recording", "content_sha256", "record", *same])
    folder.mkdir(parents=True)
    with parquet.ParquetWriter(folder / "rows.parquet", schema) as writer:
        for start in range(0, count, 10_000):
            numbers = range(start, min(count, start + 10_000))
            chosen = [chance.randrange(len(records)) for _ in numbers]
            columns = {
                "recording": [f"{number:08}.wav" for number in numbers],
                "content_sha256": [f"{number:064x}" for number in numbers],
                "record": [records[place] for place in chosen],
            }
            columns |= {name: [templates[place % len(templates)][name] for place in chosen] for name in same}
            writer.write_table(pyarrow.table(columns, schema))


def listing(count: int) -> None:
    """The files hold nothing, so almost only what the driver does is measured."""
    source = TEMPORARY / f"listing-{count}"
    for number in range(count):
        path = source / f"{number // 1000:04}" / f"{number:07}.wav"
        if number % 1000 == 0:
            path.parent.mkdir(parents=True, exist_ok=True)
        path.touch()
    _plan(Spark, source, lambda job: any(job.output.glob("*/_SUCCESS")), "the first rows of 10,000 recordings")


def manifest(count: int) -> None:
    """The same for Ray, which reads all paths from a manifest."""
    source = TEMPORARY / f"listing-{count}.parquet"
    names = [f"{number // 1000:04}/{number:07}.wav" for number in range(count)]
    parquet.write_table(pyarrow.table({"path": [f"/nowhere/{name}" for name in names], "recording": names}), source)
    _plan(Ray, source, lambda job: any(job.output.glob("*.parquet")), "the first rows")


def _plan(kind: type[Spark] | type[Ray], source: Path, is_planned: Callable[[Job], bool], what: str) -> None:
    """Memory of a driver until its cluster has done a first part of its work."""
    with tempfile.TemporaryDirectory(dir=TEMPORARY) as folder, cluster(kind, Path(folder) / "c") as started:
        job = Job(started, source, Path(folder) / "results.parquet", settings=SETTINGS, faulty=False)
        most = 0.0

        def is_done() -> bool:
            nonlocal most
            for process in _family(job.process.pid):
                with contextlib.suppress(psutil.Error):
                    most = max(most, process.memory_info().rss / MB)
            return is_planned(job)

        start = time.monotonic()
        job.until(is_done, what)
        job.kill()
        print(f"{what} are there after {time.monotonic() - start:.0f} s; driver: at most {most:.0f} MB")


if __name__ == "__main__":
    TEMPORARY.mkdir(exist_ok=True)
    what, *numbers = sys.argv[1:]
    counts = [int(number) for number in numbers]
    {
        "spark": lambda: engine(Spark, *counts),
        "ray": lambda: engine(Ray, *counts),
        "kernel": lambda: kernel(*counts),
        "listing": lambda: listing(*counts),
        "manifest": lambda: manifest(*counts),
        "study": lambda: study(*counts),
    }[what]()
