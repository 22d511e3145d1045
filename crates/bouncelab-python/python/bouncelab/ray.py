"""Recordings by the million on Ray; ``pip install bouncelab[ray]``."""
# pyright: reportMissingImports=false, reportAttributeAccessIssue=false

from __future__ import annotations

import os
import uuid
from collections.abc import Iterable, Iterator
from contextlib import closing, nullcontext
from hashlib import sha256
from itertools import accumulate
from typing import TYPE_CHECKING

from bouncelab._errors import imported

imported("pyarrow", "ray")
imported("ray", "ray")

import pyarrow
import ray
from pyarrow import compute, parquet
from pyarrow.fs import FileSystem

from bouncelab import batch
from bouncelab._analyze import Bars, Progress
from bouncelab._errors import InputError
from bouncelab._settings import count

if TYPE_CHECKING:
    from os import PathLike

    from bouncelab.batch import Kernel, KernelOptions

#: Blocks that each processor is given, so that it need not wait for the next.
BLOCKS_AHEAD = 2


def analyze(
    manifest: str | PathLike[str],
    output: str | PathLike[str],
    settings: KernelOptions | None = None,
    *,
    rows_per_block: int = 50,
    progress: Progress | None = None,
) -> int:
    """Analyse the recordings of a manifest that have no row yet; return how many.

    It takes the cluster of ``ray.init()``. A recording that ends its process becomes a row that says so, for each is
    analysed in a child process.

    Parameters
    ----------
    manifest : path
        Parquet with a column ``path``, a column ``recording`` of unique names, and notes of text: what
        :func:`bouncelab.batch.manifest` writes.
    output : path
        Folder for the rows as Parquet, a file for each block. It belongs to one manifest and one kernel.
    settings : KernelOptions, optional
        As of :func:`bouncelab.batch.kernel`.
    rows_per_block : int
        At most this number of recordings of each worker is analysed again after it was killed.
    progress : optional
        As of :func:`bouncelab.analyze`.

    Raises
    ------
    InputError
        If the manifest lacks a column or has a name twice, or the output has rows of other settings or of another version;
        and what :func:`bouncelab.batch.kernel` raises.
    """
    rows_at_once = max(count("rows_per_block", rows_per_block), 1)
    report = None if progress is None else Bars(progress)
    kernel = batch.kernel(settings, isolated=True)
    listed = _listed(manifest)
    rows = _Folder(output)
    left = listed.filter(compute.invert(compute.is_in(listed["recording"], rows.recordings(kernel))))
    # Where a worker or its node ends, another takes the block.
    analyze_block = ray.remote(max_retries=-1)(_analyze_block)
    tasks = (analyze_block.remote(kernel, block, rows) for block in _blocks(left, rows_at_once))
    with nullcontext() if report is None else closing(report):
        for analyzed in accumulate(_results(tasks)):
            if report is not None:
                report("recordings", analyzed, left.num_rows)
    return left.num_rows


class _Folder:
    """A folder of Parquet that all nodes reach."""

    def __init__(self, place: str | PathLike[str]) -> None:
        self._files, self._path = _reached(place)
        self._files.create_dir(self._path)

    def write(self, name: str, table: pyarrow.Table) -> None:
        """Write a file at once: whoever reads it finds all of it, or none."""
        unfinished = f"{self._path}/.{uuid.uuid4().hex}"
        parquet.write_table(table, unfinished, filesystem=self._files)
        self._files.move(unfinished, f"{self._path}/{name}.parquet")

    def recordings(self, kernel: Kernel) -> pyarrow.ChunkedArray:
        """The names of the recordings in all files, whose rows must be of this kernel."""
        schema = pyarrow.schema(dict.fromkeys(("recording", "kernel_sha256"), pyarrow.string()))
        rows = parquet.read_table(self._path, schema=schema, filesystem=self._files)
        kernel.refuse_rows_of_others(rows["kernel_sha256"].unique().to_pylist(), self._path)
        return rows["recording"]


def _reached(place: str | PathLike[str]) -> tuple[FileSystem, str]:
    """The file system of a path or URI, and the path there."""
    path = batch.plain(os.fspath(place))
    return FileSystem.from_uri(path if "://" in path else os.path.abspath(path))


def _listed(manifest: str | PathLike[str]) -> pyarrow.Table:
    files, path = _reached(manifest)
    listed = parquet.read_table(path, filesystem=files)
    for column in ("path", "recording"):
        if column not in listed.column_names or listed[column].null_count:
            raise InputError(f"{os.fspath(manifest)} has no column {column} without gaps; batch.manifest writes one")
    names = listed["recording"].cast(pyarrow.string())
    counts = compute.value_counts(names)
    twice = counts.filter(compute.greater(counts.field("counts"), 1))
    if len(twice):
        raise InputError(f"{os.fspath(manifest)} has the recording {twice[0]['values'].as_py()!r} twice")
    return listed.set_column(listed.column_names.index("recording"), "recording", names)


def _blocks(recordings: pyarrow.Table, rows: int) -> Iterator[pyarrow.Table]:
    for first in range(0, recordings.num_rows, rows):
        block = recordings.slice(first, rows)
        # It would be sent with all that it is a slice of.
        yield block.take([*range(block.num_rows)])


def _analyze_block(kernel: Kernel, recordings: pyarrow.Table, rows: _Folder) -> int:
    """Analyse recordings, and write their rows."""
    # Whoever writes a block again writes the same file.
    name = sha256("\0".join(recordings["recording"].to_pylist()).encode()).hexdigest()[:32]
    rows.write(name, pyarrow.Table.from_batches(kernel(recordings.to_batches()), kernel.schema))
    return recordings.num_rows


def _results(tasks: Iterable[ray.ObjectRef[int]]) -> Iterator[int]:
    """What tasks give, as they end; no more of them are begun than the cluster needs to be busy."""
    running: list[ray.ObjectRef[int]] = []
    for task in tasks:
        running.append(task)
        if len(running) >= BLOCKS_AHEAD * ray.cluster_resources().get("CPU", 1):
            ended, running = ray.wait(running)
            yield from ray.get(ended)
    for task in running:
        yield ray.get(task)
