"""Recordings by the million on Ray; ``pip install bouncelab[ray]``."""
# pyright: reportMissingImports=false

from __future__ import annotations

from os import fspath
from typing import TYPE_CHECKING

import pyarrow
import ray.data
from ray.data.checkpoint import CheckpointConfig

from bouncelab import batch

if TYPE_CHECKING:
    from os import PathLike

    from bouncelab.batch import Kernel, Settings

def analyze(
    manifest: str | PathLike[str],
    output: str | PathLike[str],
    checkpoint: str | PathLike[str],
    settings: Settings | None = None,
    *,
    rows_per_block: int = 50,
) -> None:
    """Analyse all recordings of a manifest that were not analysed yet, on the cluster of ``ray.init()``.

    What was done is in the checkpoint; a recording that ends its process becomes a row that says so, for each is
    analysed in a child process.

    Parameters
    ----------
    manifest : path
        Parquet with a column ``path``, a column ``recording`` of unique names, and notes of text: what
        :func:`bouncelab.batch.manifest` writes.
    output : path
        Folder for the rows as Parquet. It and the checkpoint belong to one manifest and one kernel: other settings
        or another version of bouncelab need others.
    checkpoint : path
        Folder in which Ray keeps what was done.
    settings : Settings, optional
        As of :func:`bouncelab.batch.kernel`.
    rows_per_block : int
        At most so many recordings of each worker are analysed again after it was killed.
    """
    kernel = batch.kernel(settings, isolated=True)
    context = ray.data.DataContext.get_current()
    before = context.checkpoint_config
    context.checkpoint_config = CheckpointConfig(
        id_column="recording", checkpoint_path=fspath(checkpoint), delete_checkpoint_on_success=False
    )
    try:
        recordings = ray.data.read_parquet(fspath(manifest)).repartition(target_num_rows_per_block=rows_per_block)
        rows = recordings.map_batches(_Task(kernel), batch_format="pyarrow", batch_size=rows_per_block)
        rows.write_parquet(fspath(output))
    finally:
        context.checkpoint_config = before


class _Task:
    """The kernel, from table to table."""

    def __init__(self, kernel: Kernel) -> None:
        self._kernel = kernel

    def __call__(self, recordings: pyarrow.Table) -> pyarrow.Table:
        return pyarrow.Table.from_batches(self._kernel(recordings.to_batches()), self._kernel.schema)
