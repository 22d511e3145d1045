"""Spark on a cluster of one master and two workers."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from clusters import Spark, cluster
from faults import faulty
from job import spark_session
from laboratory import RECORDINGS, SETTINGS, alone, differences, failures, names, rows, with_faults, work
from pyspark.sql import SparkSession

from bouncelab import batch
from bouncelab.spark import analyze, study

#: For what is not about numbers.
QUICK: batch.KernelOptions = {"draws": None}

#: All in one trigger, of no more tasks than it needs.
ONCE = 400


@pytest.fixture(scope="module")
def spark(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Spark]:
    with cluster(Spark, tmp_path_factory.mktemp("spark")) as started:
        assert isinstance(started, Spark)
        yield started


@pytest.fixture(scope="module")
def session_of_spark(spark: Spark) -> Iterator[SparkSession]:
    with pytest.MonkeyPatch.context() as patch:
        for name, value in spark.environment.items():
            patch.setenv(name, value)
        session = spark_session(spark.url)
        yield session
        session.stop()


def test_rows_are_those_of_a_session(
    session_of_spark: SparkSession, recordings: Path, session: Path, tmp_path: Path
) -> None:
    output = tmp_path / "results.parquet"
    count = analyze(session_of_spark, recordings, output, tmp_path / "checkpoint", SETTINGS, files_per_trigger=RECORDINGS)
    cells, different = differences(session, output, tmp_path / "tables")
    print(f"Spark: {count} recordings, {cells} cells, {different} differ")
    assert (count, different) == (len(list(recordings.iterdir())), 0)
    assert len(names(output)) == count


def test_rows_depend_on_no_partitioning(session_of_spark: SparkSession, few: Path, tmp_path: Path) -> None:
    found = []
    for trigger, task in [(1000, 1000), (110, 7), (40, 13)]:
        output, checkpoint = tmp_path / f"{trigger}.parquet", tmp_path / f"{trigger}.checkpoint"
        counts = {"files_per_trigger": trigger, "files_per_task": task}
        analyze(session_of_spark, few, output, checkpoint, SETTINGS, **counts)  # type: ignore[arg-type]
        found.append(rows(output))
    assert found[0] == found[1] == found[2] == alone(few)


def test_contents_and_notes_go_along(session_of_spark: SparkSession, few: Path, tmp_path: Path) -> None:
    """As from an object store: the workers get contents, not paths."""
    operators = [(path.name, "Ada" if number % 2 else "Bob") for number, path in enumerate(sorted(few.iterdir()))]
    notes = session_of_spark.createDataFrame(operators, ["recording", "operator"])
    by_path, by_content = tmp_path / "path.parquet", tmp_path / "content.parquet"
    analyze(session_of_spark, few, by_path, tmp_path / "1", SETTINGS, notes=notes, files_per_trigger=ONCE)
    counts = {"with_content": True, "files_per_trigger": ONCE}
    analyze(session_of_spark, few, by_content, tmp_path / "2", SETTINGS, notes=notes, **counts)  # type: ignore[arg-type]
    assert rows(by_content) == rows(by_path)
    fields = ["surface", "operator"]
    means = study(session_of_spark.read.parquet(f"{by_path}/*"), fields, compare_at_m_s=1.5).collect()
    groups = batch.study(by_path, by=fields, compare_at_m_s=1.5)["study"]["groups"]  # type: ignore[index,call-overload]
    together = {tuple(group["levels"][field] for field in fields): group["restitution"] for group in groups}  # type: ignore[union-attr,index,call-overload]
    assert {tuple(row[field] for field in fields) for row in means} == together.keys()
    for row in means:
        restitution = together[tuple(row[field] for field in fields)]
        assert row["restitution"] == pytest.approx(restitution["value"], abs=0.02 * restitution["sd"])
        assert row["restitution_sd"] == pytest.approx(restitution["sd"], rel=0.05)


def test_what_fails_becomes_a_row(
    spark: Spark, session_of_spark: SparkSession, few: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The time limit isolates every recording; without it only the task that is tried again does."""
    monkeypatch.setattr(batch, "kernel", faulty)
    source, broken = with_faults(few, tmp_path / "recordings")
    output = tmp_path / "limited.parquet"
    limited: batch.KernelOptions = {**QUICK, "time_limit_s": 20.0}
    analyze(session_of_spark, source, output, tmp_path / "1", limited, files_per_trigger=ONCE)
    expected = dict.fromkeys(broken, "not-analysed") | {"abort.wav": "process-died"}
    assert failures(output) == expected | {"endless.wav": "out-of-time"}
    assert len(names(output)) == 302
    (source / "endless.wav").unlink()
    retried = tmp_path / "retried.parquet"
    analyze(session_of_spark, source, retried, tmp_path / "2", QUICK, files_per_trigger=ONCE)
    assert failures(retried) == expected
    assert len(names(retried)) == 301


def test_nothing_new_is_nothing_done(
    spark: Spark, session_of_spark: SparkSession, few: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(batch, "kernel", faulty)
    source = tmp_path / "recordings"
    shutil.copytree(few, source, ignore=lambda _, names: sorted(names)[20:])
    output, counts = tmp_path / "results.parquet", []
    for new in (None, None, "new.wav"):
        if new is not None:
            shutil.copy(next(few.iterdir()), source / new)
        before = len(work(spark.folder))
        analyze(session_of_spark, source, output, tmp_path / "checkpoint", QUICK, files_per_trigger=ONCE)
        counts.append(len(work(spark.folder)) - before)
    assert counts == [20, 0, 1] and len(names(output)) == 21
