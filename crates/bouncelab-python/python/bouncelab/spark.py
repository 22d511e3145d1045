"""Recordings by the million on Apache Spark; ``pip install bouncelab[spark]``."""
# pyright: reportMissingImports=false

from __future__ import annotations

import uuid
from collections.abc import Iterable, Iterator
from os import fspath
from typing import TYPE_CHECKING

from bouncelab._errors import imported

imported("pyarrow", "spark")
imported("pyspark", "spark")

import pyarrow
from pyspark.errors import AnalysisException
from pyspark.sql import functions
from pyspark.sql.pandas.types import from_arrow_schema

from bouncelab import batch
from bouncelab._settings import count

if TYPE_CHECKING:
    from os import PathLike

    from pyspark.sql import DataFrame, SparkSession


def analyze(
    spark: SparkSession,
    source: str | PathLike[str],
    output: str | PathLike[str],
    settings: batch.KernelOptions | None = None,
    *,
    notes: DataFrame | None = None,
    files_at_once: int = 10_000,
    files_per_task: int = 200,
) -> int:
    """Analyse the recordings of a folder that have no row yet, each exactly once; return how many.

    It lists them, and writes what :func:`bouncelab.batch.analyze_frame` makes of them. A recording that ends its process
    becomes a row: a task that is tried again analyses in child processes.

    Parameters
    ----------
    spark : SparkSession
        The cluster, perhaps over Spark Connect. It must try tasks again (``local[2,4]``, not ``local[2]``).
    source : path
        Folder of recordings, which this process and all workers see, or a URL that fsspec opens. New files may be
        added, old ones not be changed.
    output : path
        Folder for the rows as Parquet, with a folder for each write, wherever Spark writes. It belongs to one source and
        one kernel.
    settings : KernelOptions, optional
        As of :func:`bouncelab.batch.kernel`.
    notes : DataFrame, optional
        What was noted: a column ``recording``, the path relative to the source, and others of text.
    files_at_once, files_per_task : int
        At most this number of recordings is analysed again after a driver, or the process of a task, was killed.

    Raises
    ------
    InputError
        If the output has rows of other settings or of another version; and what :func:`bouncelab.batch.kernel` raises.
    """
    at_once, per_task = (
        max(count(name, number), 1)
        for name, number in (("files_at_once", files_at_once), ("files_per_task", files_per_task))
    )
    done = _done(spark, batch.kernel(settings), fspath(output))
    left = sorted(given for given in batch.recordings_in(fspath(source)).items() if given[0] not in done)
    for start in range(0, len(left), at_once):
        part = left[start : start + at_once]
        given = spark.createDataFrame(part, "recording string, path string")
        if notes is not None:
            given = given.join(notes, "recording", "left")
        given = given.repartition(-(-len(part) // per_task))
        # What a killed driver left in its folder must not be committed by another.
        batch.analyze_frame(given, settings).write.parquet(f"{fspath(output)}/{uuid.uuid4().hex}")
    return len(left)


def _done(spark: SparkSession, kernel: batch.Kernel, output: str) -> set[str]:
    """Return the names of the recordings that have a row of this kernel; refuse rows of another one."""
    try:
        written = spark.read.schema("recording string, kernel_sha256 string").option("recursiveFileLookup", True)
        rows = written.parquet(output).distinct().collect()
    except AnalysisException as reason:
        if "PATH_NOT_FOUND" not in str(reason):
            raise
        return set()
    kernel.refuse_rows_of_others((row["kernel_sha256"] for row in rows), output)
    return {row["recording"] for row in rows}


def study(results: DataFrame, by: Iterable[str], *, compare_at_m_s: float) -> DataFrame:
    """Return the restitution of each group of drops, by the drops of this group alone; Spark 4.1 or later.

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
    types = dict.fromkeys(fields, pyarrow.string()) | dict.fromkeys(batch.MEAN, pyarrow.float64())
    schema = pyarrow.schema(types | {"no_study": pyarrow.string()})

    def mean(
        key: tuple[pyarrow.Scalar, ...], rows: Iterator[pyarrow.RecordBatch]
    ) -> Iterator[pyarrow.RecordBatch]:
        known = dict(zip(fields, (level.as_py() for level in key), strict=True))
        yield pyarrow.RecordBatch.from_pylist([known | batch.mean(rows, compare_at_m_s)], schema)

    return groups.applyInArrow(mean, from_arrow_schema(schema))
