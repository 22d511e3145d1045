"""Drivers and workers that are killed at five moments, and what is lost: nothing."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from clusters import Job, Ray, Spark, cluster
from laboratory import listed, names, work

#: So many recordings of a trigger, or of a block of each worker, may be analysed again.
AGAIN = {Spark: 50, Ray: 2 * 50}
KILLS = 5


@pytest.fixture(scope="module", params=[Spark, Ray])
def engine(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Spark | Ray]:
    # The sockets of Ray take a short path.
    with cluster(request.param, tmp_path_factory.mktemp("c")) as started:
        yield started


class Work:
    """A job of three hundred recordings, in triggers or blocks of fifty."""

    def __init__(self, engine: Spark | Ray, source: Path, folder: Path) -> None:
        self.engine, self.source, self.output = engine, source, folder / "results.parquet"
        self.given = source if isinstance(engine, Spark) else listed(source)
        self.counts = {"files_per_trigger": 50, "files_per_task": 10} if isinstance(engine, Spark) else {}
        self.before = len(work(engine.folder))

    def start(self) -> Job:
        return Job(self.engine, self.given, self.output, settings={"draws": None}, **self.counts)

    def begun(self) -> int:
        """How many triggers were begun, or blocks written."""
        if isinstance(self.engine, Ray):
            return len(list(self.output.glob("*.parquet")))
        return sum(path.name.isdigit() for path in self.output.with_suffix(".checkpoint").glob("offsets/*"))

    def check(self) -> None:
        expected = sorted(path.name for path in self.source.iterdir())
        assert names(self.output) == expected
        again = len(work(self.engine.folder)) - self.before - len(expected)
        print(f"{type(self.engine).__name__}: {KILLS} kills, 0 lost, 0 double, {again} recordings analysed again")
        assert again <= KILLS * AGAIN[type(self.engine)]


def test_a_driver_killed_at_five_moments_loses_nothing(engine: Spark | Ray, few: Path, tmp_path: Path) -> None:
    work = Work(engine, few, tmp_path)
    for kill in range(KILLS):
        job = work.start()
        job.until(lambda kill=kill: work.begun() > kill, "a trigger")  # type: ignore[misc]
        job.kill()
    work.start().finish()
    work.check()


def test_a_worker_killed_at_five_moments_loses_nothing(engine: Spark | Ray, few: Path, tmp_path: Path) -> None:
    work = Work(engine, few, tmp_path)
    job = work.start()
    for kill in range(KILLS):
        job.until(lambda kill=kill: work.begun() > kill, "a trigger")  # type: ignore[misc]
        engine.kill_worker()
        engine.add_worker()
    job.finish()
    work.check()
