"""Spark on a cluster of one master and two workers."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pyspark
import pytest
from clusters import HERE, Spark, cluster
from faults import faulty, same_groups
from job import CONNECT, spark_session
from laboratory import RECORDINGS, SETTINGS, alone, differences, failures, names, rows, with_faults, work
from pyspark.sql import SparkSession, functions

from bouncelab import InputError, batch
from bouncelab.spark import analyze, study

#: For what is not about numbers.
QUICK: batch.KernelOptions = {"draws": None}


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
    count = analyze(session_of_spark, recordings, output, SETTINGS, files_at_once=RECORDINGS)
    cells, different = differences(session, output, tmp_path / "tables")
    print(f"Spark: {count} recordings, {cells} cells, {different} differ")
    assert (count, different) == (len(list(recordings.iterdir())), 0)
    assert len(names(output)) == count


def test_rows_depend_on_no_partitioning(session_of_spark: SparkSession, few: Path, tmp_path: Path) -> None:
    found = []
    for at_once, per_task in [(1000, 1000), (110, 7), (40, 13)]:
        output = tmp_path / f"{at_once}.parquet"
        analyze(session_of_spark, few, output, SETTINGS, files_at_once=at_once, files_per_task=per_task)
        found.append(rows(output))
    assert found[0] == found[1] == found[2] == alone(few)


def test_contents_and_notes_go_along(session_of_spark: SparkSession, few: Path, tmp_path: Path) -> None:
    """Contents that Spark has read, as from an object store, give the rows of paths."""
    operators = [(path.name, "Ada" if number % 2 else "Bob") for number, path in enumerate(sorted(few.iterdir()))]
    notes = session_of_spark.createDataFrame(operators, "recording string, operator string")
    by_path, by_content = tmp_path / "path.parquet", tmp_path / "content.parquet"
    analyze(session_of_spark, few, by_path, SETTINGS, notes=notes)
    session_of_spark.conf.set("spark.sql.execution.arrow.maxRecordsPerBatch", 10)
    read = session_of_spark.read.format("binaryFile").load(str(few)).select("path", "content")
    named = read.withColumn("recording", functions.substring_index("path", "/", -1))
    batch.analyze_frame(named.join(notes, "recording"), SETTINGS).write.parquet(f"{by_content}/rows")
    assert rows(by_content) == rows(by_path)


def test_the_study_of_workers_is_that_of_one_process(
    session_of_spark: SparkSession, few: Path, tmp_path: Path
) -> None:
    """Sums are added up in another order, so the last digits differ."""
    operators = [(path.name, "Ada" if number % 2 else "Bob") for number, path in enumerate(sorted(few.iterdir()))]
    notes = session_of_spark.createDataFrame(operators, "recording string, operator string")
    by_path = tmp_path / "path.parquet"
    analyze(session_of_spark, few, by_path, SETTINGS, notes=notes)
    for by in (None, ["surface", "operator"]):
        found = study(session_of_spark.read.parquet(f"{by_path}/*"), by=by, compare_at_m_s=1.5)
        expected = batch.study(by_path, by=by, compare_at_m_s=1.5)
        assert found["drops"] == expected["drops"]
        same_groups(found, expected)


@pytest.mark.skipif(pyspark.__version__ < "4", reason="the package of Spark 3.5 has no server of Connect")
def test_rows_over_connect_are_the_same(spark: Spark, few: Path, tmp_path: Path) -> None:
    output = tmp_path / "results.parquet"
    request = {"engine": "Spark", "url": CONNECT, "source": str(few), "output": str(output), "settings": SETTINGS}
    command = [sys.executable, HERE / "job.py", json.dumps(request)]
    for said in ("300", "0"):
        done = subprocess.run(command, env=spark.environment, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr[-4000:]
        assert done.stdout.split()[-1] == said
    assert rows(output) == alone(few)


def test_what_fails_becomes_a_row(
    spark: Spark, session_of_spark: SparkSession, few: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The time limit isolates every recording; without it only the task that is tried again does."""
    monkeypatch.setattr(batch, "kernel", faulty)
    source, broken = with_faults(few, tmp_path / "recordings")
    output = tmp_path / "limited.parquet"
    limited: batch.KernelOptions = {**QUICK, "time_limit_s": 20.0}
    analyze(session_of_spark, source, output, limited)
    expected = dict.fromkeys(broken, "not-analysed") | {"abort.wav": "process-died"}
    assert failures(output) == expected | {"endless.wav": "out-of-time"}
    assert len(names(output)) == len(list(source.iterdir()))
    (source / "endless.wav").unlink()
    retried = tmp_path / "retried.parquet"
    analyze(session_of_spark, source, retried, QUICK)
    assert failures(retried) == expected


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
        said = analyze(session_of_spark, source, output, QUICK)
        counts.append((said, len(work(spark.folder)) - before))
    assert counts == [(20, 20), (0, 0), (1, 1)] and len(names(output)) == 21
    with pytest.raises(InputError, match="rows of other settings"):
        analyze(session_of_spark, source, output, {**QUICK, "ball": "tennis"})
