"""Opens the tables of a session by Polars, DuckDB and pandas, and compares what they see.

usage: open_tables.py FOLDER
"""

import json
import sys
from pathlib import Path

import duckdb
import pandas
import polars
import pyarrow.parquet

folder = Path(sys.argv[1])
for table in ["drops", "impacts"]:
    path = folder / f"{table}.parquet"
    by_polars = polars.read_parquet(path)
    by_pandas = pandas.read_parquet(path)
    by_duckdb = duckdb.sql(f"select * from read_parquet('{path}')")
    rows = len(by_polars)
    assert rows > 0
    assert by_polars.columns == list(by_pandas.columns) == by_duckdb.columns
    assert rows == len(by_pandas) == len(by_duckdb.fetchall())
    # A mean over the column, by each of them, and from the other forms of the table.
    mean = by_polars["restitution"].mean()
    assert abs(mean - by_pandas["restitution"].mean()) < 1e-12
    query = f"select avg(restitution) from read_parquet('{path}')"
    assert abs(mean - duckdb.sql(query).fetchall()[0][0]) < 1e-12
    assert abs(mean - polars.read_csv(folder / f"{table}.csv")["restitution"].mean()) < 1e-12
    lines = pandas.read_json(folder / f"{table}.jsonl", lines=True)
    assert abs(mean - lines["restitution"].mean()) < 1e-9
    assert by_polars.schema["recording"] == polars.String
    assert by_polars.schema["drop"] == polars.Int64
    assert by_polars.schema["restitution"] == polars.Float64
    about = pyarrow.parquet.read_schema(path).metadata
    assert about[b"bouncelab.schema"].decode() == f"bouncelab.{table}/2"
    units = json.loads(about[b"bouncelab.units"])
    assert set(units) <= set(by_polars.columns)
    assert set(json.loads(about[b"bouncelab.about"])) == set(by_polars.columns)
    print(f"{table}: {rows} rows, {len(units)} columns with a unit, the same by all")
by_polars = polars.read_parquet(folder / "drops.parquet")
assert by_polars.schema["height_contradicts"] == polars.Boolean
joined = duckdb.sql(
    f"select count(*) from read_parquet('{folder}/drops.parquet')"
    f" join read_parquet('{folder}/impacts.parquet') using (recording, drop)"
).fetchall()[0][0]
assert joined == len(polars.read_parquet(folder / "impacts.parquet"))
