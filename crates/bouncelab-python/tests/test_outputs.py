"""What the package writes replaces no file that somebody would miss."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

import bouncelab as bl

TIMES_S = [0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045]

#: Saves a file of this name; ``force`` is handed on.
Save = Callable[..., object]


def figure(path: Path, **options: bool) -> object:
    return bl.analyze_times(TIMES_S, draws=None).figure("drag").save(path, **options)


def sound(path: Path, **options: bool) -> object:
    return bl.synthesize(bounces=3, seed=1).save(path, **options)


def manifest(path: Path, **options: bool) -> object:
    pytest.importorskip("pyarrow")
    from bouncelab import batch

    (path.parent / "recordings").mkdir(exist_ok=True)
    return batch.manifest(path.parent / "recordings", path, **options)


FILES: list[tuple[str, Save]] = [
    ("drag.svg", figure),
    ("drag.PNG", figure),
    ("drag.pdf", figure),
    ("drop.wav", sound),
    ("manifest.parquet", manifest),
]


@pytest.mark.parametrize(("name", "save"), FILES, ids=[name for name, _ in FILES])
def test_a_file_of_others_is_replaced_only_by_force(name: str, save: Save, tmp_path: Path) -> None:
    path = tmp_path / name
    path.write_text("notes of years")
    with pytest.raises(bl.OutputError, match="force=True"):
        save(path)
    assert path.read_text() == "notes of years"
    save(path, force=True)
    written = path.read_bytes()
    assert written != b"notes of years"
    save(path)
    assert path.read_bytes() == written
    assert [file.name for file in tmp_path.iterdir() if file.is_file()] == [name]


@pytest.mark.parametrize("name", ["drag.svg", "drag.png", "drag.pdf"])
def test_another_figure_of_the_package_is_replaced(name: str, tmp_path: Path) -> None:
    path = tmp_path / name
    figure(path)
    first = path.read_bytes()
    bl.simulate(bounces=3).figure("height").save(path)
    assert path.read_bytes() != first


def test_another_manifest_of_the_package_is_replaced(tmp_path: Path) -> None:
    path = tmp_path / "manifest.parquet"
    manifest(path)
    first = path.read_bytes()
    sound(tmp_path / "recordings" / "drop.wav")
    manifest(path)
    assert path.read_bytes() != first


def test_a_sound_has_no_mark_by_which_it_were_known(tmp_path: Path) -> None:
    sound(tmp_path / "drop.wav")
    with pytest.raises(bl.OutputError, match="force=True"):
        bl.synthesize(bounces=3, seed=2).save(tmp_path / "drop.wav")


def test_an_input_is_replaced_by_no_force(tmp_path: Path) -> None:
    path, link = tmp_path / "drop.wav", tmp_path / "link.svg"
    sound(path)
    link.symlink_to(path)
    before = path.read_bytes()
    with pytest.raises(bl.OutputError, match="input"):
        bl.analyze(path, draws=None).figure("waveform").save(link, force=True)
    pytest.importorskip("pyarrow")
    from bouncelab import batch

    with pytest.raises(bl.OutputError, match="input"):
        batch.manifest(tmp_path, path, force=True)
    assert path.read_bytes() == before
