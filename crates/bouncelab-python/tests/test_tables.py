"""Tables are read by whatever reads Arrow."""

from __future__ import annotations

import numpy as np
import pytest

import bouncelab as bl


@pytest.fixture(params=["drops", "impacts", "flights", "draws", "figure"])
def table(recording: bl.Recording, request: pytest.FixtureRequest) -> bl.Table:
    match request.param:
        case "draws":
            return recording.drops[0].draws
        case "figure":
            return recording.drops[0].figure("restitution").data
        case name:
            found: bl.Table = getattr(recording, name)
            return found


def same(table: bl.Table, columns: dict[str, list[object]]) -> bool:
    expected = table.to_dict()
    return list(columns) == list(expected) and all(
        [None if value != value else value for value in columns[name]] == expected[name] for name in expected
    )


def test_pyarrow_reads_it(table: bl.Table) -> None:
    pyarrow = pytest.importorskip("pyarrow")
    assert same(table, pyarrow.table(table).to_pydict())
    assert pyarrow.table(table).schema.field(0).metadata[b"about"]
    assert table.to_arrow().num_rows == len(table)


def test_polars_reads_it(table: bl.Table) -> None:
    polars = pytest.importorskip("polars")
    assert same(table, polars.DataFrame(table).to_dict(as_series=False))
    assert table.to_polars().height == len(table)


def test_pandas_reads_it(table: bl.Table) -> None:
    pandas = pytest.importorskip("pandas")
    pytest.importorskip("pyarrow")
    for frame in (pandas.DataFrame.from_arrow(table), table.to_pandas()):
        known = frame.astype(object).where(frame.notna(), None)
        assert same(table, known.to_dict("list"))


def test_duckdb_reads_it(table: bl.Table) -> None:
    duckdb = pytest.importorskip("duckdb")
    given = table  # noqa: F841 (the query names it)
    found = duckdb.sql("select * from given")
    assert same(table, dict(zip(found.columns, map(list, zip(*found.fetchall(), strict=True)), strict=True)))


def test_daft_reads_it(table: bl.Table) -> None:
    daft = pytest.importorskip("daft")
    assert same(table, daft.from_arrow(table).to_pydict())


def test_a_column_is_an_array_of_numpy(recording: bl.Recording) -> None:
    impacts = recording.impacts
    assert impacts["time_s"].dtype == np.float64
    assert impacts["number"].dtype == np.int64
    assert np.isnan(impacts["flight_time_s"][-1])
    assert recording.flights["in_fit"].dtype == np.bool_
    with pytest.raises(KeyError):
        impacts["colour"]


def test_a_table_reads_like_a_data_frame(table: bl.Table) -> None:
    names = [column.name for column in table.columns]
    assert list(table.keys()) == names == table._ipython_key_completions_()
    assert names[0] in table and "colour" not in table
    if not isinstance(table, bl.Drops):
        assert list(table) == names
    columns, array = dict(table), np.asarray(table)
    assert list(columns) == names == list(array.dtype.names or ())
    assert len(array) == len(table)
    for name, column in table.items():
        assert np.array_equal(array[name], column, equal_nan=column.dtype.kind == "f")


def test_the_drops_are_a_table_and_a_sequence(recording: bl.Recording) -> None:
    drops = recording.drops
    assert len(drops) == len(list(drops)) == 1
    assert drops[0] == drops[-1] == drops[:][0]
    assert drops["restitution"][0] == drops[0].restitution.value
    with pytest.raises(IndexError):
        drops[1]
