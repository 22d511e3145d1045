"""Recordings by the million on Apache Spark; ``pip install bouncelab[spark]``."""
# pyright: reportMissingImports=false

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from os import fspath
from typing import TYPE_CHECKING

from bouncelab._errors import imported

imported("pyarrow", "spark")
imported("pyspark", "spark")

import pyarrow
from pyspark import TaskContext
from pyspark.sql import functions
from pyspark.sql.pandas.types import from_arrow_schema, to_arrow_schema
from pyspark.sql.types import StructType

from bouncelab import _core, batch

if TYPE_CHECKING:
    from os import PathLike

    from pyspark.sql import DataFrame, SparkSession


def analyze(
    spark: SparkSession,
    source: str | PathLike[str],
    output: str | PathLike[str],
    checkpoint: str | PathLike[str],
    settings: batch.KernelOptions | None = None,
    *,
    notes: DataFrame | None = None,
    with_content: bool | None = None,
    files_per_trigger: int = 10_000,
    files_per_task: int = 200,
) -> int:
    """Analyse the recordings of a folder that were not analysed yet, each exactly once; return how many.

    A recording that ends its process becomes a row: a task that is tried again analyses in child processes.

    Parameters
    ----------
    spark : SparkSession
        The cluster. It must try tasks again (``local[2,4]``, not ``local[2]``).
    source : path
        Folder of recordings, of any kind that Spark reads. New files may be added, old ones not be changed.
    output : path
        Folder for the rows as Parquet, with a folder for each trigger. It and the checkpoint belong to one
        source and one kernel: other settings, or another version of bouncelab, need others.
    checkpoint : path
        Folder in which Spark keeps what was done.
    settings : KernelOptions, optional
        As of :func:`bouncelab.batch.kernel`.
    notes : DataFrame, optional
        What was noted: a column ``recording``, the path relative to the source, and others of text.
    with_content : bool, optional
        Whether Spark reads the files, as from an object store, or the kernel, under a path that all workers
        see; unless stated, Spark does where the source is no such path.
    files_per_trigger, files_per_task : int
        At most this number of recordings is analysed again after a driver, or the process of a task, was killed.
    """
    root = fspath(source)
    kernel = batch.kernel(settings, root=root)
    globs = sorted({form for ending in _core.endings() for form in (ending, ending.upper())})
    files = spark.readStream.format("binaryFile").option("maxFilesPerTrigger", files_per_trigger)
    files = files.schema("path string, modificationTime timestamp, length long, content binary")
    files = files.option("recursiveFileLookup", True).option("pathGlobFilter", f"*.{{{','.join(globs)}}}")
    # Without the content the plan does not read it.
    reads = not root.startswith(("/", "file:")) if with_content is None else with_content
    given = files.load(root).select("path", *["content"] * reads)
    if notes is not None:
        start = len(batch.plain(root).rstrip("/")) + 2
        plain = functions.regexp_replace("path", "^file:/+", "/")
        given = given.withColumn("recording", plain.substr(start, 1 << 20)).join(notes, "recording", "left")
        given = given.repartition(-(-files_per_trigger // files_per_task))  # a join leaves as many as it likes
    rows = given.mapInArrow(_Task(kernel), from_arrow_schema(kernel.schema))

    def write(rows: DataFrame, trigger: int) -> None:
        # A trigger that is repeated replaces what it wrote.
        rows.write.mode("overwrite").parquet(f"{fspath(output)}/{trigger:06}")

    query = rows.writeStream.foreachBatch(write).option("checkpointLocation", fspath(checkpoint))
    with _configured(spark, files_per_task):
        running = query.trigger(availableNow=True).start()
        running.awaitTermination()
    return sum(progress.numInputRows for progress in running.recentProgress)


@contextmanager
def _configured(spark: SparkSession, files_per_task: int) -> Iterator[None]:
    """Say how a stream lists files, divides them (long ones count for several), takes contents and counts triggers."""
    file_bytes = 1 << 26  # added to the length of each: a minute of sound, and what each costs anyway
    options = {
        "sources.parallelPartitionDiscovery.parallelism": spark.sparkContext.defaultParallelism,
        "files.openCostInBytes": file_bytes,
        "files.maxPartitionBytes": file_bytes * files_per_task,
        "execution.arrow.maxRecordsPerBatch": 10,
        "streaming.numRecentProgressUpdates": 1 << 20,
    }
    before = {option: spark.conf.get(f"spark.sql.{option}") for option in options}
    for option, value in options.items():
        spark.conf.set(f"spark.sql.{option}", value)
    try:
        yield
    finally:
        for option, value in before.items():
            spark.conf.set(f"spark.sql.{option}", value)


class _Task:
    """The kernel, which analyses in child processes where it is tried again."""

    def __init__(self, kernel: batch.Kernel) -> None:
        self._kernel = kernel

    def __call__(self, batches: Iterator[pyarrow.RecordBatch]) -> Iterator[pyarrow.RecordBatch]:
        context = TaskContext.get()
        is_retry = context is not None and context.attemptNumber() > 0
        return (self._kernel.isolated() if is_retry else self._kernel)(batches)


def study(results: DataFrame, by: Iterable[str], *, compare_at_m_s: float) -> DataFrame:
    """Return the restitution of each group of drops, by the drops of this group alone.

    :func:`bouncelab.batch.study` fits all groups as one model, in which they share balls and operators. The
    restitutions of the two differ by little of their uncertainty.

    Parameters
    ----------
    results : DataFrame
        The rows, as of ``spark.read.parquet(f"{output}/*")``.
    by : iterable of str
        What makes groups, as it was noted.
    compare_at_m_s : float
        Impact speed at which drops are compared.
    """
    fields = list(by)
    # Of equal contents the first name counts.
    first = results.groupBy("content_sha256").agg(functions.min("recording").alias("recording"))
    rows = results.where("record is not null").join(first, ["content_sha256", "recording"], "left_semi")
    groups = rows.groupBy(*(rows["noted"][field].alias(field) for field in fields))
    levels = [f"`{field}` string" for field in fields]
    means = [f"{name} double" for name in batch.MEAN]
    schema = StructType.fromDDL(", ".join([*levels, *means, "no_study string"]))
    arrow = to_arrow_schema(schema)

    def mean(
        key: tuple[pyarrow.Scalar, ...], rows: Iterator[pyarrow.RecordBatch]
    ) -> Iterator[pyarrow.RecordBatch]:
        known = dict(zip(fields, (level.as_py() for level in key), strict=True))
        yield pyarrow.RecordBatch.from_pylist([known | batch.mean(rows, compare_at_m_s)], arrow)

    return groups.applyInArrow(mean, schema)
