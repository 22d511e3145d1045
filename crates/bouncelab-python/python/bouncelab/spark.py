"""Recordings by the million on Apache Spark; ``pip install bouncelab[spark]``."""
# pyright: reportMissingImports=false

from __future__ import annotations

import itertools
import tempfile
from collections.abc import Iterable, Iterator
from os import fspath
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pyarrow
from pyarrow import parquet
from pyspark import TaskContext
from pyspark.sql import functions
from pyspark.sql.pandas.types import from_arrow_schema, to_arrow_schema
from pyspark.sql.types import StructType

from bouncelab import _core, batch

if TYPE_CHECKING:
    from os import PathLike

    from pyspark.sql import DataFrame, SparkSession

#: What Spark says of a file.
_FILE = "path string, modificationTime timestamp, length long, content binary"


def analyze(
    spark: SparkSession,
    source: str | PathLike[str],
    output: str | PathLike[str],
    checkpoint: str | PathLike[str],
    settings: batch.Settings | None = None,
    *,
    notes: DataFrame | None = None,
    with_content: bool | None = None,
    files_per_trigger: int = 10_000,
    files_per_task: int = 50,
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
    settings : Settings, optional
        As of :func:`bouncelab.batch.kernel`.
    notes : DataFrame, optional
        What was noted: a column ``recording``, the path relative to the source, and others of text.
    with_content : bool, optional
        Whether Spark reads the files, as from an object store, or the kernel, under a path that all workers
        see; unless stated, Spark does where the source is no such path.
    files_per_trigger, files_per_task : int
        At most so many recordings are analysed again after a driver, or the process of a task, was killed.
    """
    root = fspath(source)
    kernel = batch.kernel(settings, root=root)
    globs = sorted({form for ending in _core.endings() for form in (ending, ending.upper())})
    files = spark.readStream.format("binaryFile").schema(_FILE).option("maxFilesPerTrigger", files_per_trigger)
    files = files.option("recursiveFileLookup", True).option("pathGlobFilter", f"*.{{{','.join(globs)}}}")
    if with_content is None:
        with_content = not root.startswith(("/", "file:"))
    # Without the content the plan does not read it.
    given = files.load(root).select("path", *["content"] * with_content)
    if notes is not None:
        start = len(batch.plain(root).rstrip("/")) + 2
        plain = functions.regexp_replace("path", "^file:/+", "/")
        given = given.withColumn("recording", plain.substr(start, 1 << 20)).join(notes, "recording", "left")
    tasks = -(-files_per_trigger // files_per_task)
    rows = given.repartition(tasks).mapInArrow(_Task(kernel), from_arrow_schema(kernel.schema))

    def write(rows: DataFrame, trigger: int) -> None:
        # A trigger that is repeated replaces what it wrote.
        rows.write.mode("overwrite").parquet(f"{fspath(output)}/{trigger:06}")

    query = rows.writeStream.foreachBatch(write).option("checkpointLocation", fspath(checkpoint))
    running = query.trigger(availableNow=True).start()
    running.awaitTermination()
    return sum(progress.numInputRows for progress in running.recentProgress)


class _Task:
    """The kernel, which analyses in child processes where it is tried again."""

    def __init__(self, kernel: batch.Kernel) -> None:
        self._kernel = kernel

    def __call__(self, batches: Iterator[pyarrow.RecordBatch]) -> Iterator[pyarrow.RecordBatch]:
        context = TaskContext.get()
        is_retry = context is not None and context.attemptNumber() > 0
        return (self._kernel.isolated() if is_retry else self._kernel)(batches)


def study(results: DataFrame, by: Iterable[str], *, compare_at_m_s: float) -> DataFrame:
    """Return the mean restitution of each group of drops: that of :func:`bouncelab.batch.study`.

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
    schema = StructType.fromDDL(", ".join([*levels, *(f"{name} double" for name in _MEAN), "no_study string"]))
    return groups.applyInArrow(_Mean(fields, compare_at_m_s, to_arrow_schema(schema)).of, schema)


#: What is said of a group, and where the document of a study has it.
_MEAN = {
    "restitution": lambda group: group["restitution"]["value"],
    "standard_error": lambda group: group["restitution"]["standard_error"],
    "drops": lambda group: group["restitution"]["drops"],
    "between_drops": lambda group: group["restitution"]["between"],
    "between_impacts": lambda group: group["between_impacts"],
    "shared_sd": lambda group: group["shared_sd"],
}


class _Mean:
    """The mean of a group, from its rows."""

    def __init__(self, fields: list[str], compare_at_m_s: float, schema: pyarrow.Schema) -> None:
        self._fields, self._compare_at_m_s, self._schema = fields, compare_at_m_s, schema

    def of(
        self, key: tuple[pyarrow.Scalar, ...], rows: Iterator[pyarrow.RecordBatch]
    ) -> Iterator[pyarrow.RecordBatch]:
        with tempfile.TemporaryDirectory() as folder:
            path, first = Path(folder) / "rows.parquet", next(rows)
            with parquet.ParquetWriter(path, first.schema) as writer:
                for part in itertools.chain([first], rows):
                    writer.write_batch(part)
            document: dict[str, Any] = batch.study(path, compare_at_m_s=self._compare_at_m_s)
        row = dict(zip(self._fields, (level.as_py() for level in key), strict=True))
        row["no_study"], found = document["no_study"], document["study"]
        row |= {name: found and of(found["all"]) for name, of in _MEAN.items()}
        yield pyarrow.RecordBatch.from_pylist([row], self._schema)
