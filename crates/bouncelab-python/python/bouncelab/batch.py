"""Recordings by the million: one kernel for every engine.

A :class:`Kernel` takes batches of recordings and gives batches of rows, one for each recording. An engine such as
Spark (:func:`analyze_frame`, :mod:`bouncelab.spark`) or Ray (:mod:`bouncelab.ray`) spreads them over a cluster and writes
them as Parquet; :func:`explode` and :func:`study` read that. It takes pyarrow.
"""
# pyright: reportMissingImports=false

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from os import PathLike, fspath
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, cast

from bouncelab import _core
from bouncelab._errors import BouncelabError, InputError, RecordingNotFoundError, imported
from bouncelab._isolated import Outcome, child_process
from bouncelab._paths import fetched, files_at, is_url
from bouncelab._settings import (
    Options,
    flag,
    number,
    refuse_options_of_one_recording,
    settings_of,
    text,
    texts,
)

if TYPE_CHECKING:
    import pandas
    import pyarrow
    from pyspark.sql import DataFrame

    from bouncelab._data import JSON

__all__ = ["Kernel", "KernelOptions", "StudySums", "analyze_frame", "explode", "kernel", "manifest", "study"]

#: Number of rows in a batch: a megabyte or two.
ROWS_AT_ONCE = 50


class KernelOptions(Options, total=False):
    """What holds for all recordings: the options of :func:`bouncelab.analyze`, and these.

    pattern : str
        What the names of the files say, as of :func:`bouncelab.session`.
    allow_implausible : bool
        Whether to believe notes that look like a mistake of units.
    time_limit_s : float
        Longest time for one recording; one that takes longer becomes a row that says so.
    """

    pattern: str | None
    allow_implausible: bool
    time_limit_s: float | None


class Given(NamedTuple):
    """A recording: name, place, content if that was read, and what was noted of it."""

    name: str
    path: str
    content: bytes | None
    notes: dict[str, str]


class Kernel:
    """Analyses batches of recordings; it comes from :func:`kernel`, and can be pickled."""

    def __init__(self, settings: str, options: str, root: str, limit_s: float | None, isolates: bool) -> None:
        self._arguments = (settings, options, root, limit_s, isolates)
        self._core = _core.Kernel(settings, options)
        self._root = root
        self._limit_s = limit_s
        self._isolates = isolates

    def __reduce__(self) -> tuple[type[Kernel], tuple[str, str, str, float | None, bool]]:
        return (type(self), self._arguments)

    def isolated(self) -> Kernel:
        """Return the same kernel that analyses each recording in a child process.

        A recording that ends its process then becomes a row that says so.
        """
        settings, options, root, limit_s, _ = self._arguments
        return type(self)(settings, options, root, limit_s, True)

    @property
    def sha256(self) -> str:
        """Hash of settings, options and version: the column ``kernel_sha256`` of all its rows."""
        return self._core.sha256()

    def refuse_rows_of_others(self, hashes: Iterable[str | None], output: str) -> None:
        """Refuse an output whose rows have other hashes than this kernel.

        Parameters
        ----------
        hashes : iterable of str or None
            The column ``kernel_sha256``.
        output : str
            Where it was read.

        Raises
        ------
        InputError
            If there is another one.
        """
        if set(hashes) - {self.sha256}:
            raise InputError(
                f"{output} has rows of other settings, or of another version of bouncelab; give another output"
            )

    @property
    def schema(self) -> pyarrow.Schema:
        """The schema of the rows."""
        return _arrow([]).schema

    def __call__(self, batches: Iterable[pyarrow.RecordBatch]) -> Iterator[pyarrow.RecordBatch]:
        """Analyse recordings.

        Parameters
        ----------
        batches : iterable of pyarrow.RecordBatch
            A column ``path``, of this machine or a URL that fsspec opens; perhaps ``content``, of bytes, where the path is
            neither, and ``recording``, the name. All other columns are notes: texts, quantities with their unit.

        Yields
        ------
        pyarrow.RecordBatch
            A row for each recording, at most 50 at once.
        """
        rows: list[bytes] = []
        with self._one_by_one() as row:
            for batch in batches:
                for given in _recordings(batch, self._root):
                    rows.append(row(given))
                    if len(rows) == ROWS_AT_ONCE:
                        yield from _arrow(rows).to_batches()
                        rows = []
        if rows:
            yield from _arrow(rows).to_batches()

    def row(self, given: Given) -> bytes:
        """Analyse one recording in this process; return its row as JSON."""
        if given.content is None and is_url(given.path):
            try:
                given = given._replace(content=fetched(given.path))
            except BouncelabError as reason:
                return self._core.failed(given, "unreadable", str(reason))
        return self._core.row(given)

    def pandas(self, frame: pandas.DataFrame) -> pandas.DataFrame:
        """Analyse the recordings of a data frame of pandas, or of a partition of Dask.

        Parameters
        ----------
        frame : pandas.DataFrame
            With the columns that a call takes.

        Returns
        -------
        pandas.DataFrame
            The rows of a call; without recordings it has their columns, as ``meta=`` of Dask takes.
        """
        imported("pandas", "pandas")
        pyarrow = imported("pyarrow", "pyarrow")
        batches = self(pyarrow.Table.from_pandas(frame, preserve_index=False).to_batches())
        rows: pandas.DataFrame = pyarrow.Table.from_batches(batches, self.schema).to_pandas()
        return rows

    @contextmanager
    def _one_by_one(self) -> Iterator[Outcome]:
        """Give what analyses one recording after the other, in this process or in a child."""
        if not self._isolates and self._limit_s is None:
            yield self.row
            return
        with child_process(self, self._limit_s) as child:

            def row(given: Given) -> bytes:
                outcome = child.row(given)
                return outcome if isinstance(outcome, bytes) else self._core.failed(given, *outcome)

            yield row


def kernel(settings: KernelOptions | None = None, *, root: str | PathLike[str] = "", isolated: bool = False) -> Kernel:
    """Return what analyses batches of recordings, the same way as :func:`bouncelab.session`.

    Its rows depend on the recordings and the settings alone: not on batches, order, engine or machines.

    Parameters
    ----------
    settings : KernelOptions, optional
        What holds for all recordings; what is noted of one goes before.
    root : path
        Folder of the recordings: names are relative to it.
    isolated : bool
        Whether to analyse in a child process, so that a recording that ends it becomes a row. A
        ``time_limit_s`` does so anyway.

    Returns
    -------
    Kernel

    Raises
    ------
    InputError, OutOfRangeError, UnknownNameError, PhysicsError, SessionError
        If a setting makes no sense.

    Examples
    --------
    >>> import pyarrow
    >>> from bouncelab import batch
    >>> times = b"0 0.4605 0.8877 1.2854 1.6568".replace(b" ", b"\\n")
    >>> recordings = pyarrow.table({"path": ["steel_1.txt"], "content": [times], "operator": ["Ada"]})
    >>> [rows] = batch.kernel({"pattern": "{surface}_{}", "draws": None})(recordings.to_batches())
    >>> row = rows.to_pylist()[0]
    >>> row["noted"], len(row["impacts"]), row["failure"]
    ([('operator', 'Ada'), ('surface', 'steel')], 5, None)
    """
    given = dict(settings or {})
    pattern, limit_s = given.pop("pattern", None), given.pop("time_limit_s", None)
    implausible = flag("allow_implausible", given.pop("allow_implausible", False))
    refuse_options_of_one_recording(given)
    stated = settings_of(cast(Options, given))
    options = {
        "pattern": None if pattern is None else text("pattern", pattern),
        "allow_implausible": implausible,
    }
    longest = None if limit_s is None else number("time_limit_s", limit_s)
    if longest is not None and longest <= 0.0:
        raise InputError(f"time_limit_s is {longest:g}; it must be above 0")
    return Kernel(stated, json.dumps(options), plain(fspath(root)), longest, isolated)


class _Task:
    """A kernel as a task of Spark, which analyses in child processes where it is tried again."""

    def __init__(self, kernel: Kernel) -> None:
        self._kernel = kernel

    def __call__(self, batches: Iterator[pyarrow.RecordBatch]) -> Iterator[pyarrow.RecordBatch]:
        context = imported("pyspark", "spark").TaskContext.get()
        is_retry = context is not None and context.attemptNumber() > 0
        return (self._kernel.isolated() if is_retry else self._kernel)(batches)


def analyze_frame(
    recordings: DataFrame, settings: KernelOptions | None = None, *, root: str | PathLike[str] = ""
) -> DataFrame:
    """Analyse the recordings of a data frame of Spark, 3.5 or later, also over Spark Connect.

    Parameters
    ----------
    recordings : pyspark.sql.DataFrame
        A column ``path``, which all workers see, or a URL that fsspec opens; perhaps ``content``, the bytes of the file,
        such as the format ``binaryFile`` of Spark has, and ``recording``, the name. All other columns are notes, such as
        texts and quantities with their unit.
    settings : KernelOptions, optional
        As of :func:`kernel`.
    root : path
        Folder of the recordings: where there is no column ``recording``, names are relative to it.

    Returns
    -------
    pyspark.sql.DataFrame
        A row for each recording, not yet computed: write it where you like, as Parquet, Delta, Iceberg or into a catalog.

    Raises
    ------
    InputError, OutOfRangeError, UnknownNameError, PhysicsError, SessionError
        If a setting makes no sense.

    Notes
    -----
    Where contents travel, let a batch have few: ``spark.sql.execution.arrow.maxRecordsPerBatch`` of 10. A task that is
    tried again analyses in child processes, so that a recording that ends its process becomes a row.
    """
    types = imported("pyspark.sql.pandas.types", "spark")
    analyzes = kernel(settings, root=root)
    return recordings.mapInArrow(_Task(analyzes), types.from_arrow_schema(analyzes.schema))


def manifest(
    source: str | PathLike[str],
    path: str | PathLike[str],
    notes: Mapping[str, Mapping[str, str]] | None = None,
    *,
    force: bool = False,
) -> int:
    """Write the list of the recordings of a folder as Parquet: ``path``, ``recording`` and what was noted.

    Parameters
    ----------
    source : path
        A folder, also at a URL that fsspec opens, which is searched with the folders in it; names with a dot before them
        are left out.
    path : path
        The file to write.
    notes : mapping, optional
        What was noted, by the path of a recording relative to the folder.
    force : bool
        Whether it may replace a file that bouncelab did not write. A recording of the folder is never replaced.

    Returns
    -------
    int
        How many recordings there are.
    """
    pyarrow, parquet = imported("pyarrow", "pyarrow"), imported("pyarrow.parquet", "pyarrow")
    recordings = recordings_in(fspath(source))
    names = sorted(recordings)
    known = notes or {}
    fields = sorted({field for noted in known.values() for field in noted})
    columns: dict[str, list[str | None]] = {"path": [recordings[name] for name in names]}
    columns["recording"] = list(names)
    columns |= {field: [known.get(name, {}).get(field) for name in names] for field in fields}
    content = pyarrow.BufferOutputStream()
    # Known by it as a file of bouncelab.
    table = pyarrow.table(columns).replace_schema_metadata({"bouncelab.schema": "bouncelab.manifest/1"})
    parquet.write_table(table, content)
    inputs = [name for name in columns["path"] if name is not None]
    _core.write_file(text("path", fspath(path)), "parquet", content.getvalue().to_pybytes(), inputs, bool(force))
    return len(names)


def explode(
    results: str | PathLike[str],
    output: str | PathLike[str],
    *,
    forms: Iterable[str] = ("parquet",),
    force: bool = False,
    **options: object,
) -> list[Path]:
    """Write the tables of drops and impacts of :func:`bouncelab.session` from the rows of an engine.

    Parameters
    ----------
    results : path
        The folder of Parquet that an engine wrote.
    output : path
        The folder for ``drops`` and ``impacts``.
    forms : iterable of str
        ``"parquet"``, ``"csv"``, ``"jsonl"``.
    force : bool
        Whether they may replace files that bouncelab did not write. The results are never replaced.
    **options
        As of :func:`study`: they decide at which speed drops are compared.

    Returns
    -------
    list of Path
        The files. Their rows are in the order of the results.
    """
    folder = Path(output)
    folder.mkdir(parents=True, exist_ok=True)
    return _results(results, options).write_tables(
        fspath(folder), [text("forms", form) for form in forms], bool(force)
    )


def study(
    results: str | PathLike[str],
    *,
    by: str | Iterable[str] | None = None,
    compare_at_m_s: float | None = None,
    wanted: float | None = None,
    exclude: str | Iterable[str] = (),
    language: str = "en",
) -> dict[str, JSON]:
    """Compare the drops that an engine analysed: the model of :func:`bouncelab.session`.

    Parameters
    ----------
    results : path
        The folder of Parquet that an engine wrote.
    by, compare_at_m_s, wanted, exclude
        As of :func:`bouncelab.session`.
    language : str
        Language of the reasons.

    Returns
    -------
    dict
        The document of the schema ``bouncelab.session/3``.

    Raises
    ------
    SessionError
        If the results cannot be read, or have two different rows of a recording.
    """
    asked = {"by": by, "compare_at_m_s": compare_at_m_s, "wanted": wanted, "exclude": exclude}
    document: dict[str, JSON] = json.loads(_results(results, asked).document(language))
    return document


@dataclass(frozen=True)
class StudySums:
    """What the drops of some rows add to a study: each part of them becomes a row with its sums, and few parts one.

    Attributes
    ----------
    request : str
        What is asked, with every level that was noted, as JSON.
    """

    request: str

    def add(self, rows: Iterable[pyarrow.RecordBatch]) -> Iterator[pyarrow.RecordBatch]:
        """Give the sums of rows of a kernel, without those of equal contents: columns ``record`` and ``noted``."""
        sums = _core.StudySums(self.request)
        for part in rows:
            for record, noted in zip(part["record"], part["noted"], strict=True):
                sums.add(record.as_py(), dict(noted.as_py()))
        yield self._row(sums)

    def merge(self, parts: Iterable[pyarrow.RecordBatch]) -> Iterator[pyarrow.RecordBatch]:
        """Give the sums of parts."""
        yield self._row(self.merged(each.as_py() for part in parts for each in part["sums"]))

    def merged(self, parts: Iterable[bytes]) -> _core.StudySums:
        """Return the sums of parts."""
        sums = _core.StudySums(self.request)
        for part in parts:
            sums.merge(part)
        return sums

    def _row(self, sums: _core.StudySums) -> pyarrow.RecordBatch:
        pyarrow = imported("pyarrow", "pyarrow")
        return pyarrow.RecordBatch.from_pydict({"sums": pyarrow.array([sums.sums()], pyarrow.binary())})


def _results(results: str | PathLike[str], options: Mapping[str, object]) -> _core.Results:
    unknown = options.keys() - {"by", "compare_at_m_s", "wanted", "exclude"}
    if unknown:
        raise InputError(f"there is no option {min(unknown)!r}")

    def some(name: str) -> float | None:
        value = options.get(name)
        return None if value is None else number(name, value)

    request: dict[str, object] = {"exclude": texts("exclude", options.get("exclude", ()))}
    request["by"] = None if options.get("by") is None else texts("by", options["by"])
    request |= {name: some(name) for name in ("compare_at_m_s", "wanted")}
    return _core.Results(fspath(results), json.dumps(request))


def _arrow(rows: list[bytes]) -> pyarrow.Table:
    return imported("pyarrow", "pyarrow").table(_core.batch_of_rows(rows))


def _recordings(batch: pyarrow.RecordBatch, root: str) -> Iterator[Given]:
    columns = dict(zip(batch.schema.names, batch.columns, strict=True))
    paths, contents, names = (columns.pop(name, None) for name in ("path", "content", "recording"))
    if paths is None:
        raise InputError("there is no column path")
    for place in range(batch.num_rows):
        path = plain(paths[place].as_py())
        name = path.removeprefix(root.rstrip("/") + "/") if names is None else names[place].as_py()
        content = None if contents is None else contents[place].as_py()
        noted = ((field, column[place].as_py()) for field, column in columns.items())
        yield Given(name, path, content, {field: str(value) for field, value in noted if value is not None})


def plain(path: str) -> str:
    """Return a path of this machine without ``file:``; any other as it is."""
    return re.sub("^file:/+", "/", path)


def recordings_in(source: str) -> dict[str, str]:
    """Return the paths or URLs of the recordings in a folder, by names relative to it."""
    root = plain(source)
    if is_url(root):
        return _in_store(root)
    # Another node may work in another folder.
    return {name: os.path.join(os.path.abspath(root), name) for name in _found(root, "")}


def _in_store(root: str) -> dict[str, str]:
    """Find the recordings in a folder at a URL: their URLs, by names relative to the folder."""
    hidden = re.compile(r"(^|/)\.")
    listed = files_at(root).items()
    return {name: url for name, url in listed if name.lower().endswith(_endings()) and not hidden.search(name)}


def _endings() -> tuple[str, ...]:
    return tuple(f".{ending}" for ending in _core.endings())


def _found(root: str, within: str) -> Iterator[str]:
    """Find the recordings in a folder, by names relative to the root."""
    try:
        listed = os.scandir(os.path.join(root, within))
    except OSError as reason:
        raise RecordingNotFoundError(f"{os.path.join(root, within)}: {reason.strerror}; give a folder") from reason
    with listed as entries:
        for entry in entries:
            name = os.path.join(within, entry.name)
            if entry.name.startswith("."):
                continue
            if entry.is_dir(follow_symlinks=False):
                yield from _found(root, name)
            elif entry.name.lower().endswith(_endings()):
                yield name
