"""Spark on a cluster of one master and two workers."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from clusters import Job, Spark, cluster
from conftest import SETTINGS, differences, names, rows, work

from bouncelab import batch

#: For what is not about numbers.
QUICK = {"draws": None}
TRIGGER = 50


@pytest.fixture(scope="module")
def spark(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Spark]:
    with cluster(Spark, tmp_path_factory.mktemp("spark")) as started:
        assert isinstance(started, Spark)
        yield started


def done(job: Job) -> int:
    """How many triggers are done."""
    return sum(path.name.isdigit() for path in (job.checkpoint / "commits").glob("*"))


def begun(job: Job) -> int:
    """How many triggers were begun."""
    return sum(path.name.isdigit() for path in (job.checkpoint / "offsets").glob("*"))


def test_rows_are_those_of_a_session(spark: Spark, recordings: Path, session: Path, tmp_path: Path) -> None:
    output = tmp_path / "results.parquet"
    Job(spark, recordings, output, settings=SETTINGS, faulty=False).finish()
    cells, different = differences(session, output, tmp_path / "tables")
    count = len(names(output))
    print(f"Spark: {count} recordings, {cells} cells, {different} differ")
    assert (count, different) == (len(list(recordings.iterdir())), 0)


def test_rows_depend_on_no_partitioning(spark: Spark, few: Path, tmp_path: Path) -> None:
    found = []
    for trigger, task in [(1000, 1000), (110, 7), (40, 13)]:
        output = tmp_path / f"{trigger}.parquet"
        options = {"files_per_trigger": trigger, "files_per_task": task}
        Job(spark, few, output, settings=SETTINGS, faulty=False, **options).finish()
        found.append(rows(output).combine_chunks())
    assert found[0] == found[1] == found[2]


def test_a_driver_killed_at_five_moments_loses_nothing(spark: Spark, few: Path, tmp_path: Path) -> None:
    before = len(work(spark.folder))
    output = tmp_path / "results.parquet"
    for kill in range(5):
        job = Job(spark, few, output, settings=QUICK, files_per_trigger=TRIGGER, files_per_task=10)
        job.until(lambda job=job, kill=kill: begun(job) > kill, "a trigger")  # type: ignore[misc]
        job.kill()
    Job(spark, few, output, settings=QUICK, files_per_trigger=TRIGGER, files_per_task=10).finish()
    check(spark, few, output, before, kills=5)


def test_a_worker_killed_at_five_moments_loses_nothing(spark: Spark, few: Path, tmp_path: Path) -> None:
    before = len(work(spark.folder))
    output = tmp_path / "results.parquet"
    job = Job(spark, few, output, settings=QUICK, files_per_trigger=TRIGGER, files_per_task=10)
    for kill in range(5):
        job.until(lambda kill=kill: begun(job) > kill, "a trigger")  # type: ignore[misc]
        spark.kill_worker()
        spark.add_worker()
    job.finish()
    check(spark, few, output, before, kills=5)


def check(spark: Spark, source: Path, output: Path, before: int, kills: int) -> None:
    expected = sorted(path.name for path in source.iterdir())
    assert names(output) == expected
    again = len(work(spark.folder)) - before - len(expected)
    print(f"Spark: {kills} kills, 0 lost, 0 double, {again} recordings analysed again")
    assert again <= kills * TRIGGER


def test_what_fails_becomes_a_row(spark: Spark, few: Path, tmp_path: Path) -> None:
    source = tmp_path / "recordings"
    shutil.copytree(few, source)
    broken = sorted(source.iterdir())[::100]
    for path in broken:
        path.write_bytes(path.read_bytes()[:30])
    whole = next(few.iterdir())
    for name in ("abort", "endless"):
        shutil.copy(whole, source / f"{name}.wav")
    output = tmp_path / "results.parquet"
    Job(spark, source, output, settings=QUICK | {"time_limit_s": 20.0}).finish()
    failed = {row["recording"]: row["failure"]["code"] for row in rows(output).to_pylist() if row["failure"]}
    expected = {path.name: "not-analysed" for path in broken}
    assert failed == expected | {"abort.wav": "process-died", "endless.wav": "out-of-time"}
    assert len(names(output)) == 302


def test_a_recording_that_ends_its_process_is_isolated_on_retry(spark: Spark, few: Path, tmp_path: Path) -> None:
    source = tmp_path / "recordings"
    shutil.copytree(few, source, ignore=lambda _, names: sorted(names)[100:])
    shutil.copy(next(few.iterdir()), source / "abort.wav")
    output = tmp_path / "results.parquet"
    Job(spark, source, output, settings=QUICK, files_per_task=20).finish()
    failed = [row["recording"] for row in rows(output).to_pylist() if row["failure"]]
    assert (failed, len(names(output))) == (["abort.wav"], 101)


def test_nothing_new_is_nothing_done(spark: Spark, few: Path, tmp_path: Path) -> None:
    source = tmp_path / "recordings"
    shutil.copytree(few, source, ignore=lambda _, names: sorted(names)[20:])
    output = tmp_path / "results.parquet"
    counts = []
    for new in (None, None, "new.wav"):
        if new is not None:
            shutil.copy(next(few.iterdir()), source / new)
        before = len(work(spark.folder))
        Job(spark, source, output, settings=QUICK).finish()
        counts.append(len(work(spark.folder)) - before)
    assert counts == [20, 0, 1] and len(names(output)) == 21


def test_contents_and_notes_go_along(spark: Spark, few: Path, tmp_path: Path) -> None:
    """As from an object store: the workers get contents, not paths."""
    from pyspark.sql import SparkSession

    from bouncelab.spark import analyze, study

    own = SparkSession.builder.master("local[2,4]").config("spark.ui.enabled", False)
    session = own.config("spark.driver.host", "127.0.0.1").getOrCreate()
    try:
        rows_of_notes = [(path.name, "Ada" if number % 2 else "Bob") for number, path in enumerate(sorted(few.iterdir()))]
        notes = session.createDataFrame(rows_of_notes, ["recording", "operator"])
        by_path, by_content = tmp_path / "path.parquet", tmp_path / "content.parquet"
        assert analyze(session, few, by_path, tmp_path / "1", SETTINGS, notes=notes) == 300
        analyze(session, few, by_content, tmp_path / "2", SETTINGS, notes=notes, with_content=True)
        assert rows(by_content) == rows(by_path)
        means = study(session.read.parquet(f"{by_path}/*"), ["surface", "operator"], compare_at_m_s=1.0)
        found = {(row["surface"], row["operator"]): row["restitution"] for row in means.collect()}
    finally:
        session.stop()
    document = batch.study(by_path, by=["surface", "operator"], compare_at_m_s=1.0)
    groups = document["study"]["groups"]
    expected = {tuple(group["levels"].values())[::-1]: group["restitution"]["value"] for group in groups}
    assert found == expected
