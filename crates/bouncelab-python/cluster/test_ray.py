"""Ray on a head and one more node."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pyarrow
import pytest
import ray as engine_of_ray
from clusters import Ray, cluster
from faults import faulty
from laboratory import SETTINGS, alone, differences, failures, listed, names, rows, with_faults, work
from pyarrow import parquet

from bouncelab import InputError, batch
from bouncelab.ray import analyze

#: For what is not about numbers.
QUICK: batch.KernelOptions = {"draws": None}


@pytest.fixture(scope="module")
def ray(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Ray]:
    with cluster(Ray, tmp_path_factory.mktemp("r")) as started:
        assert isinstance(started, Ray)
        engine_of_ray.init(address=started.url, log_to_driver=False)
        yield started
        engine_of_ray.shutdown()


def test_rows_are_those_of_a_session(ray: Ray, recordings: Path, session: Path, tmp_path: Path) -> None:
    output = tmp_path / "results.parquet"
    analyze(listed(recordings), output, SETTINGS)
    cells, different = differences(session, output, tmp_path / "tables")
    count = len(names(output))
    print(f"Ray: {count} recordings, {cells} cells, {different} differ")
    assert (count, different) == (len(list(recordings.iterdir())), 0)


def test_rows_depend_on_no_partitioning(ray: Ray, few: Path, tmp_path: Path) -> None:
    expected = alone(few)
    for count in (50, 7, 300):
        output = tmp_path / f"{count}.parquet"
        analyze(listed(few), output, SETTINGS, rows_per_block=count)
        assert rows(output) == expected


def test_what_fails_becomes_a_row(ray: Ray, few: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(batch, "kernel", faulty)
    source, broken = with_faults(few, tmp_path / "recordings")
    output = tmp_path / "results.parquet"
    analyze(listed(source), output, {**QUICK, "time_limit_s": 20.0})
    expected = dict.fromkeys(broken, "not-analysed")
    assert failures(output) == expected | {"abort.wav": "process-died", "endless.wav": "out-of-time"}
    assert len(names(output)) == 302


def test_nothing_new_is_nothing_done(ray: Ray, few: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(batch, "kernel", faulty)
    output, source, counts = tmp_path / "results.parquet", listed(few), []
    for _ in range(2):
        before = len(work(ray.folder))
        said = analyze(source, output, QUICK)
        counts.append((said, len(work(ray.folder)) - before))
    assert counts == [(300, 300), (0, 0)] and len(names(output)) == 300
    with pytest.raises(InputError, match="rows of other settings"):
        analyze(source, output, {**QUICK, "ball": "tennis"})


def test_progress_is_told(ray: Ray, few: Path, tmp_path: Path) -> None:
    told: list[float] = []

    class Bar:
        def __init__(self, *, total: float | None, desc: str, unit: str) -> None:
            told.append(total or 0.0)

        def update(self, n: float, /) -> None:
            told.append(n)

        def close(self) -> None:
            told.append(0.0)

    analyze(listed(few), tmp_path / "rows", QUICK, rows_per_block=130, progress=Bar)
    assert told[0] == 300 and sorted(told[1:-1]) == [40, 130, 130] and told[-1] == 0


@pytest.mark.parametrize(
    ("columns", "reason"),
    [
        ({"path": ["/a.wav"]}, "has no column recording"),
        ({"path": ["/a.wav", None], "recording": ["a", "b"]}, "has no column path without gaps"),
        ({"path": ["/a.wav", "/b.wav"], "recording": ["a", "a"]}, "has the recording 'a' twice"),
    ],
)
def test_a_manifest_that_makes_no_sense_is_refused(
    columns: dict[str, list[str | None]], reason: str, tmp_path: Path
) -> None:
    path = tmp_path / "manifest.parquet"
    parquet.write_table(pyarrow.table(columns), path)
    with pytest.raises(InputError, match=reason):
        analyze(path, tmp_path / "rows")
    assert not (tmp_path / "rows").exists()
