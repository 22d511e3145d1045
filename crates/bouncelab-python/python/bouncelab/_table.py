"""Tables that any program reads as Arrow."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from bouncelab import _core
from bouncelab._errors import imported

if TYPE_CHECKING:
    import numpy as np
    import pandas
    import polars
    import pyarrow
    from numpy.typing import NDArray


class Column(NamedTuple):
    """Name, unit and meaning of a column.

    Attributes
    ----------
    name : str
        The name, as in ``table[name]``.
    unit : str
        The unit; empty for what has none.
    about : str
        The meaning.

    Examples
    --------
    >>> import bouncelab as bl
    >>> bl.analyze_times([0.0, 0.5, 0.9], draws=None).impacts.columns[3][:2]
    ('time_s', 's')
    """

    name: str
    unit: str
    about: str


class Table:
    """A table: one row for each drop, impact, flight or bounce.

    It is a stream of Arrow (``__arrow_c_stream__``), which pyarrow, Polars, pandas, DuckDB and Daft read
    without a copy. As in a data frame, a column is a NumPy array, ``table["time_s"]``, iteration goes over the names of
    the columns, and ``len`` counts the rows; ``dict(table)`` has all columns, and ``numpy.asarray(table)`` is a structured
    array.

    Examples
    --------
    >>> import bouncelab as bl
    >>> impacts = bl.analyze_times([0.0, 0.4605, 0.8877, 1.2854], draws=None).impacts
    >>> len(impacts)
    4
    >>> impacts["time_s"]
    array([0.    , 0.4605, 0.8877, 1.2854])
    >>> "time_s" in impacts, list(impacts)[:4]
    (True, ['recording', 'drop', 'number', 'time_s'])
    """

    __slots__ = ("_core",)

    def __init__(self, core: _core.Table) -> None:
        self._core = core

    @property
    def columns(self) -> tuple[Column, ...]:
        """Name, unit and meaning of each column, in their order."""
        return tuple(Column(*about) for about in self._core.about())

    def __len__(self) -> int:
        return self._core.rows()

    def __getitem__(self, name: str) -> NDArray[np.generic]:
        """Return a column.

        Parameters
        ----------
        name : str
            One of the names of :attr:`columns`.

        Returns
        -------
        numpy.ndarray, shape (rows,)
            Numbers as ``float64``, with NaN for what is not known; counts and flags as ``int64`` and
            ``bool`` where all are known, all else as objects.

        Raises
        ------
        KeyError
            If there is no such column.
        """
        import numpy as np

        dtype, values = self._core.column(name)
        return np.array(values, dtype=dtype)

    def keys(self) -> tuple[str, ...]:
        """Return the names of the columns, in their order.

        Returns
        -------
        tuple of str
        """
        return tuple(column.name for column in self.columns)

    def items(self) -> Iterator[tuple[str, NDArray[np.generic]]]:
        """Return name and array of each column, one after the other.

        Returns
        -------
        iterator of tuple of str and numpy.ndarray
        """
        return ((name, self[name]) for name in self.keys())

    def __iter__(self) -> Iterator[str]:
        return iter(self.keys())

    def __contains__(self, name: object) -> bool:
        return name in self.keys()

    def _ipython_key_completions_(self) -> list[str]:
        return list(self.keys())

    def __array__(self, dtype: object = None, copy: bool | None = None) -> NDArray[np.void]:
        """Return a structured array, a field for each column, for NumPy."""
        import numpy as np

        columns = dict(self.items())
        array = np.empty(len(self), dtype=[(name, column.dtype) for name, column in columns.items()])
        for name, column in columns.items():
            array[name] = column
        return array

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
        """Return the stream of Arrow, for programs that read it."""
        return self._core.__arrow_c_stream__(requested_schema)

    def to_arrow(self) -> pyarrow.Table:  # type: ignore[no-any-unimported]  # pyarrow has no types
        """Return a table of pyarrow, which must be installed.

        Returns
        -------
        pyarrow.Table
        """
        return imported("pyarrow", "pyarrow").table(self)

    def to_polars(self) -> polars.DataFrame:
        """Return a data frame of Polars, which must be installed.

        Returns
        -------
        polars.DataFrame
        """
        frame: polars.DataFrame = imported("polars", "polars").DataFrame(self)
        return frame

    def to_pandas(self) -> pandas.DataFrame:
        """Return a data frame of pandas, which must be installed, with pyarrow.

        Returns
        -------
        pandas.DataFrame
        """
        imported("pandas", "pandas")
        frame: pandas.DataFrame = self.to_arrow().to_pandas()
        return frame

    def to_dict(self) -> dict[str, list[float | int | bool | str | None]]:
        """Return the columns as lists.

        Returns
        -------
        dict of list
            By name; what is not known is ``None``.
        """
        return {column.name: self._core.column(column.name)[1] for column in self.columns}

    def __reduce__(self) -> tuple[type[Table], tuple[_core.Table]]:
        return (Table, (self._core,))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Table) and self._core.packed() == other._core.packed()

    def __repr__(self) -> str:
        return f"<bouncelab.Table: {len(self)} rows of {', '.join(self.keys())}>"

    def _repr_html_(self) -> str:
        """Return the first rows as HTML, for notebooks."""
        from html import escape

        def cell(value: object) -> str:
            shown = "" if value is None else f"{value:.6g}" if isinstance(value, float) else str(value)
            return f"<td>{escape(shown)}</td>"

        columns = self.to_dict()
        head = "".join(f"<th>{escape(name)}</th>" for name in columns)
        rows = zip(*(values[:MAX_ROWS] for values in columns.values()), strict=True)
        body = "".join(f"<tr>{''.join(map(cell, row))}</tr>" for row in rows)
        more = f"<p>{len(self)} rows</p>" if len(self) > MAX_ROWS else ""
        return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>{more}"


#: Maximum number of rows of a table that a notebook shows.
MAX_ROWS = 20


