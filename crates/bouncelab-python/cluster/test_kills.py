"""Drivers and workers that are killed at five moments, and what is lost: nothing."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from clusters import Job, Ray, Spark, cluster
from laboratory import listed, names, work

#: The number of recordings of a write, or of a block of each worker, that may be analysed again.
AGAIN = {Spark: 50, Ray: 2 * 50}

#: The number of recordings that were analysed since the driver was started, when the driver or a worker is killed.
OF_DRIVERS = (1, 20, 45, 60, 90)
OF_WORKERS = (1, 60, 120, 170, 230)


@pytest.fixture(scope="module", params=[Spark, Ray])
def engine(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Spark | Ray]:
    # The sockets of Ray take a short path.
    with cluster(request.param, tmp_path_factory.mktemp("c")) as started:
        yield started


class Work:
    """A job of three hundred recordings, in writes or blocks of fifty."""

    def __init__(self, engine: Spark | Ray, source: Path, folder: Path) -> None:
        self.engine, self.source, self.output = engine, source, folder / "results.parquet"
        self.given = source if isinstance(engine, Spark) else listed(source)
        self.counts = {"files_at_once": 50, "files_per_task": 10} if isinstance(engine, Spark) else {}
        self.before = len(work(engine.folder))

    def start(self) -> Job:
        self.started = len(work(self.engine.folder))
        return Job(self.engine, self.given, self.output, settings={"draws": None}, **self.counts)

    def until(self, job: Job, count: int) -> None:
        """Wait until ``count`` recordings were analysed since the driver was started."""
        job.until(lambda: len(work(self.engine.folder)) >= self.started + count, f"{count} recordings")

    def check(self) -> None:
        expected = sorted(path.name for path in self.source.iterdir())
        assert names(self.output) == expected
        again = len(work(self.engine.folder)) - self.before - len(expected)
        print(f"{type(self.engine).__name__}: 5 kills, 0 lost, 0 double, {again} recordings analysed again")
        assert again <= 5 * AGAIN[type(self.engine)]


def test_a_driver_killed_at_five_moments_loses_nothing(engine: Spark | Ray, few: Path, tmp_path: Path) -> None:
    work = Work(engine, few, tmp_path)
    for moment in OF_DRIVERS:
        job = work.start()
        work.until(job, moment)
        job.kill()
    work.start().finish()
    work.check()


def test_a_worker_killed_at_five_moments_loses_nothing(engine: Spark | Ray, few: Path, tmp_path: Path) -> None:
    work = Work(engine, few, tmp_path)
    job = work.start()
    for moment in OF_WORKERS:
        work.until(job, moment)
        engine.kill_worker()
        engine.add_worker()
    job.finish()
    work.check()
