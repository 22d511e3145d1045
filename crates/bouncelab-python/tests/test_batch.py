"""The kernel of clusters, and what is made of its rows."""

from __future__ import annotations

import json
import os
import pickle
import subprocess
import sys
from pathlib import Path

import pytest

pyarrow = pytest.importorskip("pyarrow")

import pyarrow.compute  # noqa: E402
from pyarrow import parquet  # noqa: E402

import bouncelab as bl  # noqa: E402
from bouncelab import batch  # noqa: E402
from bouncelab._isolated import child_process  # noqa: E402
from conftest import PROGRAM  # noqa: E402
from faults import Greedy, Process, faulty, same_groups  # noqa: E402

PATTERN = "{surface}_{height}_{}"
SETTINGS: batch.KernelOptions = {"ball": "table-tennis-40", "draws": 100, "pattern": PATTERN}


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Ten recordings: two are the same, one is damaged, one holds no drop."""
    folder = tmp_path_factory.mktemp("recordings")
    (folder / "monday").mkdir()
    for number in range(8):
        surface, restitution = [("wood", 0.85), ("steel", 0.90)][number % 2]
        sound = bl.synthesize(restitution=restitution + 0.001 * number, bounces=10, seed=number, sample_rate_hz=22_050)
        sound.save(folder / ("monday" if number > 5 else ".") / f"{surface}_30cm_{number}.wav")
    whole = (folder / "wood_30cm_0.wav").read_bytes()
    (folder / "wood_30cm_copy.wav").write_bytes(whole)
    (folder / "wood_30cm_damaged.wav").write_bytes(whole[:30])
    (folder / "wood_30cm_silent.wav").write_bytes(whole[:44] + bytes(len(whole) - 44))
    return folder


def recordings(folder: Path) -> pyarrow.Table:
    path = folder.parent / f"{folder.name}.parquet"
    batch.manifest(folder, path)
    return parquet.read_table(path, columns=["path"])


def rows(table: pyarrow.Table, kernel: batch.Kernel, chunk: int = 100) -> pyarrow.Table:
    found = pyarrow.Table.from_batches(kernel(table.to_batches(max_chunksize=chunk)), kernel.schema)
    return found.sort_by("recording")


def bytes_of(table: pyarrow.Table) -> bytes:
    stream = pyarrow.BufferOutputStream()
    with pyarrow.ipc.new_stream(stream, table.schema) as writer:
        writer.write_table(table.combine_chunks())
    return stream.getvalue().to_pybytes()


@pytest.fixture(scope="module")
def results(folder: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The rows in two files, not in the order of the names; one file was written twice."""
    found = rows(recordings(folder), batch.kernel(SETTINGS, root=folder))
    results = tmp_path_factory.mktemp("results")
    parquet.write_table(found[6:], results / "1.parquet")
    (results / "more").mkdir()
    parquet.write_table(found[:6], results / "more" / "2.parquet", row_group_size=2)
    parquet.write_table(found[:6], results / "more" / "3.parquet")
    (results / "_temporary").mkdir()
    (results / "_temporary" / "4.parquet").write_bytes(b"cut off")
    return results


def test_rows_depend_on_no_batches_no_order_and_no_process(folder: Path) -> None:
    table = recordings(folder)
    expected = bytes_of(rows(table, batch.kernel(SETTINGS, root=folder)))
    kernel = pickle.loads(pickle.dumps(batch.kernel(SETTINGS, root=f"file://{folder}")))
    backwards = table.take(list(reversed(range(len(table)))))
    assert bytes_of(rows(backwards, kernel, chunk=3)) == expected
    assert bytes_of(rows(table, kernel.isolated())) == expected
    contents = [Path(path).read_bytes() for path in table["path"].to_pylist()]
    with_content = table.append_column("content", pyarrow.array(contents, pyarrow.binary()))
    assert bytes_of(rows(with_content, kernel)) == expected


def test_a_session_takes_the_rows_for_its_own_results(folder: Path, results: Path, tmp_path: Path) -> None:
    known = ["--pattern", PATTERN, "--ball", "table-tennis-40", "--draws", "100"]

    def session(name: str, *arguments: object) -> dict[str, object]:
        command = [*PROGRAM, "session", *arguments, "--output", tmp_path / name, "--tables", "parquet", "--figures"]
        document = subprocess.run([*command, "--format", "json"], check=True, capture_output=True, text=True).stdout
        tables = [parquet.read_table(tmp_path / name / f"{table}.parquet") for table in ("drops", "impacts")]
        keys = [("recording", "ascending"), ("drop", "ascending")]
        cells = [table.sort_by(keys + [("number", "ascending")] * (table is tables[1])) for table in tables]
        figures = [path.read_text() for path in sorted((tmp_path / name).glob("*.svg"))]
        return {"document": document, "cells": [table.to_pydict() for table in cells], "figures": figures}

    expected, found = session("own", folder, *known), session("from", "--from", results)
    assert found["cells"] == expected["cells"]
    assert found["document"] == expected["document"]
    assert found["figures"] == expected["figures"]
    batch.explode(results, tmp_path / "exploded", forms=["parquet", "csv"])
    assert (tmp_path / "exploded" / "drops.csv").exists()
    for table in ("drops", "impacts"):
        exploded = (tmp_path / "exploded" / f"{table}.parquet").read_bytes()
        assert exploded == (tmp_path / "from" / f"{table}.parquet").read_bytes()


def test_lists_have_the_columns_of_the_tables(results: Path, tmp_path: Path) -> None:
    batch.explode(results, tmp_path)
    schema = parquet.read_schema(results / "1.parquet")
    for name in ("drops", "impacts"):
        listed = schema.field(name).type.value_type
        tidy = parquet.read_schema(tmp_path / f"{name}.parquet").names
        assert [field.name for field in listed] == [name for name in tidy if name not in ("recording", "surface", "height")]


def test_exploded_tables_replace_no_file_of_others(results: Path, tmp_path: Path) -> None:
    drops = tmp_path / "drops.parquet"
    drops.write_text("notes of years")
    with pytest.raises(bl.OutputError, match="force=True"):
        batch.explode(results, tmp_path)
    assert drops.read_text() == "notes of years"
    batch.explode(results, tmp_path, force=True)
    rows = tmp_path / "rows"
    rows.mkdir()
    (rows / "drops.parquet").write_bytes((results / "1.parquet").read_bytes())
    with pytest.raises(bl.OutputError, match="input"):
        batch.explode(rows, rows, force=True)


def test_a_study_is_that_of_a_session(folder: Path, results: Path) -> None:
    expected = bl.session(folder, pattern=PATTERN, ball="table-tennis-40", draws=100).to_dict()
    assert batch.study(results) == expected
    assert batch.study(results, by=["surface"], compare_at_m_s=1.0)["study"]["at_speed_m_s"] == 1.0  # type: ignore[index,call-overload]


def test_a_study_of_parts_is_that_of_all(results: Path) -> None:
    """Each row makes sums of its own, which merge in two steps; of equal contents one counts."""
    whole = parquet.read_table(results).sort_by("recording").to_pylist()
    first = {row["content_sha256"]: row for row in reversed(whole) if row["record"] is not None}
    chosen = list(first.values())
    schema = pyarrow.schema({"record": pyarrow.string(), "noted": pyarrow.map_(pyarrow.string(), pyarrow.string())})
    parts = [pyarrow.RecordBatch.from_pylist([{name: row[name] for name in schema.names}], schema) for row in chosen]
    noted = sorted({level for row in chosen for level in row["noted"]})
    asked = {"noted": noted, "drops": len(chosen), "by": ["surface"], "compare_at_m_s": 1.5, "wanted": None}
    sums = batch.StudySums(json.dumps(asked))
    apart = [part for each in parts for part in sums.add([each])]
    merged = [part["sums"][0].as_py() for half in (apart[::2], apart[1::2]) for part in sums.merge(half)]
    found = json.loads(sums.merged(merged).document(len(chosen), "en"))
    same_groups(found, batch.study(results, by=["surface"], compare_at_m_s=1.5))


def test_notes_are_columns(folder: Path, tmp_path: Path) -> None:
    notes = {"wood_30cm_0.wav": {"operator": "Ada"}, "steel_30cm_1.wav": {"height": "40 cm"}}
    assert batch.manifest(folder, tmp_path / "manifest.parquet", notes) == 11
    table = parquet.read_table(tmp_path / "manifest.parquet")
    found = {row["recording"]: row for row in rows(table, batch.kernel(SETTINGS)).to_pylist()}
    assert ("operator", "Ada") in found["wood_30cm_0.wav"]["noted"]
    failure = found["steel_30cm_1.wav"]["failure"]
    assert failure["code"] == "metadata" and "30cm" in failure["message"] and "40 cm" in failure["message"]
    assert "monday/wood_30cm_6.wav" in found


def test_what_fails_becomes_a_row_and_harms_no_other(folder: Path, tmp_path: Path) -> None:
    whole = (folder / "wood_30cm_0.wav").read_bytes()
    names = ["a.wav", "abort.wav", "b.wav", "damaged.wav", "endless.wav", "missing.wav", "z.wav"]
    for name in names:
        if name != "missing.wav":
            (tmp_path / name).write_bytes(whole[:30] if name == "damaged.wav" else whole)
    table = pyarrow.table({"path": [str(tmp_path / name) for name in names]})
    kernel = faulty({"draws": None, "time_limit_s": 5.0}, root=str(tmp_path))
    found = {row["recording"]: row for row in rows(table, kernel).to_pylist()}
    codes = {name: row["failure"] and row["failure"]["code"] for name, row in found.items()}
    assert codes == {
        "a.wav": None,
        "abort.wav": "process-died",
        "b.wav": None,
        "damaged.wav": "not-analysed",
        "endless.wav": "out-of-time",
        "missing.wav": "unreadable",
        "z.wav": None,
    }
    assert "SIGABRT" in found["abort.wav"]["failure"]["message"]
    assert len(found["z.wav"]["drops"]) == 1
    assert found["abort.wav"]["content_sha256"] == found["a.wav"]["content_sha256"]


def test_dask_analyses_partitions(folder: Path, tmp_path: Path) -> None:
    pandas, dask = pytest.importorskip("pandas"), pytest.importorskip("dask.dataframe")
    kernel = batch.kernel(SETTINGS, root=folder)
    table = recordings(folder)
    frame = dask.from_pandas(pandas.DataFrame(table.to_pydict()), npartitions=3)
    found = frame.map_partitions(kernel.pandas, meta=kernel.pandas(frame.head(0)))
    found.to_parquet(tmp_path / "rows", schema=kernel.schema, write_index=False)
    assert batch.study(tmp_path / "rows") == batch.study(written(rows(table, kernel), tmp_path))


def written(found: pyarrow.Table, folder: Path) -> Path:
    parquet.write_table(found, folder / "alone.parquet")
    return folder / "alone.parquet"


def test_recordings_are_read_from_an_object_store(
    folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A server of S3 on this machine; what is not there becomes a row."""
    server, s3fs = pytest.importorskip("moto.server"), pytest.importorskip("s3fs")
    started = server.ThreadedMotoServer(ip_address="127.0.0.1", port=0)
    started.start()
    try:
        host, port = started.get_host_and_port()
        for name, value in {"ENDPOINT_URL": f"http://{host}:{port}", "ACCESS_KEY_ID": "a", "SECRET_ACCESS_KEY": "b"}.items():
            monkeypatch.setenv(f"AWS_{name}", value)
        monkeypatch.setenv("AWS_DEFAULT_REGION", "us-east-1")
        store = s3fs.S3FileSystem(skip_instance_cache=True)
        store.mkdir("bucket")
        table = recordings(folder)
        for path in table["path"].to_pylist():
            store.put(path, f"bucket/drops/{Path(path).relative_to(folder)}")
        store.pipe("bucket/drops/.hidden.wav", b"left out")
        count = batch.manifest("s3://bucket/drops", tmp_path / "manifest.parquet")
        listed = parquet.read_table(tmp_path / "manifest.parquet")
        assert count == len(listed) == len(table)
        of_store = rows(listed, batch.kernel(SETTINGS, root="s3://bucket/drops"))
        assert of_store.sort_by("recording") == rows(table, batch.kernel(SETTINGS, root=folder)).sort_by("recording")
        missing = rows(pyarrow.table({"path": ["s3://bucket/nothing.wav"]}), batch.kernel(SETTINGS))
        assert missing["failure"].to_pylist()[0]["code"] == "unreadable"
    finally:
        started.stop()


def test_results_of_different_settings_are_not_mixed(folder: Path, results: Path, tmp_path: Path) -> None:
    """Not even of different recordings."""
    found = parquet.read_table(results)
    parquet.write_table(found.filter(pyarrow.compute.not_equal(found["recording"], "steel_30cm_1.wav")), tmp_path / "1.parquet")
    table = recordings(folder)
    one = table.filter(pyarrow.compute.ends_with(table["path"], "steel_30cm_1.wav"))
    for settings in (SETTINGS, {**SETTINGS, "draws": None}, {**SETTINGS, "pattern": None}):
        parquet.write_table(rows(one, batch.kernel(settings, root=folder)), tmp_path / "2.parquet")  # type: ignore[arg-type]
        if settings is SETTINGS:
            assert batch.study(tmp_path) == batch.study(results)
        else:
            with pytest.raises(bl.SessionError, match="other settings, or of another version"):
                batch.study(tmp_path)


def test_a_recording_has_one_result(folder: Path, results: Path, tmp_path: Path) -> None:
    found = parquet.read_table(results)
    changed = found[:1].set_column(found.column_names.index("content_sha256"), "content_sha256", [["0" * 64]])
    parquet.write_table(pyarrow.concat_tables([found, changed]), tmp_path / "rows.parquet")
    with pytest.raises(bl.SessionError, match="two results of"):
        batch.study(tmp_path)


def test_another_compression_is_named(results: Path, tmp_path: Path) -> None:
    parquet.write_table(parquet.read_table(results), tmp_path / "rows.parquet", compression="zstd")
    with pytest.raises(bl.SessionError, match="compressed with ZSTD"):
        batch.study(tmp_path)


@pytest.mark.parametrize(
    "wrong",
    [
        lambda: batch.kernel({"pattern": "{"}),
        lambda: batch.kernel({"ball": "moon"}),
        lambda: batch.kernel({"colour": 1}),  # type: ignore[typeddict-unknown-key]
        lambda: batch.kernel({"channel": 1}),
        lambda: batch.kernel({"time_limit_s": "long"}),  # type: ignore[typeddict-item]
        lambda: batch.kernel({"time_limit_s": 0.0}),
        lambda: list(batch.kernel()(pyarrow.table({"file": ["a.wav"]}).to_batches())),
        lambda: batch.study("nowhere.parquet"),
        lambda: batch.explode(__file__, "."),
    ],
)
def test_only_exceptions_of_the_package_come_out(wrong, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:  # type: ignore[no-untyped-def]
    monkeypatch.chdir(tmp_path)
    with pytest.raises(bl.BouncelabError) as raised:
        wrong()
    assert len(str(raised.value)) > 15


def test_a_child_process_is_kept_until_it_may_owe_a_reply() -> None:
    def process() -> bytes | tuple[str, str]:
        with child_process(Process(), None) as child:
            return child.row(None)

    first, this = process(), str(os.getpid()).encode()
    assert first != this and process() == first
    with pytest.raises(KeyboardInterrupt), child_process(Process(), None):
        raise KeyboardInterrupt
    assert process() not in (first, this)


@pytest.mark.skipif(sys.platform != "linux", reason="memory is limited on Linux only")
def test_a_child_that_takes_too_much_memory_ends() -> None:
    with child_process(Greedy(), None) as child:
        kind, reason = child.row(None)
    assert kind == "process-died" and "SIGABRT" in reason


def test_the_place_of_the_job_is_one_word_however_long() -> None:
    command = [sys.executable, "-m", "bouncelab.spark_job", "--place"]
    printed = subprocess.run(command, env=os.environ | {"COLUMNS": "20"}, capture_output=True, text=True, check=True)
    assert Path(printed.stdout.rstrip("\n")).is_file()
