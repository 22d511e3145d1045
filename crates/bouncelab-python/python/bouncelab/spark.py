"""Recordings by the million on Apache Spark; ``pip install bouncelab[spark]``."""
# pyright: reportMissingImports=false

from __future__ import annotations

import json
import uuid
from collections.abc import Iterable
from os import fspath
from typing import TYPE_CHECKING

from bouncelab._errors import imported

imported("pyarrow", "spark")
imported("pyspark", "spark")

from pyspark.errors import AnalysisException
from pyspark.sql import functions

from bouncelab import batch
from bouncelab._data import JSON
from bouncelab._settings import count, texts

if TYPE_CHECKING:
    from os import PathLike

    from pyspark.sql import DataFrame, SparkSession

#: The sums of all parts are merged by this number of tasks, and their results by the driver.
MERGED = 8


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


def study(
    results: DataFrame,
    *,
    by: str | Iterable[str] | None = None,
    compare_at_m_s: float | None = None,
    wanted: float | None = None,
    language: str = "en",
) -> dict[str, JSON]:
    """Compare the drops of rows: the model of :func:`bouncelab.batch.study`, whose sums the workers make.

    Parameters
    ----------
    results : DataFrame
        The rows, as of ``spark.read.parquet(f"{output}/*")``.
    by, compare_at_m_s, wanted
        As of :func:`bouncelab.session`.
    language : str
        Language of the reasons.

    Returns
    -------
    dict
        The document of the schema ``bouncelab.session/3``, without what names single drops: those left out or odd, heights and
        outliers.
    """
    # Of equal contents the first name counts.
    first = results.groupBy("content_sha256").agg(functions.min("recording").alias("recording"))
    rows = results.where("record is not null").join(first, ["content_sha256", "recording"], "left_semi")
    counts = rows.agg(functions.count("*"), functions.sum(functions.size("drops"))).head()
    noted = rows.select(functions.explode("noted")).distinct().collect()
    asked = {
        "noted": sorted((field, level) for field, level in noted),
        "drops": counts[1] or 0,
        "by": None if by is None else texts("by", by),
        "compare_at_m_s": compare_at_m_s,
        "wanted": wanted,
    }
    sums = batch.StudySums(json.dumps(asked))
    parts = rows.select("record", "noted").mapInArrow(sums.add, "sums binary")
    few = parts.repartition(MERGED).mapInArrow(sums.merge, "sums binary").collect()
    document: dict[str, JSON] = json.loads(sums.merged(bytes(row[0]) for row in few).document(counts[0], language))
    return document
