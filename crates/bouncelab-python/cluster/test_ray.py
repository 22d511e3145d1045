"""Ray on a head and one more node."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from clusters import Job, Ray, cluster
from conftest import SETTINGS, differences, listed, names, rows, work

#: For what is not about numbers.
QUICK = {"draws": None}
BLOCK = 50


@pytest.fixture(scope="module")
def ray(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Ray]:
    with cluster(Ray, tmp_path_factory.mktemp("r")) as started:
        assert isinstance(started, Ray)
        yield started


def test_rows_are_those_of_a_session(ray: Ray, recordings: Path, session: Path, tmp_path: Path) -> None:
    output = tmp_path / "results.parquet"
    Job(ray, listed(recordings), output, settings=SETTINGS, faulty=False).finish()
    cells, different = differences(session, output, tmp_path / "tables")
    count = len(names(output))
    print(f"Ray: {count} recordings, {cells} cells, {different} differ")
    assert (count, different) == (len(list(recordings.iterdir())), 0)


def blocks(output: Path) -> int:
    return len(list(output.glob("*.parquet"))) if output.exists() else 0


def test_a_driver_killed_at_five_moments_loses_nothing(ray: Ray, few: Path, tmp_path: Path) -> None:
    before = len(work(ray.folder))
    output, source = tmp_path / "results.parquet", listed(few)
    for kill in range(5):
        job = Job(ray, source, output, settings=QUICK)
        job.until(lambda kill=kill: blocks(output) > kill, "a block")  # type: ignore[misc]
        job.kill()
    Job(ray, source, output, settings=QUICK).finish()
    check(ray, few, output, before, kills=5)


def test_a_worker_killed_at_five_moments_loses_nothing(ray: Ray, few: Path, tmp_path: Path) -> None:
    before = len(work(ray.folder))
    output, source = tmp_path / "results.parquet", listed(few)
    job = Job(ray, source, output, settings=QUICK)
    for kill in range(5):
        job.until(lambda kill=kill: blocks(output) > kill, "a block")  # type: ignore[misc]
        ray.kill_worker()
        ray.add_worker()
    job.finish()
    check(ray, few, output, before, kills=5)


def check(ray: Ray, source: Path, output: Path, before: int, kills: int) -> None:
    expected = sorted(path.name for path in source.iterdir())
    assert names(output) == expected
    again = len(work(ray.folder)) - before - len(expected)
    print(f"Ray: {kills} kills, 0 lost, 0 double, {again} recordings analysed again")
    assert again <= kills * BLOCK * 2


def test_what_fails_becomes_a_row(ray: Ray, few: Path, tmp_path: Path) -> None:
    source = tmp_path / "recordings"
    shutil.copytree(few, source)
    broken = sorted(source.iterdir())[::100]
    for path in broken:
        path.write_bytes(path.read_bytes()[:30])
    whole = next(few.iterdir())
    for name in ("abort", "endless"):
        shutil.copy(whole, source / f"{name}.wav")
    output = tmp_path / "results.parquet"
    Job(ray, listed(source), output, settings=QUICK | {"time_limit_s": 20.0}).finish()
    failed = {row["recording"]: row["failure"]["code"] for row in rows(output).to_pylist() if row["failure"]}
    expected = {path.name: "not-analysed" for path in broken}
    assert failed == expected | {"abort.wav": "process-died", "endless.wav": "out-of-time"}
    assert len(names(output)) == 302


def test_nothing_new_is_nothing_done(ray: Ray, few: Path, tmp_path: Path) -> None:
    output, source = tmp_path / "results.parquet", listed(few)
    counts = []
    for _ in range(2):
        before = len(work(ray.folder))
        Job(ray, source, output, settings=QUICK).finish()
        counts.append(len(work(ray.folder)) - before)
    assert counts == [300, 0] and len(names(output)) == 300
