"""Small clusters on this machine: processes on loopback, started and stopped by the tests."""

from __future__ import annotations

import json
import os
import signal
import socket
import subprocess
import sys
import time
import urllib.request
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import psutil
import pyspark

HERE = Path(__file__).parent
HOST = "127.0.0.1"


def until(state: Callable[[], bool], what: str, *processes: subprocess.Popen[bytes]) -> None:
    """Wait for a state; a minute is long, five are a fault."""
    for _ in range(6000):
        if state():
            return
        for process in processes:
            assert process.poll() in (None, 0), f"{process.args} ended with {process.returncode} before {what}"
        time.sleep(0.05)
    raise AssertionError(f"waited in vain for {what}")


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind((HOST, 0))
        port: int = probe.getsockname()[1]
        return port


def end(process: psutil.Process | subprocess.Popen[bytes], how: int) -> None:
    """End a process and all that it started."""
    try:
        whole = psutil.Process(process.pid)
        family = [whole, *whole.children(recursive=True)]
    except psutil.NoSuchProcess:
        return
    for member in family:
        try:
            member.send_signal(how)
        except psutil.NoSuchProcess:
            continue
    psutil.wait_procs(family, timeout=30)
    if isinstance(process, subprocess.Popen):
        process.wait()


class Spark:
    """A master and workers of Spark standalone, of one core each."""

    def __init__(self, folder: Path, environment: dict[str, str]) -> None:
        self.home = Path(pyspark.__file__).parent
        self.folder = folder
        self.environment = environment | {"SPARK_HOME": str(self.home), "SPARK_LOCAL_IP": HOST}
        self.environment |= {"PYSPARK_PYTHON": sys.executable, "SPARK_LOCAL_DIRS": str(folder / "local")}
        # Short jobs gain nothing from the second compiler.
        self.environment["JAVA_TOOL_OPTIONS"] = "-XX:TieredStopAtLevel=1 -XX:+UseSerialGC"
        self.web = free_port()
        self.url = f"spark://{HOST}:{free_port()}"
        port = self.url.rsplit(":", 1)[1]
        options = ["--host", HOST, "--port", port, "--webui-port", str(self.web)]
        self.master = self._start("master.Master", *options)
        self.workers: list[subprocess.Popen[bytes]] = []

    def _start(self, role: str, *options: str) -> subprocess.Popen[bytes]:
        log = (self.folder / "spark.log").open("ab")
        command = [self.home / "bin" / "spark-class", f"org.apache.spark.deploy.{role}", *options]
        return subprocess.Popen(command, env=self.environment, stdout=log, stderr=log, start_new_session=True)

    def add_worker(self) -> None:
        # A worker that comes before the master leads is not taken, and does not ask again.
        until(lambda: self._status().get("status") == "ALIVE", "the master of Spark", self.master)
        count = self._alive() + 1
        options = ["--host", HOST, "--cores", "1", "--memory", "1g", "--webui-port", "0"]
        options += ["--work-dir", str(self.folder / "work"), self.url]
        self.workers.append(self._start("worker.Worker", *options))
        until(lambda: self._alive() >= count, "a worker of Spark", self.master, self.workers[-1])

    def kill_worker(self) -> None:
        """Kill a worker at once, with what runs in it."""
        end(self.workers.pop(0), signal.SIGKILL)

    def _alive(self) -> int:
        return sum(worker["state"] == "ALIVE" for worker in self._status().get("workers", []))

    def _status(self) -> dict[str, Any]:
        """What the master says of itself; nothing before it answers in JSON: its first page is HTML."""
        try:
            with urllib.request.urlopen(f"http://{HOST}:{self.web}/json/", timeout=5) as answer:
                status: dict[str, Any] = json.load(answer)
                return status
        except (OSError, json.JSONDecodeError):
            return {}

    def processes(self) -> list[subprocess.Popen[bytes]]:
        return [*self.workers, self.master]


class Ray:
    """A head of Ray and nodes, of one processor each."""

    def __init__(self, folder: Path, environment: dict[str, str]) -> None:
        self.folder = folder
        self.environment = environment | {"RAY_USAGE_STATS_ENABLED": "0", "RAY_DISABLE_IMPORT_WARNING": "1"}
        self.port = free_port()
        self.nodes: list[subprocess.Popen[bytes]] = []
        options = ["--head", f"--port={self.port}", "--include-dashboard=false", f"--temp-dir={folder / 'ray'}"]
        self.head = self._start(*options)
        self.url = f"{HOST}:{self.port}"
        # A driver waits for it a few seconds only.
        until(self._answers, "the head of Ray", self.head)

    def _start(self, *options: str) -> subprocess.Popen[bytes]:
        log = (self.folder / "ray.log").open("ab")
        command = [Path(sys.executable).parent / "ray", "start", "--block", "--num-cpus=1", *options]
        command += [f"--node-ip-address={HOST}", "--object-store-memory=100000000", "--disable-usage-stats"]
        # Nodes of one machine would all listen at the same port.
        command += [f"--dashboard-agent-listen-port={free_port()}"]
        return subprocess.Popen(command, env=self.environment, stdout=log, stderr=log, start_new_session=True)

    def _answers(self) -> bool:
        with socket.socket() as probe:
            return probe.connect_ex((HOST, self.port)) == 0

    def add_worker(self) -> None:
        self.nodes.append(self._start(f"--address={self.url}"))

    def kill_worker(self) -> None:
        """Kill a node at once, with what runs in it."""
        end(self.nodes.pop(0), signal.SIGKILL)

    def processes(self) -> list[subprocess.Popen[bytes]]:
        return [*self.nodes, self.head]


@contextmanager
def cluster(kind: type[Spark] | type[Ray], folder: Path, workers: int = 2) -> Iterator[Spark | Ray]:
    """A cluster, which ends with the block."""
    folder.mkdir(parents=True, exist_ok=True)
    path = os.pathsep.join([str(HERE), str(HERE.parent / "tests")])
    started = kind(folder, os.environ | {"PYTHONPATH": path, "BOUNCELAB_WORK": str(folder / "work.log")})
    try:
        # The head of Ray is a worker too.
        for _ in range(workers - (kind is Ray)):
            started.add_worker()
        yield started
    finally:
        for process in started.processes():
            end(process, signal.SIGKILL)


class Job:
    """A driver, as a process of its own."""

    def __init__(self, engine: Spark | Ray, source: Path, output: Path, **options: object) -> None:
        self.output = output
        request = {"engine": type(engine).__name__, "url": engine.url, "source": str(source)}
        request |= {"output": str(output), **options}
        self.log = output.with_suffix(".log")
        with self.log.open("ab") as log:
            command = [sys.executable, HERE / "job.py", json.dumps(request)]
            self.process = subprocess.Popen(
                command, env=engine.environment, stdout=log, stderr=log, start_new_session=True
            )

    def finish(self) -> None:
        assert self.process.wait() == 0, self.log.read_text()[-4000:]

    def kill(self) -> None:
        end(self.process, signal.SIGKILL)

    def until(self, state: Callable[[], bool], what: str) -> None:
        until(state, what, self.process)
